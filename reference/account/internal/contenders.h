#pragma once

// Which spheres affect what a ray of a neighbourhood meets first, by intervals. Internal to
// reference/.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "reference/account/nearby_choice.h"

namespace raycheck::reference {

/// Whether a claim is right everywhere in a neighbourhood, or nowhere, if intervals can tell; and
/// the spheres that may make it wrong or right somewhere: the others do not matter.
struct Contenders {
  std::optional<bool> is_right;
  std::vector<std::size_t> spheres;
};

Contenders contenders(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                      const Neighbourhood& around, const FirstMet& claim);

}  // namespace raycheck::reference
