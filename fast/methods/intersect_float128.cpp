#include "fast/internal/intersect_formulas.h"

namespace raycheck {
namespace {

__extension__ typedef __float128 Float128;

}  // namespace

/// One Newton step improves a square root of 64 bits to 112 of 113 correct bits. The compilers
/// provide all arithmetic of the type but the square root. That of libquadmath is not used, since
/// only one of the compilers finds its header.
template <>
Float128 scene::square_root(const Float128& x) {
  if (!(x > 0)) return static_cast<Float128>(std::sqrt(static_cast<long double>(x)));
  const Float128 guess = std::sqrt(static_cast<long double>(x));
  return guess + (x - guess * guess) / (2 * guess);
}

namespace fast {

/// The formula of `double-double` with 113-bit significands, by software. Domain: kWideDomain.
const IntersectMethod kFloat128 = {
    .name = "float128",
    .sentence = "disc = a r^2 - |T x D|^2 and roots by q, with 113-bit significands (software)",
    RAYCHECK_FUNCTIONS_RAY_BY_RAY(Lagrange<Float128>),
    .max_ulp = 1,
    .max_point_ulp = 1.5,
    .domain = kWideDomain,
};

}  // namespace fast
}  // namespace raycheck
