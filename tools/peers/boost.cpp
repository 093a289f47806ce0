#include <boost/math/tools/roots.hpp>

#include "fast/ray_by_ray.h"
#include "tools/peers/peers.h"
#include "tools/peers/textbook.h"

namespace raycheck::peers {
namespace {

struct Boost {
  const scene::Sphere& sphere;

  std::optional<fast::Hit> answer(const scene::Ray& ray, scene::Root root,
                                  scene::Tangent /*tangent*/) const {
    const Quadratic quadratic = textbook(ray, sphere);
    // Two NaNs where there is no real root: choose() takes neither.
    const auto s =
        choose(boost::math::tools::quadratic_roots(quadratic.a, quadratic.b, quadratic.c), root);
    return s ? std::optional(fast::hit_at(ray, *s)) : std::nullopt;
  }
};

}  // namespace

extern const fast::IntersectMethod kBoost = {
    .name = "boost-math",
    .sentence = "boost::math::tools::quadratic_roots of the textbook's rounded coefficients",
    .intersect = fast::intersect_ray_by_ray<Boost>,
    .intersect_one = fast::intersect_one_ray<Boost>,
    .max_ulp = kSquaresMaxUlp,
    .max_point_ulp = kSquaresMaxUlp,
    .not_kept = "far spheres, grazing rays, a double root at the origin",
    .contract = {.tangent = scene::Tangent::kHit},
};

}  // namespace raycheck::peers
