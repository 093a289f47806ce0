#ifndef RAYCHECK_TESTS_DULL_HASH_H_
#define RAYCHECK_TESTS_DULL_HASH_H_

#include <bit>
#include <cstdint>
#include <initializer_list>

#include "properties/cases/random.h"

namespace raycheck::dull {

/// Random numbers that depend on what was asked alone.
inline properties::Random random_of(std::initializer_list<double> asked) {
  std::uint64_t sum = 0;
  for (const double x : asked)
    sum = properties::Random(sum ^ std::bit_cast<std::uint64_t>(x)).bits();
  return properties::Random(sum);
}

}  // namespace raycheck::dull

#endif  // RAYCHECK_TESTS_DULL_HASH_H_
