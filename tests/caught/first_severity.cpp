#include "tests/caught/first_severity.h"

#include "properties/truth.h"
#include "tests/caught/places.h"

namespace raycheck::caught {

using mutants::Mutant;

std::vector<FirstCaught> first_caught(const CaseSource& source, std::span<const Mutant> mutants) {
  std::vector<FirstCaught> result;
  for (const Mutant& mutant : mutants) {
    for (const std::string_view name : mutant.caught_by) {
      const Law* const law = properties::find_law(name);
      if (law == nullptr) throw std::invalid_argument("no law is called " + std::string(name));
      if (suits(*law, source)) result.push_back({&mutant, law});
    }
  }
  for (const properties::ChosenSource& place : places_of(source, kFewSeverities)) {
    for_each_case(place, kMutantCases, [&](int, const Case& the_case) {
      properties::SharedTruths truths(the_case);
      std::optional<Trial> trial;
      const Mutant* asked = nullptr;
      bool all_are_caught = true;
      for (FirstCaught& row : result) {
        if (row.severity) continue;
        if (asked != row.mutant) {
          asked = row.mutant;
          const auto conventions = asked->candidate.declared.over(the_case.scene.conventions);
          trial.emplace(the_case, asked->candidate,
                        properties::TrialOptions{.truth = truths.under(conventions)});
        }
        if (apply(*row.law, *trial).holds()) {
          all_are_caught = false;
        } else {
          row.severity = place.severity.value_or(0);
        }
      }
      return !all_are_caught;
    });
  }
  return result;
}

}  // namespace raycheck::caught
