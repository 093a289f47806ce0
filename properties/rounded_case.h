#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "properties/candidate.h"
#include "properties/case.h"
#include "scene/precision.h"

namespace raycheck::properties {

/// A case in the numbers that a candidate is asked about. It replaces the case before truth, law and
/// candidate see it, so that all three use the same numbers.
struct RoundedCase {
  std::optional<Case> the_case;  ///< Empty where it is left out.
  std::string reason;            ///< Why it is left out.
  std::size_t changed = 0;       ///< How many numbers of the scene had to be rounded.
  std::size_t made_unit = 0;     ///< And how many given directions to be made unit.
};

/// Every number of the scene rounded to the format, to nearest, ties to even, after given directions
/// have been made unit where they have to be and are not. Left out if a number leaves the format's
/// range (becomes infinite, or 0), or if the rounded scene has a defect.
RoundedCase rounded_case(Case the_case, InputFormat format);

/// The ray, rounded to the format.
scene::Ray rounded_ray(scene::Ray ray, InputFormat format);

/// Whether rounded_case() leaves the scene as it is.
bool is_of_format(const scene::Scene& scene, InputFormat format);

}  // namespace raycheck::properties
