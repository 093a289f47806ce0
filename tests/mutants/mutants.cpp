#include "tests/mutants/mutants.h"

#include <iterator>
#include <utility>

#include "tests/properties/drawing.h"

namespace raycheck::mutants {

properties::Candidate unmutated() { return properties::drawing_candidate(); }

std::vector<Mutant> all_mutants() {
  std::vector<Mutant> all = camera_mutants();
  for (std::vector<Mutant> more : {intersect_mutants(), plan_mutants()}) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace raycheck::mutants
