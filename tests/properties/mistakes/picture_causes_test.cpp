#include "properties/mistakes/picture_causes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/candidates/fast_candidate.h"
#include "properties/case.h"
#include "tests/properties/mistakes/shown_scenes.h"

namespace raycheck::properties {
namespace {

using scene::Scene;
using Sentences = std::vector<std::string>;

Sentences sentences_for(const std::vector<ShownPicture>& pictures) {
  Sentences sentences;
  for (const Explanation& one : explanations(picture_causes(pictures))) {
    EXPECT_GT(one.errors, 0u);
    EXPECT_LE(one.explained, one.errors);
    sentences.push_back(one.sentence);
  }
  return sentences;
}

bool is_named(const Causes& causes, const Fault& fault) {
  return std::find(causes.alternatives.begin(), causes.alternatives.end(), fault) !=
         causes.alternatives.end();
}

const Mistake* mistake(std::string_view sentence) {
  const Mistake* const found = find_mistake(sentence);
  if (found == nullptr) throw std::invalid_argument(std::string(sentence));
  return found;
}

std::uint64_t differences(const Fault& a, const Fault& b, const std::vector<Scene>& scenes) {
  std::uint64_t count = 0;
  for (const Scene& scene : scenes) {
    const ImageAnswer one = predicted(a, scene);
    const ImageAnswer other = predicted(b, scene);
    for (std::size_t k = 0; k < one.size(); ++k) count += one[k] == other[k] ? 0 : 1;
  }
  return count;
}

/// Other mistakes that make the same pictures.
std::size_t count_alike(const Mistake& its, const std::vector<Scene>& scenes) {
  return static_cast<std::size_t>(std::count_if(
      mistakes().begin(), mistakes().end(),
      [&](const Mistake& other) { return differences({&its}, {&other}, scenes) == 0; }));
}

TEST(PictureCausesOfEveryMistake, AreItsOwn) {
  const std::vector<Scene> scenes = rubric_scenes();
  int named = 0, alone = 0;
  for (const Mistake& its : mistakes()) {
    if (!its.is_told_by_pictures) continue;
    const Causes causes = picture_causes(shown_with({&its}, scenes));
    if (causes.kind == CauseKind::kExplained) {
      EXPECT_TRUE(is_named(causes, {&its}))
          << its.sentence << ": " << sentence_of(causes.alternatives.front());
      EXPECT_LE(causes.alternatives.size(), kMostAlternatives) << its.sentence;
      EXPECT_EQ(causes.explained, causes.errors) << its.sentence;
      for (const Fault& other : causes.alternatives) {
        EXPECT_LE(differences({&its}, other, scenes), 1u) << its.sentence;
      }
      ++named;
      alone += causes.alternatives.size() == 1 ? 1 : 0;
      continue;
    }
    const bool shows_little = causes.errors < kFewestWrongPixels;
    const bool is_one_of_many = count_alike(its, scenes) > kMostAlternatives;
    const bool is_plain = causes.kind == CauseKind::kBlack || causes.kind == CauseKind::kUniform;
    EXPECT_TRUE(shows_little || is_one_of_many || is_plain) << its.sentence;
  }
  EXPECT_GE(named, 125);
  EXPECT_GE(alone, 85);
}

TEST(PictureCauses, UnderOtherConventionsAreTheirMistakes) {
  std::vector<Scene> scenes = rubric_scenes();
  for (Scene& scene : scenes) {
    scene.conventions = {scene::Rows::kTopFirst, scene::Samples::kCentres, scene::Origin::kFocal,
                         scene::Root::kSmaller, scene::Tangent::kHit};
  }
  for (const char* sentence :
       {"pixels are sampled from edge to edge",
        "rays start on the image plane, so that spheres before it are not seen",
        "the far root counts too, so that spheres around the origin are seen",
        "rows are divided by the width", "beta = bottom + j/h (top - bottom)",
        "directions are not normalised: D = P - E", "rows and columns are exchanged",
        "the loops over rows and columns are exchanged: the pixels are written column by column, "
        "each from its top"}) {
    EXPECT_EQ(sentences_for(shown_with({mistake(sentence)}, scenes)), Sentences{sentence});
  }
}

TEST(PictureCauses, OfTangentsAreTheirConvention) {
  Scene scene = rubric_scenes().front();
  scene.camera->width = scene.camera->height = 5;
  // The ray of the middle pixel is tangent to the first.
  scene.spheres = {{{1, 0, -5}, 1}, {{-2.5, 0, -5}, 1}};
  Scene other = scene;
  other.conventions.tangent = scene::Tangent::kMiss;
  const std::vector<ShownPicture> pictures = {{scene, exact_image(other, other.conventions)}};
  const Causes causes = picture_causes(pictures);
  EXPECT_GT(causes.errors, 0u);
  EXPECT_EQ(sentences_for(pictures), Sentences{"a tangent counts as a miss"});
}

TEST(PictureCauses, OfALargePictureAreThoseOfASmallOne) {
  Scene scene = probe();
  scene.camera->width = 360;
  scene.camera->height = 234;
  for (const char* sentence :
       {"V is up itself, not made perpendicular to W", "the last sphere in the file wins",
        "E is not added: P = nW + alpha U + beta V"}) {
    EXPECT_EQ(sentences_for(shown_with({mistake(sentence)}, {scene})), Sentences{sentence});
  }
}

TEST(PictureCausesOfTwoMistakes, AreBoth) {
  constexpr std::array kCommon = {
      "rows are upside down",
      "rows and columns are exchanged",
      "up is taken for (0, 1, 0)",
      "rays start at the eye, so that spheres before the image plane are seen",
      "s >= 0 is not tested: spheres behind the origin are hit",
      "the last sphere in the file wins",
      "directions are not normalised: D = P - E",
      "E is not subtracted: D = P/|P|"};
  const std::vector<Scene> scenes = rubric_scenes();
  int pairs = 0, found = 0;
  for (std::size_t a = 0; a < kCommon.size(); ++a) {
    // Each with every second one of the others.
    for (std::size_t b = a + 1; b < kCommon.size(); b += 2) {
      const Fault fault = {mistake(kCommon[a]), mistake(kCommon[b])};
      if (!can_be_together(*fault[0], *fault[1])) continue;
      ++pairs;
      const Causes causes = picture_causes(shown_with(fault, scenes));
      if (causes.kind == CauseKind::kUnknown) continue;
      ASSERT_EQ(causes.kind, CauseKind::kExplained);
      ++found;
      // Two mistakes may make what one makes.
      for (const Fault& other : causes.alternatives) {
        EXPECT_LE(differences(fault, other, scenes), causes.errors / 50 + scenes.size())
            << sentence_of(fault) << ": " << sentence_of(other);
      }
    }
  }
  EXPECT_GE(pairs, 10);
  EXPECT_GE(found, pairs - 1);
}

/// What either may be is named, too.
TEST(PictureCausesOfTwoMistakes, AreTheTiesOfBoth) {
  const std::vector<ShownPicture> pictures =
      shown_with({mistake("left and right are both negated"),
                  mistake("s >= 0 is not tested: spheres behind the origin are hit")},
                 rubric_scenes());
  const Causes causes = picture_causes(pictures);
  EXPECT_EQ(causes.alternatives.size(), 4u);
  EXPECT_EQ(
      sentences_for(pictures),
      Sentences{"left and right are both negated, or: U has the wrong sign; and s >= 0 is not "
                "tested: spheres behind the origin are hit, or: the smallest s wins, though "
                "it is negative"});
}

TEST(PictureCauses, ContradictNoRightPicture) {
  const std::vector<Scene> scenes = rubric_scenes();
  const Fault mirrored = {mistake("columns are mirrored")};
  std::vector<ShownPicture> pictures = shown_with(mirrored, scenes);
  EXPECT_EQ(picture_causes(pictures).kind, CauseKind::kExplained);
  pictures[1].image = predicted({}, scenes[1]);
  EXPECT_EQ(picture_causes(pictures).kind, CauseKind::kUnknown);
}

constexpr const char* kBlack = "the picture is black: it shows no sphere";

TEST(PictureCauses, OfBlackPicturesIsBlackness) {
  std::vector<ShownPicture> pictures = shown_with({}, rubric_scenes());
  for (std::size_t k : {1u, 3u}) {
    std::fill(pictures[k].image.begin(), pictures[k].image.end(), std::nullopt);
  }
  EXPECT_EQ(sentences_for(pictures), Sentences{kBlack});
  for (ShownPicture& one : pictures) {
    std::fill(one.image.begin(), one.image.end(), std::nullopt);
  }
  EXPECT_EQ(sentences_for(pictures), Sentences{kBlack});
}

/// What shows nothing of one scene only may be a mistake that shows there alone.
TEST(PictureCauses, OfABlackPictureAmongRightOnesMayBeAMistake) {
  Scene tiny = rubric_scenes().front();
  tiny.camera->near *= 1e-6;
  for (double* bound :
       {&tiny.camera->left, &tiny.camera->right, &tiny.camera->bottom, &tiny.camera->top}) {
    *bound *= 1e-6;
  }
  for (scene::Sphere& sphere : tiny.spheres) {
    sphere = {{sphere.centre.x * 1e-6, sphere.centre.y * 1e-6, sphere.centre.z * 1e-6},
              sphere.radius * 1e-6};
  }
  std::vector<Scene> scenes = rubric_scenes();
  std::erase_if(scenes, [](const Scene& scene) { return scene.camera->near > -1e-5; });
  scenes.push_back(tiny);
  const Fault fault = {mistake(
      "hits with an s below about 1e-4 (perhaps more) are dropped: the epsilon is too large")};
  const std::vector<ShownPicture> pictures = shown_with(fault, scenes);
  EXPECT_EQ(std::count(pictures.back().image.begin(), pictures.back().image.end(), std::nullopt),
            static_cast<std::ptrdiff_t>(pictures.back().image.size()));
  const Causes causes = picture_causes(pictures);
  ASSERT_EQ(causes.kind, CauseKind::kExplained);
  EXPECT_TRUE(
      std::any_of(causes.alternatives.begin(), causes.alternatives.end(),
                  [&](const Fault& one) { return one.front()->family == fault.front()->family; }));
}

TEST(PictureCauses, OfExchangedSidesAreNamedUnlessARightPictureContradicts) {
  const auto is_oblong = [](const ShownPicture& one) {
    return one.scene.camera->width != one.scene.camera->height;
  };
  // What is wrong with the others is named too.
  for (const Fault& fault : {Fault{}, Fault{mistake("rows are upside down")}}) {
    std::vector<ShownPicture> pictures = shown_with(fault, rubric_scenes());
    std::uint64_t pixels = 0;
    for (ShownPicture& one : pictures) {
      if (!is_oblong(one)) continue;
      pixels += std::exchange(one.image, {}).size();
      one.sides_exchanged = true;
    }
    Sentences sentences = {kSidesExchanged};
    if (!fault.empty()) sentences.push_back("rows are upside down");
    EXPECT_EQ(sentences_for(pictures), sentences);
    EXPECT_EQ(picture_causes(pictures).exchanged, pixels);
    auto& oblong = *std::find_if(pictures.begin(), pictures.end(), is_oblong);
    oblong = shown_with({}, {oblong.scene}).front();
    EXPECT_EQ(sentences_for(pictures), Sentences());
  }
}

/// Spheres that are seen from so many radii away.
Scene far_scene(double radii) {
  Scene scene = rubric_scenes().front();
  scene::Camera& camera = *scene.camera;
  camera.left = camera.bottom = -3 / radii;
  camera.right = camera.top = 3 / radii;
  scene.spheres = {{{0, 0, -radii}, 1}, {{1.5, 1.5, -1.2 * radii}, 1.5}};
  return scene;
}

/// What methods of fast/ show.
std::vector<ShownPicture> shown_by(const fast::PixelRayMethod& rays,
                                   const fast::IntersectMethod& intersect,
                                   const std::vector<Scene>& scenes) {
  const Candidate candidate = fast_candidate(rays, intersect);
  std::vector<ShownPicture> pictures;
  for (const Scene& scene : scenes) {
    const auto its =
        candidate.pixel_rays(*scene.camera, scene.conventions, all_pixels(*scene.camera));
    pictures.push_back({scene, candidate.nearest(its, scene.spheres, scene.conventions)});
  }
  return pictures;
}

constexpr const char* kDifference =
    "the difference r^2 - (|T|^2 - v^2), or b^2 - 4ac, loses its digits from 10^";

TEST(PictureCauses, OfRoundingsAreThoseOfTheLeastFormula) {
  std::vector<Scene> scenes = rubric_scenes();
  for (const double radii : {2e5, 2e8}) scenes.push_back(far_scene(radii));
  for (const auto* intersect : {&fast::kLecture, &fast::kQuadratic}) {
    EXPECT_EQ(sentences_for(shown_by(fast::kDirectRays, *intersect, scenes)),
              Sentences{kDifference + std::string("8 radii away")})
        << intersect->name;
  }
  for (const auto* intersect : {&fast::kSingleLecture, &fast::kSingleQuadratic}) {
    const Sentences said = sentences_for(shown_by(fast::kSingleRays, *intersect, scenes));
    ASSERT_EQ(said.size(), 1u) << intersect->name;
    EXPECT_TRUE(
        said.front().starts_with(std::string("computed in single precision: ") + kDifference))
        << said.front();
  }
  EXPECT_EQ(sentences_for(shown_by(fast::kDirectRays, fast::kCross, scenes)), Sentences());
}

/// Far spheres that are not seen at all are no roundings: some number is too small.
TEST(PictureCauses, OfFarSpheresThatAreDroppedAreNoRoundings) {
  std::vector<Scene> scenes = rubric_scenes();
  for (const double radii : {2e5, 2e8}) scenes.push_back(far_scene(radii));
  const char* const sentence =
      "hits with an s above about 1e5 (perhaps less) are dropped: the largest s that counts is too "
      "small";
  EXPECT_EQ(sentences_for(shown_with({mistake(sentence)}, scenes)), Sentences{sentence});
  // Of one of two far spheres nothing is seen, whatever the cause.
  std::vector<ShownPicture> pictures = shown_with({}, scenes);
  for (auto& sphere : pictures.back().image) {
    if (sphere == 0u) sphere.reset();
  }
  EXPECT_EQ(picture_causes(pictures).kind, CauseKind::kUnknown);
}

TEST(PictureCauses, OfRoundingsBesideAMistakeAreBoth) {
  const Fault fault = {mistake("top is -bottom")};
  std::vector<ShownPicture> pictures = shown_with(fault, rubric_scenes());
  pictures.push_back(shown_by(fast::kDirectRays, fast::kLecture, {far_scene(2e8)}).front());
  EXPECT_EQ(sentences_for(pictures),
            Sentences{std::string("top is -bottom; and ") + kDifference + "8 radii away"});
}

/// Where nothing is certain, nothing is known.
TEST(PictureCauses, OfRoundingsAreNotNamedByOnePictureInDoubt) {
  const auto pictures = shown_by(fast::kSingleRays, fast::kSingleLecture, {far_scene(2e6)});
  EXPECT_EQ(picture_causes(pictures).kind, CauseKind::kUnknown);
}

TEST(PictureCauses, OfWhatIsNoPictureOfSpheresAreSaid) {
  std::vector<ShownPicture> pictures = shown_with({}, rubric_scenes());
  for (ShownPicture& one : pictures) std::fill(one.image.begin(), one.image.end(), 0);
  EXPECT_EQ(picture_causes(pictures).kind, CauseKind::kUniform);
  EXPECT_EQ(sentences_for(pictures), Sentences{"the picture is of one colour, whatever the scene"});
  std::vector<ShownPicture> some = shown_with({}, rubric_scenes());
  some.front() = pictures.front();
  EXPECT_EQ(picture_causes(some).kind, CauseKind::kUnknown);
  pictures = shown_with({}, rubric_scenes());
  for (ShownPicture& one : pictures) {
    for (auto& sphere : one.image) sphere = sphere.value_or(kSomeSphere);
  }
  EXPECT_EQ(picture_causes(pictures).kind, CauseKind::kBackground);
  some.front() = pictures.front();
  EXPECT_EQ(picture_causes(some).kind, CauseKind::kUnknown);
}

}  // namespace
}  // namespace raycheck::properties
