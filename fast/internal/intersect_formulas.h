// The formulas that several methods share, for any number type. Internal to fast/. Compiled once
// for each of Highway's targets (fast/internal/lanes.h).

#if defined(RAYCHECK_FAST_INTERNAL_INTERSECT_FORMULAS_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_INTERSECT_FORMULAS_H_
#undef RAYCHECK_FAST_INTERNAL_INTERSECT_FORMULAS_H_
#else
#define RAYCHECK_FAST_INTERNAL_INTERSECT_FORMULAS_H_
#endif

#include "fast/internal/intersect_batch.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

/// The general parametric approach as textbooks print it: t = (-b -+ sqrt(b^2 - 4ac)) / 2a.
template <class N>
struct Textbook {
  using Number = N;

  static RootsOf<N> roots(const RayOf<N>& ray, const SphereOf<N>& sphere) {
    const auto& [origin, direction] = ray;
    const Triple<N> from_centre = origin - sphere.centre;
    const N a = dot(direction, direction);
    const N b = N(2) * dot(direction, from_centre);
    const N c = dot(from_centre, from_centre) - sphere.radius * sphere.radius;
    const N discriminant = b * b - N(4) * a * c;
    const N root = square_root(discriminant);
    return {-b / (N(2) * square_root(a)), discriminant / (N(4) * a), (-b - root) / (N(2) * a),
            (-b + root) / (N(2) * a), discriminant};
  }
};

/// The lecture's faster method: v = T.D, d^2 = r^2 - (|T|^2 - v^2), s = v -+ d.
template <class N>
struct LectureFormula {
  using Number = N;

  static RootsOf<N> roots(const RayOf<N>& ray, const SphereOf<N>& sphere) {
    const auto& [origin, direction] = ray;
    const N length = norm(direction);
    const Triple<N> U = direction / length;
    const Triple<N> T = sphere.centre - origin;
    const N v = dot(T, U);
    const N half_chord_sq = sphere.radius * sphere.radius - (dot(T, T) - v * v);
    const N half_chord = square_root(half_chord_sq);
    return {v, half_chord_sq, (v - half_chord) / length, (v + half_chord) / length, half_chord_sq};
  }
};

/// By Lagrange's identity, disc = b^2 - a c = a r^2 - |T x d|^2, whose terms cancel only near
/// tangency; roots by q. For number types so slow that an early exit on a miss saves time.
template <class N>
struct Lagrange {
  using Number = N;

  static RootsOf<N> roots(const RayOf<N>& ray, const SphereOf<N>& sphere) {
    const auto& [origin, direction] = ray;
    const Triple<N> T = sphere.centre - origin;
    const Triple<N> moment = cross(T, direction);
    const N a = dot(direction, direction);
    const N b = dot(T, direction);
    const N radius_sq = sphere.radius * sphere.radius;
    const N discriminant = a * radius_sq - dot(moment, moment);
    if (!(discriminant >= N(0))) {
      return {b / square_root(a), discriminant / a, N(0), N(0), discriminant};
    }
    return roots_by_q<N>(a, b, dot(T, T) - radius_sq, discriminant);
  }
};

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // RAYCHECK_FAST_INTERNAL_INTERSECT_FORMULAS_H_
