#pragma once

// The laws by subject, each defined in the file of that name. Internal to the laws.

#include <span>
#include <vector>

#include "properties/laws/law.h"
#include "reference/error_measure.h"

namespace raycheck::properties {

using reference::enclose_exactly;
using reference::Enclosure;
using reference::Enclosure3;
using reference::in_units_of_u;

extern const std::span<const Law> kFrameLaws;          // camera_frame.cpp
extern const std::span<const Law> kPixelPlaneLaws;     // pixel_plane.cpp
extern const std::span<const Law> kPixelRayLaws;       // pixel_ray.cpp
extern const std::span<const Law> kIntersectLaws;      // intersect.cpp
extern const std::span<const Law> kNearestSphereLaws;  // nearest_sphere.cpp
extern const std::span<const Law> kPlanLaws;           // plan.cpp
extern const std::span<const Law> kMetamorphicLaws;    // metamorphic.cpp
extern const std::span<const Law> kRefusalLaws;        // refusal.cpp

/// The term that the textbook's formula adds to the condition number of s. It is 0 if the candidate
/// promises more than ordinary cases, and beyond kOrdinaryDistance.
double plain_condition(const Candidate& candidate, const ExactRay& ray, const Sphere& sphere,
                       const Intersection& at);

/// The term that the lecture's P - E, with P computed as E + n W + ..., adds to the condition
/// number of D. It is 0 if the candidate promises more than ordinary cases, and beyond
/// kOrdinaryDistance.
double plain_condition(const Candidate& candidate, const ExactRay& ray);

/// The coordinates as a list, for reports.
template <class Triple>
std::vector<double> numbers(const Triple& value) {
  return {value.x, value.y, value.z};
}

/// Describes an answer and the exact one, which is computed only for a discrepancy.
template <class Answer, class Exact>
auto shown(const Answer& got, const Exact& exact) {
  return [&got, exact](Discrepancy& d) {
    d.got = numbers(got);
    d.exact = numbers(exact());
  };
}

}  // namespace raycheck::properties
