#pragma once

// Finds an intersection from the signs of coefficients. Internal to reference/.

#include <optional>

#include "reference/exact_ray.h"
#include "reference/internal/formulas.h"

namespace raycheck::reference {

enum class Coefficient { kDiscriminant, kConstant, kLinear };

template <class K>
typename K::FT coefficient_of(Coefficient coefficient, const LineAndSphere<K>& pair) {
  switch (coefficient) {
    case Coefficient::kDiscriminant:
      return discriminant(pair);
    case Coefficient::kConstant:
      return constant_coefficient(pair);
    default:
      return linear_coefficient(pair);
  }
}

template <class K>
std::optional<int> sign_of(Coefficient coefficient, const LineAndSphere<K>& pair) {
  return certain_sign(coefficient_of(coefficient, pair));
}

/// The intersection from the signs of three coefficients, each computed only if it matters; empty
/// if a sign that matters is not certain. If c < 0, the roots have opposite signs; if c > 0, both
/// have the sign of b; if c = 0, one of them is 0.
template <class Sign>
std::optional<Intersection> classify(Sign sign, scene::Root convention) {
  const Intersection miss{};
  const std::optional<int> discriminant_sign = sign(Coefficient::kDiscriminant);
  if (!discriminant_sign) return std::nullopt;
  if (*discriminant_sign < 0) return miss;
  const std::optional<int> c = sign(Coefficient::kConstant);
  if (!c) return std::nullopt;
  const HitClass hit = *discriminant_sign == 0 ? HitClass::kTangent : HitClass::kHit;
  const bool larger_counts = convention == scene::Root::kNearest;
  if (*c < 0) return larger_counts ? Intersection{hit, WhichRoot::kLarger} : miss;
  const std::optional<int> b = sign(Coefficient::kLinear);
  if (!b) return std::nullopt;
  if (*b > 0 || (*b == 0 && *c == 0)) return Intersection{hit, WhichRoot::kSmaller};
  if (*c == 0 && larger_counts) return Intersection{hit, WhichRoot::kLarger};
  return miss;
}

}  // namespace raycheck::reference
