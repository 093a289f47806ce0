#include <gsl/gsl_poly.h>

#include "fast/ray_by_ray.h"
#include "tools/peers/peers.h"
#include "tools/peers/textbook.h"

namespace raycheck::peers {
namespace {

struct Gsl {
  const scene::Sphere& sphere;

  std::optional<fast::Hit> answer(const scene::Ray& ray, scene::Root root,
                                  scene::Tangent /*tangent*/) const {
    const Quadratic quadratic = textbook(ray, sphere);
    double smaller = 0;
    double larger = 0;
    // A double root counts as two that are equal.
    if (gsl_poly_solve_quadratic(quadratic.a, quadratic.b, quadratic.c, &smaller, &larger) != 2) {
      return std::nullopt;
    }
    const auto s = choose({smaller, larger}, root);
    return s ? std::optional(fast::hit_at(ray, *s)) : std::nullopt;
  }
};

}  // namespace

extern const fast::IntersectMethod kGsl = {
    .name = "gsl",
    .sentence = "gsl_poly_solve_quadratic of the textbook's rounded coefficients",
    .intersect = fast::intersect_ray_by_ray<Gsl>,
    .intersect_one = fast::intersect_one_ray<Gsl>,
    .max_ulp = kSquaresMaxUlp,
    .max_point_ulp = kSquaresMaxUlp,
    .not_kept = "far spheres, grazing rays",
    .contract = {.tangent = scene::Tangent::kHit},
};

}  // namespace raycheck::peers
