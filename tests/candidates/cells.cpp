// A candidate that is right, except for rays that start near x = 0: there it divides by zero.

#include <cmath>
#include <raycheck/candidate.hpp>

using namespace raycheck;

namespace {

/// Where hits are counted.
volatile int column = 0;

double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const auto& [o, d] = ray;
  const Vector to = {sphere.centre.x - o.x, sphere.centre.y - o.y, sphere.centre.z - o.z};
  column = 640 / static_cast<int>(o.x);
  const double a = dot(d, d), b = dot(to, d), c = dot(to, to) - sphere.radius * sphere.radius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return {};
  const double q = b >= 0 ? b + std::sqrt(discriminant) : b - std::sqrt(discriminant);
  const double low = std::fmin(q / a, c / q), high = std::fmax(q / a, c / q);
  const double s = low >= 0 ? low : high;
  if (!(s >= 0)) return {};
  return Hit{s, {o.x + s * d.x, o.y + s * d.y, o.z + s * d.z}};
}

}  // namespace

RAYCHECK_CANDIDATE(.intersect = intersect)
