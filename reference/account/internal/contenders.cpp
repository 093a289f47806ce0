#include "reference/account/internal/contenders.h"

#include <algorithm>
#include <limits>

#include "reference/account/internal/possible_meeting.h"

namespace raycheck::reference {
Contenders contenders(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                      const Neighbourhood& around, const FirstMet& claim) {
  const IntervalGuard guard;
  const ChangedIntervalLift lift(around.relative_change);
  const auto line = lifted_line(lift, ray.source());
  std::vector<PossibleMeeting> meetings;
  meetings.reserve(spheres.size());
  // Nothing behind the first certain hit is met first.
  double end = std::numeric_limits<double>::infinity();
  const bool has_favourite = claim.what == FirstMet::What::kSphere;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const auto sphere = lift_sphere<IntervalKernel>(lift, spheres[k]);
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
