#pragma once

// A ray's line under each kernel, and what an EnclosedRay holds. Internal to reference/.

#include "reference/exact_ray.h"
#include "reference/internal/camera_impl.h"
#include "scene/validate.h"

namespace raycheck::reference {

/// Of the root of a discriminant: 0 for a tangent, whose two roots are one.
inline int root_sign(const Intersection& intersection) {
  if (intersection.hit_class == HitClass::kTangent) return 0;
  return intersection.root == WhichRoot::kSmaller ? -1 : 1;
}

// A camera under each approximate kernel.
inline const CameraNumbers<IntervalKernel>& numbers_of(const IntervalLift& /*lift*/,
                                                       const ExactCamera::Impl& camera) {
  return camera.intervals;
}
inline CameraNumbers<EnclosureKernel> numbers_of(const EnclosureLift& lift,
                                                 const ExactCamera::Impl& camera) {
  std::optional<CameraNumbers<EnclosureKernel>> scratch;
  return camera.enclosed(lift, scratch);
}

/// E, or a given ray's own origin.
inline const scene::Point3& base_of(const ExactRay::Source& source) {
  return source.camera != nullptr ? source.camera->camera.eye : source.given.origin;
}

// The line of a ray under each kernel: through a camera's pixel, or given.
template <class K, class Lift>
Line<K> line_of(const Lift& lift, const CameraNumbers<K>& numbers, const ExactRay::Source& source) {
  return camera_line<K>(lift, numbers, source.camera->camera, source.camera->conventions,
                        source.pixel);
}

inline Line<IntervalKernel> line_of(const IntervalLift& lift, const ExactRay::Source& source) {
  if (source.camera == nullptr) return given_line(lift_ray<IntervalKernel>(lift, source.given));
  return line_of(lift, source.camera->intervals, source);
}

inline Line<DoubleDoubleKernel> line_of(const DoubleDoubleLift& lift,
                                        const ExactRay::Source& source) {
  if (source.camera == nullptr) return given_line(lift_ray<DoubleDoubleKernel>(lift, source.given));
  return line_of(lift, source.camera->double_doubles, source);
}

/// The same, as the ray caches it.
inline Line<DoubleDoubleKernel> line_in_double_doubles(const ExactRay& ray) {
  const ExactRay::Source& source = ray.source();
  const auto [g, a] = ray.direction_in_double_doubles();
  const bool from_camera = source.camera != nullptr;
  return {lift_vector<DoubleDoubleKernel>(DoubleDoubleLift{}, base_of(source)),
          {g.x, g.y, g.z},
          a,
          from_camera && source.camera->conventions.origin == scene::Origin::kPixel,
          from_camera};
}

inline Line<EnclosureKernel> line_of(const EnclosureLift& lift, const ExactRay::Source& source) {
  if (source.camera == nullptr) return given_line(lift_ray<EnclosureKernel>(lift, source.given));
  std::optional<CameraNumbers<EnclosureKernel>> scratch;
  return line_of(lift, source.camera->enclosed(lift, scratch), source);
}

inline Line<ExactKernel> line_of(const ExactLift& lift, const ExactRay::Source& source) {
  if (source.camera == nullptr) return given_line(lift_ray<ExactKernel>(lift, source.given));
  return line_of(lift, source.camera->exact, source);
}

/// The line with every input lifted anew, for lifts that count them (they name their Kernel).
template <class Lift>
Line<typename Lift::Kernel> lifted_line(const Lift& lift, const ExactRay::Source& source) {
  using K = typename Lift::Kernel;
  if (source.camera == nullptr) return given_line(lift_ray<K>(lift, source.given));
  return line_of(lift, camera_numbers<K>(lift, source.camera->camera), source);
}

struct EnclosedRay::Impl {
  Line<EnclosureKernel> line;
  EnclosureLift lift;

  LineAndSphere<EnclosureKernel> with(const scene::Sphere& sphere) const {
    scene::require_valid(sphere);
    return line_and_sphere(line, lift_sphere<EnclosureKernel>(lift, sphere));
  }
};

}  // namespace raycheck::reference
