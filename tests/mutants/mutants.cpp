#include "tests/mutants/mutants.h"

#include <iterator>
#include <utility>

#include "properties/fast_candidate.h"

namespace raycheck::mutants {

properties::Candidate unmutated() {
  return properties::fast_candidate(fast::kDirectRays, fast::kCross);
}

std::vector<Mutant> all_mutants() {
  std::vector<Mutant> all = camera_mutants();
  for (std::vector<Mutant> more : {intersect_mutants(), plan_mutants()}) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace raycheck::mutants
