#include "reference/exact_ray.h"

#include <stdexcept>
#include <utility>

#include "reference/camera_impl.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

enum class Coefficient { kDiscriminant, kConstant, kLinear };

template <class K>
std::optional<int> sign_of(Coefficient coefficient, const LineAndSphere<K>& pair) {
  switch (coefficient) {
    case Coefficient::kDiscriminant:
      return certain_sign(discriminant(pair));
    case Coefficient::kConstant:
      return certain_sign(constant_coefficient(pair));
    default:
      return certain_sign(linear_coefficient(pair));
  }
}

/// The intersection from the signs of three coefficients, each asked for only when it matters;
/// empty when one that matters is not certain. With c < 0 the roots lie on both sides of the
/// origin; with c > 0 on one side, b's; c = 0 makes one of them 0.
template <class Sign>
std::optional<Intersection> classify(Sign sign, scene::Root convention) {
  const Intersection miss{};
  const std::optional<int> discriminant_sign = sign(Coefficient::kDiscriminant);
  if (!discriminant_sign) return std::nullopt;
  if (*discriminant_sign < 0) return miss;
  const std::optional<int> c = sign(Coefficient::kConstant);
  if (!c) return std::nullopt;
  const HitClass hit = *discriminant_sign == 0 ? HitClass::kTangent : HitClass::kHit;
  const bool larger_counts = convention == scene::Root::kNearest;
  if (*c < 0) return larger_counts ? Intersection{hit, WhichRoot::kLarger} : miss;
  const std::optional<int> b = sign(Coefficient::kLinear);
  if (!b) return std::nullopt;
  if (*b > 0 || (*b == 0 && *c == 0)) return Intersection{hit, WhichRoot::kSmaller};
  if (*c == 0 && larger_counts) return Intersection{hit, WhichRoot::kLarger};
  return miss;
}

int root_sign(const Intersection& intersection) {
  return intersection.root == WhichRoot::kSmaller ? -1 : 1;
}

/// The root's sqrt(discriminant) with its sign, as an enclosure; exactly 0 for a tangent.
Enclosure signed_root(const LineAndSphere<EnclosureKernel>& pair,
                      const Intersection& intersection) {
  if (intersection.hit_class == HitClass::kTangent) return Enclosure(0);
  const Enclosure root = sqrt(discriminant(pair));
  return intersection.root == WhichRoot::kSmaller ? -root : root;
}

ExactNumber exact(const Rational& value) { return ExactNumber(FirstExtension(value)); }

}  // namespace

struct EnclosedRay::Impl {
  Line<EnclosureKernel> line;
  bool from_camera;
  EnclosureLift lift;

  LineAndSphere<EnclosureKernel> with(const scene::Sphere& sphere) const {
    scene::require_valid(sphere);
    return line_and_sphere(lift, line, sphere);
  }
  EnclosureKernel::Vector_3 start() const {
    return line.starts_at_g ? EnclosureKernel::Vector_3(line.base + line.g) : line.base;
  }
};

Enclosure3 EnclosedRay::origin() const { return coordinates(impl_->start()); }
Enclosure3 EnclosedRay::pixel_point() const {
  return coordinates(impl_->line.base + impl_->line.g);
}
Enclosure3 EnclosedRay::direction() const { return coordinates(impl_->line.g / length()); }
Enclosure EnclosedRay::length() const { return sqrt(impl_->line.a); }

Enclosure EnclosedRay::parameter(const scene::Sphere& sphere,
                                 const Intersection& intersection) const {
  const auto pair = impl_->with(sphere);
  const Enclosure numerator = linear_coefficient(pair) + signed_root(pair, intersection);
  return numerator / (impl_->from_camera ? length() : impl_->line.a);
}

Enclosure3 EnclosedRay::point(const scene::Sphere& sphere, const Intersection& intersection) const {
  const auto pair = impl_->with(sphere);
  const Enclosure mu = (linear_coefficient(pair) + signed_root(pair, intersection)) / impl_->line.a;
  return coordinates(impl_->start() + mu * impl_->line.g);
}

Enclosure EnclosedRay::half_chord_sq(const scene::Sphere& sphere) const {
  return discriminant(impl_->with(sphere)) / impl_->line.a;
}

Enclosure EnclosedRay::axial_distance(const scene::Sphere& sphere) const {
  return linear_coefficient(impl_->with(sphere)) / length();
}

