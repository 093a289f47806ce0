#pragma once

#include "properties/candidate.h"
#include "tests/standard.h"

namespace raycheck::mutants {

// The types of mutants.
using namespace properties;
using namespace scene;

/// The candidate `direct/cross` with one classic mistake; or `certified`, if only that candidate
/// makes the promise that is broken.
struct Mutant {
  std::string_view sentence;
  /// The laws that must catch it.
  std::vector<std::string_view> caught_by;
  properties::Candidate candidate;
  /// The level at which they catch it.
  properties::Level level = properties::Level::kOrdinary;
};

/// The candidate from which the mutants are made; also under another name.
properties::Candidate unmutated();
properties::Candidate named(std::string name);

/// The mutant, with this name, that makes a classic mistake of properties/mistakes/mistakes.h.
/// Throws std::invalid_argument if no mistake has this sentence.
Mutant from_mistake(std::string name, std::string_view sentence,
                    std::vector<std::string_view> caught_by);

/// The errors of a careful candidate; none by default.
struct Fault {
  double s = 0;        ///< s times 1 + this
  double Q = 0;        ///< Q moved by this share of its distance from the world's origin
  double D = 0;        ///< directions turned by this
  double epsilon = 0;  ///< hits whose s is less than this are dropped
  double band = 0;     ///< hit and miss are exchanged if |b - r| < band r, b the impact parameter
};

/// The candidate from which mutants are made, with a fault. (Without a fault, it breaks no law.)
properties::Candidate careful_candidate(std::string name, const Fault& fault);

/// Every mutant; the names of their candidates differ.
std::vector<Mutant> all_mutants();

/// Concatenates lists.
template <class One>
std::vector<One> joined(std::initializer_list<std::vector<One>> lists) {
  std::vector<One> all;
  for (const std::vector<One>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

// The mutants by stage, each list in the file of its name.
std::vector<Mutant> camera_mutants();
std::vector<Mutant> intersect_mutants();
std::vector<Mutant> plan_mutants();
std::vector<Mutant> pick_mutants();

/// direct/cross as code that only picks.
properties::Candidate picking_candidate();

}  // namespace raycheck::mutants
