#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fast/batch.h"
#include "fast/domain.h"
#include "fast/method_list.h"
#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::fast {

/// A method's results for one ray and one sphere before it chooses a root.
struct Roots {
  double axial_distance;  ///< v = T.D, a length
  double half_chord_sq;   ///< d^2; the ray's line meets the sphere where it is >= 0.
  double smaller;         ///< Both roots in multiples of the direction; valid only where
  double larger;          ///< half_chord_sq >= 0.
};

/// A way to intersect rays with a sphere. All methods share one contract:
/// Shape:  N rays, one sphere -> N hits; the output is resized to N.
/// Units:  scene lengths; s in multiples of the ray's direction, which need not be unit.
/// Domain: finite rays with direction != 0, a finite sphere with radius >= 0, otherwise throws
///         std::invalid_argument naming the field; nonzero lengths inside `domain`, otherwise
///         intermediate values over- or underflow silently.
/// Error:  of the method only, with the given rays taken as exact: at most max_ulp in s
///         and max_point_ulp in Q (in ulp of s and u of |Q|), each while the quantity's condition
///         number is at most kModerateCondition (properties/quantity.h), growing in proportion
///         beyond; the class is exact but for inputs that a relative change by kExcusedChange takes
///         to tangency, or an origin across the surface; with `exact_class` it is exact on every
///         valid input. A method's `not_kept` says where it keeps no promise.
struct IntersectMethod {
  std::string_view name;
  std::string_view sentence;
  void (*intersect)(const Rays&, const scene::Sphere&, scene::HitRule, Hits&);
  /// The same answer for one ray, to the bit; validity is not checked.
  std::optional<Hit> (*intersect_one)(const scene::Ray&, const scene::Sphere&, scene::HitRule);
  /// The values an answer is chosen from, for one ray, unchecked; null if a method lacks them.
  Roots (*roots)(const scene::Ray&, const scene::Sphere&) = nullptr;
  /// A superset of the classes that `intersect` answers on boxes of valid input
  /// (fast/internal/between.h); null: not known.
  scene::PossibleClasses (*classes_in)(const scene::Box<scene::Ray>&,
                                       const scene::Box<scene::Sphere>&, scene::HitRule) = nullptr;
  // The bounds; audited by the tests of fast/ and the campaigns of `raycheck properties`.
  double max_ulp;
  double max_point_ulp;
  std::string_view not_kept = {};  ///< Where it keeps no promise (a test pins that).
  Domain domain = {};
  bool exact_class = false;
  double unit_roundoff = 0x1p-53;  ///< Of the arithmetic it uses.
};

#define RAYCHECK_DECLARE(name) extern const IntersectMethod k##name;
RAYCHECK_INTERSECT_METHODS(RAYCHECK_DECLARE)
#undef RAYCHECK_DECLARE

/// Every method, in the order of reports.
std::span<const IntersectMethod* const> intersect_methods();

/// The first hit of a ray: the sphere's index, and s.
struct FirstHit {
  std::size_t sphere;
  double parameter;
};

/// The first sphere that each ray meets; among equals the earlier in the list.
/// Shape: N rays, M spheres -> N answers, empty where every sphere is missed.
std::vector<std::optional<FirstHit>> nearest_spheres(const IntersectMethod& method,
                                                     const Rays& rays,
                                                     std::span<const scene::Sphere> spheres,
                                                     scene::HitRule rule);

}  // namespace raycheck::fast
