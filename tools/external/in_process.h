#pragma once

#include <raycheck/candidate.h>

#include <string>

#include "scene/scene.h"

namespace raycheck::tools {

/// The functions of someone else's shared library, called in raycheck's own process: nothing keeps
/// it there. It is loaded once and stays, since what it has started may still run.
/// Errors: CandidateError where it is no such library.
const raycheck_candidate& functions_in_process(const std::string& library);

raycheck_vector to_c(const scene::Point3& point);
raycheck_vector to_c(const scene::Vector3& vector);
raycheck_ray to_c(const scene::Ray& ray);
raycheck_sphere to_c(const scene::Sphere& sphere);
raycheck_camera to_c(const scene::Camera& camera);
raycheck_conventions to_c(const scene::Conventions& conventions);

}  // namespace raycheck::tools
