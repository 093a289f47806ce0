#pragma once

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "properties/candidate.h"
#include "properties/cases/random.h"

namespace raycheck::dull {

/// A right candidate, but for one part that does not compute what it is asked.
struct Dull {
  std::string_view sentence;
  /// The laws that break it wherever its answers differ from the right ones.
  std::vector<std::string_view> broken_by;
  properties::Candidate candidate;
};

/// Every dull candidate, each made from the right one; their names differ.
std::vector<Dull> all_dull(const properties::Candidate& right);

// The same by what is dull, each in the file of its name.
std::vector<Dull> dull_hits(const properties::Candidate& right);
std::vector<Dull> dull_rays(const properties::Candidate& right);
std::vector<Dull> dull_scenes(const properties::Candidate& right);

/// Random numbers that depend on what was asked alone.
inline properties::Random random_of(std::initializer_list<double> asked) {
  std::uint64_t sum = 0;
  for (const double x : asked)
    sum = properties::Random(sum ^ std::bit_cast<std::uint64_t>(x)).bits();
  return properties::Random(sum);
}

}  // namespace raycheck::dull
