// CGAL's CORE::Expr: the textbook's formula with exact signs, and s to 96 bits. Debian:
// libcgal-dev; -lgmp -lmpfr.

#include <CGAL/CORE/Expr.h>

#include "adapter.h"

using namespace raycheck;
using CORE::Expr;

struct Exact {
  Expr x, y, z;
};
static Exact exact(const Vector& v) { return {Expr(v.x), Expr(v.y), Expr(v.z)}; }
static Expr dot(const Exact& a, const Exact& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// x / y with a relative error of at most 2^-kBits, rounded to double. Domain: y != 0. It divides
/// approximations of x and y, since within a quotient CORE returns fewer bits of a large number's
/// square root than requested, and since CORE's conversion to double truncates.
static double rounded_quotient(const Expr& x, const Expr& y) {
  constexpr long kBits = 96;
  if (x.isZero()) return 0;
  const auto approximate = [](const Expr& z) {
    return z.approx(kBits, CORE::CORE_posInfty).BigFloatValue();
  };
  const CORE::BigFloat value = approximate(x).div(approximate(y), kBits);
  const double truncated = value.doubleValue();
  const CORE::BigFloat rest = value - CORE::BigFloat(truncated);
  return rest.isZeroIn() ? truncated : truncated + rest.doubleValue();
}

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere,
                                    const Conventions& asked) {
  const Exact c = exact(sphere.centre), o = exact(ray.origin), d = exact(ray.direction);
  const Exact t = {c.x - o.x, c.y - o.y, c.z - o.z};
  const Expr r(sphere.radius), a = dot(d, d), b = dot(t, d);
  const Expr discriminant = b * b - a * (dot(t, t) - r * r);
  const int sign = discriminant.sign();
  if (sign < 0 || (sign == 0 && asked.tangent == Tangent::miss)) return std::nullopt;
  const Expr half = sign == 0 ? Expr(0) : sqrt(discriminant);
  const Expr smaller = b - half, larger = b + half;
  const bool in_front = smaller.sign() >= 0;
  if (!in_front && (asked.root == Root::smaller || larger.sign() < 0)) return std::nullopt;
  return hit_at(ray, rounded_quotient(in_front ? smaller : larger, a));
}

// CORE aborts on overflow, and its time grows with the exponents.
RAYCHECK_CANDIDATE(.name = "core", .intersect = intersect, .level = Level::demanding,
                   .smallest_length = 0x1p-200, .largest_length = 0x1p200)
