#include "reference/internal/contenders.h"

#include <algorithm>
#include <limits>

#include "reference/internal/ray_impl.h"

namespace raycheck::reference {
namespace {

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
Fate fate_of(const LineAndSphere<IntervalKernel>& pair, scene::Root root) {
  const Interval squared_root = discriminant(pair);
  if (squared_root.sup() < 0) return {};
  const Interval c = constant_coefficient(pair);
  const Interval b = linear_coefficient(pair);
  const Interval half = CGAL::sqrt(squared_root);
  const bool is_nearest = root == scene::Root::kNearest;
  Fate fate;
  fate.may_miss = !(squared_root.inf() > 0) || (!(c.inf() > 0) && !is_nearest) ||
                  (!(c.sup() < 0) && !(b.inf() > 0));
  const auto may_be_at = [&](const Interval& s) {
    fate.may_hit = true;
    // A bound that is no number, where intervals overflow, is none.
    fate.earliest = std::min(fate.earliest, s.inf() >= 0 ? s.inf() : 0);
    fate.latest = s.sup() >= fate.latest   ? s.sup()
                  : s.sup() <= fate.latest ? fate.latest
                                           : std::numeric_limits<double>::infinity();
  };
  if (!(c.sup() < 0) && !(b.sup() < 0)) may_be_at(b - half);
  if (!(c.inf() > 0) && is_nearest) may_be_at(b + half);
  return fate;
}

}  // namespace

Contenders contenders(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                      const Neighbourhood& around, const FirstMet& claim) {
  const IntervalGuard guard;
  const ChangedIntervalLift lift(around.relative_change);
  const auto line = lifted_line(lift, ray.source());
  std::vector<Fate> fates;
  fates.reserve(spheres.size());
  // Behind the first that is certainly hit nothing is first.
  double end = std::numeric_limits<double>::infinity();
  const bool has_favourite = claim.what == FirstMet::What::kSphere;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const auto sphere = lift_sphere<IntervalKernel>(lift, spheres[k]);
    fates.push_back(fate_of(line_and_sphere(line, sphere), around.root));
    if (!fates[k].may_miss && !(has_favourite && k == claim.sphere)) {
      end = std::min(end, fates[k].latest);
    }
  }
  const bool is_hit_throughout = end < std::numeric_limits<double>::infinity();
  Contenders result;
  for (std::size_t k = 0; k < fates.size(); ++k) {
    const bool is_too_late = has_favourite && fates[k].earliest > fates[claim.sphere].latest;
    if (fates[k].may_hit && !is_too_late) result.spheres.push_back(k);
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
      const Fate& favourite = fates[claim.sphere];
      if (!favourite.may_hit || favourite.earliest > end) result.is_right = false;
      if (result.spheres.size() == 1 && !favourite.may_miss) result.is_right = true;
    }
  }
  return result;
}

}  // namespace raycheck::reference
