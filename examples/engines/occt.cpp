// Open CASCADE's IntAna_IntConicQuad of a line and a sphere, in doubles: the analytic
// intersection, "points associated with the parameter on the conic", here the distance along the
// line. Debian: libocct-modeling-data-dev; -lTKGeomBase -lTKG3d -lTKMath -lTKernel.
// Source: opencascade/IntAna_IntConicQuad.hxx, gp_Lin.hxx. gp_Dir makes directions unit. Silent on
// the order of points and on tangents.

// IntAna_Quadric.hxx needs the headers before it.
// clang-format off
#include <gp.hxx>
#include <gp_Ax3.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <IntAna_Quadric.hxx>
#include <IntAna_IntConicQuad.hxx>
// clang-format on

#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const gp_Lin line(to<gp_Pnt>(ray.origin), to<gp_Dir>(ray.direction));
  const gp_Sphere ball(gp_Ax3(to<gp_Pnt>(sphere.centre), gp::DZ()), sphere.radius);
  const IntAna_IntConicQuad points(line, IntAna_Quadric(ball));
  if (!points.IsDone() || points.IsInQuadric() || points.IsParallel()) return std::nullopt;
  std::optional<Hit> first;
  for (int i = 1; i <= points.NbPoints(); ++i) {
    const double distance = points.ParamOnConic(i);
    if (!first || distance < first->parameter) first = Hit{distance, {}};
  }
  return first;
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .roots = Roots::declared, .valid = kLine,
                   .returns = Returns::distance)
