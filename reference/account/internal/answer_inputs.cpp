#include "reference/account/internal/answer_inputs.h"

#include "reference/internal/ray_impl.h"

namespace raycheck::reference {
namespace {

using DoubleKernel = CGAL::Simple_cartesian<double>;

/// Records what it lifts.
struct NotingLift {
  double operator()(double value) const {
    noted.push_back(value);
    return value;
  }

  std::vector<double>& noted;
};

}  // namespace

std::vector<double> inputs_of(const ExactRay& ray, std::span<const scene::Sphere> spheres) {
  std::vector<double> result;
  const NotingLift lift{result};
  const ExactRay::Source& source = ray.source();
  if (source.camera) {
    lift_camera<DoubleKernel>(lift, source.camera->camera);
  } else {
    lift_ray<DoubleKernel>(lift, source.given);
  }
  for (const scene::Sphere& sphere : spheres) lift_sphere<DoubleKernel>(lift, sphere);
  return result;
}

}  // namespace raycheck::reference
