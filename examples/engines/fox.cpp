// FOX's FXSphered::intersect (with the macro SINGLE, FXSpheref), in doubles: whether a ray from one
// point to another meets the sphere. Debian: libfox-1.6-dev; -lFOX-1.6.
// Source: FXSphered.h: "Intersect sphere with ray u-v". Silent on tangents, and on whether the ray
// ends at v (here it does not, the milder reading). Both points are given by raycheck (rays end).

#include <fox-1.6/fx.h>
#include <fox-1.6/fx3d.h>

#include "adapter.h"

#ifdef SINGLE
using Point = FX::FXVec3f;
using Ball = FX::FXSpheref;
#else
using Point = FX::FXVec3d;
using Ball = FX::FXSphered;
#endif

static std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray,
                                              const raycheck::Sphere& sphere,
                                              const raycheck::Conventions&) {
  const Ball ball(to<Point, Real>(sphere.centre), static_cast<Real>(sphere.radius));
  if (!ball.intersect(to<Point, Real>(ray.origin), to<Point, Real>(ray.direction))) {
    return std::nullopt;
  }
  return raycheck::Hit{};
}

RAYCHECK_CANDIDATE(.root = raycheck::Root::nearest, .tangent = raycheck::Tangent::either,
                   .intersect = intersect, .level = raycheck::Level::ordinary,
                   .smallest_length = kSmallest, .largest_length = kLargest,
                   .precision = kPrecision, .returns = raycheck::Returns::class_only,
                   .contract = "rays end")