namespace {

/// The line of a ray under one kernel: through a camera's pixel, or given.
template <class K, class Lift>
Line<K> line_of(const Lift& lift, const ExactCamera::Impl* camera, const Axes<K>* axes,
                const scene::Pixel& pixel, const scene::Ray& given) {
  if (camera == nullptr) return given_line<K>(lift, given);
  return camera_line<K>(lift, camera->camera, camera->conventions, *axes, pixel);
}

Line<ExactKernel> exact_line(const ExactCamera::Impl* camera, const scene::Pixel& pixel,
                             const scene::Ray& given) {
  return line_of<ExactKernel>(ExactLift{}, camera, camera ? &camera->axes_exact : nullptr, pixel,
                              given);
}

Line<EnclosureKernel> enclosed_line(const EnclosureLift& lift, const ExactCamera::Impl* camera,
                                    const scene::Pixel& pixel, const scene::Ray& given) {
  if (camera == nullptr) return given_line<EnclosureKernel>(lift, given);
  std::optional<Axes<EnclosureKernel>> scratch;
  const auto& axes = camera->enclosed_axes(lift.bits, lift.relative_change, scratch);
  return line_of<EnclosureKernel>(lift, camera, &axes, pixel, given);
}

}  // namespace

ExactRay::ExactRay(const ExactCamera& camera, const scene::Pixel& pixel)
    : camera_(camera.impl()), pixel_(pixel) {
  require_pixel_of(camera_->camera, pixel);
  const IntervalGuard guard;
  const auto line = line_of<IntervalKernel>(IntervalLift{}, camera_.get(), &camera_->axes_interval,
                                            pixel_, given_);
  bounds_ = {line.g.x().inf(), line.g.x().sup(), line.g.y().inf(), line.g.y().sup(),
             line.g.z().inf(), line.g.z().sup(), line.a.inf(),     line.a.sup()};
}

ExactRay::ExactRay(const scene::Ray& ray) : given_(ray) {
  scene::require_valid(ray);
  const IntervalGuard guard;
  const auto line = given_line<IntervalKernel>(IntervalLift{}, ray);
  bounds_ = {ray.direction.x, ray.direction.x, ray.direction.y, ray.direction.y,
             ray.direction.z, ray.direction.z, line.a.inf(),    line.a.sup()};
}

/// The ladder: `sign` of the ray and two spheres under intervals, balls, the exact field, until one
/// is certain; the last always is.
template <class F>
int ExactRay::decide(const scene::Sphere& first, const scene::Sphere& second, Engine engine,
                     F sign) const {
  if (engine == Engine::kFiltered) {
    {
      const IntervalGuard guard;
      const scene::Point3& base = camera_ ? camera_->camera.eye : given_.origin;
      const IntervalLift lift;
      const Line<IntervalKernel> line{
          lift_vector<IntervalKernel>(lift, base),
          {Interval(bounds_[0], bounds_[1]), Interval(bounds_[2], bounds_[3]),
           Interval(bounds_[4], bounds_[5])},
          Interval(bounds_[6], bounds_[7]),
          camera_ && camera_->conventions.origin == scene::Origin::kPixel};
      const auto answer =
          sign(line_and_sphere(lift, line, first), line_and_sphere(lift, line, second));
      if (answer) return *answer;
    }
    const EnclosureLift lift{kMiddleBits};
    const auto line = enclosed_line(lift, camera_.get(), pixel_, given_);
    const auto answer =
        sign(line_and_sphere(lift, line, first), line_and_sphere(lift, line, second));
    if (answer) return *answer;
  }
  const ExactLift lift;
  const auto line = exact_line(camera_.get(), pixel_, given_);
  return *sign(line_and_sphere(lift, line, first), line_and_sphere(lift, line, second));
}

Intersection ExactRay::intersect(const scene::Sphere& sphere, scene::Root root,
                                 Engine engine) const {
  scene::require_valid(sphere);
  return *classify(
      [&](Coefficient coefficient) -> std::optional<int> {
        return decide(sphere, sphere, engine, [coefficient](const auto& pair, const auto&) {
          return sign_of(coefficient, pair);
        });
      },
      root);
}

int ExactRay::compare(const scene::Sphere& first, const Intersection& at_first,
                      const scene::Sphere& second, const Intersection& at_second,
                      Engine engine) const {
  scene::require_valid(first);
  scene::require_valid(second);
  return decide(first, second, engine, [&](const auto& one, const auto& other) {
    const auto difference = linear_coefficient(one) - linear_coefficient(other);
    using Number = std::decay_t<decltype(difference)>;
    // A tangent's discriminant is 0; leaving it out keeps approximations from widening.
    const auto scale = [](const Intersection& at, int sign) {
      return Number(at.hit_class == HitClass::kTangent ? 0 : sign * root_sign(at));
    };
    return sign_of_radical_sum(difference, scale(at_first, 1), Number(discriminant(one)),
                               scale(at_second, -1), Number(discriminant(other)));
  });
}

