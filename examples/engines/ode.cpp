// ODE's dCollide of a dCreateRay and a dCreateSphere, in doubles as Debian builds it: the contact's
// depth is the distance from the ray's start to the hit. Debian: libode-dev; -lode.
// Source: the manual, "Collision Detection" (contact points, ray class). Silent on tangents. A
// contact also has a position, but for directions of any length a candidate can return only one.

#include <ode/ode.h>

#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  static const int ready = dInitODE2(0);
  (void)ready;
  const auto& [o, d] = ray;
  const dGeomID line = dCreateRay(nullptr, dInfinity), ball = dCreateSphere(nullptr, sphere.radius);
  dGeomRaySet(line, o.x, o.y, o.z, d.x, d.y, d.z);
  dGeomSetPosition(ball, sphere.centre.x, sphere.centre.y, sphere.centre.z);
  dContactGeom contact;
  const int contacts = dCollide(line, ball, 1, &contact, sizeof contact);
  dGeomDestroy(line);
  dGeomDestroy(ball);
  if (contacts == 0) return std::nullopt;
  return Hit{contact.depth, {}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .returns = Returns::distance)
