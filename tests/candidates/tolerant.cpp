// A right candidate with a tolerance, as transport codes have it: if the origin is so near to the
// surface, the root there is dropped. Tests set other tolerances.

#include <algorithm>
#include <cmath>
#include <raycheck/candidate.hpp>

using namespace raycheck;

#ifndef CONTRACT
#define CONTRACT "tolerance_c 1e-12"
#define IS_ON_SURFACE std::abs(c) <= 1e-12
#define TOUCHES false
#endif

namespace {

double dot(const Vector& p, const Vector& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
Vector cross(const Vector& p, const Vector& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

std::optional<Hit> hit_at(double s, const Ray& ray) {
  const auto& [o, d] = ray;
  if (s < 0) return {};
  return Hit{s, {o.x + s * d.x, o.y + s * d.y, o.z + s * d.z}};
}

std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions& asked) {
  const auto& [o, d] = ray;
  const Vector to = {sphere.centre.x - o.x, sphere.centre.y - o.y, sphere.centre.z - o.z};
  const Vector moment = cross(to, d);
  const double r = sphere.radius, a = dot(d, d), b = dot(to, d), distance = std::sqrt(dot(to, to));
  const double c = (distance - r) * (distance + r), under = a * r * r - dot(moment, moment);
  [[maybe_unused]] const double apart = std::sqrt(dot(moment, moment) / a);
  if (TOUCHES) return hit_at(b / a, ray);
  if (under < 0 || (under == 0 && asked.tangent == Tangent::miss)) return {};
  const double q = b >= 0 ? b + std::sqrt(under) : b - std::sqrt(under);
  const double one = q / a, other = q == 0 ? 0 : c / q;
  const double smaller = std::min(one, other), larger = std::max(one, other);
  if (IS_ON_SURFACE)
    return b > 0 && asked.root == Root::nearest ? hit_at(larger, ray) : std::nullopt;
  return hit_at(smaller < 0 && asked.root == Root::nearest ? larger : smaller, ray);
}

std::optional<std::size_t> nearest(const Ray& ray, const std::vector<Sphere>& spheres,
                                   const Conventions& asked) {
  std::optional<std::size_t> found;
  double least = 0;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const auto hit = intersect(ray, spheres[k], asked);
    if (!hit || (found && hit->parameter >= least)) continue;
    found = k;
    least = hit->parameter;
  }
  return found;
}

}  // namespace

RAYCHECK_CANDIDATE(.intersect = intersect, .nearest = nearest, .contract = CONTRACT)
