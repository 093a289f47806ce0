#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "properties/case.h"
#include "properties/tally.h"

namespace raycheck::properties {

class Trial;
struct TrialPart;

/// How many failures of a candidate are searched for in failed batches, in all: each costs at most
/// two restarts per halving of a batch.
inline constexpr int kMostFailuresSought = 8;

/// A search for failures, shared by successive trials.
struct FailureSearch {
  int batches = 0;     ///< Batches that failed and were asked in parts.
  int found = 0;       ///< Rays, or rays with a sphere, that fail alone.
  int together = 0;    ///< Parts that fail, but whose halves are answered.
  int not_sought = 0;  ///< Batches, or parts, that failed once it was over.
  /// The messages of failures whatever is asked: each is reported once.
  std::set<std::string> whatever_asked = {};
  bool is_over() const { return found + together >= kMostFailuresSought; }
};

/// How many rays a trial asks about, or `by_sphere` rays with spheres.
std::uint64_t count_asked(const Trial& trial, bool by_sphere);

/// A trial that failed, asked in parts.
class FailedParts {
 public:
  /// The two halves of its rays, or of one ray's spheres, as trials of their own that are kept.
  /// Domain: more than one ray or sphere.
  const std::vector<std::shared_ptr<TrialPart>>& halves(const Trial& whole);
  bool is_halved() const { return !halves_.empty(); }
  /// Whether no law has met a failure of all of it in the same words.
  bool is_new(const std::string& failure) { return failures_.insert(failure).second; }

 private:
  std::vector<std::shared_ptr<TrialPart>> halves_;
  std::set<std::string> failures_;
};

}  // namespace raycheck::properties
