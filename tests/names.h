#pragma once

// Names for tests of each element of a list.

#include "tests/testing.h"

namespace raycheck {

/// In the form that GoogleTest accepts.
inline std::string identifier(std::string_view name) {
  std::string result(name);
  std::replace(result.begin(), result.end(), '-', '_');
  return result;
}
inline std::string by_name(const testing::TestParamInfo<std::string>& the_test) {
  return identifier(the_test.param);
}

template <class List>
std::vector<std::string> names_of(const List& list) {
  std::vector<std::string> names;
  for (const auto& one : list) names.emplace_back(one.name);
  return names;
}

}  // namespace raycheck
