#pragma once

// A ray's line under each kernel, and the data of an EnclosedRay. Internal to reference/.

#include "reference/exact_ray.h"
#include "reference/internal/camera_impl.h"
#include "scene/validate.h"

namespace raycheck::reference {

/// The sign of the root of the discriminant; 0 for a tangent, whose two roots are equal.
inline int root_sign(const Intersection& intersection) {
  if (intersection.hit_class == HitClass::kTangent) return 0;
  return intersection.root == WhichRoot::kSmaller ? -1 : 1;
}

// Call use(camera) with the camera of each kernel, which is kept or lifted again.
template <class Lift, class Use>
auto with_numbers(const Lift& lift, const ExactCamera::Impl& camera, Use use) {
  return use(camera_numbers(lift, camera.camera));
}
template <class Use>
auto with_numbers(const IntervalLift& /*lift*/, const ExactCamera::Impl& camera, Use use) {
  return use(camera.intervals);
}
template <class Use>
auto with_numbers(const DoubleDoubleLift& /*lift*/, const ExactCamera::Impl& camera, Use use) {
  return use(camera.double_doubles());
}
template <class Use>
auto with_numbers(const EnclosureLift& lift, const ExactCamera::Impl& camera, Use use) {
  return camera.enclosed(lift, use);
}
template <class Use>
auto with_numbers(const ExactLift& /*lift*/, const ExactCamera::Impl& camera, Use use) {
  return use(camera.exact());
}

inline const scene::Point3& base_of(const ExactRay::Source& source) {
  return source.camera != nullptr ? source.camera->camera.eye : source.given.origin;
}

/// The line of a ray, through a camera's pixel or given.
template <class Lift>
Line<typename Lift::Kernel> line_of(const Lift& lift, const ExactRay::Source& source) {
  if (source.camera == nullptr) return given_line(lift_ray(lift, source.given));
  return with_numbers(lift, *source.camera, [&](const auto& numbers) {
    return camera_line(lift, numbers, source.camera->camera, source.camera->conventions,
                       source.pixel);
  });
}

/// The line of a ray in double-doubles, which the ray caches.
inline Line<DoubleDoubleKernel> line_in_double_doubles(const ExactRay& ray) {
  const ExactRay::Source& source = ray.source();
  if (source.camera == nullptr) return given_line(lift_ray(DoubleDoubleLift{}, source.given));
  const auto [g, a] = ray.direction_in_double_doubles();
  return {lift_vector(DoubleDoubleLift{}, base_of(source)),
          {g.x, g.y, g.z},
          a,
          source.camera->conventions.origin == scene::Origin::kPixel,
          true};
}

struct EnclosedRay::Impl {
  Line<EnclosureKernel> line;
  EnclosureLift lift;

  LineAndSphere<EnclosureKernel> with(const scene::Sphere& sphere) const {
    scene::require_valid(sphere);
    return line_and_sphere(line, lift_sphere(lift, sphere));
  }
};

}  // namespace raycheck::reference
