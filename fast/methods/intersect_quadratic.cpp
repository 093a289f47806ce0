#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fast/methods/intersect_quadratic.cpp"
#include <hwy/foreach_target.h>

#include "fast/internal/intersect_formulas.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {
namespace {

bool batch(const BatchQuestion& question, const HitArrays& answers) {
  return answer_batch(answer_whole_vectors<FromRoots<Textbook<Lanes>>>, question, answers);
}

}  // namespace
}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raycheck::fast {
namespace {

HWY_EXPORT(batch);

void intersect(const Rays& rays, const scene::Sphere& sphere, scene::Root root,
               scene::Tangent tangent, Hits& hits) {
  intersect_by(HWY_DYNAMIC_DISPATCH(batch), rays, sphere, root, tangent, hits);
}

using One = HWY_NAMESPACE::FromRoots<HWY_NAMESPACE::Textbook<double>>;

}  // namespace

const IntersectMethod kQuadratic = {
    .name = "quadratic",
    .sentence = "t = (-b -+ sqrt(b^2 - 4ac)) / 2a, the textbook's general parametric approach",
    .intersect = intersect,
    .intersect_one = HWY_NAMESPACE::intersect_one<One>,
    .roots = HWY_NAMESPACE::roots_of<One>,
    .max_ulp = kQuadraticMaxUlp,
    .max_point_ulp = kQuadraticMaxPointUlp,
    .not_kept = "spheres many radii away, grazing rays",
};

}  // namespace raycheck::fast
#endif
