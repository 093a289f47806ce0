#pragma once

// What a given ray meets first at changed inputs, in rational arithmetic.

#include <boost/multiprecision/gmp.hpp>
#include <cstddef>
#include <vector>

#include "reference/account/nearby_choice.h"

namespace raycheck::reference {

using Fraction = boost::multiprecision::mpq_rational;
using Spheres = std::vector<scene::Sphere>;

inline constexpr double kU = 0x1p-53;
inline constexpr double kChange = 16 * kU;

inline Fraction absolute(const Fraction& x) { return x < 0 ? Fraction(-x) : x; }
inline int sign(const Fraction& x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

/// Of p + q sqrt(x), x >= 0.
inline int sign_of_sum(const Fraction& p, const Fraction& q, const Fraction& x) {
  const int of_root = x == 0 ? 0 : sign(q);
  if (of_root == 0 || sign(p) == of_root) return of_root == 0 ? sign(p) : of_root;
  return sign(p) == 0 ? of_root : sign(p) * sign(p * p - q * q * x);
}

/// Of p + q sqrt(x) + r sqrt(y).
inline int sign_of_sum(const Fraction& p, const Fraction& q, const Fraction& x, const Fraction& r,
                       const Fraction& y) {
  const int first = sign_of_sum(p, q, x);
  const int second = y == 0 ? 0 : sign(r);
  if (second == 0 || first == second) return second == 0 ? first : second;
  return first == 0 ? second : first * sign_of_sum(p * p + q * q * x - r * r * y, 2 * p * q, x);
}

/// A sphere's equation along a ray at changed inputs: a mu^2 - 2 b mu + c.
struct Met {
  Fraction a = 0, b = 0, c = 0, discriminant = 0;
  int root = 0;  ///< -1 or 1: that which the conventions ask for; 0: none.
};

/// A ray and spheres at changed inputs, and whether a claim is right there.
class ChangedChoice {
 public:
  ChangedChoice(const scene::Ray& ray, const Spheres& spheres, const InputChange& change,
                scene::Root root, scene::Tangent tangent) {
    std::size_t next = 0;
    const auto input = [&](double x) {
      const std::size_t k = next++;
      return k < change.size() ? Fraction(x) * (1 + Fraction(change[k])) : Fraction(x);
    };
    const Fraction o[3] = {input(ray.origin.x), input(ray.origin.y), input(ray.origin.z)};
    const Fraction d[3] = {input(ray.direction.x), input(ray.direction.y), input(ray.direction.z)};
    const Fraction a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    for (const scene::Sphere& sphere : spheres) {
      const double centre[3] = {sphere.centre.x, sphere.centre.y, sphere.centre.z};
      Met met;
      for (int axis = 0; axis < 3; ++axis) {
        const Fraction t = input(centre[axis]) - o[axis];
        met.b += t * d[axis];
        met.c += t * t;
      }
      const Fraction radius = input(sphere.radius);
      met.c -= radius * radius;
      met.a = a;
      met.discriminant = met.b * met.b - a * met.c;
      const bool is_met =
          met.discriminant > 0 || (met.discriminant == 0 && tangent == scene::Tangent::kHit);
      if (is_met && met.c >= 0 && met.b >= 0) {
        met.root = -1;
      } else if (is_met && root == scene::Root::kNearest && met.c <= 0) {
        met.root = 1;
      }
      met_.push_back(met);
    }
  }

  const Met& first() const { return met_.front(); }

  bool is_right(const FirstMet& claim) const {
    bool is_any = false;
    for (const Met& met : met_) is_any = is_any || met.root != 0;
    if (claim.what == FirstMet::What::kNothing) return !is_any;
    if (claim.what == FirstMet::What::kSomething) return is_any;
    const Met& first = met_[claim.sphere];
    if (first.root == 0) return false;
    for (const Met& met : met_) {
      if (met.root != 0 && sign_of_sum(met.b - first.b, met.root, met.discriminant, -first.root,
                                       first.discriminant) < 0) {
        return false;
      }
    }
    return true;
  }

 private:
  std::vector<Met> met_;
};

}  // namespace raycheck::reference
