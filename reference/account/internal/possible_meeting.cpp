#include "reference/account/internal/possible_meeting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/account/internal/answer_decider.h"
#include "reference/internal/ray_impl.h"

namespace raycheck::reference {
namespace {

/// Lifts doubles to intervals of their possible changes.
struct ChangedIntervalLift {
  using Kernel = IntervalKernel;

  explicit ChangedIntervalLift(double change) : factor(Interval(1) + Interval(-change, change)) {}
  Interval operator()(double value) const { return Interval(value) * factor; }
  Interval constant(double value) const { return Interval(value); }

  Interval factor;
};

/// Whether a ray of the neighbourhood may hit or miss a sphere, and bounds on s times a positive
/// number that depends only on the ray.
struct PossibleMeeting {
  bool may_hit = false;
  bool may_miss = true;
  double earliest = std::numeric_limits<double>::infinity();
  double latest = 0;
};

/// Bounds on the largest |coordinate|.
Interval largest(const IntervalKernel::Vector_3& v) {
  const Interval size[] = {CGAL::abs(v.x()), CGAL::abs(v.y()), CGAL::abs(v.z())};
  return {std::max({size[0].inf(), size[1].inf(), size[2].inf()}),
          std::max({size[0].sup(), size[1].sup(), size[2].sup()})};
}

/// How a ray may meet a sphere. A tangent counts as a possible hit and a possible miss.
PossibleMeeting possible_meeting(const LineAndSphere<IntervalKernel>& pair, scene::Root root) {
  const Interval squared_root = discriminant(pair);
  if (squared_root.sup() < 0) return {};
  const Interval c = constant_coefficient(pair);
  const Interval b = linear_coefficient(pair);
  const Interval half = CGAL::sqrt(squared_root);
  const bool is_nearest = root == scene::Root::kNearest;
  PossibleMeeting meeting;
  meeting.may_miss = !(squared_root.inf() > 0) || (!(c.inf() > 0) && !is_nearest) ||
                     (!(c.sup() < 0) && !(b.inf() > 0));
  const auto may_be_at = [&](const Interval& s) {
    meeting.may_hit = true;
    // If intervals overflow, a bound may be NaN; 0 or infinity is then used.
    meeting.earliest = std::min(meeting.earliest, s.inf() >= 0 ? s.inf() : 0);
    meeting.latest = s.sup() >= meeting.latest   ? s.sup()
                     : s.sup() <= meeting.latest ? meeting.latest
                                                 : std::numeric_limits<double>::infinity();
  };
  if (!(c.sup() < 0) && !(b.sup() < 0)) may_be_at(b - half);
  if (!(c.inf() > 0) && is_nearest) may_be_at(b + half);
  return meeting;
}

}  // namespace

bool is_far_from_right(const ExactRay& ray, const scene::Sphere& sphere,
                       const Neighbourhood& around, const std::optional<double>& answer) {
  const IntervalGuard guard;
  const ChangedIntervalLift lift(around.relative_change);
  const auto line = line_of(lift, ray.source());
  const auto pair = line_and_sphere(line, lift_sphere(lift, sphere));
  const PossibleMeeting meeting = possible_meeting(pair, around.root);
  if (!answer) return !meeting.may_miss;
  if (!meeting.may_hit) return true;
  const Interval s(*answer);
  const Interval length = line.is_unit ? ray_length(line) : Interval(1);
  const Interval roots = Interval(meeting.earliest, meeting.latest) * length / line.a;
  const bool is_beyond = s.inf() > roots.sup();
  const Interval gap = is_beyond ? s - Interval(roots.sup()) : Interval(roots.inf()) - s;
  const Interval scale = line.is_unit ? Interval(1) : largest(line.g);
  const Interval slack = (s + largest(to_centre(pair)) / scale) * Interval(around.relative_change);
  // A function that is 0 at a root varies by at most half of the interval's width.
  const Interval at_answer = value_of(Decider::kAtAnswer, pair, s);
  const Interval reach = Interval(at_answer.sup()) - Interval(at_answer.inf());
  const Interval apart = gap / length;
  return gap.inf() > slack.sup() && (line.a * apart * apart).inf() > reach.sup();
}

Contenders contenders(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                      const Neighbourhood& around, const FirstMet& claim) {
  const IntervalGuard guard;
  const ChangedIntervalLift lift(around.relative_change);
  const auto line = line_of(lift, ray.source());
  std::vector<PossibleMeeting> meetings;
  meetings.reserve(spheres.size());
  // A sphere behind the first certain hit is not met first.
  double end = std::numeric_limits<double>::infinity();
  const bool has_favourite = claim.what == FirstMet::What::kSphere;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const auto sphere = lift_sphere(lift, spheres[k]);
    meetings.push_back(possible_meeting(line_and_sphere(line, sphere), around.root));
    if (!meetings[k].may_miss && !(has_favourite && k == claim.sphere)) {
      end = std::min(end, meetings[k].latest);
    }
  }
  const bool is_hit_throughout = end < std::numeric_limits<double>::infinity();
  Contenders result;
  for (std::size_t k = 0; k < meetings.size(); ++k) {
    const bool is_too_late = has_favourite && meetings[k].earliest > meetings[claim.sphere].latest;
    if (meetings[k].may_hit && !is_too_late) result.spheres.push_back(k);
  }
  switch (claim.what) {
    case FirstMet::What::kNothing:
      if (result.spheres.empty()) result.is_right = true;
      if (is_hit_throughout) result.is_right = false;
      break;
    case FirstMet::What::kSomething:
      if (result.spheres.empty()) result.is_right = false;
      if (is_hit_throughout) result.is_right = true;
      break;
    default: {
      const PossibleMeeting& favourite = meetings[claim.sphere];
      if (!favourite.may_hit || favourite.earliest > end) result.is_right = false;
      if (result.spheres.size() == 1 && !favourite.may_miss) result.is_right = true;
    }
  }
  return result;
}

}  // namespace raycheck::reference
