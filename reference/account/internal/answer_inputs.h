#pragma once

// The inputs of rays and spheres as they are listed in an InputChange. Internal to reference/.

#include <span>
#include <vector>

#include "reference/exact_ray.h"

namespace raycheck::reference {

std::vector<double> inputs_of(const ExactRay& ray, std::span<const scene::Sphere> spheres);

}  // namespace raycheck::reference
