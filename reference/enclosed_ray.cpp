#include "reference/internal/ray_impl.h"

namespace raycheck::reference {

Enclosure3 EnclosedRay::origin() const { return coordinates(ray_origin(impl_->line)); }
Enclosure3 EnclosedRay::pixel_point() const {
  return coordinates(impl_->line.base + impl_->line.g);
}
Enclosure3 EnclosedRay::direction() const { return coordinates(unit_direction(impl_->line)); }
Enclosure EnclosedRay::length() const { return ray_length(impl_->line); }

Enclosure EnclosedRay::parameter(const scene::Sphere& sphere,
                                 const Intersection& intersection) const {
  return ray_parameter(impl_->with(sphere), root_sign(intersection));
}
Enclosure3 EnclosedRay::point(const scene::Sphere& sphere, const Intersection& intersection) const {
  return coordinates(hit_point(impl_->with(sphere), root_sign(intersection)));
}

Enclosure EnclosedRay::half_chord_sq(const scene::Sphere& sphere) const {
  return reference::half_chord_sq(impl_->with(sphere));
}
Enclosure EnclosedRay::axial_distance(const scene::Sphere& sphere) const {
  return reference::axial_distance(impl_->with(sphere));
}

EnclosedRay ExactRay::enclose(int bits, double relative_change) const {
  const EnclosureLift lift{bits, relative_change};
  return EnclosedRay(
      std::make_shared<const EnclosedRay::Impl>(EnclosedRay::Impl{line_of(lift, source_), lift}));
}

}  // namespace raycheck::reference
