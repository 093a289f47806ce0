#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "scene/scene.h"

namespace raycheck::tools {

/// A scene's spheres in Embree, in floats. Packets of eight rays E + lambda g, through neighbouring
/// pixels of a row, find the nearest sphere with lambda >= 1; for focal rays, with lambda >= 0.
/// Source: the Embree 3 manual, RTC_GEOMETRY_TYPE_SPHERE_POINT, rtcIntersect8.
class EmbreeImage {
 public:
  /// Whether the squares of the scene's magnitudes are normal floats. If not, Embree may end the
  /// program.
  static bool has(const scene::Scene& scene);

  /// Domain: has(scene).
  explicit EmbreeImage(const scene::Scene& scene);
  ~EmbreeImage();

  /// The nearest sphere of every pixel, or -1, row by row.
  void nearest(std::span<std::int32_t> spheres) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace raycheck::tools
