#include "reference/closed_form.h"

#include <optional>

#include "reference/internal/radical_sum.h"
// The formulas find first_root(RadicalSum) when they are instantiated here.
#include "reference/internal/camera_impl.h"
#include "reference/internal/formulas.h"
#include "scene/scene.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

using SymbolicKernel = CGAL::Simple_cartesian<RadicalSum>;
using SymbolicVector = SymbolicKernel::Vector_3;

struct SymbolicLift {
  RadicalSum operator()(double value) const { return RadicalSum(Rational(value)); }
  RadicalSum constant(double value) const { return (*this)(value); }
};

ClosedForm3 texts(const SymbolicVector& v) { return {v.x().text(), v.y().text(), v.z().text()}; }

RadicalSum root_factor(const Intersection& intersection) {
  if (intersection.hit_class == HitClass::kTangent) return RadicalSum(0);
  return RadicalSum(intersection.root == WhichRoot::kSmaller ? -1 : 1);
}

}  // namespace

struct ClosedFormRay::Impl {
  Line<SymbolicKernel> line;
  RadicalSum length;
  std::optional<PlanePosition<RadicalSum>> position;

  LineAndSphere<SymbolicKernel> with(const scene::Sphere& sphere) const {
    scene::require_valid(sphere);
    return line_and_sphere(line, lift_sphere<SymbolicKernel>(SymbolicLift{}, sphere));
  }
  /// (v -+ d) / unit
  std::string root_over(const RadicalSum& unit, const scene::Sphere& sphere,
                        const Intersection& intersection) const {
    const auto pair = with(sphere);
    return text_of_sum(linear_coefficient(pair) / length / unit, root_factor(intersection) / unit,
                       discriminant(pair) / line.a);
  }
};

ClosedFormFrame closed_form_frame(const scene::Camera& camera) {
  scene::require_valid(camera);
  const auto axes = camera_numbers<SymbolicKernel>(SymbolicLift{}, camera).axes;
  return {texts(axes.U), texts(axes.V), texts(axes.W)};
}

ClosedFormRay::ClosedFormRay(const scene::Camera& camera, const scene::Conventions& conventions,
                             const scene::Pixel& pixel) {
  scene::Scene scene;
  scene.camera = camera;
  scene.conventions = conventions;
  scene::require_valid(scene);
  require_pixel_of(camera, pixel);
  const SymbolicLift lift;
  const auto numbers = camera_numbers<SymbolicKernel>(lift, camera);
  auto line = camera_line<SymbolicKernel>(lift, numbers, camera, conventions, pixel);
  const RadicalSum length = first_root(line.a);
  impl_ = std::make_shared<const Impl>(
      Impl{std::move(line), length,
           plane_position<SymbolicKernel>(lift, numbers.inputs, camera, conventions, pixel)});
}

ClosedFormRay::ClosedFormRay(const scene::Ray& ray) {
  scene::require_valid(ray);
  auto line = given_line(lift_ray<SymbolicKernel>(SymbolicLift{}, ray));
  const RadicalSum length = first_root(line.a);
  impl_ = std::make_shared<const Impl>(Impl{std::move(line), length, std::nullopt});
}

std::string ClosedFormRay::alpha() const { return impl_->position.value().alpha.text(); }
std::string ClosedFormRay::beta() const { return impl_->position.value().beta.text(); }
ClosedForm3 ClosedFormRay::pixel_point() const { return texts(impl_->line.base + impl_->line.g); }
ClosedForm3 ClosedFormRay::origin() const { return texts(ray_origin(impl_->line)); }
ClosedForm3 ClosedFormRay::direction() const { return texts(impl_->line.g / impl_->length); }
std::string ClosedFormRay::length() const { return impl_->length.text(); }

ClosedForm3 ClosedFormRay::to_centre(const scene::Sphere& sphere) const {
  return texts(reference::to_centre(impl_->with(sphere)));
}
std::string ClosedFormRay::axial_distance(const scene::Sphere& sphere) const {
  return (linear_coefficient(impl_->with(sphere)) / impl_->length).text();
}
std::string ClosedFormRay::half_chord_sq(const scene::Sphere& sphere) const {
  return (discriminant(impl_->with(sphere)) / impl_->line.a).text();
}

std::string ClosedFormRay::distance(const scene::Sphere& sphere,
                                    const Intersection& intersection) const {
  return impl_->root_over(RadicalSum(1), sphere, intersection);
}

std::string ClosedFormRay::parameter(const scene::Sphere& sphere,
                                     const Intersection& intersection) const {
  return impl_->root_over(impl_->position ? RadicalSum(1) : impl_->length, sphere, intersection);
}

ClosedForm3 ClosedFormRay::point(const scene::Sphere& sphere,
                                 const Intersection& intersection) const {
  const auto pair = impl_->with(sphere);
  const SymbolicVector start = ray_origin(impl_->line);
  const RadicalSum mu = linear_coefficient(pair) / impl_->line.a;
  const RadicalSum half_chord_sq = discriminant(pair) / impl_->line.a;
  const auto coordinate = [&](int k) {
    const RadicalSum& g = impl_->line.g[k];
    return text_of_sum(start[k] + mu * g, root_factor(intersection) * g / impl_->length,
                       half_chord_sq);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

}  // namespace raycheck::reference
