#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "properties/case.h"
#include "scene/precision.h"

namespace raycheck::properties {

/// A case in the format that a candidate is judged in. It replaces the case before truth, law and
/// candidate see it, so that all three use the same numbers.
struct RoundedCase {
  std::optional<Case> the_case;  ///< Empty where it is left out.
  std::string reason;            ///< Why it is left out.
  std::size_t changed = 0;       ///< How many numbers of the scene had to be rounded.
};

/// Every number of the scene rounded to the format, to nearest, ties to even. Left out if a number
/// leaves the format's range (becomes infinite, or 0), or if the rounded scene has a defect.
RoundedCase rounded_case(Case the_case, scene::Precision precision);

/// The ray, rounded to the format.
scene::Ray rounded_ray(scene::Ray ray, scene::Precision precision);

/// Whether every number of the scene is representable in the format.
bool is_of_format(const scene::Scene& scene, scene::Precision precision);

}  // namespace raycheck::properties
