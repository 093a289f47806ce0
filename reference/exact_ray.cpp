#include "reference/exact_ray.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "reference/internal/classify.h"
#include "reference/internal/ray_impl.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

ExactRay::Direction direction_of(const ExactRay::Source& source) {
  return by_double_doubles([&]() -> ExactRay::Direction {
    const auto line = line_of(DoubleDoubleLift{}, source);
    return {{line.g.x(), line.g.y(), line.g.z()}, line.a};
  });
}

/// Bounds on g and |g|^2.
[[RAYCHECK_FLATTEN gnu::noinline]] std::array<double, 8> bounds_of(const ExactRay::Source& source) {
  const IntervalGuard guard;
  const auto line = line_of(IntervalLift{}, source);
  return {line.g.x().inf(), line.g.x().sup(), line.g.y().inf(), line.g.y().sup(),
          line.g.z().inf(), line.g.z().sup(), line.a.inf(),     line.a.sup()};
}

std::array<double, 6> packed(const QuickLine& line) {
  return {line.g.x, line.g.y, line.g.z, line.a, line.size, line.doubt};
}

void raise(Filtering by, FilterStage stage) {
  if (by.highest != nullptr) *by.highest = std::max(*by.highest, stage);
}

}  // namespace

ExactRay::ExactRay(const ExactCamera& camera, const scene::Pixel& pixel)
    : source_{camera.impl(), pixel, {}} {
  const ExactCamera::Impl& its = *source_.camera;
  require_pixel_of(its.camera, pixel);
  const auto [alpha, beta] = quick_position(its.camera, its.conventions, pixel);
  quick_ = packed(QuickLine::through(its.quick, its.camera, alpha, beta));
}

ExactRay::ExactRay(const scene::Ray& ray) : source_{nullptr, {}, ray} {
  scene::require_valid(ray);
  const auto& [x, y, z] = ray.direction;
  quick_ = packed(QuickLine::given({x, y, z}));
}

ExactRay::Direction ExactRay::direction_in_double_doubles() const {
  return direction_.get([this] { return direction_of(source_); });
}

/// The first stage: the ray's line in intervals. While an object lives, doubles round upward.
struct ExactRay::Filter {
  explicit Filter(const ExactRay& ray)
      : Filter(ray, ray.bounds_.get([&ray] { return bounds_of(ray.source_); })) {}
  Filter(const ExactRay& ray, const std::array<double, 8>& bounds)
      : line{lift_vector(IntervalLift{}, base_of(ray.source_)),
             {Interval(bounds[0], bounds[1]), Interval(bounds[2], bounds[3]),
              Interval(bounds[4], bounds[5])},
             Interval(bounds[6], bounds[7]),
             ray.source_.camera != nullptr &&
                 ray.source_.camera->conventions.origin == scene::Origin::kPixel,
             ray.source_.camera != nullptr} {}

  IntervalGuard guard;
  Line<IntervalKernel> line;
};

/// Computes `sign` of the ray and two spheres by intervals, double-doubles, balls and the exact
/// field until the result is certain; that of the field always is.
template <class F>
int ExactRay::decide(const scene::Sphere& first, const scene::Sphere& second, Filtering by,
                     F sign) const {
  const auto take = [by](FilterStage stage, int answer) {
    raise(by, stage);
    return answer;
  };
  const auto sign_under = [&](const auto& lift, const auto& line) {
    return sign(line_and_sphere(line, lift_sphere(lift, first)),
                line_and_sphere(line, lift_sphere(lift, second)));
  };
  if (by.engine == Engine::kFiltered) {
    {
      const Filter filter(*this);
      if (const auto answer = sign_under(IntervalLift{}, filter.line)) {
        return take(FilterStage::kIntervals, *answer);
      }
    }
    const std::optional<int> certain = by_double_doubles(
        [&] { return sign_under(DoubleDoubleLift{}, line_in_double_doubles(*this)); });
    if (certain) {
      return take(FilterStage::kDoubleDoubles, *certain);
    }
    const EnclosureLift lift{kMiddleBits};
    if (const auto answer = sign_under(lift, line_of(lift, source_))) {
      return take(FilterStage::kBalls, *answer);
    }
  }
  const ExactLift lift;
  return take(FilterStage::kField, *sign_under(lift, line_of(lift, source_)));
}

std::optional<Intersection> ExactRay::intersect_by_doubles(const scene::Sphere& sphere,
                                                           scene::Root root) const {
  const QuickLine line{{quick_[0], quick_[1], quick_[2]}, quick_[3], quick_[4], quick_[5]};
  const ExactCamera::Impl* const camera = source_.camera.get();
  const bool starts_at_g = camera != nullptr && camera->conventions.origin == scene::Origin::kPixel;
  const QuickPair pair(line, starts_at_g, base_of(source_), sphere);
  if (!pair.is_in_range()) return std::nullopt;
  return classify([&](Coefficient coefficient) { return pair.sign(coefficient); }, root);
}

[[RAYCHECK_FLATTEN gnu::noinline]] std::optional<Intersection> ExactRay::intersect_by_intervals(
    const scene::Sphere& sphere, scene::Root root) const {
  const Filter filter(*this);
  const auto pair = line_and_sphere(filter.line, lift_sphere(IntervalLift{}, sphere));
  const auto sign = [&](Coefficient coefficient) { return sign_of(coefficient, pair); };
  return classify(sign, root);
}

