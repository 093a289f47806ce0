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
      middle_bits(camera_numbers(EnclosureLift{kMiddleBits}, camera)),
      intervals{lift_camera(IntervalLift{}, camera),
                converted<IntervalKernel>(middle_bits.axes, bounds)},
      double_doubles{lift_camera(DoubleDoubleLift{}, camera),
                     converted<DoubleDoubleKernel>(
                         middle_bits.axes, [](const Enclosure& x) { return DoubleDouble(x); })} {}

const CameraNumbers<ExactKernel>& ExactCamera::Impl::exact() const {
  return exact_.get([this] { return camera_numbers(ExactLift{}, camera); });
}

CameraNumbers<EnclosureKernel> ExactCamera::Impl::enclosed(const EnclosureLift& lift) const {
  if (lift.relative_change == 0 && lift.bits == kFirstBits) {
    return first_bits_.get([&] { return camera_numbers(lift, camera); });
  }
  if (lift.relative_change == 0 && lift.bits == kMiddleBits) return middle_bits;
  return camera_numbers(lift, camera);
}

ExactCamera::ExactCamera(const scene::Camera& camera, const scene::Conventions& conventions)
    : impl_(std::make_shared<Impl>(camera, conventions)) {}

const scene::Camera& ExactCamera::camera() const { return impl_->camera; }
const scene::Conventions& ExactCamera::conventions() const { return impl_->conventions; }

namespace {

/// Narrows or rounds every coordinate of the axes.
template <class Frame, class Finish>
Frame finish_frame(const ExactCamera::Impl& impl, Finish finish) {
  const auto first_bits = impl.enclosed(EnclosureLift{kFirstBits});
  const auto axis = [&](auto of, auto exact_of) -> decltype(Frame::U) {
    const auto coordinate = [&](int k) {
      return finish(
          (first_bits.axes.*of)[k],
          [&, k](int bits) { return (impl.enclosed(EnclosureLift{bits}).axes.*of)[k]; },
          [&, k](const Rational& m) {
            return *certain_sign((impl.exact().axes.*exact_of)[k] - ExactNumber(FirstExtension(m)));
          });
    };
    return {coordinate(0), coordinate(1), coordinate(2)};
  };
  return {axis(&Axes<EnclosureKernel>::U, &Axes<ExactKernel>::U),
          axis(&Axes<EnclosureKernel>::V, &Axes<ExactKernel>::V),
          axis(&Axes<EnclosureKernel>::W, &Axes<ExactKernel>::W)};
}

}  // namespace

EnclosedFrame ExactCamera::frame(int relative_bits) const {
  return finish_frame<EnclosedFrame>(*impl_, Narrow{relative_bits});
}

RoundedFrame ExactCamera::rounded_frame(scene::Precision precision) const {
  return finish_frame<RoundedFrame>(*impl_, Round{precision});
}

Enclosure3 ExactCamera::plane_position(const scene::Pixel& pixel, int bits) const {
  require_pixel_of(impl_->camera, pixel);
  const EnclosureLift lift{bits};
  const auto inputs = lift_camera(lift, impl_->camera);
  auto position = reference::plane_position(lift, inputs, impl_->camera, impl_->conventions, pixel);
  return {std::move(position.alpha), std::move(position.beta), inputs.near};
}

}  // namespace raycheck::reference
