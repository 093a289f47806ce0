#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "properties/case.h"
#include "scene/precision.h"

namespace raycheck::properties {

/// A case in the format that a candidate is judged in. It takes the place of the case before truth,
/// law and candidate see it, so that all three speak of the same numbers.
struct RoundedCase {
  std::optional<Case> the_case;  ///< Empty where it is left out.
  std::string reason;            ///< Why it is.
  std::size_t changed = 0;       ///< How many numbers of the scene were none of the format.
};

/// Every number of the scene rounded to the format, to nearest, ties to even. Left out where a
/// number leaves the format's range (is infinite, or 0 and was not), and where the scene has a
/// defect then.
RoundedCase rounded_case(Case the_case, scene::Precision precision);

/// A ray whose numbers are of the format.
scene::Ray rounded_ray(scene::Ray ray, scene::Precision precision);

/// Whether every number of the scene is one of the format.
bool is_of_format(const scene::Scene& scene, scene::Precision precision);

}  // namespace raycheck::properties
