#include <cmath>
#include <limits>
#include <optional>
#include <raycheck/candidate.hpp>
#include <vector>

using namespace raycheck;

namespace {

Vector times(double k, const Vector& a) { return {k * a.x, k * a.y, k * a.z}; }
Vector plus(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector minus(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(const Vector& a) { return std::hypot(a.x, a.y, a.z); }
Vector unit(const Vector& a) {
  double n = length(a);
  return {a.x / n, a.y / n, a.z / n};
}
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double step(double first, double last, double k, double count) {
  return first + k / (count - 1) * (last - first);
}

Frame frame(const Camera& camera) {
  Frame f;
  f.w = unit(minus(camera.eye, camera.look_at));
  f.u = unit(cross(camera.up, f.w));
  f.v = cross(f.w, f.u);
  return f;
}

// from the eye to the pixel
Vector toPixel(const Camera& camera, const Pixel& pixel) {
  Frame f = frame(camera);
  double alpha = step(camera.left, camera.right, pixel.i, camera.width);
  double beta = step(camera.bottom, camera.top, pixel.j, camera.height);
  return plus(times(camera.near_plane, f.w), plus(times(alpha, f.u), times(beta, f.v)));
}

Vector pixelPoint(const Camera& camera, const Conventions&, Pixel pixel) {
  return plus(camera.eye, toPixel(camera, pixel));
}

Ray pixelRay(const Camera& camera, const Conventions&, Pixel pixel) {
  Vector g = toPixel(camera, pixel);
  return {plus(camera.eye, g), unit(g)};
}

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  double scale = length(ray.direction);
  Vector d = unit(ray.direction), t = minus(sphere.centre, ray.origin);
  double v = dot(t, d), b = length(cross(t, d));
  if (b > sphere.radius) return std::nullopt;
  double half = std::sqrt((sphere.radius - b) * (sphere.radius + b));
  double s = v - half;
  if (s < 0) s = v + half;
  if (s < 0) return std::nullopt;
  return Hit{s / scale, plus(ray.origin, times(s, d))};
}

std::optional<std::size_t> nearest(const Ray& ray, const std::vector<Sphere>& spheres, const Conventions& c) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < spheres.size(); ++k)
    if (auto hit = intersect(ray, spheres[k], c); hit && hit->parameter < least) {
      least = hit->parameter;
      best = k;
    }
  return best;
}

}  // namespace

RAYCHECK_CANDIDATE(.frame = frame, .pixel_point = pixelPoint, .pixel_ray = pixelRay, .intersect = intersect,
                   .nearest = nearest)
