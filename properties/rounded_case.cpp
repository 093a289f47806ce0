#include "properties/rounded_case.h"

#include <cmath>
#include <utility>

#include "scene/number.h"
#include "scene/scene_scalars.h"
#include "scene/validate.h"

namespace raycheck::properties {

using scene::Precision;

RoundedCase rounded_case(Case the_case, Precision precision) {
  RoundedCase result;
  if (precision == Precision::kDouble) {
    result.the_case = std::move(the_case);
    return result;
  }
  for_each_number(the_case.scene, [&](double& x) {
    const double rounded = scene::rounded_to(precision, x);
    if (rounded == x) return;
    ++result.changed;
    const bool is_lost = !std::isfinite(rounded) || rounded == 0;
    if (is_lost && result.reason.empty()) {
      result.reason = "rounded to floats: " + scene::shortest(x) + " leaves their range";
    }
    x = rounded;
  });
  if (the_case.scene.camera) the_case.scene.camera->far.reset();
  if (!result.reason.empty()) return result;
  const auto defects = scene::defects(the_case.scene);
  if (!defects.empty()) {
    result.reason = "rounded to floats: " + defects.front().field + " = " + defects.front().value +
                    ": " + defects.front().what;
    return result;
  }
  result.the_case = std::move(the_case);
  return result;
}

bool is_of_format(const scene::Scene& scene, Precision precision) {
  if (precision == Precision::kDouble) return true;
  bool all = true;
  scene::Scene copy = scene;
  for_each_number(copy,
                  [&](const double& x) { all = all && scene::rounded_to(precision, x) == x; });
  return all;
}

}  // namespace raycheck::properties
