#include "reference/ray_impl.h"

namespace raycheck::reference {
namespace {

/// The root's sqrt(discriminant) with its sign, as an enclosure; exactly 0 for a tangent.
Enclosure signed_root(const LineAndSphere<EnclosureKernel>& pair,
                      const Intersection& intersection) {
  if (intersection.hit_class == HitClass::kTangent) return Enclosure(0);
  const Enclosure root = sqrt(discriminant(pair));
  return intersection.root == WhichRoot::kSmaller ? -root : root;
}

}  // namespace

Enclosure3 EnclosedRay::origin() const { return coordinates(impl_->start()); }
Enclosure3 EnclosedRay::pixel_point() const {
  return coordinates(impl_->line.base + impl_->line.g);
}
Enclosure3 EnclosedRay::direction() const { return coordinates(impl_->line.g / length()); }
Enclosure EnclosedRay::length() const { return sqrt(impl_->line.a); }

Enclosure EnclosedRay::parameter(const scene::Sphere& sphere,
                                 const Intersection& intersection) const {
  const auto pair = impl_->with(sphere);
  const Enclosure numerator = linear_coefficient(pair) + signed_root(pair, intersection);
  return numerator / (impl_->from_camera ? length() : impl_->line.a);
}

Enclosure3 EnclosedRay::point(const scene::Sphere& sphere, const Intersection& intersection) const {
  const auto pair = impl_->with(sphere);
  const Enclosure mu = (linear_coefficient(pair) + signed_root(pair, intersection)) / impl_->line.a;
  return coordinates(impl_->start() + mu * impl_->line.g);
}

Enclosure EnclosedRay::half_chord_sq(const scene::Sphere& sphere) const {
  return discriminant(impl_->with(sphere)) / impl_->line.a;
}

Enclosure EnclosedRay::axial_distance(const scene::Sphere& sphere) const {
  return linear_coefficient(impl_->with(sphere)) / length();
}

EnclosedRay ExactRay::enclose(int bits, double relative_change) const {
  const EnclosureLift lift{bits, relative_change};
  return EnclosedRay(std::make_shared<const EnclosedRay::Impl>(EnclosedRay::Impl{
      enclosed_line(lift, camera_.get(), pixel_, given_), camera_ != nullptr, lift}));
}

}  // namespace raycheck::reference
