// QMath3d's (Qt3D 1) QSphere3D::intersection(QRay3D), in floats: the parameter t >= 0 of the
// nearest hit, or NaN. With the macro BOTH, intersection(ray, &minimum_t, &maximum_t): both
// parameters, also negative ones, equal for a tangent; the adapter takes the first >= 0. Debian:
// libqmath3d-dev; -lQMath3d. Source: the comments of qsphere3d.cpp, and of qray3d.cpp: directions
// of any length.

#include <qray3d.h>
#include <qsphere3d.h>

#include <cmath>

#define SINGLE
#include "adapter.h"

static std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray,
                                              const raycheck::Sphere& sphere,
                                              const raycheck::Conventions&) {
  const QRay3D line(to<QVector3D, float>(ray.origin), to<QVector3D, float>(ray.direction));
  const QSphere3D ball(to<QVector3D, float>(sphere.centre), static_cast<float>(sphere.radius));
#ifdef BOTH
  float first = 0, last = 0;
  if (!ball.intersection(line, &first, &last) || last < 0) return std::nullopt;
  return raycheck::Hit{first >= 0 ? first : last, {}};
#else
  const float t = ball.intersection(line);
  if (std::isnan(t)) return std::nullopt;
  return raycheck::Hit{t, {}};
#endif
}

RAYCHECK_CANDIDATE(.root = raycheck::Root::nearest, .tangent = raycheck::Tangent::hit,
                   .intersect = intersect, .level = raycheck::Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest,
                   .precision = kPrecision, .returns = raycheck::Returns::parameter)
