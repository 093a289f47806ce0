// The camera and spheres of a small ray tracer. The environment variable TRACER_MISTAKE selects one
// of five classic mistakes: far_root, behind, upside_down, not_unit, pixel_step.

#pragma once

#include <raycheck/judge.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>

using raycheck::Vector;

inline bool makes(const char* mistake) {
  static const char* const asked = std::getenv("TRACER_MISTAKE");
  return asked != nullptr && std::strcmp(asked, mistake) == 0;
}

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector unit(Vector a) { return (1 / std::sqrt(dot(a, a))) * a; }

/// The position of line k, of `count` lines from one bound to the other.
inline double between(double low, double high, double k, double count) {
  const double steps = makes("pixel_step") ? count : count - 1;
  return low * ((steps - k) / steps) + high * (k / steps);  // both bounds are reached exactly
}

inline raycheck::Ray pixel_ray(const raycheck::Camera& camera, const raycheck::Conventions&,
                               raycheck::Pixel pixel) {
  const Vector w = unit(camera.eye - camera.look_at);
  const Vector u = unit(cross(camera.up, w));
  const Vector v = cross(w, u);
  const auto width = static_cast<double>(camera.width), height = static_cast<double>(camera.height);
  double row = static_cast<double>(pixel.j);
  if (makes("upside_down")) row = height - 1 - row;
  const double alpha = between(camera.left, camera.right, static_cast<double>(pixel.i), width);
  const double beta = between(camera.bottom, camera.top, row, height);
  const Vector sight = camera.near_plane * w + alpha * u + beta * v;
  return {camera.eye + sight, makes("not_unit") ? sight : unit(sight)};
}

inline std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray,
                                              const raycheck::Sphere& sphere,
                                              const raycheck::Conventions&) {
  const Vector to = sphere.centre - ray.origin;
  const Vector& d = ray.direction;
  const double a = dot(d, d), b = dot(to, d), r = sphere.radius;
  const Vector off = cross(to, d);
  const double discriminant = a * r * r - dot(off, off);  // does not cancel for far spheres
  if (discriminant < 0) return {};
  const double q = b >= 0 ? b + std::sqrt(discriminant) : b - std::sqrt(discriminant);
  const double distance = std::sqrt(dot(to, to));
  const double one = q / a, other = q == 0 ? 0 : (distance - r) * (distance + r) / q;
  const double near = std::fmin(one, other), far = std::fmax(one, other);
  double s = near < 0 ? far : near;
  if (makes("far_root")) s = far;
  if (makes("behind")) s = near;
  if (s < 0 && !makes("behind")) return {};
  return raycheck::Hit{s, ray.origin + s * d};
}

/// The tracer as a candidate. Rows count from the bottom; the first and last pixels lie on the
/// bounds.
inline raycheck::Candidate tracer() {
  raycheck::Candidate candidate("tracer");
  candidate.declares = {raycheck::Rows::bottom_first, raycheck::Samples::edges,
                        raycheck::Origin::pixel, raycheck::Root::nearest, raycheck::Tangent::hit};
  candidate.smallest_length = 1e-70;  // the fourth powers of lengths are doubles
  candidate.largest_length = 1e70;
  candidate.pixel_ray = pixel_ray;
  candidate.intersect = intersect;
  return candidate;
}
