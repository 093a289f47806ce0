#pragma once

#include <optional>

#include "reference/exact_ray.h"
#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::reference {

/// How a ray meets a sphere, as decided by intervals of doubles.
struct IntervalIntersection {
  Intersection intersection;  ///< The exact one.
  // Bounds of s, for hits and tangents.
  double lower = 0;
  double upper = 0;
};

/// The first filter stage of ExactRay, intervals, and the bounds of s that it gives.
/// Shape:  a given ray and a sphere -> their intersection; empty where intervals do not decide.
/// Units:  s in multiples of the ray's direction.
/// Domain: every valid input; otherwise throws std::invalid_argument naming the field.
/// Error:  an intersection is exact, s lies within its bounds (infinite where intervals overflow).
/// Source: reference/internal/formulas.h.
std::optional<IntervalIntersection> intersect_by_intervals(const scene::Ray& ray,
                                                           const scene::Sphere& sphere,
                                                           scene::Root root);

/// The intersection that all rays and spheres of two boxes have in common, also after a relative
/// change of any of their numbers.
/// Shape:  a box of given rays, a box of spheres -> their intersection; empty where intervals do
///         not show that they have one in common.
/// Domain: boxes with valid ends (otherwise as above); 0 <= relative_change < 1.
/// Error:  exact.
/// Source: reference/internal/formulas.h.
std::optional<Intersection> intersection_in(const scene::Box<scene::Ray>& rays,
                                            const scene::Box<scene::Sphere>& spheres,
                                            double relative_change, scene::Root root);

}  // namespace raycheck::reference
