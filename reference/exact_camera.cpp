#include "reference/exact_camera.h"

#include <optional>
#include <stdexcept>
#include <string>

#include "reference/internal/camera_impl.h"
#include "scene/scene.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

const scene::Camera& validated(const scene::Camera& camera, const scene::Conventions& conventions) {
  scene::require_valid(camera, conventions);
  return camera;
}

/// Axes under another kernel; convert(coordinate) encloses the coordinate.
template <class K, class From, class Convert>
Axes<K> converted(const Axes<From>& axes, Convert convert) {
  const auto vector = [&](const typename From::Vector_3& v) {
    return typename K::Vector_3(convert(v.x()), convert(v.y()), convert(v.z()));
  };
  return {vector(axes.U), vector(axes.V), vector(axes.W)};
}

/// The axes by double-doubles; empty if an interval would be wider than the gap of two doubles.
std::optional<Axes<IntervalKernel>> axes_by_double_doubles(const scene::Camera& camera) {
  return by_double_doubles([&]() -> std::optional<Axes<IntervalKernel>> {
    constexpr int kNarrow = 60;
    bool is_narrow = true;
    const auto axes = converted<IntervalKernel>(
        camera_axes(lift_camera(DoubleDoubleLift{}, camera)), [&](const DoubleDouble& x) {
          is_narrow = is_narrow && x.is_within(kNarrow);
          return Interval(x.lower(), x.upper());
        });
    return is_narrow ? std::optional(axes) : std::nullopt;
  });
}

Axes<IntervalKernel> axes_in_intervals(const scene::Camera& camera) {
  if (const auto axes = axes_by_double_doubles(camera)) return *axes;
  return converted<IntervalKernel>(
      camera_numbers(EnclosureLift{kMiddleBits}, camera).axes,
      [](const Enclosure& x) { return Interval(x.lower(), x.upper()); });
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
      intervals{lift_camera(IntervalLift{}, camera), axes_in_intervals(camera)},
      quick(intervals.axes) {}

/// Computed from balls, which gives narrower axes than double-doubles.
const CameraNumbers<DoubleDoubleKernel>& ExactCamera::Impl::double_doubles() const {
  return double_doubles_.get([this]() -> CameraNumbers<DoubleDoubleKernel> {
    const NearestGuard guard;
    return {lift_camera(DoubleDoubleLift{}, camera),
            converted<DoubleDoubleKernel>(middle_bits().axes,
                                          [](const Enclosure& x) { return DoubleDouble(x); })};
  });
}

const CameraNumbers<EnclosureKernel>& ExactCamera::Impl::first_bits() const {
  return first_bits_.get([this] { return camera_numbers(EnclosureLift{kFirstBits}, camera); });
}

const CameraNumbers<EnclosureKernel>& ExactCamera::Impl::middle_bits() const {
  return middle_bits_.get([this] { return camera_numbers(EnclosureLift{kMiddleBits}, camera); });
}

const CameraNumbers<ExactKernel>& ExactCamera::Impl::exact() const {
  return exact_.get([this] { return camera_numbers(ExactLift{}, camera); });
}

ExactCamera::ExactCamera(const scene::Camera& camera, const scene::Conventions& conventions)
    : impl_(std::make_shared<Impl>(camera, conventions)) {}

const scene::Camera& ExactCamera::camera() const { return impl_->camera; }
const scene::Conventions& ExactCamera::conventions() const { return impl_->conventions; }

namespace {

template <class Frame, class Finish>
Frame finish_frame(const ExactCamera::Impl& impl, Finish finish) {
  const auto axis = [&](auto of, auto exact_of) -> decltype(Frame::U) {
    const auto coordinate = [&](int k) {
      const auto enclose = [&impl, of, k](int bits) {
        return impl.enclosed(EnclosureLift{bits}, [of, k](const auto& numbers) -> Enclosure {
          return (numbers.axes.*of)[k];
        });
      };
      return finish(enclose(kFirstBits), enclose, [&, k](const Rational& m) {
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

DoubleDoubleFrame ExactCamera::frame_in_double_doubles() const {
  const auto triple = [](const DoubleDoubleKernel::Vector_3& v) {
    return Triple<DoubleDouble>{v.x(), v.y(), v.z()};
  };
  const auto& [U, V, W] = impl_->double_doubles().axes;
  return {triple(U), triple(V), triple(W)};
}

Enclosure3 ExactCamera::plane_position(const scene::Pixel& pixel, int bits) const {
  require_pixel_of(impl_->camera, pixel);
  const EnclosureLift lift{bits};
  return impl_->enclosed(lift, [&](const auto& numbers) -> Enclosure3 {
    auto position =
        reference::plane_position(lift, numbers.inputs, impl_->camera, impl_->conventions, pixel);
    return {std::move(position.alpha), std::move(position.beta), numbers.inputs.near};
  });
}

Triple<DoubleDouble> ExactCamera::plane_position_in_double_doubles(
    const scene::Pixel& pixel) const {
  require_pixel_of(impl_->camera, pixel);
  return by_double_doubles([&]() -> Triple<DoubleDouble> {
    const auto& inputs = impl_->double_doubles().inputs;
    const auto [alpha, beta] = reference::plane_position(DoubleDoubleLift{}, inputs, impl_->camera,
                                                         impl_->conventions, pixel);
    return {alpha, beta, inputs.near};
  });
}

}  // namespace raycheck::reference
