#ifndef RAYCHECK_FAST_INTERSECT_FORMULAS_H_
#define RAYCHECK_FAST_INTERSECT_FORMULAS_H_

// The formulas that several methods share, each in its own type of number. Internal to fast/.

#include "fast/intersect_batch.h"

namespace raycheck::fast {

/// The general parametric approach as textbooks print it: t = (-b -+ sqrt(b^2 - 4ac)) / 2a.
template <class N>
struct Textbook {
  using Number = N;

  static RootsOf<N> roots(const Vector3Of<N>& origin, const Vector3Of<N>& direction,
                          const Vector3Of<N>& centre, N radius) {
    const Vector3Of<N> from_centre = origin - centre;
    const N a = direction.dot(direction);
    const N b = 2 * direction.dot(from_centre);
    const N c = from_centre.dot(from_centre) - radius * radius;
    const N discriminant = b * b - 4 * a * c;
    const N root = square_root(discriminant);
    return {-b / (2 * square_root(a)), discriminant / (4 * a), (-b - root) / (2 * a),
            (-b + root) / (2 * a)};
  }
};

/// The lecture's faster method: v = T.D, d^2 = r^2 - (|T|^2 - v^2), s = v -+ d.
template <class N>
struct LectureFormula {
  using Number = N;

  static RootsOf<N> roots(const Vector3Of<N>& origin, const Vector3Of<N>& direction,
                          const Vector3Of<N>& centre, N radius) {
    const N length = direction.norm();
    const Vector3Of<N> U = direction / length;
    const Vector3Of<N> T = centre - origin;
    const N v = T.dot(U);
    const N half_chord_sq = radius * radius - (T.dot(T) - v * v);
    const N half_chord = square_root(half_chord_sq);
    return {v, half_chord_sq, (v - half_chord) / length, (v + half_chord) / length};
  }
};

/// Lagrange's identity, disc = b^2 - a c = a r^2 - |T x d|^2, whose terms cancel only near
/// tangency; roots by q. For numbers so slow that a miss had better end early.
template <class N>
struct Lagrange {
  using Number = N;

  static RootsOf<N> roots(const Vector3Of<N>& origin, const Vector3Of<N>& direction,
                          const Vector3Of<N>& centre, N radius) {
    const Vector3Of<N> T = centre - origin;
    const Vector3Of<N> moment = T.cross(direction);
    const N a = direction.dot(direction);
    const N b = T.dot(direction);
    const N radius_sq = radius * radius;
    const N discriminant = a * radius_sq - moment.dot(moment);
    if (!(discriminant >= N(0))) return {b / square_root(a), discriminant / a, N(0), N(0)};
    return roots_by_q<N>(a, b, T.dot(T) - radius_sq, discriminant);
  }
};

}  // namespace raycheck::fast

#endif  // RAYCHECK_FAST_INTERSECT_FORMULAS_H_
