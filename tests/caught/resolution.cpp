#include "tests/caught/resolution.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "properties/cases/random.h"
#include "properties/truth.h"
#include "tests/caught/places.h"

namespace raycheck::caught {
namespace {

using properties::Candidate;
using properties::Case;
using properties::CaseSource;
using properties::Law;
using properties::Trial;

/// The candidates of one kind of error, the largest first.
std::vector<Candidate> injected(const ErrorKind& kind, const ExactParts& exact) {
  std::vector<Candidate> candidates;
  for (int k = 0; k <= kind.smallest; ++k) {
    candidates.push_back(kind.inject(exact, std::pow(double(kind.base), -k)));
  }
  return candidates;
}

/// One kind of error, and what the laws that may notice it noticed so far.
struct Ladder {
  std::vector<Candidate> candidates;
  std::vector<Resolution> resolutions;
};

/// Goes down from the smallest error noticed so far, while the next is noticed.
void descend(const Law& law, const Case& the_case, const std::vector<Candidate>& candidates,
             properties::SharedTruths& truths, std::optional<int>& noticed) {
  for (std::size_t next = noticed ? std::size_t(*noticed) + 1 : 0; next < candidates.size();
       ++next) {
    Trial trial(the_case, candidates[next], {.truth = truths.under(the_case.scene.conventions)});
    if (apply(law, trial).holds()) return;
    noticed = static_cast<int>(next);
  }
}

}  // namespace

std::vector<Resolution> resolutions(const CaseSource& source, int cases,
                                    std::span<const ErrorKind* const> kinds,
                                    std::span<const Law* const> laws) {
  ExactParts exact;
  static_cast<properties::Domain&>(exact.candidate) = kRoundedDomain;
  std::vector<Ladder> ladders;
  for (const ErrorKind* kind : kinds) {
    Ladder ladder{injected(*kind, exact), {}};
    for (const std::string_view name : kind->laws) {
      const Law* const law = properties::find_law(name);
      if (law == nullptr) throw std::invalid_argument("no law is called " + std::string(name));
      const bool is_wanted = laws.empty() || std::find(laws.begin(), laws.end(), law) != laws.end();
      const bool is_asked = suits(*law, source) && (source.has_camera || !kind->of_rays_made);
      if (is_wanted && is_asked) ladder.resolutions.push_back({kind, law});
    }
    if (!ladder.resolutions.empty()) ladders.push_back(std::move(ladder));
  }
  properties::Random seeds(1);
  const auto places = places_of(source, kFewSeverities);
  for (int k = 0; k < cases; ++k) {
    const auto& place = places[static_cast<std::size_t>(k) % places.size()];
    const int severity = place.severity.value_or(0);
    const Case the_case = place.make(seeds.bits());
    *exact.looked_at = the_case.pixels;
    properties::SharedTruths truths(the_case);
    for (Ladder& ladder : ladders) {
      for (Resolution& resolution : ladder.resolutions) {
        const auto at = resolution.by_severity.find(severity);
        std::optional<int> noticed;
        if (at != resolution.by_severity.end()) noticed = at->second;
        descend(*resolution.law, the_case, ladder.candidates, truths, noticed);
        if (noticed) resolution.by_severity[severity] = *noticed;
      }
    }
  }
  std::vector<Resolution> result;
  for (Ladder& ladder : ladders) {
    for (Resolution& resolution : ladder.resolutions) {
      for (const auto& [severity, noticed] : resolution.by_severity) {
        resolution.noticed = std::max(resolution.noticed.value_or(noticed), noticed);
      }
      result.push_back(std::move(resolution));
    }
  }
  return result;
}

}  // namespace raycheck::caught