std::optional<NearestSphere> ExactRay::nearest(std::span<const scene::Sphere> spheres,
                                               const scene::Conventions& conventions) const {
  std::optional<NearestSphere> best;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const Intersection here = intersect(spheres[k], conventions.root);
    if (!counts_as_hit(here.hit_class, conventions.tangent)) continue;
    const int order =
        best ? compare(spheres[k], here, spheres[best->index], best->intersection) : -1;
    if (order < 0) best = NearestSphere{k, here, {}};
    if (order <= 0) best->ties.push_back(k);
  }
  return best;
}

bool ExactRay::may_flip_within(const scene::Sphere& sphere, scene::Root root,
                               double relative_change) const {
  scene::require_valid(sphere);
  const EnclosureLift lift{kMiddleBits, relative_change};
  const auto line = enclosed_line(lift, camera_.get(), pixel_, given_);
  const auto pair = line_and_sphere(lift, line, sphere);
  const auto sign = [&](Coefficient coefficient) { return sign_of(coefficient, pair); };
  return !classify(sign, root).has_value();
}

EnclosedRay ExactRay::enclose(int bits, double relative_change) const {
  const EnclosureLift lift{bits, relative_change};
  return EnclosedRay(std::make_shared<const EnclosedRay::Impl>(EnclosedRay::Impl{
      enclosed_line(lift, camera_.get(), pixel_, given_), camera_ != nullptr, lift}));
}

namespace {

/// Applies narrow() or round_to_nearest() to the three coordinates of an EnclosedRay's value;
/// compare(k, m) is the exact sign of coordinate k - m.
template <class Result, class Value, class Compare, class Finish>
Result finish_vector(const ExactRay& ray, Value value, Compare compare, Finish finish) {
  Enclosure3 first = value(ray.enclose(kFirstBits));
  const auto coordinate = [&](int k, Enclosure Enclosure3::*member) {
    return finish(
        std::move(first.*member),
        [&, member](int bits) { return value(ray.enclose(bits)).*member; },
        [&, k](const Rational& m) { return compare(k, m); });
  };
  return {coordinate(0, &Enclosure3::x), coordinate(1, &Enclosure3::y),
          coordinate(2, &Enclosure3::z)};
}

auto narrow_to(int relative_bits) {
  return [relative_bits](Enclosure first, auto enclose, auto compare) {
    return narrow(std::move(first), relative_bits, enclose, compare);
  };
}

auto rounded() {
  return [](Enclosure first, auto enclose, auto compare) {
    return round_to_nearest(std::move(first), enclose, compare);
  };
}

/// Exact comparisons of a line's values with rationals; the line is made on first use.
class ExactValues {
 public:
  ExactValues(const ExactCamera::Impl* camera, const scene::Pixel& pixel, const scene::Ray& given)
      : camera_(camera), pixel_(pixel), given_(given) {}

  int compare_pixel_point(int k, const Rational& m) {
    return *certain_sign(line().base[k] + line().g[k] - exact(m));
  }
  int compare_origin(int k, const Rational& m) {
    return line().starts_at_g ? compare_pixel_point(k, m)
                              : *certain_sign(line().base[k] - exact(m));
  }
  /// g_k / sqrt(a) - m
  int compare_direction(int k, const Rational& m) {
    return *sign_of_radical_sum(line().g[k], exact(-m), line().a, ExactNumber(0), ExactNumber(0));
  }
  /// (b +- sqrt(disc)) / sqrt(a) - m for a camera's ray, (b +- sqrt(disc)) / a - m for a given one.
  int compare_parameter(const scene::Sphere& sphere, const Intersection& at, const Rational& m) {
    const auto pair = line_and_sphere(ExactLift{}, line(), sphere);
    const ExactNumber b = linear_coefficient(pair);
    const ExactNumber sign(root_sign(at));
    if (camera_) {
      return *sign_of_radical_sum(b, exact(-m), line().a, sign, discriminant(pair));
    }
    return *sign_of_radical_sum(b - exact(m) * line().a, sign, discriminant(pair), ExactNumber(0),
                                ExactNumber(0));
  }
  /// L_k + (b +- sqrt(disc)) g_k / a - m
  int compare_point(const scene::Sphere& sphere, const Intersection& at, int k, const Rational& m) {
    const auto pair = line_and_sphere(ExactLift{}, line(), sphere);
    const ExactNumber& g = line().g[k];
    const ExactNumber start = line().starts_at_g ? ExactNumber(line().base[k] + g) : line().base[k];
    return *sign_of_radical_sum((start - exact(m)) * line().a + linear_coefficient(pair) * g,
                                ExactNumber(root_sign(at)) * g, discriminant(pair), ExactNumber(0),
                                ExactNumber(0));
  }

