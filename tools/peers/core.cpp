#include <CGAL/CORE/Expr.h>

#include <cmath>
#include <mutex>
#include <stdexcept>
#include <string>

#include "fast/ray_by_ray.h"
#include "scene/number.h"
#include "tools/peers/peers.h"

namespace raycheck::peers {
namespace {

using CORE::Expr;

/// CORE aborts the process on overflow, and its time grows with the exponents: beyond these lengths
/// it is not asked at all.
constexpr fast::Domain kCoreDomain;

/// Bits of an answer before it is rounded.
constexpr long kBits = 96;

/// Throws std::invalid_argument naming the field whose length is beyond the domain.
void require_length(const char* field, double length, double smallest) {
  if (length >= smallest && length <= kCoreDomain.largest_length) return;
  throw std::invalid_argument(std::string(field) + ": CORE is asked about lengths from " +
                              scene::hexfloat(kCoreDomain.smallest_length) + " to " +
                              scene::hexfloat(kCoreDomain.largest_length) + " only, not " +
                              scene::hexfloat(length));
}

template <class Triple>
double length(const Triple& v) {
  return std::hypot(v.x, v.y, v.z);
}

void require_inside_domain(const scene::Sphere& sphere) {
  require_length("sphere.centre", length(sphere.centre), 0);
  require_length("sphere.radius", sphere.radius,
                 sphere.radius == 0 ? 0 : kCoreDomain.smallest_length);
}
void require_inside_domain(const scene::Ray& ray) {
  require_length("ray.origin", length(ray.origin), 0);
  require_length("ray.direction", length(ray.direction), kCoreDomain.smallest_length);
}

struct Vector {
  Expr x, y, z;
};
template <class Triple>
Vector lifted(const Triple& v) {
  return {Expr(v.x), Expr(v.y), Expr(v.z)};
}
Expr dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The double nearest to x / y but for 2^-kBits of it, y != 0. CORE divides after both are known:
/// asked through a quotient, the square root of a large number comes with fewer bits than were
/// asked for. Its own conversion to a double truncates.
double rounded_quotient(const Expr& x, const Expr& y) {
  if (x.isZero()) return 0;
  const auto approximate = [](const Expr& z) {
    return z.approx(kBits, CORE::CORE_posInfty).BigFloatValue();
  };
  const CORE::BigFloat value = approximate(x).div(approximate(y), kBits);
  const double truncated = value.doubleValue();
  const CORE::BigFloat rest = value - CORE::BigFloat(truncated);
  return rest.isZeroIn() ? truncated : truncated + rest.doubleValue();
}

/// CORE's reference counts are not atomic, and some of its objects belong to all threads.
std::mutex& core_in_use() {
  static std::mutex mutex;
  return mutex;
}

struct Core {
  explicit Core(const scene::Sphere& given) : sphere(given) { require_inside_domain(sphere); }

  std::optional<fast::Hit> answer(const scene::Ray& ray, scene::Root root,
                                  scene::Tangent tangent) const {
    require_inside_domain(ray);
    const std::lock_guard lock(core_in_use());
    const Vector C = lifted(sphere.centre);
    const Expr r(sphere.radius);
    const Vector L = lifted(ray.origin);
    const Vector D = lifted(ray.direction);
    const Vector T = {C.x - L.x, C.y - L.y, C.z - L.z};
    const Expr a = dot(D, D);
    const Expr b = dot(T, D);
    const Expr discriminant = b * b - a * (dot(T, T) - r * r);
    const int sign = discriminant.sign();
    if (sign < 0 || (sign == 0 && tangent == scene::Tangent::kMiss)) return std::nullopt;
    const Expr half = sign == 0 ? Expr(0) : sqrt(discriminant);
    const Expr smaller = b - half;
    const Expr larger = b + half;
    const bool in_front = smaller.sign() >= 0;
    if (!in_front && (root == scene::Root::kSmaller || larger.sign() < 0)) return std::nullopt;
    return fast::hit_at(ray, rounded_quotient(in_front ? smaller : larger, a));
  }

  scene::Sphere sphere;
};

/// Of s, kBits rounded once; Q is computed in doubles.
constexpr double kMaxUlp = 0.5 + 0x1p-30;
constexpr double kMaxPointUlp = 96;

}  // namespace

extern const fast::IntersectMethod kCore = {
    .name = "core",
    .sentence = "the textbook's formula in CORE::Expr: exact signs, s to 96 bits",
    .intersect = fast::intersect_ray_by_ray<Core>,
    .intersect_one = fast::intersect_one_ray<Core>,
    .max_ulp = kMaxUlp,
    .max_point_ulp = kMaxPointUlp,
    .not_kept = "lengths beyond its domain: it refuses them",
    .domain = kCoreDomain,
};

}  // namespace raycheck::peers
