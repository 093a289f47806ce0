// Cases as in course assignments: cameras and spheres with few digits. The usual formulas are
// right, and the usual mistakes give other answers. No ray from E or from P starts inside a sphere.

#include <algorithm>
#include <cmath>

#include "properties/cases/case_list.h"
#include "properties/cases/generators.h"

namespace raycheck::properties {
namespace {

constexpr double kGrain = 0.25;        ///< Coordinates are multiples of it, radii of its half.
constexpr double kFineGrain = 0x1p-6;  ///< Grain and gap in front of the image plane.
constexpr double kGap = 0.0625;        ///< How far spheres stay from planes that they avoid.

double quarters(Random& random, std::int64_t low, std::int64_t high) {
  return kGrain * static_cast<double>(random.integer(low, high));
}

Camera course_camera(Random& random) {
  Camera camera;
  for (double* x : {&camera.eye.x, &camera.eye.y, &camera.eye.z}) *x = quarters(random, -32, 32);
  Vector3 view;
  do {
    for (double* x : {&view.x, &view.y, &view.z}) *x = random.small_integer(6);
  } while (dot(view, view) < 4);
  camera.look_at = along(camera.eye, 1, view);
  camera.up = {0, 1, 0};
  // A camera whose `up` is nearly along the view is not ordinary.
  while (dot(cross(camera.up, view), cross(camera.up, view)) <=
             0.1 * dot(view, view) * dot(camera.up, camera.up) ||
         random.one_in(2)) {
    for (double* x : {&camera.up.x, &camera.up.y, &camera.up.z}) *x = random.small_integer(3);
  }
  camera.near = -quarters(random, 2, 12);
  camera.left = -quarters(random, 1, 10);
  camera.right = quarters(random, 1, 10);
  camera.bottom = -quarters(random, 1, 10);
  camera.top = quarters(random, 1, 10);
  camera.width = random.integer(8, 24);
  do {
    camera.height = random.integer(6, 18);
  } while (camera.height == camera.width);
  return camera;
}

/// The axes of a camera, and points in its view.
struct View {
  explicit View(const Camera& of) : camera(of), axes(of) {}

  /// A direction towards a point of the image plane, sometimes a little outside its bounds.
  Vector3 sight(Random& random) const {
    const double alpha = random.between(1.1 * camera.left, 1.1 * camera.right);
    const double beta = random.between(1.1 * camera.bottom, 1.1 * camera.top);
    const Vector3 along_w = times(camera.near, axes.w);
    const Vector3 along_u = times(alpha, axes.u);
    const Vector3 along_v = times(beta, axes.v);
    return {along_w.x + along_u.x + along_v.x, along_w.y + along_u.y + along_v.y,
            along_w.z + along_u.z + along_v.z};
  }
  /// The depth of a point before the eye.
  double depth(const Point3& point) const { return -dot(point - camera.eye, axes.w); }

  const Camera& camera;
  const Axes axes;
};

Sphere rounded(const Point3& centre, double radius, double grain) {
  const auto round = [grain](double x) { return grain * std::round(x / grain); };
  return {{round(centre.x), round(centre.y), round(centre.z)},
          std::max(grain / 2, (grain / 2) * std::round(radius / (grain / 2)))};
}

/// A sphere entirely beyond the image plane.
Sphere beyond(Random& random, const View& view) {
  const Camera& camera = view.camera;
  for (;;) {
    const Vector3 sight = view.sight(random);
    const double times_near = random.between(1.5, 6);
    const double share = random.between(0.1, 0.8);
    const Sphere sphere = rounded(along(camera.eye, times_near, sight),
                                  share * (times_near - 1) * -camera.near, kGrain);
    if (view.depth(sphere.centre) - sphere.radius > -camera.near + kGap) return sphere;
  }
}

/// A sphere behind the eye, on the backward extension of rays.
Sphere behind(Random& random, const View& view) {
  const Camera& camera = view.camera;
  for (;;) {
    const Vector3 sight = view.sight(random);
    const double times_near = random.between(0.5, 5);
    const double share = random.between(0.1, 0.8);
    const Sphere sphere =
        rounded(along(camera.eye, -times_near, sight), share * times_near * -camera.near, kGrain);
    if (view.depth(sphere.centre) + sphere.radius < -kGap) return sphere;
  }
}

/// A sphere between the eye and the image plane.
Sphere before(Random& random, const View& view) {
  const Camera& camera = view.camera;
  const double near = -camera.near;
  for (;;) {
    const Vector3 sight = view.sight(random);
    const double share = random.between(0.3, 0.7);
    const double size = random.between(0.1, 0.25);
    const Sphere sphere = rounded(along(camera.eye, share, sight), size * near, kFineGrain);
    const double depth = view.depth(sphere.centre);
    if (depth - sphere.radius > kFineGrain && depth + sphere.radius < near - kFineGrain) {
      return sphere;
    }
  }
}

constexpr std::int64_t kPixels = 10;

std::vector<Pixel> corners_and_others(Random& random, const Camera& camera) {
  const std::int64_t right = camera.width - 1, top = camera.height - 1;
  std::vector<Pixel> pixels = {{0, 0}, {right, 0}, {0, top}, {right, top}};
  for (std::int64_t k = 0; k < kPixels; ++k) {
    const std::int64_t i = random.integer(0, right);
    pixels.push_back({i, random.integer(0, top)});
  }
  return pixels;
}

Case course_scene(std::uint64_t seed, bool with_behind) {
  return valid_case(seed, [with_behind](Random& random, Case& result) {
    const Camera camera = course_camera(random);
    const View view(camera);
    auto& spheres = result.scene.spheres;
    if (with_behind) {
      spheres.push_back(behind(random, view));
      spheres.push_back(before(random, view));
    }
    for (auto more = random.integer(2, 5); more > 0; --more) {
      spheres.push_back(beyond(random, view));
    }
    if (random.one_in(2)) std::reverse(spheres.begin(), spheres.end());
    result.scene.camera = camera;
    result.pixels = corners_and_others(random, camera);
  });
}

Case course(int, std::uint64_t seed) { return course_scene(seed, false); }
Case course_behind(int, std::uint64_t seed) { return course_scene(seed, true); }

constexpr CaseSource kCourseSourceTable[] = {
    {"course",
     "cameras and spheres of few digits, the spheres beyond the image plane",
     true,
     {},
     course},
    {"course-behind",
     "cameras and spheres of few digits, some spheres behind the eye or before the image plane",
     true,
     {},
     course_behind}};

}  // namespace

constinit const std::span<const CaseSource> kCourseSources = kCourseSourceTable;

}  // namespace raycheck::properties
