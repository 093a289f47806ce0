#include <fmt/core.h>
#include <raycheck/exact.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "library/conversions.h"
#include "library/quantity.h"
#include "reference/account/closed_form.h"
#include "reference/enclosure.h"
#include "reference/error_measure.h"
#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "scene/arithmetic.h"
#include "scene/on_demand.h"
#include "scene/validate.h"

namespace raycheck::exact {

using reference::Enclosure, reference::Enclosure3;
constexpr int kValueBits = reference::ExactRay::kValueBits;

/// A point or a vector, or a number as its x. Each of its values is computed once, for all
/// coordinates.
struct Values {
  std::function<Enclosure3(int bits)> enclose;
  std::function<scene::Point3()> round;
  std::function<std::vector<std::string>()> write;
  std::function<double()> condition;
  scene::OnDemand<Enclosure3> kept_enclosure = {};
  scene::OnDemand<scene::Point3> kept_rounded = {};
  scene::OnDemand<std::vector<std::string>> kept_forms = {};
  scene::OnDemand<double> kept_condition = {};
};

struct Number::Impl {
  std::shared_ptr<const Values> of;
  int k;

  /// This coordinate of a point or vector.
  template <class Triple>
  const auto& in(const Triple& triple) const {
    return k == 0 ? triple.x : k == 1 ? triple.y : triple.z;
  }
  const Enclosure& enclosed() const {
    return in(of->kept_enclosure.get([this] { return of->enclose(kValueBits); }));
  }
};

namespace {

constexpr int kFewestBits = 2, kMostBits = 100000;
/// Decimal digits per bit.
constexpr double kDigitsOfABit = 0.30103;
/// A printed enclosure is computed with this number of bits more than requested.
constexpr int kSpareBits = 8;
/// A printed enclosure has this number of digits more than the requested bits need.
constexpr int kSpareDigits = 3;

Number number(const std::shared_ptr<const Values>& of, int k = 0) {
  return Number(std::make_shared<const Number::Impl>(Number::Impl{of, k}));
}
Numbers numbers(const std::shared_ptr<const Values>& of) {
  return {number(of, 0), number(of, 1), number(of, 2)};
}
template <class Enclose, class Round, class Write, class Condition>
std::shared_ptr<const Values> values(Enclose enclose, Round round, Write write,
                                     Condition condition) {
  return std::shared_ptr<const Values>(new Values{enclose, round, write, condition});
}

}  // namespace

Number::Number(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

double Number::rounded() const {
  const scene::PlainArithmetic plain;
  return impl_->in(impl_->of->kept_rounded.get(impl_->of->round));
}

Interval Number::interval() const {
  const scene::PlainArithmetic plain;
  const Enclosure& enclosed = impl_->enclosed();
  return {enclosed.lower(), enclosed.upper()};
}

std::string Number::enclosure(int bits) const {
  const scene::PlainArithmetic plain;
  if (bits < kFewestBits || bits > kMostBits) {
    throw std::invalid_argument(
        fmt::format("bits = {}: must be {} to {}", bits, kFewestBits, kMostBits));
  }
  const Enclosure3 all = impl_->of->enclose(bits + kSpareBits);
  const Enclosure& enclosed = impl_->in(all);
  const auto digits = static_cast<slong>(std::ceil(bits * kDigitsOfABit)) + kSpareDigits;
  const std::unique_ptr<char, void (*)(void*)> text(arb_get_str(enclosed.ball(), digits, 0),
                                                    flint_free);
  return text.get();
}

std::string Number::closed_form() const {
  const scene::PlainArithmetic plain;
  return impl_->of->kept_forms.get(impl_->of->write)[static_cast<std::size_t>(impl_->k)];
}

double Number::ulp_error(double given) const {
  const scene::PlainArithmetic plain;
  return reference::ulp_error(given, impl_->enclosed()).value;
}

double Number::condition() const {
  const scene::PlainArithmetic plain;
  return impl_->of->kept_condition.get(impl_->of->condition);
}

Vector Numbers::rounded() const { return {x.rounded(), y.rounded(), z.rounded()}; }

/// A ray that is known exactly, and on demand in closed form.
struct Ray::Impl {
  using Forms = reference::ClosedFormRay;
  Impl(reference::ExactRay its_ray, std::function<Forms()> make, bool is_of_pixel = false)
      : ray(std::move(its_ray)), make_forms(std::move(make)), starts_at_pixel(is_of_pixel) {}

  const Forms& forms() const { return kept_forms.get(make_forms); }

  reference::ExactRay ray;
  std::function<Forms()> make_forms;
  bool starts_at_pixel;  ///< If not set, its origin is an input.
  scene::OnDemand<Forms> kept_forms;
};

namespace {

using SharedRay = std::shared_ptr<const Ray::Impl>;
using library::Quantity;

std::vector<std::string> written(const reference::ClosedFormRay& forms, Quantity quantity,
                                 const scene::Sphere& sphere, const reference::Intersection& at) {
  switch (quantity) {
    case Quantity::kParameter:
      return {forms.parameter(sphere, at).text()};
    case Quantity::kPoint:
      return texts(forms.point(sphere, at));
    case Quantity::kDirection:
      return texts(forms.direction());
    case Quantity::kOrigin:
      return texts(forms.origin());
    default:
      return texts(forms.pixel_point());
  }
}

std::shared_ptr<const Values> values_of(const SharedRay& of, Quantity quantity,
                                        const scene::Sphere& sphere = {},
                                        const reference::Intersection& at = {}) {
  return values(
      [=](int bits) {
        return library::enclosed(quantity, {of->ray, sphere, at}, bits);
      },
      [=] {
        return library::rounded(quantity, {of->ray, sphere, at});
      },
      [=] { return written(of->forms(), quantity, sphere, at); },
      [=] {
        return library::condition(quantity, {of->ray, sphere, at});
      });
}

Intersection intersection(const SharedRay& of, const scene::Sphere& sphere,
                          const reference::Intersection& at, scene::Tangent tangent) {
  Intersection met;
  met.hit_class = static_cast<HitClass>(at.hit_class);
  met.is_hit = counts_as_hit(at.hit_class, tangent);
  if (met.hit_class == HitClass::miss) return met;
  met.root = static_cast<WhichRoot>(at.root);
  met.parameter = number(values_of(of, Quantity::kParameter, sphere, at));
  met.point = numbers(values_of(of, Quantity::kPoint, sphere, at));
  return met;
}

static_assert(static_cast<int>(HitClass::tangent) ==
                  static_cast<int>(reference::HitClass::kTangent) &&
              static_cast<int>(WhichRoot::larger) ==
                  static_cast<int>(reference::WhichRoot::kLarger));

std::optional<Nearest> nearest_of(const SharedRay& of, const std::vector<scene::Sphere>& spheres,
                                  const scene::Conventions& conventions) {
  const scene::PlainArithmetic plain;
  auto found = of->ray.nearest(spheres, conventions);
  if (!found) return {};
  return Nearest{found->index, std::move(found->ties),
                 intersection(of, spheres[found->index], found->intersection, conventions.tangent)};
}

SharedRay shared(const raycheck::Ray& ray) {
  const scene::PlainArithmetic plain;
  const scene::Ray given = library::ray(ray);
  return std::make_shared<const Ray::Impl>(reference::ExactRay(given),
                                           [given] { return reference::ClosedFormRay(given); });
}

Intersection hit_of(const SharedRay& of, const scene::Sphere& sphere,
                    const scene::Conventions& conventions) {
  const scene::PlainArithmetic plain;
  return intersection(of, sphere, of->ray.intersect(sphere, conventions), conventions.tangent);
}

/// The ray of a pixel. Errors: std::invalid_argument if the pixel is outside the image.
SharedRay shared(const reference::ExactCamera& camera, Pixel pixel) {
  const scene::PlainArithmetic plain;
  const scene::Camera of = camera.camera();
  if (pixel.i < 0 || pixel.i >= of.width || pixel.j < 0 || pixel.j >= of.height) {
    throw std::invalid_argument(fmt::format("pixel ({}, {}): the image has {} x {} pixels", pixel.i,
                                            pixel.j, of.width, of.height));
  }
  return std::make_shared<const Ray::Impl>(
      reference::ExactRay(camera, library::pixel(pixel)),
      [=, by = camera.conventions()] {
        return reference::ClosedFormRay(of, by, library::pixel(pixel));
      },
      camera.conventions().origin == scene::Origin::kPixel);
}

}  // namespace

Ray::Ray(const raycheck::Ray& ray) : impl_(shared(ray)) {}
Ray::Ray(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

Numbers Ray::origin() const {
  return numbers(
      values_of(impl_, impl_->starts_at_pixel ? Quantity::kPixelPoint : Quantity::kOrigin));
}

Numbers Ray::direction() const { return numbers(values_of(impl_, Quantity::kDirection)); }

Intersection Ray::hit(const Sphere& sphere, const Conventions& conventions) const {
  return hit_of(impl_, library::sphere(sphere), library::conventions(conventions));
}

std::optional<Nearest> Ray::nearest(const std::vector<Sphere>& spheres,
                                    const Conventions& conventions) const {
  return nearest_of(impl_, library::spheres(spheres), library::conventions(conventions));
}

struct Camera::Impl {
  explicit Impl(reference::ExactCamera its_camera) : camera(std::move(its_camera)) {}
  reference::ExactCamera camera;
  scene::OnDemand<reference::ClosedFormFrame> forms;
};

Camera::Camera(const raycheck::Camera& camera, const Conventions& conventions)
    : impl_([&] {
        const scene::PlainArithmetic plain;
        const scene::Camera inside = library::camera(camera);
        return std::make_shared<const Impl>(
            reference::ExactCamera(inside, library::conventions(conventions)));
      }()) {}

Axes Camera::axes() const {
  const auto axis = [of = impl_](auto enclosed, auto rounded, auto form) {
    return numbers(values(
        [=](int bits) { return of->camera.frame(bits).*enclosed; },
        [=] { return contract::triple<scene::Point3>(of->camera.rounded_frame().*rounded); },
        [=] {
          const auto make = [&] { return reference::closed_form_frame(of->camera.camera()); };
          return texts(of->forms.get(make).*form);
        },
        [=] { return condition_of_frame(of->camera); }));
  };
  using reference::ClosedFormFrame, reference::EnclosedFrame, reference::RoundedFrame;
  return {axis(&EnclosedFrame::U, &RoundedFrame::U, &ClosedFormFrame::U),
          axis(&EnclosedFrame::V, &RoundedFrame::V, &ClosedFormFrame::V),
          axis(&EnclosedFrame::W, &RoundedFrame::W, &ClosedFormFrame::W)};
}

Numbers Camera::pixel_point(Pixel pixel) const {
  return numbers(values_of(shared(impl_->camera, pixel), Quantity::kPixelPoint));
}

Ray Camera::ray(Pixel pixel) const { return Ray(shared(impl_->camera, pixel)); }

Intersection hit(const raycheck::Ray& ray, const Sphere& sphere, const Conventions& conventions) {
  return Ray(ray).hit(sphere, conventions);
}

std::optional<Nearest> nearest(const raycheck::Ray& ray, const std::vector<Sphere>& spheres,
                               const Conventions& conventions) {
  return Ray(ray).nearest(spheres, conventions);
}

}  // namespace raycheck::exact
