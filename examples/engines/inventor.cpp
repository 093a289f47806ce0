// Open Inventor's (SGI) SbSphere::intersect(SbLine, enter, exit), in floats: the points where the
// line enters and leaves the sphere. Debian: libinventor1. Its headers, in inventor-dev, cannot be
// installed beside those of Coin, so that this file declares what it calls. Source:
// Inventor/SbLinear.h: a line goes through two points, directed from the first to the second.
// Silent on tangents. Both points are given by raycheck (rays end).

#define SINGLE
#include "adapter.h"

struct SbVec3f {
  float x, y, z;
};
class SbLine {
 public:
  SbLine(const SbVec3f& p0, const SbVec3f& p1);

 private:
  SbVec3f position_, direction_;
};
class SbSphere {
 public:
  SbSphere(const SbVec3f& centre, float radius);
  int intersect(const SbLine& line, SbVec3f& nearest) const;
  int intersect(const SbLine& line, SbVec3f& enter, SbVec3f& exit) const;

 private:
  SbVec3f centre_;
  float radius_;
};

static SbVec3f point(const raycheck::Vector& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

static std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray,
                                              const raycheck::Sphere& sphere,
                                              const raycheck::Conventions&) {
  const SbLine line(point(ray.origin), point(ray.direction));
  const SbSphere ball(point(sphere.centre), static_cast<float>(sphere.radius));
  SbVec3f found{};
#ifdef NEAREST
  if (!ball.intersect(line, found)) return std::nullopt;
#else
  SbVec3f exit{};
  if (!ball.intersect(line, found, exit)) return std::nullopt;
#endif
  return raycheck::Hit{.point = {found.x, found.y, found.z}};
}

#ifdef NEAREST
constexpr raycheck::ValidRoots kRoots;
#else
constexpr raycheck::ValidRoots kRoots = kLine;
#endif
RAYCHECK_CANDIDATE(.root = raycheck::Root::nearest, .tangent = raycheck::Tangent::either,
                   .intersect = intersect, .level = raycheck::Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest,
                   .precision = kPrecision, .roots = raycheck::Roots::declared, .valid = kRoots,
                   .returns = raycheck::Returns::point, .contract = "rays end")
