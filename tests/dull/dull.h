#pragma once

#include "properties/candidate.h"
#include "properties/cases/random.h"
#include "tests/standard.h"

namespace raycheck::dull {

// What they are made of.
using namespace properties;
using namespace scene;

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

/// A candidate under another name.
inline Candidate renamed(Candidate candidate, std::string name) {
  candidate.name = std::move(name);
  return candidate;
}

/// Lists, one after the other.
inline std::vector<Dull> joined(std::vector<Dull> all,
                                std::initializer_list<std::vector<Dull>> lists) {
  for (const std::vector<Dull>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Random numbers that depend on what was asked alone.
inline properties::Random random_of(std::initializer_list<double> asked) {
  std::uint64_t sum = 0;
  for (const double x : asked)
    sum = properties::Random(sum ^ std::bit_cast<std::uint64_t>(x)).bits();
  return properties::Random(sum);
}

}  // namespace raycheck::dull
