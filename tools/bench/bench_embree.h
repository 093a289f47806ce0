#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "scene/scene.h"

namespace raycheck::tools {

/// A scene's spheres in Embree, in floats, seen by packets of eight rays through neighbouring
/// pixels of a row: lambda of E + lambda g counts from 1, or from 0 of focal rays.
/// Source: the Embree 3 manual, RTC_GEOMETRY_TYPE_SPHERE_POINT, rtcIntersect8.
class EmbreeImage {
 public:
  /// Whether floats have the squares of its magnitudes; else Embree may end the program.
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
