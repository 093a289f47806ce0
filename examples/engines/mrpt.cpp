// MRPT's CSphere::traceRay, in doubles, of a sphere whose radius is a float: the distance along the
// x axis of a pose to the nearest hit. The adapter makes the pose's rotation; its first column is
// the ray's unit direction in doubles. Debian: libmrpt-opengl-dev; -lmrpt-opengl -lmrpt-poses.
// Source: CRenderizable.h: traceRay "simulates a ray; o: the pose of the ray emission point; dist:
// the distance to the object". Silent on tangents.

#include <mrpt/opengl/CSphere.h>
#include <mrpt/poses/CPose3D.h>

#include <cmath>

#define SINGLE
#include "adapter.h"

using mrpt::math::TVector3D;

static std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray,
                                              const raycheck::Sphere& sphere,
                                              const raycheck::Conventions&) {
  const auto& [o, d] = ray;
  const TVector3D x = TVector3D(d.x, d.y, d.z).unitarize();
  const bool flat = std::abs(x.z) < 0.5;
  const TVector3D side = TVector3D(flat ? -x.y : 0, flat ? x.x : -x.z, flat ? 0 : x.y);
  const TVector3D y = side.unitarize();
  const TVector3D z(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);
  mrpt::math::CMatrixDouble33 axes;
  for (int i = 0; i < 3; ++i) {
    axes(i, 0) = x[i];
    axes(i, 1) = y[i];
    axes(i, 2) = z[i];
  }
  const mrpt::poses::CPose3D pose(axes, mrpt::math::CVectorFixedDouble<3>({o.x, o.y, o.z}));
  mrpt::opengl::CSphere ball(static_cast<float>(sphere.radius));
  ball.setLocation(sphere.centre.x, sphere.centre.y, sphere.centre.z);
  double distance = 0;
  if (!ball.traceRay(pose, distance)) return std::nullopt;
  return raycheck::Hit{distance, {}};
}

RAYCHECK_CANDIDATE(.root = raycheck::Root::nearest, .tangent = raycheck::Tangent::either,
                   .intersect = intersect, .level = raycheck::Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest,
                   .precision = kPrecision, .returns = raycheck::Returns::distance)
