#pragma once

#include <optional>

#include "reference/exact_ray.h"
#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::reference {

/// How a ray meets a sphere, decided by intervals of doubles.
struct IntervalIntersection {
  Intersection intersection;  ///< Exact.
  // Bounds on s, for hits and tangents.
  double lower = 0;
  double upper = 0;
};

/// The first filter stage of ExactRay, intervals, with its bounds on s.
/// Shape:  a given ray and a sphere -> their intersection; empty if intervals do not decide.
/// Units:  s in multiples of the ray's direction.
/// Domain: every valid input; otherwise throws std::invalid_argument naming the field.
/// Error:  an intersection is exact; s lies within its bounds, which are infinite if intervals
///         overflow.
/// Source: reference/internal/formulas.h.
std::optional<IntervalIntersection> intersect_by_intervals(const scene::Ray& ray,
                                                           const scene::Sphere& sphere,
                                                           scene::Root root);

/// The intersection (class and root) that is the same for all rays and spheres of two boxes, also
/// after a relative change of their numbers.
/// Shape:  a box of given rays, a box of spheres -> their intersection; empty if intervals do not
///         show that it is the same for all.
/// Domain: boxes with valid ends; otherwise throws like intersect_by_intervals(). 0 <=
///         relative_change < 1.
/// Error:  exact.
/// Source: reference/internal/formulas.h.
std::optional<Intersection> intersection_in(const scene::Box<scene::Ray>& rays,
                                            const scene::Box<scene::Sphere>& spheres,
                                            double relative_change, scene::Root root);

}  // namespace raycheck::reference
