#ifndef RAYCHECK_TESTS_MUTANTS_MUTANTS_H_
#define RAYCHECK_TESTS_MUTANTS_MUTANTS_H_

#include <string>
#include <string_view>
#include <vector>

#include "properties/candidate.h"

namespace raycheck::mutants {

/// The candidate `direct/cross`, or `certified` where it is about what that alone promises, with
/// one classic mistake.
struct Mutant {
  std::string_view sentence;
  /// The laws that must catch it.
  std::vector<std::string_view> caught_by;
  properties::Candidate candidate;
  /// The level at which they catch it.
  properties::Level level = properties::Level::kOrdinary;
};

/// The candidate that the mutants are made from.
properties::Candidate unmutated();

/// The mutant that makes a classic mistake of properties/mistakes/mistakes.h, under a name of its
/// own. Throws std::invalid_argument where no mistake has that sentence.
Mutant from_mistake(std::string name, std::string_view sentence,
                    std::vector<std::string_view> caught_by);

/// Every mutant; the names of their candidates differ.
std::vector<Mutant> all_mutants();

// The same by stage, each in the file of its name.
std::vector<Mutant> camera_mutants();
std::vector<Mutant> intersect_mutants();
std::vector<Mutant> plan_mutants();

}  // namespace raycheck::mutants

#endif  // RAYCHECK_TESTS_MUTANTS_MUTANTS_H_
