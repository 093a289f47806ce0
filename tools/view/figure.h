#ifndef RAYCHECK_TOOLS_VIEW_FIGURE_H_
#define RAYCHECK_TOOLS_VIEW_FIGURE_H_

#include <functional>

#include "reference/enclosure.h"
#include "reference/exact_ray.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// Where drawn coordinates have their origin, and how they are scaled: by a power of two, which
/// brings the camera's image plane, or without one the first ray's way to the first sphere, near 1.
class DrawnFrame {
 public:
  explicit DrawnFrame(const scene::Scene& scene);

  const scene::Point3& origin() const { return origin_; }
  int exponent() const { return exponent_; }

  /// Exact but for one rounding; infinite where the scaled coordinate leaves the double range.
  Drawn point(const scene::Point3& point) const;
  double length(double length) const;
  /// A point that is known by enclosures of any precision, to within 2^-40 of its distance from the
  /// origin or better.
  Drawn point(const std::function<reference::Enclosure3(int bits)>& enclose) const;

 private:
  scene::Point3 origin_;
  int exponent_ = 0;
};

/// What is drawn of a scene: at most `most_spheres` of its spheres.
/// Domain: a valid scene.
Figure figure_of(const scene::Scene& scene, std::size_t most_spheres);

/// What is drawn of one ray and a sphere (null: none) under the conventions of the scene.
PanelDrawing drawing_of(const DrawnFrame& frame, const reference::ExactRay& ray,
                        const scene::Sphere* sphere, const scene::Conventions& conventions);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_VIEW_FIGURE_H_
