// Shared code of the engines' adapters.

#ifndef ENGINES_ADAPTER_H_
#define ENGINES_ADAPTER_H_

#include <limits>
#include <optional>
#include <raycheck/candidate.hpp>

inline raycheck::Vector difference(const raycheck::Vector& a, const raycheck::Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline double dot(const raycheck::Vector& a, const raycheck::Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Converts a vector to a library's type with components T.
template <class V, class T = double>
V to(const raycheck::Vector& v) {
  return V(static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z));
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

/// The root that counts, of two roots from a solver. NaNs never count.
inline std::optional<raycheck::Hit> chosen(const raycheck::Ray& ray, double smaller, double larger,
                                           const raycheck::Conventions& asked) {
  if (smaller >= 0) return hit_at(ray, smaller);
  if (asked.root == raycheck::Root::nearest && larger >= 0) return hit_at(ray, larger);
  return std::nullopt;
}

// Adapters of templates compute in Real. It is float if a file defines SINGLE before it includes
// the adapter, otherwise double. For floats, lengths are limited so that their squares are in
// range; for doubles, only as a library documents.
#ifdef SINGLE
using Real = float;
constexpr auto kPrecision = raycheck::Precision::single;
constexpr double kSmallest = 0x1p-30, kLargest = 0x1p30;
#else
using Real = double;
constexpr auto kPrecision = raycheck::Precision::double_;
constexpr double kSmallest = 0, kLargest = std::numeric_limits<double>::max();
#endif

/// For libraries that intersect lines, not rays: every root counts.
constexpr raycheck::ValidRoots kLine = {.t_min = -std::numeric_limits<double>::infinity()};

/// If a library takes two points of a line, the second is this number of directions from the first,
/// far enough for its rounding not to turn the line.
constexpr double kFar = kPrecision == raycheck::Precision::single ? 0x1p30 : 0x1p250;

/// If a library takes the two ends of a segment, the second is this number of directions away.
constexpr double kEnd = 1024;
constexpr raycheck::ValidRoots kSegment = {.t_max = kEnd};

#endif  // ENGINES_ADAPTER_H_
