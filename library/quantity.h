#pragma once

// The values of a ray and a sphere that exact.h and batch.h give: enclosed, rounded, conditioned.

#include "contract/public_structs.h"
#include "reference/account/condition.h"
#include "reference/exact_ray.h"

namespace raycheck::library {

/// s, Q, D, the origin of a given ray, and P, which only cameras have.
enum class Quantity { kParameter, kPoint, kDirection, kOrigin, kPixelPoint };

/// A ray, and how it meets a sphere; D, P and the origin need only the ray.
struct Meeting {
  const reference::ExactRay& ray;
  const scene::Sphere& sphere;
  const reference::Intersection& at;
};

/// The coordinates; a number is x.
inline reference::Enclosure3 enclosed(Quantity quantity, const Meeting& of,
                                      int bits = reference::ExactRay::kValueBits) {
  switch (quantity) {
    case Quantity::kParameter:
      return {of.ray.parameter(of.sphere, of.at, bits), {}, {}};
    case Quantity::kPoint:
      return of.ray.point(of.sphere, of.at, bits);
    case Quantity::kDirection:
      return of.ray.direction(bits);
    case Quantity::kOrigin:
      return of.ray.origin(bits);
    default:
      return of.ray.pixel_point(bits);
  }
}

inline scene::Point3 rounded(Quantity quantity, const Meeting& of,
                             scene::Precision precision = scene::Precision::kDouble) {
  switch (quantity) {
    case Quantity::kParameter:
      return {of.ray.rounded_parameter(of.sphere, of.at, precision), 0, 0};
    case Quantity::kPoint:
      return of.ray.rounded_point(of.sphere, of.at, precision);
    case Quantity::kDirection:
      return contract::triple<scene::Point3>(of.ray.rounded_direction(precision));
    case Quantity::kOrigin:
      return of.ray.rounded_origin(precision);
    default:
      return of.ray.rounded_pixel_point(precision);
  }
}

/// Of a vector: for all coordinates.
inline double condition(Quantity quantity, const Meeting& of) {
  switch (quantity) {
    case Quantity::kParameter:
      return condition_of_parameter(of.ray, of.sphere, of.at);
    case Quantity::kPoint:
      return condition_of_point(of.ray, of.sphere, of.at);
    case Quantity::kDirection:
      return condition_of_direction(of.ray);
    case Quantity::kOrigin:
      return 1;
    default:
      return condition_of_pixel_point(of.ray);
  }
}

}  // namespace raycheck::library
