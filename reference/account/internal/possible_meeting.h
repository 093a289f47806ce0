#pragma once

// Finds by intervals how rays of a neighbourhood may meet spheres. Internal to reference/.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "reference/account/nearby_choice.h"

namespace raycheck::reference {

/// Whether intervals show that an answer is right nowhere in the neighbourhood (see right_nearby).
bool is_far_from_right(const ExactRay& ray, const scene::Sphere& sphere,
                       const Neighbourhood& around, const std::optional<double>& answer);

/// Whether a claim is right everywhere or nowhere in a neighbourhood, if intervals can decide; and
/// the spheres that may make the claim wrong or right somewhere.
struct Contenders {
  std::optional<bool> is_right;
  std::vector<std::size_t> spheres;
};

Contenders contenders(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                      const Neighbourhood& around, const FirstMet& claim);

}  // namespace raycheck::reference
