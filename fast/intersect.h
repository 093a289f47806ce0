#ifndef RAYCHECK_FAST_INTERSECT_H_
#define RAYCHECK_FAST_INTERSECT_H_

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fast/batch.h"
#include "fast/domain.h"
#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::fast {

/// What a method knows of one ray and one sphere before a root is chosen.
struct Roots {
  double axial_distance;  ///< v = T.D, a length
  double half_chord_sq;   ///< d^2; the ray's line meets the sphere where it is >= 0.
  double smaller;         ///< Both roots in multiples of the direction; they mean something
  double larger;          ///< only where half_chord_sq >= 0.
};

/// Where a ray meets a sphere.
struct Hit {
  double parameter;     ///< s, in multiples of the ray's direction.
  scene::Point3 point;  ///< Q = L + s D.
};

/// What a method asks beyond validity. Ours ask nothing; peers from other libraries do.
struct Contract {
  bool unit_direction = false;
  bool origin_outside = false;
  // The conventions that it fixes: it answers by these, whichever it is asked for.
  std::optional<scene::Root> root = {};
  std::optional<scene::Tangent> tangent = {};
};

/// A way to intersect rays with a sphere. All methods share one contract:
/// Shape:  N rays, one sphere -> N hits; the output is resized to N.
/// Units:  scene lengths; s in multiples of the ray's direction, which need not be unit.
/// Domain: finite rays with direction != 0, a finite sphere with radius >= 0, otherwise throws
///         std::invalid_argument naming the field; nonzero lengths inside `domain`, otherwise
///         intermediate values over- or underflow silently; what `contract` asks.
/// Error:  of the method alone, on the rays that it is given, taken exactly: at most max_ulp in s
///         and max_point_ulp in Q (in ulp of s and u of |Q|), each while the quantity's condition
///         number is at most kModerateCondition (properties/quantity.h), growing in proportion
///         beyond; the class is exact but for inputs that a relative change by kExcusedChange takes
///         to tangency, or an origin across the surface; with `exact_class` it is exact on every
///         valid input. A method's `not_kept` says where it keeps neither promise.
struct IntersectMethod {
  std::string_view name;
  std::string_view sentence;
  void (*intersect)(const Rays&, const scene::Sphere&, scene::Root, scene::Tangent, Hits&);
  /// The same answer to one ray, to the bit; validity is not checked.
  std::optional<Hit> (*intersect_one)(const scene::Ray&, const scene::Sphere&, scene::Root,
                                      scene::Tangent);
  /// What the answer is chosen from, of one ray, unchecked; null where a method has no such values.
  Roots (*roots)(const scene::Ray&, const scene::Sphere&) = nullptr;
  double max_ulp;
  double max_point_ulp;
  std::string_view not_kept = {};  ///< Where it keeps no promise (a test pins that).
  Domain domain = {};
  Contract contract = {};
  bool exact_class = false;
  double unit_roundoff = 0x1p-53;  ///< Of the arithmetic that it computes in.
};

// The bounds; audited by the tests of fast/ and the campaigns of `raycheck properties`.
inline constexpr double kQuadraticMaxUlp = 128;
inline constexpr double kQuadraticMaxPointUlp = 160;
inline constexpr double kLectureMaxUlp = 128;
inline constexpr double kLectureMaxPointUlp = 160;
inline constexpr double kStableQuadraticMaxUlp = 128;
inline constexpr double kStableQuadraticMaxPointUlp = 160;
inline constexpr double kKahanMaxUlp = 128;
inline constexpr double kKahanMaxPointUlp = 160;
inline constexpr double kPerpendicularMaxUlp = 96;
inline constexpr double kPerpendicularMaxPointUlp = 112;
inline constexpr double kCrossMaxUlp = 88;
inline constexpr double kCrossMaxPointUlp = 104;
inline constexpr double kCross2MaxUlp = 88;
inline constexpr double kCross2MaxPointUlp = 104;
inline constexpr double kSingleQuadraticMaxUlp = kQuadraticMaxUlp * 0x1p29;
inline constexpr double kSingleQuadraticMaxPointUlp = kQuadraticMaxPointUlp * 0x1p29;
inline constexpr double kSingleLectureMaxUlp = kLectureMaxUlp * 0x1p29;
inline constexpr double kSingleLectureMaxPointUlp = kLectureMaxPointUlp * 0x1p29;
inline constexpr double kDoubleDoubleMaxUlp = 1;
inline constexpr double kDoubleDoubleMaxPointUlp = 1.5;
inline constexpr double kLongDoubleMaxUlp = 1;
inline constexpr double kLongDoubleMaxPointUlp = 1.5;
inline constexpr double kFloat128MaxUlp = 1;
inline constexpr double kFloat128MaxPointUlp = 1.5;
inline constexpr double kRobustMaxUlp = 1;
inline constexpr double kRobustMaxPointUlp = 1.5;

/// `quadratic`: the general parametric approach as textbooks print it, b^2 - 4ac.
extern const IntersectMethod kQuadratic;
/// `lecture`: the lecture's faster method: v = T.D, d^2 = r^2 - (|T|^2 - v^2), s = v - d.
extern const IntersectMethod kLecture;
/// `stable-quadratic`: the same coefficients, roots by q = b + sign(b) sqrt(disc).
extern const IntersectMethod kStableQuadratic;
/// `kahan`: the same coefficients, the discriminant by Kahan's difference of products.
extern const IntersectMethod kKahan;
/// `perpendicular`: disc from |T - (T.D) D|^2, which does not cancel; roots by q.
extern const IntersectMethod kPerpendicular;
/// `cross`: disc = |d|^2 r^2 - |T x d|^2 with Kahan's products; roots by q.
extern const IntersectMethod kCross;
/// `cross2`: cross with T as an exact pair and c = |T|^2 - r^2 compensated.
extern const IntersectMethod kCross2;
/// `single-quadratic`, `single-lecture`: the same in single precision; lengths are in
/// kSingleDomain.
extern const IntersectMethod kSingleQuadratic;
extern const IntersectMethod kSingleLecture;
/// `double-double`: disc = |d|^2 r^2 - |T x d|^2 and roots by q, in pairs of doubles (about 106
/// bits).
extern const IntersectMethod kDoubleDouble;
/// `long-double`: the same in the processor's 64 bits; lengths are in kWideDomain.
extern const IntersectMethod kLongDouble;
/// `float128`: the same in 113 bits by software; lengths are in kWideDomain.
extern const IntersectMethod kFloat128;
/// `robust`: the class is exact and s within kRobustMaxUlp on every valid input, also where s is
/// subnormal; it overflows to infinity as IEEE-754. kWideDomain is where Q's relative error means
/// something.
extern const IntersectMethod kRobust;

/// Every method, in the order of reports.
std::span<const IntersectMethod* const> intersect_methods();

/// The first sphere that each ray meets; the earlier in the file among equals.
/// Shape: N rays, M spheres -> N indices, empty where every sphere is missed.
std::vector<std::optional<std::size_t>> nearest_spheres(const IntersectMethod& method,
                                                        const Rays& rays,
                                                        std::span<const scene::Sphere> spheres,
                                                        scene::Root root, scene::Tangent tangent);

}  // namespace raycheck::fast

#endif  // RAYCHECK_FAST_INTERSECT_H_
