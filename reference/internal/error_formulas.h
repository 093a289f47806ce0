#pragma once

// The formulas of reference/error_measure.h and reference/ray_error.h for all number types.
// Internal to reference/.

#include "reference/internal/kernels.h"
#include "reference/near_error.h"

namespace raycheck::reference {

/// The tangent of the angle between two directions. The exact one is unit; the cosine is given.
template <class Number>
Number tangent(const Triple<Number>& given, const Triple<Number>& exact, const Number& cosine) {
  return norm(cross(given, exact)) / cosine;
}

/// | |given| - 1 |
template <class Number>
Number distance_from_unit(const Triple<Number>& given) {
  return abs(norm(given) - Number(1));
}

/// | |point - centre| - radius | / radius
template <class Number>
Number distance_from_sphere(const Triple<Number>& point, const Triple<Number>& centre,
                            const Number& radius) {
  return abs(norm(point - centre) - radius) / radius;
}

/// |along x D| / |along|
template <class Number>
Number distance_from_line(const Triple<Number>& along, const Triple<Number>& direction) {
  return norm(cross(along, direction)) / norm(along);
}

}  // namespace raycheck::reference
