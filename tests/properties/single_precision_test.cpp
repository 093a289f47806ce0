// Candidates judged in single precision: what is asked, what errors count, what is excused.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "properties/candidates/fast_candidate.h"
#include "properties/case.h"
#include "properties/laws/law.h"
#include "properties/search/campaign.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

constexpr auto kSingle = scene::Precision::kSingle;

/// Doubles judged as floats, whose s, or D.x, are off by a share.
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

TEST(SinglePrecision, HoldsErrorsAgainstFloats) {
  const auto is_broken = [](std::string_view law, const Candidate& candidate) {
    CampaignOptions options;
    options.cases = 300;
    options.level = Level::kOrdinary;
    return run_campaign(*find_law(law), candidate, options).finding() == Finding::kBroken;
  };
  EXPECT_TRUE(is_broken("parameter", off_by(0x1p-15)));
  EXPECT_FALSE(is_broken("parameter", off_by(0x1p-22)));
  EXPECT_TRUE(is_broken("direction", off_by(0, 0x1p-15)));
  EXPECT_FALSE(is_broken("direction", off_by(0, 0x1p-23)));
}

TEST(SinglePrecision, ExcusesSixteenUOfFloat) {
  // The line passes the unit sphere at `height`, and the answer is a miss.
  const auto excuse = [](double height) {
    Case one;
    one.scene.rays = {{{-5, height, 0}, {1, 0, 0}}};
    one.scene.spheres = {{{0, 0, 0}, 1}};
    Candidate candidate = judged_in(kSingle, Candidate{});
    candidate.intersect = [](Candidate::Rays, Candidate::Spheres, const scene::Conventions&) {
      return std::vector<SphereHits>(1);
    };
    Trial trial(one, candidate);
    return apply(*find_law("class"), trial).worst(1).front().excuse.standing();
  };
  EXPECT_EQ(excuse(1 - 0x1p-23), Standing::kExcused);
  EXPECT_EQ(excuse(1 - 0x1p-16), Standing::kDefect);
}

TEST(SinglePrecision, TakesTheFloatNextToARootForThatRoot) {
  const auto is_right = [](double radius, double s) {
    Case one;
    one.scene.rays = {{{0, 0, 2}, {0, 0, 1}}};
    one.scene.spheres = {{{0, 0, 1e8}, radius}};
    Candidate candidate = judged_in(kSingle, Candidate{});
    candidate.intersect = [s](Candidate::Rays, Candidate::Spheres, const scene::Conventions&) {
      return std::vector<SphereHits>{{{0, {s, {0, 0, s + 2}}}}};
    };
    Trial trial(one, candidate);
    return apply(*find_law("nearest-root"), trial).discrepancies() == 0;
  };
  // The roots are 99999996.125 and 99999999.875; floats there are 8 apart.
  EXPECT_TRUE(is_right(1.875, 1e8));
  EXPECT_FALSE(is_right(0x1p24, 1e8 + 0x1p24));
}

TEST(SinglePrecision, AsksFloatsOnly) {
  Case one;
  one.scene.rays = {{{0, 0, 0}, {1, 0, 0}}};
  one.scene.spheres = {{{3, 0, 0.1}, 1}};
  const Candidate candidate = off_by(0);
  EXPECT_THROW(Trial(one, candidate), std::invalid_argument);
  EXPECT_NO_THROW(Trial(*rounded_case(one, kSingle).the_case, candidate));
  // A campaign never does otherwise, whatever the law makes of a case.
  for (const Law& law : laws()) {
    Candidate watched = candidate;
    watched.refuses = false;                       // of what is no problem it is asked otherwise
    watched.pixel_rays = watched.focal_rays = {};  // they are given
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
    CampaignOptions options;
    options.cases = 60;
    options.level = Level::kOrdinary;
    run_campaign(law, watched, options);
    if (law.name == "class" || law.name == "scaling" || law.name == "growing-radius") {
      EXPECT_GT(asked, 50u) << law.name;
    }
  }
}

TEST(SinglePrecision, KeepsBoundsInOwnUnits) {
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
  // Random scales of the whole range of doubles.
  CampaignOptions options;
  options.cases = 60;
  options.sources = {chosen_source("scale@300")};
  const CampaignResult result = run_campaign(*find_law("class"), off_by(0), options);
  EXPECT_EQ(result.counts.cases, 60);
  EXPECT_GT(result.counts.left_out, 50);
  EXPECT_NE(result.counts.reason.find("leaves their range"), std::string::npos)
      << result.counts.reason;
}

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

}  // namespace
}  // namespace raycheck::properties
