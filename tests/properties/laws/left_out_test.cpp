// The reasons why laws are left out.

#include "properties/candidates/fast_candidate.h"
#include "tests/properties/one_ray.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

Case two_spheres_ahead() {
  Case result;
  result.scene.camera = scene::Camera{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, -2, {}, -1, 1, -1, 1, 3, 3};
  result.scene.spheres = {{{0, 0, -10}, 3}, {{0, 0, -20}, 3}};
  result.pixels = {{1, 1}, {0, 2}};
  return result;
}

std::string reason_for(std::string_view law, const Case& the_case, const Candidate& candidate) {
  return judge(law, the_case, candidate).reason_left_out();
}

TEST(LeftOut, LawsOfHitsSayWhichHitsAreMissing) {
  const Candidate misses = that_answers({}), far = that_answers(HitAnswer{6, {1, 0, 0}});
  for (const char* law : {"nearest-root", "parameter", "backward-error", "hit-point"}) {
    EXPECT_EQ(reason_for(law, at_height(2), misses), "no ray hits a sphere") << law;
    EXPECT_EQ(reason_for(law, at_height(0), misses), "the candidate finds no hit to compare")
        << law;
    EXPECT_EQ(reason_for(law, at_height(0), far),
              std::string_view(law) == "nearest-root"
                  ? ""
                  : "the candidate finds no hit at the right root")
        << law;
  }
}

TEST(LeftOut, LawsOfRaysNameTheMissingFunction) {
  Case given = two_spheres_ahead();
  const Candidate intersects = that_answers({});
  for (const char* law : {"unit-direction", "focal-and-pixel"}) {
    EXPECT_EQ(reason_for(law, given, intersects), "the candidate does not implement pixel_ray()");
  }
  given.scene.conventions.origin = scene::Origin::kFocal;
  EXPECT_EQ(reason_for("unit-direction", given, intersects),
            "the candidate does not implement focal_ray()");
}

TEST(LeftOut, OfAPickAreTheLawsOfRays) {
  Candidate picks;
  picks.refuses = false;
  picks.pick = [](auto&&...) { return std::vector<SphereHits>(2); };
  const Case the_case = two_spheres_ahead();
  EXPECT_EQ(reason_for("class", the_case, picks), "");
  EXPECT_EQ(reason_for("direction", the_case, picks),
            "the candidate does not implement pixel_ray()");
  for (const char* law : {"backward-error", "growing-radius", "exchange"}) {
    EXPECT_EQ(reason_for(law, the_case, picks), "pick() is asked for pixels, not for rays") << law;
  }
  EXPECT_EQ(reason_for("class", at_height(0), picks),
            "the candidate does not implement intersect()");
}

TEST(LeftOut, OfARendererAreAllLawsButThoseOfPictures) {
  Candidate draws;
  draws.image = [](auto&&...) { return ImageAnswer(9); };
  draws.refuses = false;
  for (const Law& law : laws()) {
    if (law.name == "image" || law.name == "refusal") continue;
    EXPECT_EQ(reason_for(law.name, two_spheres_ahead(), draws),
              "applies to functions; the law image judges a renderer's pictures")
        << law.name;
  }
  EXPECT_EQ(reason_for("image", two_spheres_ahead(), draws), "");
}

/// The error is the distance from the right corner.
TEST(PixelZeroZero, AtAnotherCornerHasAFiniteError) {
  Candidate mirrors = fast_candidate(fast::kDirectRays, fast::kCross);
  mirrors.pixel_points = [ask = mirrors.pixel_points](const scene::Camera& camera,
                                                      const scene::Conventions& by,
                                                      Candidate::Pixels pixels) {
    std::vector<scene::Pixel> mirrored(pixels.begin(), pixels.end());
    for (scene::Pixel& pixel : mirrored) pixel.i = camera.width - 1 - pixel.i;
    return ask(camera, by, mirrored);
  };
  const Verdict verdict = judge("pixel-zero-zero", two_spheres_ahead(), mirrors);
  ASSERT_EQ(verdict.discrepancies(), 1u);
  const Discrepancy shown = verdict.worst(1).front();
  EXPECT_EQ(shown.what, "nearer to another corner");
  EXPECT_TRUE(std::isfinite(shown.error));
  EXPECT_GT(shown.error, 0x1p50);
}

}  // namespace
}  // namespace raycheck::properties
