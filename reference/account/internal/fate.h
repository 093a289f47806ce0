#pragma once

// What may become of a ray and a sphere in a neighbourhood, by intervals. Internal to reference/.

#include <limits>
#include <optional>

#include "reference/account/nearby_answer.h"
#include "reference/internal/ray_impl.h"

namespace raycheck::reference {

/// Lifts doubles to the intervals that they may lie in.
struct ChangedIntervalLift {
  using Kernel = IntervalKernel;

  explicit ChangedIntervalLift(double change) : factor(Interval(1) + Interval(-change, change)) {}
  Interval operator()(double value) const { return Interval(value) * factor; }
  Interval constant(double value) const { return Interval(value); }

  Interval factor;
};

/// What a sphere may be to a ray of the neighbourhood, and where it may be met: bounds of s times a
/// positive number of the ray's own.
struct Fate {
  bool may_hit = false;
  bool may_miss = true;
  double earliest = std::numeric_limits<double>::infinity();
  double latest = 0;
};

/// What touches may be either.
Fate fate_of(const LineAndSphere<IntervalKernel>& pair, scene::Root root);

/// Whether intervals show that an answer, as right_nearby has it, is right nowhere.
bool is_far_from_right(const ExactRay& ray, const scene::Sphere& sphere,
                       const Neighbourhood& around, const std::optional<double>& answer);

}  // namespace raycheck::reference
