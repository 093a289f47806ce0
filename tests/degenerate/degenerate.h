#pragma once

#include "properties/candidate.h"
#include "properties/cases/random.h"
#include "tests/standard.h"

namespace raycheck::degenerate {

// The types of degenerate candidates.
using namespace properties;
using namespace scene;

/// A candidate that is right except for one part, which computes nothing from its input.
struct Degenerate {
  std::string_view sentence;
  /// The laws that must be broken whenever its answers differ from the right ones.
  std::vector<std::string_view> broken_by;
  properties::Candidate candidate;
};

/// Every degenerate candidate, each made from the right one; their names differ.
std::vector<Degenerate> all_degenerate(const properties::Candidate& right);

// The degenerate candidates by their degenerate part, each list in the file of its name.
std::vector<Degenerate> degenerate_hits(const properties::Candidate& right);
std::vector<Degenerate> degenerate_rays(const properties::Candidate& right);
std::vector<Degenerate> degenerate_scenes(const properties::Candidate& right);

/// A candidate under another name.
inline Candidate renamed(Candidate candidate, std::string name) {
  candidate.name = std::move(name);
  return candidate;
}

/// Concatenates lists.
inline std::vector<Degenerate> joined(std::vector<Degenerate> all,
                                      std::initializer_list<std::vector<Degenerate>> lists) {
  for (const std::vector<Degenerate>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// A stream of random numbers that depends only on the question.
inline properties::Random random_of(std::initializer_list<double> asked) {
  std::uint64_t sum = 0;
  for (const double x : asked)
    sum = properties::Random(sum ^ std::bit_cast<std::uint64_t>(x)).bits();
  return properties::Random(sum);
}

}  // namespace raycheck::degenerate
