#pragma once

// Which spheres matter to what a ray of a neighbourhood meets first, by intervals. Internal to
// reference/.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "reference/account/nearby_choice.h"

namespace raycheck::reference {

/// Whether a claim is right all over a neighbourhood, or nowhere, where intervals tell; and the
/// spheres that may make it wrong somewhere, or right: all others have no say.
struct Contenders {
  std::optional<bool> is_right;
  std::vector<std::size_t> spheres;
};

Contenders contenders(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                      const Neighbourhood& around, const FirstMet& claim);

}  // namespace raycheck::reference
