#include "tests/degenerate/judged.h"

namespace raycheck::degenerate {
namespace {

using Names = std::vector<std::string_view>;
const Names kDecisions = {"class", "nearest-root", "nearest-sphere"};
const Names kKnowTheClass = {"knows-hits-at-0", "knows-hits-at-the-origin"};

constexpr const char* kManyAtTheSurface =
    "rays start within a few roundings of every sphere's surface, and which sphere is nearest "
    "depends on these roundings";

}  // namespace

std::span<const WhyExcused> why_excused() {
  static const std::vector<WhyExcused> kReasons = {
      {{"tangent-ulps", 48, 53},
       kDecisions,
       {},
       "the impact parameter is within 2^-48 of the radius, and 16 u, 2^-49, of each input moves "
       "it as far: with a radius a rounding smaller a tangent is a miss, and its roots are as "
       "close "
       "together as the uncertainty of their distance from s = 0"},
      {{"tangent-ulps", 53, 53},
       {"parameter", "hit-point", "scaling", "axes"},
       {},
       "at an exact tangent an s whose backward error is within its bound is allowed: it may be "
       "off by half of its bits"},
      {{"tangency", 14, 16},
       kDecisions,
       {},
       "the impact parameter is within 10^-14 of the radius, up to a thousand radii away: 16 u of "
       "that distance moves it as far"},
      {{"horizon", 15, 15},
       {"class", "nearest-root", "parameter", "hit-point"},
       {},
       "the eye is within 10^-15 radii of the surface and the rays level: 16 u takes it inside, "
       "and the line off the sphere"},
      {{"surface", 14, 15}, {"nearest-sphere"}, kKnowTheClass, kManyAtTheSurface},
      {{"surface", 15, 15},
       {"parameter", "hit-point"},
       {},
       "the near root is of the size of the rounding of the inputs: 0 is right for nearby inputs"},
      {{"surface", 16, 16},
       {"parameter"},
       {},
       "the exact s is 0, where a relative error has no size and the condition number is infinite; "
       "`backward-error` and `hit-point` catch a wrong one"},
      {{"from-surface", 0, 0},
       {"scaling"},
       {},
       "every ray starts exactly on the surface: 16 u turn its hits at s = 0 into misses, and its "
       "misses into hits"},
      {{"distance", 14, 15},
       kDecisions,
       {},
       "16 u of 10^14 radii is a fifth of a radius, of 10^15 more than one: the root, the sphere "
       "and even hit or miss depend on the last bits of the inputs"},
      {{"far-world", 15, 15},
       kDecisions,
       {},
       "16 u of 10^15 is more than the whole scene, so that any answer may be right"},
      {{"far-camera", 14, 15},
       {"class", "nearest-root", "nearest-sphere", "visible-sphere", "growing-radius", "scaling",
        "axes"},
       {},
       "16 u of 10^15 is more than the whole scene, so that any answer may be right"},
      {{"far-camera", 6, 15},
       {"image"},
       {},
       "an image is excused by relative changes of 10^-6, which at a distance of 10^6 is the size "
       "of the scene: no picture in single precision can show it"},
      {{"up", 14, 15},
       {"class", "nearest-root", "nearest-sphere", "visible-sphere", "growing-radius",
        "focal-and-pixel", "scaling", "axes"},
       {},
       "16 u of `up` and of the view are as much as the angle between them: the image may be "
       "turned by any angle"},
      {{"up", 5, 15},
       {"image"},
       {},
       "an image is excused by relative changes of 10^-6, which for `up` and the view are up to a "
       "tenth of the angle between them: the image may be turned by as much"},
      {{"near-plane", 14, 15}, {"nearest-sphere"}, kKnowTheClass, kManyAtTheSurface},
      {{"coincident", 15, 16},
       {"nearest-sphere"},
       kKnowTheClass,
       "all spheres that are hit are within a rounding of each other: any of them may be the "
       "nearest"},
      {{"ties", 0, 0},
       {"nearest-sphere"},
       kKnowTheClass,
       "all spheres that are hit are equal, or an ulp of the radius apart"},
  };
  return kReasons;
}

}  // namespace raycheck::degenerate
