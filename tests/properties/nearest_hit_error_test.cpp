#include "properties/nearest_hit_error.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "properties/candidates/fast_candidate.h"
#include "reference/visibility/visibility.h"

namespace raycheck::properties {
namespace {

using reference::kNoSphere;
using scene::Sphere;

/// A ray through the middles of spheres 0, 1 and 2 (1 and 2 are one), one that touches sphere 0,
/// and one that misses all.
Case three_rays(scene::Tangent tangent) {
  Case the_case;
  the_case.scene.rays = {{{0, 0, 0}, {1, 0, 0}}, {{0, 2, 0}, {1, 0, 0}}, {{0, 9, 0}, {1, 0, 0}}};
  the_case.scene.spheres = {{{20, 0, 0}, 2}, {{10, 0, 0}, 1}, {{10, 0, 0}, 1}};
  the_case.scene.conventions.tangent = tangent;
  return the_case;
}

/// The errors of a candidate that ranks spheres like this.
std::vector<NearestHitError> errors_of(const std::vector<std::optional<std::size_t>>& nearest,
                                       scene::Tangent tangent = scene::Tangent::kHit) {
  const Case the_case = three_rays(tangent);
  Candidate candidate = fast_candidate(fast::kDirectRays, fast::kRobust);
  candidate.nearest = [&](Candidate::Rays, Candidate::Spheres, const scene::Conventions&) {
    return nearest;
  };
  Trial trial(the_case, candidate);
  const std::int32_t touched = tangent == scene::Tangent::kMiss ? kNoSphere : 0;
  return nearest_hit_errors(trial, std::vector<std::int32_t>{1, touched, kNoSphere});
}

/// Any of spheres that are equally near is right.
TEST(NearestHitError, IsMeasuredWhereTheSphereIsRight) {
  for (const std::size_t nearest : {1u, 2u}) {
    const auto errors = errors_of({nearest, 0, std::nullopt});
    ASSERT_EQ(errors.size(), 3u);
    for (const NearestHitError& error : errors) EXPECT_EQ(error.wrong, Wrong::kNot);
    EXPECT_EQ(errors[0].ulp, 0);
    EXPECT_EQ(errors[1].ulp, 0);
    EXPECT_FALSE(errors[2].ulp);
  }
}

TEST(NearestHitError, SaysHowAnAnswerIsWrong) {
  // A tangent is excused, or not judged, as its convention is.
  for (const auto& [tangent, standing] : {std::pair(scene::Tangent::kHit, Standing::kExcused),
                                          {scene::Tangent::kEither, Standing::kNotJudged}}) {
    const auto errors = errors_of({0, std::nullopt, 1}, tangent);
    EXPECT_EQ(errors[0].wrong, Wrong::kWrongSphere);
    EXPECT_EQ(errors[1].wrong, Wrong::kMissed);
    EXPECT_EQ(errors[2].wrong, Wrong::kFalseHit);
    for (const NearestHitError& error : errors) EXPECT_FALSE(error.ulp);
    EXPECT_EQ(errors[0].standing, Standing::kDefect);
    EXPECT_EQ(errors[1].standing, standing);
    EXPECT_EQ(errors[2].standing, Standing::kDefect);
  }
}

}  // namespace
}  // namespace raycheck::properties
