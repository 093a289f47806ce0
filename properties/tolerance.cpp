#include "properties/tolerance.h"

#include <cmath>

namespace raycheck::properties {
namespace {

using contract::Tolerances;
using reference::Enclosure;
using reference::Enclosure3;

constexpr int kBits = 256;

Enclosure3 within(const scene::Point3& point, double change) {
  return {Enclosure::within(point.x, change, kBits), Enclosure::within(point.y, change, kBits),
          Enclosure::within(point.z, change, kBits)};
}

/// All that the pair may be.
struct Enclosed {
  explicit Enclosed(const ChangedPair& pair)
      : ray(pair.ray.enclose(kBits, pair.relative_change)),
        centre(within(pair.sphere.centre, pair.relative_change)),
        radius(Enclosure::within(pair.sphere.radius, pair.relative_change, kBits)),
        D(ray.direction()),
        T(centre - ray.origin()),
        step(pair.ray.source().camera ? Enclosure(1) : ray.length()) {}
  reference::EnclosedRay ray;
  Enclosure3 centre;
  Enclosure radius;
  Enclosure3 D, T;
  Enclosure step;  ///< The length of s = 1.
};

/// How far a point at this vector from the centre is from the surface.
struct Off {
  Off(const Enclosed& its_pair, const Enclosure3& to_centre)
      : pair(its_pair), distance_sq(dot(to_centre, to_centre)) {}
  Enclosure squares() const { return distance_sq - pair.radius * pair.radius; }
  Enclosure length() const { return sqrt(distance_sq) - pair.radius; }
  const Enclosed& pair;
  Enclosure distance_sq;
};

bool is_at_most(const Enclosure& value, const Enclosure& most) {
  return (abs(value) - most).certain_sign().value_or(0) <= 0;
}

/// Whether a root has an |s| of at most this: whether a s^2 - 2 b s + c has a zero there.
bool has_small_root(const Enclosed& pair, const Enclosure& most) {
  const Enclosure s = (Enclosure::within(1, 1, kBits) - Enclosure(1)) * most * pair.step;
  const Enclosure c = Off(pair, pair.T).squares();
  return (s * s - Enclosure(2) * dot(pair.T, pair.D) * s + c).contains_zero();
}

struct Kind {
  double Tolerances::*size;
  bool is_of_origin;  ///< Otherwise it is of the point of the line that is nearest to the centre.
  bool (*allows)(const Off& off, const Enclosure& most);
};

bool of_squares(const Off& off, const Enclosure& most) { return is_at_most(off.squares(), most); }
bool of_length(const Off& off, const Enclosure& most) { return is_at_most(off.length(), most); }

constexpr Kind kKinds[] = {{&Tolerances::discriminant, false,
                            [](const Off& off, const Enclosure& most) {
                              const Enclosure& step = off.pair.step;
                              return is_at_most(Enclosure(4) * step * step * off.squares(), most);
                            }},
                           {&Tolerances::d_sq, false, of_squares},
                           {&Tolerances::distance, false, of_length},
                           {&Tolerances::radii, false,
                            [](const Off& off, const Enclosure& most) {
                              return is_at_most(off.length(), most * off.pair.radius);
                            }},
                           {&Tolerances::c, true, of_squares},
                           {&Tolerances::surface, true, of_length},
                           {&Tolerances::s, true,
                            [](const Off& off, const Enclosure& most) {
                              return is_at_most(off.length(), most * off.pair.step);
                            }},
                           {&Tolerances::s_radii, true, [](const Off& off, const Enclosure& most) {
                              return is_at_most(off.length(),
                                                most * off.pair.radius * off.pair.step);
                            }}};

/// `hit`: the vector to the centre from where the hit is; null if that does not matter.
double first_of(const Tolerances& declared, const Enclosed& pair, const Enclosure3* hit) {
  for (const auto& [member, is_of_origin, allows] : kKinds) {
    const double size = declared.*member;
    if (size == 0) continue;
    const Enclosure most(size, kBits);
    const bool is_within =
        member == &Tolerances::s ? has_small_root(pair, most)
        : member == &Tolerances::s_radii
            ? has_small_root(pair, most * pair.radius)
            : allows({pair, is_of_origin ? pair.T : cross(pair.T, pair.D)}, most);
    if (is_within && (hit == nullptr || allows({pair, *hit}, most))) return size;
  }
  return 0;
}

}  // namespace

double tolerance_of(const Tolerances& declared, const ChangedPair& pair) {
  if (declared == Tolerances{}) return 0;
  return first_of(declared, Enclosed(pair), nullptr);
}

double tolerance_of(const Tolerances& declared, const ChangedPair& pair, double s) {
  if (declared == Tolerances{} || !std::isfinite(s)) return 0;
  const Enclosed enclosed(pair);
  const Enclosure along = Enclosure(s, kBits) * enclosed.step;
  const auto& [x, y, z] = enclosed.D;
  const Enclosure3 hit = enclosed.T - Enclosure3{along * x, along * y, along * z};
  return first_of(declared, enclosed, &hit);
}

double tolerance_of(const Tolerances& declared, const ChangedPair& pair,
                    const scene::Point3& point) {
  const bool is_finite = std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
  if (declared == Tolerances{} || !is_finite) return 0;
  const Enclosed enclosed(pair);
  const Enclosure3 hit = enclosed.centre - within(point, pair.relative_change);
  return first_of(declared, enclosed, &hit);
}

}  // namespace raycheck::properties
