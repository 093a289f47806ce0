#pragma once

// How a ray of a neighbourhood may meet spheres, by intervals. Internal to reference/.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "reference/account/nearby_choice.h"

namespace raycheck::reference {

/// Whether intervals show that an answer, in the sense of right_nearby, is right nowhere.
bool is_far_from_right(const ExactRay& ray, const scene::Sphere& sphere,
                       const Neighbourhood& around, const std::optional<double>& answer);

/// Whether a claim is right everywhere in a neighbourhood, or nowhere, if intervals can decide; and
/// the spheres that may make it wrong or right somewhere.
struct Contenders {
  std::optional<bool> is_right;
  std::vector<std::size_t> spheres;
};

Contenders contenders(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                      const Neighbourhood& around, const FirstMet& claim);

}  // namespace raycheck::reference
