#pragma once

// A second opinion on the decisions of reference/exact_ray.h: CGAL's kernel with square roots,
// whose numbers are CORE's. It shares no arithmetic and no formula with reference/. CORE's
// reference counts are not atomic: one thread a process, and ctest runs each test in its own.

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <type_traits>

#include "reference/exact_ray.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
using scene::Root;
using scene::Sphere;
using Number = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;
static_assert(std::is_same_v<Number, CORE::Expr>);

/// RAYCHECK_SECOND_OPINION_PERCENT changes the number of cases: 500 makes a million decisions, less
/// suits builds that are slow by design.
inline int share_of(int count) {
  const char* const percent = std::getenv("RAYCHECK_SECOND_OPINION_PERCENT");
  return percent == nullptr ? count : count * std::atoi(percent) / 100;
}

struct Vector {
  Number x, y, z;
};
template <class Triple>
Vector vector(const Triple& v) {
  return {Number(v.x), Number(v.y), Number(v.z)};
}
inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(const Number& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Number dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline int sign_of(const Number& x) { return static_cast<int>(CGAL::sign(x)); }

/// The roots of |o + t d - C|^2 = r^2, if there are any.
struct Roots {
  Number a, b, disc;
  int disc_sign;

  Roots(const Vector& o, const Vector& d, const Sphere& sphere) : a(dot(d, d)) {
    const Vector f = vector(sphere.centre) - o;
    const Number r(sphere.radius);
    b = dot(f, d);
    disc = b * b - a * (dot(f, f) - r * r);
    disc_sign = sign_of(disc);
  }
  Number smaller() const { return disc_sign == 0 ? b / a : (b - CGAL::sqrt(disc)) / a; }
  Number larger() const { return disc_sign == 0 ? b / a : (b + CGAL::sqrt(disc)) / a; }
  Number at(WhichRoot root) const { return root == WhichRoot::kSmaller ? smaller() : larger(); }

  Intersection intersection(Root convention) const {
    if (disc_sign < 0) return {};
    const HitClass hit = disc_sign == 0 ? HitClass::kTangent : HitClass::kHit;
    if (sign_of(smaller()) >= 0) return {hit, WhichRoot::kSmaller};
    if (convention == Root::kSmaller || sign_of(larger()) < 0) return {};
    return {hit, WhichRoot::kLarger};
  }
};

/// What was decided, so that no kind of decision goes untested.
struct Counts {
  int decisions = 0;
  int hits = 0;
  int larger_roots = 0;
  int tangents = 0;
  int misses = 0;
  int behind = 0;
  int order[3] = {0, 0, 0};  ///< The first sphere nearer, a tie, the second nearer.
};

inline void expect_same_intersections(const ExactRay& ray, const Vector& o, const Vector& d,
                                      const Sphere& sphere, Counts& counts) {
  const Roots roots(o, d, sphere);
  for (const Root root : {Root::kNearest, Root::kSmaller}) {
    const Intersection second_opinion = roots.intersection(root);
    ASSERT_EQ(ray.intersect(sphere, root), second_opinion);
    ++counts.decisions;
    if (root == Root::kSmaller) continue;
    counts.hits += second_opinion.hit_class == HitClass::kHit ? 1 : 0;
    counts.larger_roots += second_opinion.root == WhichRoot::kLarger ? 1 : 0;
    counts.tangents += second_opinion.hit_class == HitClass::kTangent ? 1 : 0;
    counts.misses += second_opinion.hit_class == HitClass::kMiss ? 1 : 0;
    counts.behind += second_opinion.hit_class == HitClass::kMiss && roots.disc_sign >= 0 ? 1 : 0;
  }
}

/// Whether both spheres were met, so that their order could be compared.
inline bool expect_same_order(const ExactRay& ray, const Vector& o, const Vector& d,
                              const Sphere& first, const Sphere& second, Counts& counts) {
  const Intersection at_first = ray.intersect(first);
  const Intersection at_second = ray.intersect(second);
  if (at_first.hit_class == HitClass::kMiss || at_second.hit_class == HitClass::kMiss) return false;
  const Number difference =
      Roots(o, d, first).at(at_first.root) - Roots(o, d, second).at(at_second.root);
  const int order = sign_of(difference);
  EXPECT_EQ(ray.compare(first, at_first, second, at_second), order)
      << spelled(first) << spelled(second);
  ++counts.decisions;
  ++counts.order[order + 1];
  return true;
}

}  // namespace raycheck::reference
