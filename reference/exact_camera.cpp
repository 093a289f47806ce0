#include "reference/exact_camera.h"

#include <stdexcept>
#include <string>

#include "reference/internal/camera_impl.h"
#include "scene/scene.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

const scene::Camera& validated(const scene::Camera& camera, const scene::Conventions& conventions) {
  scene::Scene scene;
  scene.camera = camera;
  scene.conventions = conventions;
  scene::require_valid(scene);
  return camera;
}

Interval bounds(const Enclosure& x) { return {x.lower(), x.upper()}; }

/// Axes known to balls, under another kernel: convert(coordinate) encloses.
template <class K, class Convert>
Axes<K> converted(const Axes<EnclosureKernel>& axes, Convert convert) {
  const auto vector = [&](const EnclosureKernel::Vector_3& v) {
    return typename K::Vector_3(convert(v.x()), convert(v.y()), convert(v.z()));
  };
  return {vector(axes.U), vector(axes.V), vector(axes.W)};
}

}  // namespace

void require_pixel_of(const scene::Camera& camera, const scene::Pixel& pixel) {
  if (pixel.i >= 0 && pixel.i < camera.width && pixel.j >= 0 && pixel.j < camera.height) return;
  throw std::invalid_argument("pixel (" + std::to_string(pixel.i) + ", " + std::to_string(pixel.j) +
                              ") is outside an image of " + std::to_string(camera.width) + " x " +
                              std::to_string(camera.height));
}

ExactCamera::Impl::Impl(const scene::Camera& its_camera, const scene::Conventions& its_conventions)
    : camera(validated(its_camera, its_conventions)),
      conventions(its_conventions),
      first_bits(camera_numbers<EnclosureKernel>(EnclosureLift{kFirstBits}, camera)),
      middle_bits(camera_numbers<EnclosureKernel>(EnclosureLift{kMiddleBits}, camera)),
      intervals{lift_camera<IntervalKernel>(IntervalLift{}, camera),
                converted<IntervalKernel>(middle_bits.axes, bounds)},
      double_doubles{lift_camera<DoubleDoubleKernel>(DoubleDoubleLift{}, camera),
                     converted<DoubleDoubleKernel>(
                         middle_bits.axes, [](const Enclosure& x) { return DoubleDouble(x); })},
      exact(camera_numbers<ExactKernel>(ExactLift{}, camera)) {}

const CameraNumbers<EnclosureKernel>& ExactCamera::Impl::enclosed(
    const EnclosureLift& lift, std::optional<CameraNumbers<EnclosureKernel>>& scratch) const {
  if (lift.relative_change == 0 && lift.bits == kFirstBits) return first_bits;
  if (lift.relative_change == 0 && lift.bits == kMiddleBits) return middle_bits;
  scratch = camera_numbers<EnclosureKernel>(lift, camera);
  return *scratch;
}

ExactCamera::ExactCamera(const scene::Camera& camera, const scene::Conventions& conventions)
    : impl_(std::make_shared<Impl>(camera, conventions)) {}

const scene::Camera& ExactCamera::camera() const { return impl_->camera; }
const scene::Conventions& ExactCamera::conventions() const { return impl_->conventions; }

namespace {

using AxisOf = EnclosureKernel::Vector_3 Axes<EnclosureKernel>::*;
using ExactAxisOf = ExactKernel::Vector_3 Axes<ExactKernel>::*;

/// Applies narrow() or round_to_nearest() to one coordinate of one axis.
template <class Result, class Finish>
Result finish_axis(const ExactCamera::Impl& impl, AxisOf axis, ExactAxisOf exact_axis,
                   Finish finish) {
  const auto coordinate = [&](int k) {
    return finish(
        (impl.first_bits.axes.*axis)[k],
        [&, k](int bits) {
          std::optional<CameraNumbers<EnclosureKernel>> scratch;
          return (impl.enclosed(EnclosureLift{bits}, scratch).axes.*axis)[k];
        },
        [&, k](const Rational& m) {
          return *certain_sign((impl.exact.axes.*exact_axis)[k] - ExactNumber(FirstExtension(m)));
        });
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

}  // namespace

EnclosedFrame ExactCamera::frame(int relative_bits) const {
  const auto finish = [relative_bits](Enclosure first, auto enclose, auto compare) {
    return narrow(std::move(first), relative_bits, enclose, compare);
  };
  return {
      finish_axis<Enclosure3>(*impl_, &Axes<EnclosureKernel>::U, &Axes<ExactKernel>::U, finish),
      finish_axis<Enclosure3>(*impl_, &Axes<EnclosureKernel>::V, &Axes<ExactKernel>::V, finish),
      finish_axis<Enclosure3>(*impl_, &Axes<EnclosureKernel>::W, &Axes<ExactKernel>::W, finish)};
}

RoundedFrame ExactCamera::rounded_frame(scene::Precision precision) const {
  const auto finish = [precision](Enclosure first, auto enclose, auto compare) {
    const double nearest = round_to_nearest(std::move(first), enclose, compare);
    return precision == scene::Precision::kDouble ? nearest : round_to_single(nearest, compare);
  };
  using Unit = scene::UnitVector3;
  return {finish_axis<Unit>(*impl_, &Axes<EnclosureKernel>::U, &Axes<ExactKernel>::U, finish),
          finish_axis<Unit>(*impl_, &Axes<EnclosureKernel>::V, &Axes<ExactKernel>::V, finish),
          finish_axis<Unit>(*impl_, &Axes<EnclosureKernel>::W, &Axes<ExactKernel>::W, finish)};
}

EnclosedFrame ExactCamera::frame_within(double relative_change, int bits) const {
  std::optional<CameraNumbers<EnclosureKernel>> scratch;
  const auto& axes = impl_->enclosed(EnclosureLift{bits, relative_change}, scratch).axes;
  return {coordinates(axes.U), coordinates(axes.V), coordinates(axes.W)};
}

Enclosure3 ExactCamera::plane_position(const scene::Pixel& pixel, int bits) const {
  require_pixel_of(impl_->camera, pixel);
  const EnclosureLift lift{bits};
  const auto inputs = lift_camera<EnclosureKernel>(lift, impl_->camera);
  auto position = reference::plane_position<EnclosureKernel>(lift, inputs, impl_->camera,
                                                             impl_->conventions, pixel);
  return {std::move(position.alpha), std::move(position.beta), inputs.near};
}

}  // namespace raycheck::reference
