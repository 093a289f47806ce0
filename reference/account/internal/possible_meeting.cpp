#include "reference/account/internal/possible_meeting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

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

namespace {

/// The contenders among the spheres of these indices, for the rays that an interval line holds.
Contenders contenders_on(const Line<IntervalKernel>& line, std::span<const scene::Sphere> spheres,
                         std::span<const std::size_t> among, const Neighbourhood& around,
                         const FirstMet& claim) {
  const ChangedIntervalLift lift(around.relative_change);
  std::vector<PossibleMeeting> meetings;
  meetings.reserve(among.size());
  // A sphere behind the first certain hit is not met first.
  double end = std::numeric_limits<double>::infinity();
  PossibleMeeting favourite;
  const bool has_favourite = claim.what == FirstMet::What::kSphere;
  for (const std::size_t k : among) {
    const auto sphere = lift_sphere(lift, spheres[k]);
    meetings.push_back(possible_meeting(line_and_sphere(line, sphere), around.root));
    if (has_favourite && k == claim.sphere) {
      favourite = meetings.back();
    } else if (!meetings.back().may_miss) {
      end = std::min(end, meetings.back().latest);
    }
  }
  const bool is_hit_throughout = end < std::numeric_limits<double>::infinity();
  Contenders result;
  for (std::size_t n = 0; n < meetings.size(); ++n) {
    const bool is_too_late = has_favourite && meetings[n].earliest > favourite.latest;
    if (meetings[n].may_hit && !is_too_late) result.spheres.push_back(among[n]);
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
      if (!favourite.may_hit || favourite.earliest > end) result.is_right = false;
      if (result.spheres.size() == 1 && !favourite.may_miss) result.is_right = true;
    }
  }
  return result;
}

/// A part of a pixel's square, in shares of its sides, counted as the image's columns and rows are.
struct SquarePart {
  double x = 0, y = 0, side = 1;
};

/// The most parts of a square that are examined.
constexpr std::size_t kMostSquareParts = 1024;

std::vector<std::size_t> all_of(std::span<const scene::Sphere> spheres) {
  std::vector<std::size_t> indices(spheres.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

}  // namespace

Contenders contenders(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                      const Neighbourhood& around, const FirstMet& claim) {
  const IntervalGuard guard;
  const ChangedIntervalLift lift(around.relative_change);
  return contenders_on(line_of(lift, ray.source()), spheres, all_of(spheres), around, claim);
}

bool may_be_right_in_pixel(const ExactRay& ray, std::span<const scene::Sphere> spheres,
                           const Neighbourhood& around, const FirstMet& claim) {
  const auto& [of_camera, pixel, given] = ray.source();
  if (of_camera == nullptr || !around.valid.is_usual()) return true;
  const IntervalGuard guard;
  const scene::Camera& camera = of_camera->camera;
  const ChangedIntervalLift lift(around.relative_change);
  const auto numbers = camera_numbers(lift, camera);
  const auto& inputs = numbers.inputs;
  const auto coordinate = [](const Interval& low, const Interval& high, std::int64_t index,
                             double share, double side, std::int64_t count) {
    const Interval from = Interval(static_cast<double>(index)) + Interval(share, share + side);
    return low + from / Interval(static_cast<double>(count)) * (high - low);
  };
  const std::int64_t row =
      of_camera->conventions.rows == scene::Rows::kTopFirst ? camera.height - 1 - pixel.j : pixel.j;
  struct Question {
    SquarePart part;
    std::vector<std::size_t> among;
  };
  std::vector<Question> open = {{{}, all_of(spheres)}};
  for (std::size_t next = 0; next < open.size(); ++next) {
    const auto [x, y, side] = open[next].part;
    const PlanePosition<Interval> at = {
        coordinate(inputs.left, inputs.right, pixel.i, x, side, camera.width),
        coordinate(inputs.bottom, inputs.top, row, y, side, camera.height)};
    const Contenders found = contenders_on(line_through(numbers, at, of_camera->conventions.origin),
                                           spheres, open[next].among, around, claim);
    if (found.is_right == false) continue;
    if (found.is_right == true || open.size() + 4 > kMostSquareParts) return true;
    const double half = side / 2;
    for (const double left : {x, x + half}) {
      for (const double bottom : {y, y + half}) {
        open.push_back({{left, bottom, half}, found.spheres});
      }
    }
  }
  return false;
}

}  // namespace raycheck::reference
