#pragma once

#include <cstdint>
#include <optional>

#include "scene/geometry.h"

namespace raycheck::scene {

/// A camera as in the lecture: W = (eye - look_at) normalised, U = up x W normalised, V = W x U.
/// Lengths are scene lengths; near and far are signed positions along W, negative in front of the
/// eye; the image plane is at near and bounded along U by left, right and along V by bottom, top.
/// left > right or bottom > top mirrors the image.
struct Camera {
  Point3 eye;
  Point3 look_at;
  Vector3 up;
  double near = 0;
  std::optional<double> far;  ///< No formula uses it; kept for the files that state it.
  double left = 0;
  double right = 0;
  double bottom = 0;
  double top = 0;
  std::int64_t width = 0;   ///< Pixels across.
  std::int64_t height = 0;  ///< Pixels down.
  bool operator==(const Camera&) const = default;
};

/// The most pixels that an image may have across, and down, so that pixel indices fit 64 bits.
inline constexpr std::int64_t kMostPixelsAcross = (std::int64_t{1} << 31) - 1;

/// Pixel (i, j): column i of width, row j of height, counted as the `rows` convention says.
struct Pixel {
  std::int64_t i = 0;
  std::int64_t j = 0;
  bool operator==(const Pixel&) const = default;
};

}  // namespace raycheck::scene
