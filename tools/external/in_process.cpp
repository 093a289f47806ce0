#include "tools/external/in_process.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include "tools/external/candidate_spec.h"

namespace raycheck::tools {

const raycheck_candidate& functions_in_process(const std::string& library) {
  void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (loaded == nullptr) throw CandidateError(dlerror());
  using Functions = const raycheck_candidate* (*)();
  const auto functions = reinterpret_cast<Functions>(dlsym(loaded, "raycheck_candidate_functions"));
  const raycheck_candidate* const found = functions == nullptr ? nullptr : functions();
  if (found == nullptr) throw CandidateError("the library has no raycheck_candidate_functions()");
  return *found;
}

raycheck_vector to_c(const scene::Point3& point) { return {point.x, point.y, point.z}; }
raycheck_vector to_c(const scene::Vector3& vector) { return {vector.x, vector.y, vector.z}; }
raycheck_ray to_c(const scene::Ray& ray) { return {to_c(ray.origin), to_c(ray.direction)}; }
raycheck_sphere to_c(const scene::Sphere& sphere) { return {to_c(sphere.centre), sphere.radius}; }

raycheck_camera to_c(const scene::Camera& c) {
  return {to_c(c.eye), to_c(c.look_at), to_c(c.up), c.near,  c.left,
          c.right,     c.bottom,        c.top,      c.width, c.height};
}

raycheck_conventions to_c(const scene::Conventions& c) {
  using namespace scene;  // NOLINT(google-build-using-namespace)
  return {c.rows == Rows::kBottomFirst ? RAYCHECK_ROWS_BOTTOM_FIRST : RAYCHECK_ROWS_TOP_FIRST,
          c.samples == Samples::kEdges ? RAYCHECK_SAMPLES_EDGES : RAYCHECK_SAMPLES_CENTRES,
          c.origin == Origin::kPixel ? RAYCHECK_ORIGIN_PIXEL : RAYCHECK_ORIGIN_FOCAL,
          c.root == Root::kNearest ? RAYCHECK_ROOT_NEAREST : RAYCHECK_ROOT_SMALLER,
          c.tangent == Tangent::kHit    ? RAYCHECK_TANGENT_HIT
          : c.tangent == Tangent::kMiss ? RAYCHECK_TANGENT_MISS
                                        : RAYCHECK_TANGENT_EITHER};
}

}  // namespace raycheck::tools
