// What the adapters of engines share.

#ifndef ENGINES_ADAPTER_H_
#define ENGINES_ADAPTER_H_

#include <optional>
#include <raycheck/candidate.hpp>

inline raycheck::Vector difference(const raycheck::Vector& a, const raycheck::Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline double dot(const raycheck::Vector& a, const raycheck::Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline raycheck::Hit hit_at(const raycheck::Ray& ray, double s) {
  const auto& [o, d] = ray;
  return {s, {o.x + s * d.x, o.y + s * d.y, o.z + s * d.z}};
}

/// a s^2 + b s + c = 0 as textbooks print it, every operation rounded.
struct Quadratic {
  double a, b, c;
  Quadratic(const raycheck::Ray& ray, const raycheck::Sphere& sphere) {
    const raycheck::Vector f = difference(ray.origin, sphere.centre);
    a = dot(ray.direction, ray.direction);
    b = 2 * dot(f, ray.direction);
    c = dot(f, f) - sphere.radius * sphere.radius;
  }
};

/// The root that counts of two that a solver returns; of NaNs none does.
inline std::optional<raycheck::Hit> chosen(const raycheck::Ray& ray, double smaller, double larger,
                                           const raycheck::Conventions& asked) {
  if (smaller >= 0) return hit_at(ray, smaller);
  if (asked.root == raycheck::Root::nearest && larger >= 0) return hit_at(ray, larger);
  return std::nullopt;
}

#endif  // ENGINES_ADAPTER_H_
