#pragma once

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tests/mutants/mutants.h"
#include "tests/standard.h"

namespace raycheck::caught {

/// So many cases of a severity are to catch a mutant: as many as a campaign has by default.
inline constexpr int kMutantCases = 100;

/// Where a law first catches a mutant that it is to catch.
struct FirstCaught {
  const mutants::Mutant* mutant;
  const properties::Law* law;
  /// The lowest of kFewSeverities, or 0 of a source without a dial; empty: at none.
  std::optional<int> severity = {};
};

/// Every mutant with each of its laws that suits the source.
std::vector<FirstCaught> first_caught(const properties::CaseSource& source,
                                      std::span<const mutants::Mutant> mutants);

}  // namespace raycheck::caught
