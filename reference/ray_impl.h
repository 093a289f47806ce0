#ifndef RAYCHECK_REFERENCE_RAY_IMPL_H_
#define RAYCHECK_REFERENCE_RAY_IMPL_H_

// A ray's line under each kernel, and what an EnclosedRay holds. Internal to reference/.

#include "reference/camera_impl.h"
#include "reference/exact_ray.h"
#include "scene/validate.h"

namespace raycheck::reference {

inline int root_sign(const Intersection& intersection) {
  return intersection.root == WhichRoot::kSmaller ? -1 : 1;
}

/// The line of a ray under one kernel: through a camera's pixel, or given.
template <class K, class Lift>
Line<K> line_of(const Lift& lift, const ExactCamera::Impl* camera, const Axes<K>* axes,
                const scene::Pixel& pixel, const scene::Ray& given) {
  if (camera == nullptr) return given_line<K>(lift, given);
  return camera_line<K>(lift, camera->camera, camera->conventions, *axes, pixel);
}

inline Line<ExactKernel> exact_line(const ExactCamera::Impl* camera, const scene::Pixel& pixel,
                                    const scene::Ray& given) {
  return line_of<ExactKernel>(ExactLift{}, camera, camera ? &camera->axes_exact : nullptr, pixel,
                              given);
}

inline Line<EnclosureKernel> enclosed_line(const EnclosureLift& lift,
                                           const ExactCamera::Impl* camera,
                                           const scene::Pixel& pixel, const scene::Ray& given) {
  if (camera == nullptr) return given_line<EnclosureKernel>(lift, given);
  std::optional<Axes<EnclosureKernel>> scratch;
  const auto& axes = camera->enclosed_axes(lift.bits, lift.relative_change, scratch);
  return line_of<EnclosureKernel>(lift, camera, &axes, pixel, given);
}

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

}  // namespace raycheck::reference

#endif  // RAYCHECK_REFERENCE_RAY_IMPL_H_
