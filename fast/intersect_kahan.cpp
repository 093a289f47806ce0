#include "fast/error_free.h"
#include "fast/intersect_batch.h"

namespace raycheck::fast {
namespace {

/// Kahan, On the Cost of Floating-Point Computation Without Extra-Precise Arithmetic (2004): the
/// discriminant of the rounded coefficients to a few ulp. The errors of b and c remain.
struct Kahan {
  using Number = double;

  static RootsOf<double> roots(const Vector3d& origin, const Vector3d& direction,
                               const Vector3d& centre, double radius) {
    const Vector3d T = centre - origin;
    const double a = direction.dot(direction);
    const double b = T.dot(direction);
    const double c = T.dot(T) - radius * radius;
    return roots_by_q<double>(a, b, c, difference_of_products(b, b, a, c));
  }
};

}  // namespace

const IntersectMethod kKahan = {
    .name = "kahan",
    .sentence = "the textbook's a, b, c; disc = b^2 - ac by Kahan's products, roots by q",
    .intersect = intersect_batch<FromRoots<Kahan>>,
    .intersect_one = intersect_one<FromRoots<Kahan>>,
    .roots = roots_of<FromRoots<Kahan>>,
    .max_ulp = kKahanMaxUlp,
    .max_point_ulp = kKahanMaxPointUlp,
    .not_kept = "spheres many radii away, grazing rays",
};

}  // namespace raycheck::fast
