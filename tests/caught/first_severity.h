#pragma once

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tests/mutants/mutants.h"
#include "tests/standard.h"

namespace raycheck::caught {

/// The number of cases of a severity that must catch a mutant: the default of a campaign.
inline constexpr int kMutantCases = 100;

/// The first severity at which a law catches a mutant that it must catch.
struct FirstCaught {
  const mutants::Mutant* mutant;
  const properties::Law* law;
  /// The lowest of kFewSeverities severities, or 0 for a source without severities; empty if it is
  /// not caught.
  std::optional<int> severity = {};
};

/// The results for every mutant and each of its laws that suits the source.
std::vector<FirstCaught> first_caught(const properties::CaseSource& source,
                                      std::span<const mutants::Mutant> mutants);

}  // namespace raycheck::caught
