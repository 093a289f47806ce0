#include "fast/intersect_batch.h"

namespace raycheck::fast {
namespace {

/// x y - z w with two roundings' error at most (Kahan; analysed by Jeannerod, Louvet and Muller,
/// Further analysis of Kahan's algorithm for the accurate computation of 2x2 determinants, 2013:
/// at most 1.5 ulp).
double difference_of_products(double x, double y, double z, double w) {
  const double product = z * w;
  const double error = std::fma(-z, w, product);
  return std::fma(x, y, -product) + error;
}

/// Lagrange's identity: b^2 - a c = a r^2 - |T x d|^2, whose terms cancel only near tangency.
struct Cross {
  static Roots roots(const Vector3d& origin, const Vector3d& direction, const Vector3d& centre,
                     double radius) {
    const Vector3d T = centre - origin;
    const double a = direction.dot(direction);
    const double b = T.dot(direction);
    const double c = T.dot(T) - radius * radius;
    const Vector3d moment(difference_of_products(T.y(), direction.z(), T.z(), direction.y()),
                          difference_of_products(T.z(), direction.x(), T.x(), direction.z()),
                          difference_of_products(T.x(), direction.y(), T.y(), direction.x()));
    return roots_by_q(a, b, c, a * (radius * radius) - moment.dot(moment));
  }
};

}  // namespace

const IntersectMethod kCross = {
    .name = "cross",
    .sentence = "disc = a r^2 - |T x d|^2 with Kahan's products, roots by q",
    .intersect = intersect_batch<Cross>,
    .intersect_one = intersect_one<Cross>,
    .roots = roots_of<Cross>,
    .max_ulp = kCrossMaxUlp,
    .max_point_ulp = kCrossMaxUlp,
};

}  // namespace raycheck::fast
