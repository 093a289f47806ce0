// NanoVDB's Ray<T>::intersects(center, radius, t0, t1), in doubles (with the macro SINGLE, in
// floats): both parameters, clipped to the ray's interval, which starts at Delta<T>. Debian:
// libnanovdb-dev. Source: nanovdb/util/Ray.h: "if t0 == this->t0() or t1 == this->t1() only one
// true intersection exists". Silent on tangents.

#include <nanovdb/util/Ray.h>

#include "adapter.h"

using Vec = nanovdb::Vec3<Real>;

static std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray,
                                              const raycheck::Sphere& sphere,
                                              const raycheck::Conventions&) {
  const nanovdb::Ray<Real> line(to<Vec, Real>(ray.origin), to<Vec, Real>(ray.direction));
  Real t0 = 0, t1 = 0;
  if (!line.intersects(to<Vec, Real>(sphere.centre), static_cast<Real>(sphere.radius), t0, t1)) {
    return std::nullopt;
  }
  if (t0 != line.t0()) return raycheck::Hit{t0, {}};
  if (t1 != line.t1()) return raycheck::Hit{t1, {}};
  return std::nullopt;
}

RAYCHECK_CANDIDATE(.root = raycheck::Root::nearest, .tangent = raycheck::Tangent::either,
                   .intersect = intersect, .level = raycheck::Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest,
                   .precision = kPrecision, .roots = raycheck::Roots::declared,
                   .valid = {.t_min = nanovdb::Delta<Real>::value()},
                   .returns = raycheck::Returns::parameter)
