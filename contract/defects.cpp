#include <cmath>

#include "contract/declarations.h"

namespace raycheck::contract {

std::vector<scene::Defect> defects(const Declarations& declared) {
  std::vector<scene::Defect> found =
      scene::defects(declared.conventions.over(scene::Conventions{}));
  const auto& [smallest, largest] = declared.lengths;
  if (!(smallest >= 0 && std::isfinite(smallest) && smallest <= largest)) {
    std::string range;
    append(range, declared.lengths);
    found.push_back({"lengths", range, "must be two numbers from 0 on, the smaller one first"});
  }
  for_each_tolerance(declared.tolerances, [&](const char* name, double size, auto /*meaning*/) {
    if (size >= 0 && std::isfinite(size)) return;
    found.push_back({name, scene::shortest(size), "must be a finite number from 0 on"});
  });
  if (declared.interface.rays == RayForm::kEnd &&
      declared.interface.directions == Directions::kUnit) {
    found.push_back({"rays", "end", "cannot be combined with directions unit"});
  }
  const auto& valid = declared.conventions.valid;
  const auto& [from_inside, returns] =
      std::pair(declared.interface.from_inside, declared.interface.returns);
  if (from_inside != FromInside::kRoot &&
      (!valid || valid->t_min > 0 || returns == Returns::kRoots)) {
    found.push_back({"from_inside", std::string(name(from_inside)),
                     "cannot be combined with roots as-asked, t_min above 0 or returns roots"});
  }
  if (from_inside == FromInside::kNearRoot && returns == Returns::kSquaredDistance) {
    found.push_back({"from_inside", "near-root",
                     "cannot be combined with returns squared-distance, which has no sign"});
  }
  return found;
}

}  // namespace raycheck::contract
