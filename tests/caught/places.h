#pragma once

#include "properties/cases/case_source.h"
#include "properties/cases/random.h"
#include "properties/laws/law.h"
#include "tests/standard.h"

namespace raycheck::caught {

/// The number of severities of a source in the tables by severity.
inline constexpr int kFewSeverities = 18;

/// A source at each severity that is judged, the lowest first; a source without severities once.
inline std::vector<properties::ChosenSource> places_of(const properties::CaseSource& source,
                                                       int most = properties::kMostSeverities) {
  if (!source.severities) return {{&source, std::nullopt}};
  std::vector<properties::ChosenSource> places;
  for (const int severity : properties::some_severities(0, source.severities->highest, most)) {
    places.push_back({&source, severity});
  }
  return places;
}

/// Whether a law applies to cases of a source.
inline bool suits(const properties::Law& law, const properties::CaseSource& source) {
  return source.has_camera || !properties::is_about_cameras(law);
}

/// Calls visit(number, case) for the cases of a place as long as it returns true. The cases are
/// always the same.
template <class Visit>
void for_each_case(const properties::ChosenSource& place, int cases, Visit visit) {
  properties::Random seeds(1);
  for (int k = 0; k < cases; ++k) {
    if (!visit(k, place.make(seeds.bits()))) return;
  }
}

}  // namespace raycheck::caught
