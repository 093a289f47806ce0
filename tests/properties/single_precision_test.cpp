// Candidates judged in single precision: their input, errors and excuses.

#include "properties/candidates/fast_candidate.h"
#include "properties/case.h"
#include "scene/validate.h"
#include "tests/campaigns.h"
#include "tests/properties/one_ray.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

constexpr auto kSingle = scene::Precision::kSingle;

/// Code in doubles that is judged as floats, with a relative error of s or of D.x.
Candidate off_by(double s, double direction = 0) {
  Candidate candidate = judged_in(kSingle, fast_candidate(fast::kDirectRays, fast::kCross));
  candidate.intersect = [s, ask = candidate.intersect](const auto&... asked) {
    auto all = ask(asked...);
    for (SphereHits& hits : all) {
      for (auto& [ray, hit] : hits) hit.parameter *= 1 + s;
    }
    return all;
  };
  candidate.pixel_rays = [direction, ask = candidate.pixel_rays](const auto&... asked) {
    auto rays = ask(asked...);
    for (scene::Ray& ray : rays) ray.direction.x *= 1 + direction;
    return rays;
  };
  return candidate;
}

TEST(SinglePrecision, MeasuresErrorsInUnitsOfFloats) {
  const auto is_broken = [](std::string_view law, const Candidate& candidate) {
    const CampaignOptions options = options_of(300, {}, Level::kOrdinary);
    return run_campaign(*find_law(law), candidate, options).finding() == Finding::kBroken;
  };
  EXPECT_TRUE(is_broken("parameter", off_by(0x1p-15)));
  EXPECT_FALSE(is_broken("parameter", off_by(0x1p-22)));
  EXPECT_TRUE(is_broken("direction", off_by(0, 0x1p-15)));
  EXPECT_FALSE(is_broken("direction", off_by(0, 0x1p-23)));
}

TEST(SinglePrecision, ExcusesSixteenUOfFloat) {
  const auto excuse = [](double height) {
    const Verdict of_a_miss =
        judge("class", at_height(height), judged_in(kSingle, that_answers({})));
    return of_a_miss.worst(1).front().excuse.standing();
  };
  EXPECT_EQ(excuse(1 - 0x1p-23), Standing::kExcused);
  EXPECT_EQ(excuse(1 - 0x1p-16), Standing::kDefect);
}

TEST(SinglePrecision, TakesTheFloatNextToARootForThatRoot) {
  const auto is_right = [](double radius, double s) {
    const Case one = one_ray({{0, 0, 2}, {0, 0, 1}}, {{0, 0, 1e8}, radius});
    const Candidate answers = that_answers(HitAnswer{s, {0, 0, s + 2}});
    return judge("nearest-root", one, judged_in(kSingle, answers)).discrepancies() == 0;
  };
  // The roots are 99999996.125 and 99999999.875; floats there are 8 apart.
  EXPECT_TRUE(is_right(1.875, 1e8));
  EXPECT_FALSE(is_right(0x1p24, 1e8 + 0x1p24));
}

TEST(SinglePrecision, AsksFloatsOnly) {
  const Case one = one_ray({{0, 0, 0}, {1, 0, 0}}, {{3, 0, 0.1}, 1});
  const Candidate candidate = off_by(0);
  EXPECT_THROW(Trial(one, candidate), std::invalid_argument);
  EXPECT_NO_THROW(Trial(*rounded_case(one, kSingle).the_case, candidate));
  // So does a campaign, for every law that changes a case.
  for (const Law& law : laws()) {
    Candidate watched = candidate;
    watched.refuses = false;                       // invalid input would not be floats
    watched.pixel_rays = watched.focal_rays = {};  // rays are given
    std::size_t asked = 0;
    watched.intersect = [&](Candidate::Rays rays, Candidate::Spheres spheres,
                            const scene::Conventions& by) {
      scene::Scene scene;
      scene.rays.assign(rays.begin(), rays.end());
      scene.spheres.assign(spheres.begin(), spheres.end());
      EXPECT_TRUE(is_of_format(scene, kSingle)) << law.name;
      ++asked;
      return candidate.intersect(rays, spheres, by);
    };
    run_campaign(law, watched, options_of(60, {}, Level::kOrdinary));
    if (law.name == "class" || law.name == "scaling" || law.name == "growing-radius") {
      EXPECT_GT(asked, 50u) << law.name;
    }
  }
}

TEST(SinglePrecision, KeepsBoundsInUnitsOfTheArithmetic) {
  const Candidate cross = fast_candidate(fast::kDirectRays, fast::kCross);
  const Candidate lecture = fast_candidate(fast::kSingleRays, fast::kSingleLecture);
  const auto s = static_cast<std::size_t>(Quantity::kParameter);
  EXPECT_EQ(judged_in(kSingle, cross).max_error[s], cross.max_error[s]);
  EXPECT_EQ(*judged_in(kSingle, lecture).max_error[s], *lecture.max_error[s] * 0x1p-29);
  EXPECT_EQ(judged_in(kSingle, cross).unit_roundoff, 0x1p-24);
  EXPECT_EQ(judged_in(kSingle, cross).smallest_length, kSmallestSingleLength);
  EXPECT_EQ(judged_in(kSingle, cross).largest_camera_length, kLargestSingleLength);
  EXPECT_EQ(judged_in(scene::Precision::kDouble, cross).max_error, cross.max_error);
}

TEST(SinglePrecision, CountsCasesThatFloatsCannotHold) {
  // Scales are random, over the whole range of doubles.
  const CampaignResult result =
      run_campaign(*find_law("class"), off_by(0), options_of(60, {"scale@300"}));
  EXPECT_EQ(result.counts.cases, 60);
  EXPECT_GT(result.counts.left_out, 50);
  EXPECT_TRUE(has(result.counts.reason, "is outside the range of floats"));
}

TEST(RoundedCase, RoundsEveryNumberToTheNearestFloat) {
  const Case given = one_ray({{0.1, 0, 1}, {1, 1 + 0x1p-24, 0}}, {{1 + 0x1.8p-23, 2, 3}, 0.5});
  const RoundedCase rounded = rounded_case(given, kSingle);
  ASSERT_TRUE(rounded.the_case);
  EXPECT_EQ(rounded.changed, 3u);
  EXPECT_EQ(rounded.reason, "");
  const scene::Scene& scene = rounded.the_case->scene;
  EXPECT_EQ(scene.rays[0].origin.x, static_cast<double>(0.1F));
  EXPECT_EQ(scene.rays[0].direction.y, 1);            // a tie: to even
  EXPECT_EQ(scene.spheres[0].centre.x, 1 + 0x1p-22);  // also a tie
  EXPECT_FALSE(is_of_format(given.scene, kSingle));
  EXPECT_TRUE(is_of_format(scene, kSingle));
  EXPECT_EQ(rounded_case(*rounded.the_case, kSingle).changed, 0u);
}

TEST(RoundedCase, LeavesOutCasesThatBecomeInvalidWithTheReason) {
  Case one;
  one.scene.camera =
      scene::Camera{{1, 0, 0}, {1 + 0x1p-40, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 2, 2};
  one.pixels = {{0, 0}};
  ASSERT_TRUE(scene::defects(one.scene).empty());
  const RoundedCase lost = rounded_case(one, kSingle);
  EXPECT_FALSE(lost.the_case);
  EXPECT_TRUE(has(lost.reason, "look_at"));
}

}  // namespace
}  // namespace raycheck::properties