Intersection ExactRay::intersect(const scene::Sphere& sphere, scene::Root root,
                                 Filtering by) const {
  scene::require_valid(sphere);
  if (by.engine == Engine::kFiltered) {  // Doubles nearly always decide.
    auto certain = intersect_by_doubles(sphere, root);
    if (!certain) certain = intersect_by_intervals(sphere, root);
    if (certain) {
      raise(by, FilterStage::kIntervals);
      return *certain;
    }
  }
  return *classify(
      [&](Coefficient coefficient) -> std::optional<int> {
        return decide(sphere, sphere, by, [coefficient](const auto& pair, const auto&) {
          return sign_of(coefficient, pair);
        });
      },
      root);
}

Intersection ExactRay::intersect(const scene::Sphere& sphere, const scene::Conventions& conventions,
                                 Filtering by) const {
  const scene::ValidRoots& valid = conventions.valid;
  if (valid.is_usual()) return intersect(sphere, conventions.root, by);
  scene::require_valid(sphere);
  const int line_class = decide(sphere, sphere, by, [](const auto& pair, const auto&) {
    return sign_of(Coefficient::kDiscriminant, pair);
  });
  if (line_class < 0) return {};
  const HitClass hit = line_class == 0 ? HitClass::kTangent : HitClass::kHit;
  for (const WhichRoot root : {WhichRoot::kSmaller, WhichRoot::kLarger}) {
    const Intersection at{hit, root};
    if (counts(sphere, at, valid, by) == RootCounts::kYes) return at;
    if (conventions.root == scene::Root::kSmaller) break;
  }
  return {};
}

RootCounts ExactRay::counts(const scene::Sphere& sphere, const Intersection& at,
                            const scene::ValidRoots& valid, Filtering by) const {
  const auto culled =
      at.root == WhichRoot::kSmaller ? scene::Culling::kFrontFaces : scene::Culling::kBackFaces;
  if (valid.culling == culled) return RootCounts::kCulled;
  const int above =
      std::isinf(valid.t_min) ? 1 : compare_parameter(sphere, at, valid.t_min, valid.unit, by);
  if (above < 0) return RootCounts::kBeforeMin;
  if (above == 0 && !valid.includes_min()) return RootCounts::kOnOpenMin;
  if (std::isinf(valid.t_max)) return RootCounts::kYes;
  const int beyond = compare_parameter(sphere, at, valid.t_max, valid.unit, by);
  if (beyond > 0) return RootCounts::kBeyondMax;
  return beyond == 0 && !valid.includes_max() ? RootCounts::kOnOpenMax : RootCounts::kYes;
}

namespace {

/// A double as a number of a kernel, exactly.
template <class Number>
Number exactly(double value) {
  if constexpr (std::is_same_v<Number, Enclosure>) {
    return Enclosure(value, kMiddleBits);
  } else if constexpr (std::is_same_v<Number, ExactNumber>) {
    return ExactLift{}(value);
  } else {
    return Number(value);
  }
}

}  // namespace

int ExactRay::compare_parameter(const scene::Sphere& sphere, const Intersection& at, double t,
                                scene::TUnit unit, Filtering by) const {
  scene::require_valid(sphere);
  // s = (b + sign sqrt(disc)) / a. If the direction is unit, s is divided by sqrt(a) instead; so is
  // the length of s g.
  return decide(sphere, sphere, by, [&]<class Pair>(const Pair& pair, const Pair&) {
    using Number = std::decay_t<decltype(pair.radius)>;
    const Number end = unit == scene::TUnit::kRadius ? Number(exactly<Number>(t) * pair.radius)
                                                     : exactly<Number>(t);
    const Number b = linear_coefficient(pair);
    const Number sign(root_sign(at));
    const Number under_root = discriminant(pair);
    if (pair.line.is_unit || unit == scene::TUnit::kLength)
      return sign_of_radical_sum(b, Number(-end), Number(pair.line.a), sign, under_root);
    return sign_of_radical_sum(Number(b - end * pair.line.a), sign, under_root, Number(0),
                               Number(0));
  });
}

int ExactRay::compare(const scene::Sphere& first, const Intersection& at_first,
                      const scene::Sphere& second, const Intersection& at_second,
                      Filtering by) const {
  scene::require_valid(first);
  scene::require_valid(second);
  // Most ties are between equal spheres. Only the exact field could decide them otherwise.
  if (by.engine == Engine::kFiltered && first == second && at_first == at_second) return 0;
  return decide(first, second, by, [&](const auto& one, const auto& other) {
    const auto difference = linear_coefficient(one) - linear_coefficient(other);
    using Number = std::decay_t<decltype(difference)>;
    return sign_of_radical_sum(difference, Number(root_sign(at_first)), Number(discriminant(one)),
                               Number(-root_sign(at_second)), Number(discriminant(other)));
  });
}

void ExactRay::keep_nearest(std::span<const scene::Sphere> spheres, std::size_t index,
                            const Intersection& at, std::optional<NearestSphere>& best,
                            Filtering by) const {
  const int order =
      best ? compare(spheres[index], at, spheres[best->index], best->intersection, by) : -1;
  if (order < 0) best = NearestSphere{index, at, {}};
  if (order <= 0) best->ties.push_back(index);
}

std::optional<NearestSphere> ExactRay::nearest(std::span<const scene::Sphere> spheres,
                                               const scene::Conventions& conventions,
                                               Filtering by) const {
  constexpr std::size_t kBetweenPolls = 256;
  std::optional<NearestSphere> best;
  const bool is_usual = conventions.valid.is_usual();
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (k % kBetweenPolls == 0) scene::poll();
    const Intersection here = is_usual ? intersect(spheres[k], conventions.root, by)
                                       : intersect(spheres[k], conventions, by);
    if (!counts_as_hit(here.hit_class, conventions.tangent)) continue;
    keep_nearest(spheres, k, here, best, by);
  }
  return best;
}

}  // namespace raycheck::reference
