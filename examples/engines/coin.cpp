// Coin's SbSphere::intersect(SbLine, enter, exit), in floats: the points where the line enters and
// leaves the sphere; for a tangent they are equal. Debian: libcoin-dev; -lCoin.
// Source: Inventor/SbSphere.h, and its manual: a line is directed and infinite; its direction is
// made unit by SbLine.

#include <Inventor/SbLine.h>
#include <Inventor/SbSphere.h>

#define SINGLE
#include "adapter.h"

using namespace raycheck;

static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  SbLine line;
  line.setPosDir(to<SbVec3f, float>(ray.origin), to<SbVec3f, float>(ray.direction));
  const SbSphere ball(to<SbVec3f, float>(sphere.centre), static_cast<float>(sphere.radius));
  SbVec3f enter, exit;
  if (!ball.intersect(line, enter, exit)) return std::nullopt;
  return Hit{.point = {enter[0], enter[1], enter[2]}};
}

RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::hit, .intersect = intersect,
                   .level = Level::ordinary, .smallest_length = kSmallest,
                   .largest_length = kLargest, .precision = kPrecision, .roots = Roots::declared,
                   .valid = kLine, .returns = Returns::point)
