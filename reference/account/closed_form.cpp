#include "reference/account/closed_form.h"

#include <optional>

#include "reference/account/internal/radical_sum.h"
// The formulas find first_root(RadicalSum) when they are instantiated in this file.
#include "reference/internal/camera_impl.h"
#include "reference/internal/formulas.h"
#include "scene/scene.h"
#include "scene/validate.h"

namespace raycheck::reference {
namespace {

std::string text_of(const ClosedForm::Natural& numerator, const ClosedForm::Natural& denominator) {
  return denominator.is_one() ? numerator.digits : numerator.digits + "/" + denominator.digits;
}

/// The text of a term without its sign.
std::string text_of(const ClosedForm::Term& term) {
  std::string product = text_of(term.numerator, term.denominator);
  if (product == "1" && !term.is_rational()) product.clear();
  const auto times = [&](const std::string& factor) {
    product += (product.empty() ? "" : "*") + factor;
  };
  for (const ClosedForm& sum : term.sums) times("(" + sum.text() + ")");
  for (const ClosedForm& radicand : term.radicands) times("sqrt(" + radicand.text() + ")");
  return product;
}

using SymbolicKernel = CGAL::Simple_cartesian<RadicalSum>;
using SymbolicVector = SymbolicKernel::Vector_3;

struct SymbolicLift {
  using Kernel = SymbolicKernel;
  RadicalSum operator()(double value) const { return RadicalSum(Rational(value)); }
  RadicalSum constant(double value) const { return (*this)(value); }
};

ClosedForm3 closed_forms(const SymbolicVector& v) {
  return {v.x().closed_form(), v.y().closed_form(), v.z().closed_form()};
}

RadicalSum root_factor(const Intersection& intersection) {
  if (intersection.hit_class == HitClass::kTangent) return RadicalSum(0);
  return RadicalSum(intersection.root == WhichRoot::kSmaller ? -1 : 1);
}

}  // namespace

std::string ClosedForm::text() const {
  if (is_zero()) return "0";
  std::string sum;
  for (const Term& term : terms) {
    if (sum.empty()) {
      sum = term.negative ? "-" : "";
    } else {
      sum += term.negative ? " - " : " + ";
    }
    sum += text_of(term);
  }
  return sum;
}

std::vector<std::string> texts(std::span<const ClosedForm> forms) {
  std::vector<std::string> result;
  for (const ClosedForm& form : forms) result.push_back(form.text());
  return result;
}

struct ClosedFormRay::Impl {
  Line<SymbolicKernel> line;
  RadicalSum length;
  std::optional<PlanePosition<RadicalSum>> position;

  LineAndSphere<SymbolicKernel> with(const scene::Sphere& sphere) const {
    scene::require_valid(sphere);
    return line_and_sphere(line, lift_sphere(SymbolicLift{}, sphere));
  }
  /// (v -+ d) / unit
  ClosedForm root_over(const RadicalSum& unit, const scene::Sphere& sphere,
                       const Intersection& intersection) const {
    const auto pair = with(sphere);
    return closed_form_of_sum(linear_coefficient(pair) / length / unit,
                              root_factor(intersection) / unit, discriminant(pair) / line.a);
  }
};

ClosedFormFrame closed_form_frame(const scene::Camera& camera) {
  scene::require_valid(camera);
  const auto axes = camera_numbers(SymbolicLift{}, camera).axes;
  return {closed_forms(axes.U), closed_forms(axes.V), closed_forms(axes.W)};
}

ClosedFormRay::ClosedFormRay(const scene::Camera& camera, const scene::Conventions& conventions,
                             const scene::Pixel& pixel) {
  scene::Scene scene;
  scene.camera = camera;
  scene.conventions = conventions;
  scene::require_valid(scene);
  require_pixel_of(camera, pixel);
  const SymbolicLift lift;
  const auto numbers = camera_numbers(lift, camera);
  auto line = camera_line(lift, numbers, camera, conventions, pixel);
  const RadicalSum length = first_root(line.a);
  impl_ = std::make_shared<const Impl>(Impl{
      std::move(line), length, plane_position(lift, numbers.inputs, camera, conventions, pixel)});
}

ClosedFormRay::ClosedFormRay(const scene::Ray& ray) {
  scene::require_valid(ray);
  auto line = given_line(lift_ray(SymbolicLift{}, ray));
  const RadicalSum length = first_root(line.a);
  impl_ = std::make_shared<const Impl>(Impl{std::move(line), length, std::nullopt});
}

ClosedForm ClosedFormRay::alpha() const { return impl_->position.value().alpha.closed_form(); }
ClosedForm ClosedFormRay::beta() const { return impl_->position.value().beta.closed_form(); }
ClosedForm3 ClosedFormRay::pixel_point() const {
  return closed_forms(impl_->line.base + impl_->line.g);
}
ClosedForm3 ClosedFormRay::origin() const { return closed_forms(ray_origin(impl_->line)); }
ClosedForm3 ClosedFormRay::direction() const { return closed_forms(impl_->line.g / impl_->length); }
ClosedForm ClosedFormRay::length() const { return impl_->length.closed_form(); }

ClosedForm3 ClosedFormRay::to_centre(const scene::Sphere& sphere) const {
  return closed_forms(reference::to_centre(impl_->with(sphere)));
}
ClosedForm ClosedFormRay::axial_distance(const scene::Sphere& sphere) const {
  return (linear_coefficient(impl_->with(sphere)) / impl_->length).closed_form();
}
ClosedForm ClosedFormRay::half_chord_sq(const scene::Sphere& sphere) const {
  return (discriminant(impl_->with(sphere)) / impl_->line.a).closed_form();
}

ClosedForm ClosedFormRay::distance(const scene::Sphere& sphere,
                                   const Intersection& intersection) const {
  return impl_->root_over(RadicalSum(1), sphere, intersection);
}

ClosedForm ClosedFormRay::parameter(const scene::Sphere& sphere,
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
    return closed_form_of_sum(start[k] + mu * g, root_factor(intersection) * g / impl_->length,
                              half_chord_sq);
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

}  // namespace raycheck::reference
