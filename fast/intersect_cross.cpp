#include "fast/error_free.h"
#include "fast/intersect_batch.h"

namespace raycheck::fast {
namespace {

/// Lagrange's identity: b^2 - a c = a r^2 - |T x d|^2, whose terms cancel only near tangency.
struct Cross {
  using Number = double;

  static RootsOf<double> roots(const Vector3d& origin, const Vector3d& direction,
                               const Vector3d& centre, double radius) {
    const Vector3d T = centre - origin;
    const double a = direction.dot(direction);
    const double b = T.dot(direction);
    const double c = T.dot(T) - radius * radius;
    const Vector3d moment(difference_of_products(T.y(), direction.z(), T.z(), direction.y()),
                          difference_of_products(T.z(), direction.x(), T.x(), direction.z()),
                          difference_of_products(T.x(), direction.y(), T.y(), direction.x()));
    return roots_by_q<double>(a, b, c, a * (radius * radius) - moment.dot(moment));
  }
};

}  // namespace

const IntersectMethod kCross = {
    .name = "cross",
    .sentence = "disc = a r^2 - |T x d|^2 with Kahan's products, roots by q",
    .intersect = intersect_batch<FromRoots<Cross>>,
    .intersect_one = intersect_one<FromRoots<Cross>>,
    .roots = roots_of<FromRoots<Cross>>,
    .max_ulp = kCrossMaxUlp,
    .max_point_ulp = kCrossMaxPointUlp,
};

}  // namespace raycheck::fast
