#pragma once

// Names for tests of each intersection method: the method's name, not its address.

#include "fast/intersect.h"
#include "tests/names.h"
#include "tests/testing.h"

namespace raycheck::fast {

inline void PrintTo(const IntersectMethod* method, std::ostream* out) { *out << method->name; }

inline std::string test_name(const testing::TestParamInfo<const IntersectMethod*>& the_test) {
  return identifier(the_test.param->name);
}

}  // namespace raycheck::fast
