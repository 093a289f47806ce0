#include "properties/cases/generators.h"

#include <cmath>
#include <utility>

#include "scene/fields.h"

namespace raycheck::properties {
namespace {

/// to - from as high + low exactly, coordinate by coordinate (Knuth's two-sum).
struct Difference {
  Vector3 high;
  Vector3 low;
};
Difference difference(const Point3& from, const Point3& to) {
  const auto low = [](double a, double b, double high) {
    const double b_part = a - high;
    return (a - (high + b_part)) + (b_part - b);
  };
  const Vector3 high = to - from;
  return {high, {low(to.x, from.x, high.x), low(to.y, from.y, high.y), low(to.z, from.z, high.z)}};
}

/// x y - z w, with an error of at most 1.5 ulp (Kahan).
double difference_of_products(double x, double y, double z, double w) {
  const double product = z * w;
  const double error = std::fma(-z, w, product);
  return std::fma(x, y, -product) + error;
}

/// A sphere about where the camera looks.
Sphere sphere_in_view(Random& random, const Camera& camera) {
  const Vector3 view = camera.look_at - camera.eye;
  const double depth = random.between(0.2, 4);
  const double radius = length(view) * depth * random.between(0.05, 0.6);
  Point3 centre = along(camera.eye, depth, view);
  if (random.one_in(8)) centre = along(camera.eye, -depth, view);  // behind
  if (random.one_in(8)) centre = camera.eye;                       // around the eye
  const double off = radius * random.unit() * 1.5;
  return {along(centre, off, random.direction()), radius};
}

}  // namespace

double power_of_ten(int k) {
  double power = 1;
  for (int step = 0; step < std::abs(k); ++step) power *= 10;
  return k < 0 ? 1 / power : power;
}

double about_ten_to(Random& random, int k) { return random.between(0.5, 2) * power_of_ten(k); }

double share_of(Random& random, int k) { return random.between(0.4, 0.9) * power_of_ten(-k); }

double signed_share_of(Random& random, int k) {
  const double side = random.sign();
  return side * share_of(random, k);
}

double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

double length(const Vector3& v) { return std::sqrt(dot(v, v)); }

Point3 along(const Point3& origin, double t, const Vector3& direction) {
  return {origin.x + t * direction.x, origin.y + t * direction.y, origin.z + t * direction.z};
}

Vector3 times(double factor, const Vector3& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

Axes::Axes(const Camera& camera) {
  const auto unit = [](const Vector3& x) { return times(1 / length(x), x); };
  w = unit(camera.eye - camera.look_at);
  u = unit(cross(camera.up, w));
  v = cross(w, u);
}

Vector3 across(Random& random, const Vector3& direction) {
  for (;;) {
    const Vector3 v = cross(random.direction(), direction);
    const double size = length(v);
    if (size > 0.1) return times(1 / size, v);
  }
}

double distance_between(const Point3& from, const Point3& to) {
  const auto [high, low] = difference(from, to);
  return std::sqrt(dot(high, high) + 2 * dot(high, low));
}

double impact_parameter(const Ray& ray, const Point3& centre) {
  const auto [high, low] = difference(ray.origin, centre);
  const Vector3 moment = cross(high, ray.direction);
  const Vector3 rest = cross(low, ray.direction);
  return length({moment.x + rest.x, moment.y + rest.y, moment.z + rest.z}) / length(ray.direction);
}

double axial_distance(const Ray& ray, const Point3& centre) {
  const auto [high, low] = difference(ray.origin, centre);
  return (dot(high, ray.direction) + dot(low, ray.direction)) / length(ray.direction);
}

Conventions any_conventions(Random& random) {
  Conventions conventions;
  if (random.one_in(2)) conventions.rows = scene::Rows::kTopFirst;
  const std::int64_t samples = random.integer(1, 6);
  if (samples == 1) conventions.samples = scene::Samples::kCentres;
  if (samples == 4) conventions.samples = scene::Samples::kCorners;
  if (random.one_in(3)) conventions.origin = scene::Origin::kFocal;
  if (random.one_in(4)) conventions.root = scene::Root::kSmaller;
  if (random.one_in(4)) conventions.tangent = scene::Tangent::kMiss;
  if (random.one_in(8)) conventions.tangent = scene::Tangent::kEither;
  return conventions;
}

void scale_lengths(Scene& scene, int exponent) {
  for_each_length(scene, [exponent](double& x) { x = std::ldexp(x, exponent); });
}

Point3 ordinary_origin(Random& random) {
  const double from_world = random.between(0, 10);
  return along({}, from_world, random.direction());
}

Line any_line(Random& random, const Point3& origin) {
  const Vector3 unit = random.direction();
  if (random.one_in(2)) return {{origin, unit}, unit};
  return {{origin, times(random.power_of_ten(-2, 2), unit)}, unit};
}

Sphere sphere_off(Random& random, const Line& line, double distance, double impact, double radius) {
  const Point3 foot = along(line.ray.origin, distance, line.unit);
  return {along(foot, impact, across(random, line.unit)), radius};
}

Camera ordinary_camera(Random& random) {
  Camera camera;
  camera.eye = along({}, 10, random.in_cube(1));
  const double distance = random.between(1, 10);
  camera.look_at = along(camera.eye, distance, random.direction());
  const double up_length = random.between(0.5, 2);
  camera.up = times(up_length, random.direction());
  camera.near = -random.power_of_ten(-1, 1);
  camera.left = camera.near * random.between(0.2, 1.5);
  camera.bottom = camera.near * random.between(0.2, 1.5);
  camera.right = -camera.near * random.between(0.2, 1.5);
  camera.top = -camera.near * random.between(0.2, 1.5);
  camera.width = random.integer(2, 16);
  camera.height = random.integer(2, 16);
  return camera;
}

void vary_bounds(Random& random, Camera& camera) {
  if (random.one_in(2)) {
    camera.right = -camera.left;
    camera.top = -camera.bottom;
  }
  if (random.one_in(8)) std::swap(camera.left, camera.right);
}

std::vector<Pixel> some_pixels(Random& random, const Camera& camera) {
  std::vector<Pixel> pixels;
  const auto count = random.integer(1, 4);
  for (std::int64_t k = 0; k < count; ++k) {
    pixels.push_back({random.integer(0, camera.width - 1), random.integer(0, camera.height - 1)});
  }
  if (random.one_in(3)) pixels.push_back({0, 0});
  return pixels;
}

void add_spheres_in_view(Random& random, std::int64_t count, Scene& scene) {
  for (std::int64_t k = 0; k < count; ++k) {
    scene.spheres.push_back(sphere_in_view(random, *scene.camera));
  }
}

}  // namespace raycheck::properties
