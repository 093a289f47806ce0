#include "tests/mutants/mutants.h"

#include <iterator>
#include <stdexcept>
#include <utility>

#include "properties/mistakes/mistakes.h"
#include "tests/properties/cases/drawing.h"

namespace raycheck::mutants {

properties::Candidate unmutated() { return properties::drawing_candidate(); }

Mutant from_mistake(std::string name, std::string_view sentence,
                    std::vector<std::string_view> caught_by) {
  const properties::Mistake* const mistake = properties::find_mistake(sentence);
  if (mistake == nullptr) {
    throw std::invalid_argument("no mistake is called '" + std::string(sentence) + "'");
  }
  properties::Candidate candidate = unmutated();
  candidate.name = std::move(name);
  candidate.frame = mistake->candidate.frame;
  candidate.pixel_points = mistake->candidate.pixel_points;
  candidate.pixel_rays = mistake->candidate.pixel_rays;
  candidate.focal_rays = mistake->candidate.focal_rays;
  candidate.intersect = mistake->candidate.intersect;
  candidate.nearest = mistake->candidate.nearest;
  return {mistake->sentence, std::move(caught_by), std::move(candidate)};
}

std::vector<Mutant> all_mutants() {
  std::vector<Mutant> all = camera_mutants();
  for (std::vector<Mutant> more : {intersect_mutants(), plan_mutants()}) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace raycheck::mutants
