#include <fmt/core.h>
#include <raycheck/exact.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "library/conversions.h"
#include "reference/account/closed_form.h"
#include "reference/account/condition.h"
#include "reference/enclosure.h"
#include "reference/error_measure.h"
#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "scene/arithmetic.h"
#include "scene/validate.h"

namespace raycheck::exact {

using reference::Enclosure;

struct Number::Impl {
  std::function<Enclosure(int relative_bits)> enclose;
  std::function<double()> rounded;
  std::function<std::string()> closed_form;
  std::function<double()> condition;
};

namespace {

constexpr int kFewestBits = 2, kMostBits = 100000;
/// Decimal digits per bit.
constexpr double kDigitsOfABit = 0.30103;
/// A printed enclosure is computed with this number of bits more than requested.
constexpr int kSpareBits = 8;
/// A printed enclosure has this number of digits more than the requested bits need.
constexpr int kSpareDigits = 3;

Number number(std::function<Enclosure(int)> enclose, std::function<double()> rounded,
              std::function<std::string()> closed_form, std::function<double()> condition) {
  return Number(std::make_shared<const Number::Impl>(Number::Impl{
      std::move(enclose), std::move(rounded), std::move(closed_form), std::move(condition)}));
}

template <class Triple>
auto coordinate(const Triple& triple, int k) {
  return k == 0 ? triple.x : k == 1 ? triple.y : triple.z;
}

/// The coordinates of a vector, from functions that compute the whole vector.
template <class Enclose, class Round, class Write, class Condition>
Numbers numbers(const Enclose& enclose, const Round& round, const Write& write,
                const Condition& condition) {
  const auto one = [&](int k) {
    return number([=](int bits) { return coordinate(enclose(bits), k); },
                  [=] { return coordinate(round(), k); },
                  [=] { return write()[static_cast<std::size_t>(k)].text(); }, condition);
  };
  return {one(0), one(1), one(2)};
}

}  // namespace

Number::Number(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

double Number::rounded() const {
  const scene::PlainArithmetic plain;
  return impl_->rounded();
}

Interval Number::interval() const {
  const scene::PlainArithmetic plain;
  const Enclosure enclosed = impl_->enclose(reference::ExactRay::kValueBits);
  return {enclosed.lower(), enclosed.upper()};
}

std::string Number::enclosure(int bits) const {
  const scene::PlainArithmetic plain;
  if (bits < kFewestBits || bits > kMostBits) {
    throw std::invalid_argument(
        fmt::format("bits = {}: must be {} to {}", bits, kFewestBits, kMostBits));
  }
  const Enclosure enclosed = impl_->enclose(bits + kSpareBits);
  const auto digits = static_cast<slong>(std::ceil(bits * kDigitsOfABit)) + kSpareDigits;
  const std::unique_ptr<char, void (*)(void*)> text(arb_get_str(enclosed.ball(), digits, 0),
                                                    flint_free);
  return text.get();
}

std::string Number::closed_form() const {
  const scene::PlainArithmetic plain;
  return impl_->closed_form();
}

double Number::ulp_error(double given) const {
  const scene::PlainArithmetic plain;
  return reference::ulp_error(given, impl_->enclose(reference::ExactRay::kValueBits)).value;
}

double Number::condition() const {
  const scene::PlainArithmetic plain;
  return impl_->condition();
}

Vector Numbers::rounded() const { return {x.rounded(), y.rounded(), z.rounded()}; }

/// A ray that is known exactly and in closed form.
struct Ray::Impl {
  reference::ExactRay ray;
  reference::ClosedFormRay forms;
  bool starts_at_pixel = false;  ///< If not set, its origin is an input.
};

namespace {

using SharedRay = std::shared_ptr<const Ray::Impl>;

Intersection intersection(const SharedRay& of, const scene::Sphere& sphere,
                          const reference::Intersection& at, scene::Tangent tangent) {
  Intersection met;
  met.hit_class = static_cast<HitClass>(at.hit_class);
  met.is_hit = counts_as_hit(at.hit_class, tangent);
  if (met.hit_class == HitClass::miss) return met;
  met.root = static_cast<WhichRoot>(at.root);
  met.parameter = number([=](int bits) { return of->ray.parameter(sphere, at, bits); },
                         [=] { return of->ray.rounded_parameter(sphere, at); },
                         [=] { return of->forms.parameter(sphere, at).text(); },
                         [=] { return condition_of_parameter(of->ray, sphere, at); });
  met.point = numbers([=](int bits) { return of->ray.point(sphere, at, bits); },
                      [=] { return of->ray.rounded_point(sphere, at); },
                      [=] { return of->forms.point(sphere, at); },
                      [=] { return condition_of_point(of->ray, sphere, at); });
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
  return std::make_shared<const Ray::Impl>(
      Ray::Impl{reference::ExactRay(given), reference::ClosedFormRay(given)});
}

Intersection hit_of(const SharedRay& of, const scene::Sphere& sphere,
                    const scene::Conventions& conventions) {
  const scene::PlainArithmetic plain;
  return intersection(of, sphere, of->ray.intersect(sphere, conventions), conventions.tangent);
}

/// The ray of a pixel. Errors: std::invalid_argument if the pixel is outside the image.
SharedRay shared(const reference::ExactCamera& camera, Pixel pixel) {
  const scene::PlainArithmetic plain;
  const scene::Camera& of = camera.camera();
  if (pixel.i < 0 || pixel.i >= of.width || pixel.j < 0 || pixel.j >= of.height) {
    throw std::invalid_argument(fmt::format("pixel ({}, {}): the image has {} x {} pixels", pixel.i,
                                            pixel.j, of.width, of.height));
  }
  return std::make_shared<const Ray::Impl>(
      Ray::Impl{reference::ExactRay(camera, library::pixel(pixel)),
                reference::ClosedFormRay(of, camera.conventions(), library::pixel(pixel)),
                camera.conventions().origin == scene::Origin::kPixel});
}

}  // namespace

Ray::Ray(const raycheck::Ray& ray) : impl_(shared(ray)) {}
Ray::Ray(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

Numbers Ray::origin() const {
  return numbers(
      [of = impl_](int bits) { return of->ray.origin(bits); },
      [of = impl_] { return of->ray.rounded_origin(); },
      [of = impl_] { return of->forms.origin(); },
      [of = impl_] { return of->starts_at_pixel ? condition_of_pixel_point(of->ray) : 1.0; });
}

Numbers Ray::direction() const {
  return numbers([of = impl_](int bits) { return of->ray.direction(bits); },
                 [of = impl_] { return of->ray.rounded_direction(); },
                 [of = impl_] { return of->forms.direction(); },
                 [of = impl_] { return condition_of_direction(of->ray); });
}

Intersection Ray::hit(const Sphere& sphere, const Conventions& conventions) const {
  return hit_of(impl_, library::sphere(sphere), library::conventions(conventions));
}

std::optional<Nearest> Ray::nearest(const std::vector<Sphere>& spheres,
                                    const Conventions& conventions) const {
  return nearest_of(impl_, library::spheres(spheres), library::conventions(conventions));
}

struct Camera::Impl {
  reference::ExactCamera camera;
  reference::ClosedFormFrame forms;
};

Camera::Camera(const raycheck::Camera& camera, const Conventions& conventions)
    : impl_([&] {
        const scene::PlainArithmetic plain;
        const scene::Camera inside = library::camera(camera);
        return std::make_shared<const Impl>(
            Impl{reference::ExactCamera(inside, library::conventions(conventions)),
                 reference::closed_form_frame(inside)});
      }()) {}

Axes Camera::axes() const {
  const auto axis = [of = impl_](auto enclosed, auto rounded, auto form) {
    return numbers([=](int bits) { return of->camera.frame(bits).*enclosed; },
                   [=] { return of->camera.rounded_frame().*rounded; },
                   [=] { return of->forms.*form; }, [=] { return condition_of_frame(of->camera); });
  };
  using reference::ClosedFormFrame, reference::EnclosedFrame, reference::RoundedFrame;
  return {axis(&EnclosedFrame::U, &RoundedFrame::U, &ClosedFormFrame::U),
          axis(&EnclosedFrame::V, &RoundedFrame::V, &ClosedFormFrame::V),
          axis(&EnclosedFrame::W, &RoundedFrame::W, &ClosedFormFrame::W)};
}

Numbers Camera::pixel_point(Pixel pixel) const {
  const SharedRay of = shared(impl_->camera, pixel);
  return numbers([=](int bits) { return of->ray.pixel_point(bits); },
                 [=] { return of->ray.rounded_pixel_point(); },
                 [=] { return of->forms.pixel_point(); },
                 [=] { return condition_of_pixel_point(of->ray); });
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
