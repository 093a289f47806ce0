#include "fast/error_free.h"
#include "fast/intersect_batch.h"

namespace raycheck::fast {
namespace {

/// x.y - z.w, a component of a cross product whose first factors are pairs.
double determinant(const Rounded& x, double y, const Rounded& z, double w) {
  return difference_of_products(x.x, y, z.x, w) + (x.error * y - z.error * w);
}

/// `cross` with T = C - o as an exact pair, and c = |T|^2 - r^2 as a compensated sum (Ogita, Rump
/// and Oishi, Accurate sum and dot product, 2005), so that neither the rounding of T nor an origin
/// near the surface costs digits.
struct Cross2 {
  using Number = double;

  static RootsOf<double> roots(const Vector3d& origin, const Vector3d& direction,
                               const Vector3d& centre, double radius) {
    const Rounded x = two_sum(centre.x(), -origin.x());
    const Rounded y = two_sum(centre.y(), -origin.y());
    const Rounded z = two_sum(centre.z(), -origin.z());
    const Vector3d T(x.x, y.x, z.x);
    const Vector3d T_error(x.error, y.error, z.error);
    const double a = direction.dot(direction);
    const double b = T.dot(direction) + T_error.dot(direction);
    const Vector3d moment(determinant(y, direction.z(), z, direction.y()),
                          determinant(z, direction.x(), x, direction.z()),
                          determinant(x, direction.y(), y, direction.x()));
    const Rounded xx = two_square(x.x);
    const Rounded yy = two_square(y.x);
    const Rounded zz = two_square(z.x);
    const Rounded rr = two_square(radius);
    const Rounded first = two_sum(xx.x, -rr.x);
    const Rounded second = two_sum(first.x, yy.x);
    const Rounded sum = two_sum(second.x, zz.x);
    const double c = sum.x + ((first.error + second.error + sum.error) +
                              (xx.error + yy.error + zz.error - rr.error) + 2 * T.dot(T_error));
    return roots_by_q<double>(a, b, c, a * rr.x - moment.dot(moment));
  }
};

}  // namespace

const IntersectMethod kCross2 = {
    .name = "cross2",
    .sentence = "cross, with C - o as an exact pair and a compensated c",
    .intersect = intersect_batch<FromRoots<Cross2>>,
    .intersect_one = intersect_one<FromRoots<Cross2>>,
    .roots = roots_of<FromRoots<Cross2>>,
    .max_ulp = kCross2MaxUlp,
    .max_point_ulp = kCross2MaxPointUlp,
};

}  // namespace raycheck::fast
