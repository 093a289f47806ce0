// What the adapters of engines share.

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

/// A vector as a library's own type, of T's.
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

/// The root that counts of two that a solver returns; of NaNs none does.
inline std::optional<raycheck::Hit> chosen(const raycheck::Ray& ray, double smaller, double larger,
                                           const raycheck::Conventions& asked) {
  if (smaller >= 0) return hit_at(ray, smaller);
  if (asked.root == raycheck::Root::nearest && larger >= 0) return hit_at(ray, larger);
  return std::nullopt;
}

// An adapter of templates computes in Real: in doubles, or in floats where a file defines SINGLE
// and includes it. Squares of lengths stay in the range of floats; doubles have no limits but those
// that a library documents.
#ifdef SINGLE
using Real = float;
constexpr auto kPrecision = raycheck::Precision::single;
constexpr double kSmallest = 0x1p-30, kLargest = 0x1p30;
#else
using Real = double;
constexpr auto kPrecision = raycheck::Precision::double_;
constexpr double kSmallest = 0, kLargest = std::numeric_limits<double>::max();
#endif

/// Lines, not rays: the smaller root counts wherever it is.
constexpr raycheck::ValidRoots kLine = {.t_min = -std::numeric_limits<double>::infinity()};

/// Of a library that asks for two points of a line, the second one is that many directions from the
/// first: so far that its rounding does not turn the line.
constexpr double kFar = kPrecision == raycheck::Precision::single ? 0x1p30 : 0x1p250;

/// Of one that asks for the two ends of a segment, the second one is that many directions away.
constexpr double kEnd = 1024;
constexpr raycheck::ValidRoots kSegment = {.t_max = kEnd};

#endif  // ENGINES_ADAPTER_H_