 private:
  const Line<ExactKernel>& line() {
    if (!line_) line_ = exact_line(camera_, pixel_, given_);
    return *line_;
  }

  const ExactCamera::Impl* camera_;
  const scene::Pixel& pixel_;
  const scene::Ray& given_;
  std::optional<Line<ExactKernel>> line_;
};

template <class Result, class Finish>
Result finish_pixel_point(const ExactRay& ray, ExactValues values, Finish finish) {
  return finish_vector<Result>(
      ray, [](const EnclosedRay& at) { return at.pixel_point(); },
      [&](int k, const Rational& m) { return values.compare_pixel_point(k, m); }, finish);
}

template <class Result, class Finish>
Result finish_origin(const ExactRay& ray, ExactValues values, Finish finish) {
  return finish_vector<Result>(
      ray, [](const EnclosedRay& at) { return at.origin(); },
      [&](int k, const Rational& m) { return values.compare_origin(k, m); }, finish);
}

template <class Result, class Finish>
Result finish_direction(const ExactRay& ray, ExactValues values, Finish finish) {
  return finish_vector<Result>(
      ray, [](const EnclosedRay& at) { return at.direction(); },
      [&](int k, const Rational& m) { return values.compare_direction(k, m); }, finish);
}

template <class Result, class Finish>
Result finish_point(const ExactRay& ray, ExactValues values, const scene::Sphere& sphere,
                    const Intersection& at, Finish finish) {
  return finish_vector<Result>(
      ray, [&](const EnclosedRay& enclosed) { return enclosed.point(sphere, at); },
      [&](int k, const Rational& m) { return values.compare_point(sphere, at, k, m); }, finish);
}

template <class Finish>
auto finish_parameter(const ExactRay& ray, ExactValues values, const scene::Sphere& sphere,
                      const Intersection& at, Finish finish) {
  return finish(
      ray.enclose(kFirstBits).parameter(sphere, at),
      [&](int bits) { return ray.enclose(bits).parameter(sphere, at); },
      [&](const Rational& m) { return values.compare_parameter(sphere, at, m); });
}

}  // namespace

Enclosure3 ExactRay::pixel_point(int relative_bits) const {
  return finish_pixel_point<Enclosure3>(*this, {camera_.get(), pixel_, given_},
                                        narrow_to(relative_bits));
}
Enclosure3 ExactRay::origin(int relative_bits) const {
  return finish_origin<Enclosure3>(*this, {camera_.get(), pixel_, given_},
                                   narrow_to(relative_bits));
}
Enclosure3 ExactRay::direction(int relative_bits) const {
  return finish_direction<Enclosure3>(*this, {camera_.get(), pixel_, given_},
                                      narrow_to(relative_bits));
}
Enclosure ExactRay::parameter(const scene::Sphere& sphere, const Intersection& intersection,
                              int relative_bits) const {
  return finish_parameter(*this, {camera_.get(), pixel_, given_}, sphere, intersection,
                          narrow_to(relative_bits));
}
Enclosure3 ExactRay::point(const scene::Sphere& sphere, const Intersection& intersection,
                           int relative_bits) const {
  return finish_point<Enclosure3>(*this, {camera_.get(), pixel_, given_}, sphere, intersection,
                                  narrow_to(relative_bits));
}

scene::Point3 ExactRay::rounded_pixel_point() const {
  return finish_pixel_point<scene::Point3>(*this, {camera_.get(), pixel_, given_}, rounded());
}
scene::Point3 ExactRay::rounded_origin() const {
  return finish_origin<scene::Point3>(*this, {camera_.get(), pixel_, given_}, rounded());
}
scene::UnitVector3 ExactRay::rounded_direction() const {
  return finish_direction<scene::UnitVector3>(*this, {camera_.get(), pixel_, given_}, rounded());
}
double ExactRay::rounded_parameter(const scene::Sphere& sphere,
                                   const Intersection& intersection) const {
  return finish_parameter(*this, {camera_.get(), pixel_, given_}, sphere, intersection, rounded());
}
scene::Point3 ExactRay::rounded_point(const scene::Sphere& sphere,
                                      const Intersection& intersection) const {
  return finish_point<scene::Point3>(*this, {camera_.get(), pixel_, given_}, sphere, intersection,
                                     rounded());
}

}  // namespace raycheck::reference
