#include "properties/rounded_case.h"

#include <gtest/gtest.h>

#include "properties/cases/case_source.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

constexpr auto kSingle = scene::Precision::kSingle;

Case a_case(const scene::Ray& ray, const scene::Sphere& sphere) {
  Case one;
  one.scene.rays = {ray};
  one.scene.spheres = {sphere};
  return one;
}

TEST(RoundedCase, RoundsEveryNumberToTheNearestFloat) {
  const Case given = a_case({{0.1, 0, 1}, {1, 1 + 0x1p-24, 0}}, {{1 + 0x1.8p-23, 2, 3}, 0.5});
  const RoundedCase rounded = rounded_case(given, kSingle);
  ASSERT_TRUE(rounded.the_case);
  EXPECT_EQ(rounded.changed, 3u);
  EXPECT_EQ(rounded.reason, "");
  const scene::Scene& scene = rounded.the_case->scene;
  EXPECT_EQ(scene.rays[0].origin.x, static_cast<double>(0.1F));
  EXPECT_EQ(scene.rays[0].direction.y, 1);            // a tie: to even
  EXPECT_EQ(scene.spheres[0].centre.x, 1 + 0x1p-22);  // likewise
  EXPECT_FALSE(is_of_format(given.scene, kSingle));
  EXPECT_TRUE(is_of_format(scene, kSingle));
  EXPECT_EQ(rounded_case(*rounded.the_case, kSingle).changed, 0u);
}

TEST(RoundedCase, LeavesDoublesAlone) {
  const Case given = a_case({{0.1, 1e300, 1e-300}, {1, 0, 0}}, {{1, 2, 3}, 0.5});
  const RoundedCase same = rounded_case(given, scene::Precision::kDouble);
  ASSERT_TRUE(same.the_case);
  EXPECT_TRUE(same.the_case->scene == given.scene);
  EXPECT_TRUE(is_of_format(given.scene, scene::Precision::kDouble));
}

TEST(RoundedCase, LeavesOutWhatLeavesTheRangeAndSaysWhat) {
  for (const double size : {1e39, 1e-46}) {
    const RoundedCase lost =
        rounded_case(a_case({{0, 0, 0}, {1, 0, 0}}, {{size, 0, 0}, 1}), kSingle);
    EXPECT_FALSE(lost.the_case);
    EXPECT_NE(lost.reason.find("leaves their range"), std::string::npos) << lost.reason;
    EXPECT_NE(lost.reason.find(size > 1 ? "1e+39" : "1e-46"), std::string::npos) << lost.reason;
  }
}

TEST(RoundedCase, LeavesOutWhatBecomesNoProblemAndSaysWhy) {
  Case one;
  one.scene.camera =
      scene::Camera{{1, 0, 0}, {1 + 0x1p-40, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 2, 2};
  one.pixels = {{0, 0}};
  ASSERT_TRUE(scene::defects(one.scene).empty());
  const RoundedCase lost = rounded_case(one, kSingle);
  EXPECT_FALSE(lost.the_case);
  EXPECT_NE(lost.reason.find("look_at"), std::string::npos) << lost.reason;
}

TEST(RoundedCase, KeepsMostCasesOfEverySourceThatAreOrdinary) {
  for (const CaseSource& source : case_sources()) {
    if (!source.dial && source.level > Level::kOrdinary) continue;
    int kept = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const ChosenSource chosen{&source, source.dial ? std::optional(0) : std::nullopt};
      const auto rounded = rounded_case(chosen.make(seed), kSingle).the_case;
      kept += rounded ? 1 : 0;
      if (rounded) {
        EXPECT_TRUE(scene::defects(rounded->scene).empty()) << source.name;
      }
    }
    EXPECT_GE(kept, 10) << source.name;
  }
}

}  // namespace
}  // namespace raycheck::properties
