#pragma once

#include <limits>

#include "scene/precision.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// Where a candidate promises anything: nonzero lengths lie between these.
struct Domain {
  double smallest_length = 0;
  double largest_length = std::numeric_limits<double>::infinity();
  /// Lengths of scenes with a camera must also lie between these.
  double smallest_camera_length = 0;
  double largest_camera_length = std::numeric_limits<double>::infinity();
};

/// Results for smaller lengths may be subnormal, with too few digits for any bound relative to
/// their size.
inline constexpr double kSmallestJudgedLength = 0x1p-960;

/// Products of four lengths, such as |T x D|^2, stay normal floats for lengths between these:
/// outside, nothing is judged in single precision.
inline constexpr double kSmallestSingleLength = 0x1p-30;
inline constexpr double kLargestSingleLength = 0x1p30;

/// A domain cut to the lengths that are judged in a format.
Domain judged_in(scene::Precision precision, Domain domain);

/// True when every nonzero length of the scene lies in [smallest, largest]; for a sphere of radius
/// 0 its distance counts as one.
bool lengths_are_within(const scene::Scene& scene, double smallest, double largest);

/// True when the scene lies in the domain.
bool is_inside_domain(const Domain& domain, const scene::Scene& scene);

}  // namespace raycheck::properties
