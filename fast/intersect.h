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

/// The values of a method for one ray and one sphere before it chooses a root.
struct Roots {
  double axial_distance;  ///< v = T.D, a length
  double half_chord_sq;   ///< d^2; if it is >= 0, the ray's line meets the sphere.
  double smaller;         ///< In multiples of the direction; valid only if half_chord_sq >= 0.
  double larger;          ///< In multiples of the direction; valid only if half_chord_sq >= 0.
};

/// A way to intersect rays with a sphere. All methods share one contract:
/// Shape:  N rays, one sphere -> N hits; the output is resized to N.
/// Units:  scene lengths; s in multiples of the ray's direction, which need not be unit.
/// Domain: finite rays with direction != 0, a finite sphere with radius >= 0; otherwise throws
///         std::invalid_argument naming the field. Nonzero lengths inside `domain`; otherwise
///         intermediate values over- or underflow silently.
/// Error:  that of the method only, since the given rays are taken as exact. At most max_ulp ulp in
///         s and max_point_ulp u of |Q| in Q, up to a condition number of kModerateCondition
///         (properties/quantity.h); above, both bounds grow in proportion to the condition number.
///         The class is exact unless a relative change of the inputs by kExcusedChange makes the
///         ray tangent or moves the origin across the surface; with `exact_class` it is always
///         exact. A method's `not_kept` names the inputs for which none of this is promised.
struct IntersectMethod {
  std::string_view name;
  std::string_view sentence;
  void (*intersect)(const Rays&, const scene::Sphere&, scene::HitRule, Hits&);
  /// The answer of `intersect` for one ray, to the bit. Validity is not checked.
  std::optional<Hit> (*intersect_one)(const scene::Ray&, const scene::Sphere&, scene::HitRule);
  /// The values that an answer is chosen from. Validity is not checked. Null if a method lacks
  /// them.
  Roots (*roots)(const scene::Ray&, const scene::Sphere&) = nullptr;
  /// Contains all classes that `intersect` answers on boxes of valid input
  /// (fast/internal/between.h). Null if they are not known.
  scene::PossibleClasses (*classes_in)(const scene::Box<scene::Ray>&,
                                       const scene::Box<scene::Sphere>&, scene::HitRule) = nullptr;
  // The bounds, which tests of fast/ and `raycheck properties` check.
  double max_ulp;
  double max_point_ulp;
  std::string_view not_kept = {};  ///< The inputs without promises; a test covers them.
  Domain domain = {};
  bool exact_class = false;
  double unit_roundoff = 0x1p-53;  ///< u of the arithmetic that it uses.
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

/// The first sphere that each ray meets; of several at the same s, the first in the list.
/// Shape: N rays, M spheres -> N answers; empty if a ray misses every sphere.
std::vector<std::optional<FirstHit>> nearest_spheres(const IntersectMethod& method,
                                                     const Rays& rays,
                                                     std::span<const scene::Sphere> spheres,
                                                     scene::HitRule rule);

}  // namespace raycheck::fast
