#ifndef RAYCHECK_TESTS_CAUGHT_PLACES_H_
#define RAYCHECK_TESTS_CAUGHT_PLACES_H_

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "properties/cases/case_source.h"
#include "properties/cases/random.h"
#include "properties/laws/law.h"

namespace raycheck::caught {

/// A source with more severities is looked at in some of them, evenly spaced, and in the last.
inline constexpr int kMostSeverities = 64;
inline constexpr int kFewSeverities = 17;

/// A source at each severity that is looked at, the lowest first; at none where it has no dial.
inline std::vector<properties::ChosenSource> places_of(const properties::CaseSource& source,
                                                       int most_severities = kMostSeverities) {
  if (!source.dial) return {{&source, std::nullopt}};
  const int highest = source.dial->highest;
  const int step = highest / most_severities + 1;
  std::vector<properties::ChosenSource> places;
  for (int severity = 0; severity < highest; severity += step) {
    places.push_back({&source, severity});
  }
  places.push_back({&source, highest});
  return places;
}

/// Whether a law has anything to say about cases of a source.
inline bool suits(const properties::Law& law, const properties::CaseSource& source) {
  return source.has_camera || !properties::speaks_of_cameras(law);
}

/// Calls visit(number, case) for so many cases of a place, the same every time, while it says true.
template <class Visit>
void for_each_case(const properties::ChosenSource& place, int cases, Visit visit) {
  properties::Random seeds(1);
  for (int k = 0; k < cases; ++k) {
    if (!visit(k, place.make(seeds.bits()))) return;
  }
}

}  // namespace raycheck::caught

#endif  // RAYCHECK_TESTS_CAUGHT_PLACES_H_
