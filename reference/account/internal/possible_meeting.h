#pragma once

// How a ray and a sphere may meet in a neighbourhood, by intervals. Internal to reference/.

#include <limits>
#include <optional>

#include "reference/account/nearby_answer.h"
#include "reference/internal/ray_impl.h"

namespace raycheck::reference {

/// Lifts doubles to intervals of their possible changes.
struct ChangedIntervalLift {
  using Kernel = IntervalKernel;

  explicit ChangedIntervalLift(double change) : factor(Interval(1) + Interval(-change, change)) {}
  Interval operator()(double value) const { return Interval(value) * factor; }
  Interval constant(double value) const { return Interval(value); }

  Interval factor;
};

/// Whether a ray of the neighbourhood may hit or miss a sphere, and where: bounds of s times a
/// positive number that depends on the ray only.
struct PossibleMeeting {
  bool may_hit = false;
  bool may_miss = true;
  double earliest = std::numeric_limits<double>::infinity();
  double latest = 0;
};

/// A tangent may be either.
PossibleMeeting possible_meeting(const LineAndSphere<IntervalKernel>& pair, scene::Root root);

/// Whether intervals show that an answer, in the sense of right_nearby, is right nowhere.
bool is_far_from_right(const ExactRay& ray, const scene::Sphere& sphere,
                       const Neighbourhood& around, const std::optional<double>& answer);

}  // namespace raycheck::reference
