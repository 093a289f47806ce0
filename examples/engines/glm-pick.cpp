// GLM's unProject of a pixel's points on the near and far planes of lookAt and frustum, then
// intersectRaySphere with a position (glm-point.cpp), in doubles. unProject: "Map the specified
// window coordinates (win.x, win.y, win.z) into object coordinates". Debian: libglm-dev.
// Source: glm/ext/matrix_projection.hpp, glm/gtx/intersect.hpp. Silent on errors and on tangents;
// hits nearer than the ulp of 1 count as behind the origin.

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_projection.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtx/intersect.hpp>

#include "adapter.h"

using namespace raycheck;
using glm::dvec3;

static std::optional<Hit> pick(const Camera& camera, const Conventions&, Pixel pixel,
                               const Sphere& sphere) {
  const auto view =
      glm::lookAt(to<dvec3>(camera.eye), to<dvec3>(camera.look_at), to<dvec3>(camera.up));
  const double near = -camera.near_plane;
  const auto projection =
      glm::frustum(camera.left, camera.right, camera.bottom, camera.top, near, 1000 * near);
  const glm::dvec4 window(0, 0, static_cast<double>(camera.width),
                          static_cast<double>(camera.height));
  const auto at = [&](double depth) {
    const dvec3 place(static_cast<double>(pixel.i) + 0.5, static_cast<double>(pixel.j) + 0.5,
                      depth);
    return glm::unProject(place, view, projection, window);
  };
  const dvec3 from = at(0), direction = glm::normalize(at(1) - from);
  dvec3 point, normal;
  if (!glm::intersectRaySphere(from, direction, to<dvec3>(sphere.centre), sphere.radius, point,
                               normal)) {
    return std::nullopt;
  }
  return Hit{.point = {point.x, point.y, point.z}};
}

RAYCHECK_CANDIDATE(.rows = Rows::bottom_first, .samples = Samples::centres, .origin = Origin::pixel,
                   .root = Root::nearest, .tangent = Tangent::either, .pick = pick,
                   .level = Level::ordinary, .returns = Returns::point,
                   .contract = "windows symmetric")
