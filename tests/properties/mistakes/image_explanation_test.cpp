#include "properties/mistakes/image_explanation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "properties/candidates/fast_candidate.h"
#include "properties/mistakes/mistakes.h"
#include "properties/trial.h"
#include "scene/files/scene_file.h"

namespace raycheck::properties {
namespace {

/// The scene that tells classic mistakes apart.
const scene::Scene& probe() {
  static const scene::Scene kProbe =
      scene::load_scene(RAYCHECK_SOURCE_DIR "/scene/examples/probe.toml").scene;
  return kProbe;
}

ImageAnswer image_of(const Candidate& candidate, const scene::Scene& scene) {
  const Case the_case = {scene, all_pixels(*scene.camera)};
  Trial trial(the_case, candidate);
  return trial.nearest();
}

using Sentences = std::vector<std::string>;

Sentences sentences_for(const ImageAnswer& image, const scene::Scene& scene) {
  Sentences sentences;
  for (const Explanation& explanation : explanations(scene, scene.conventions, image)) {
    EXPECT_EQ(explanation.errors, explanation.explained) << explanation.sentence;
    sentences.push_back(explanation.sentence);
  }
  return sentences;
}

Candidate right() { return fast_candidate(fast::kDirectRays, fast::kCross); }

ImageAnswer mistaken_image(const std::string& sentence, const scene::Scene& scene) {
  return image_of(find_mistake(sentence)->candidate, scene);
}

TEST(ImageExplanation, NamesEveryMistakeThatShows) {
  const ImageAnswer truth = image_of(right(), probe());
  int shown = 0;
  for (const Mistake& mistake : mistakes()) {
    const ImageAnswer image = image_of(mistake.candidate, probe());
    const Sentences sentences = sentences_for(image, probe());
    const bool is_black = std::count(image.begin(), image.end(), std::nullopt) == std::ssize(image);
    if (image == truth || is_black) {
      EXPECT_EQ(sentences, Sentences()) << mistake.sentence;
      continue;
    }
    ++shown;
    // Another camera is named before a formula that makes the same image.
    const std::string expected = mistake.sentence == "W has the wrong sign"
                                     ? "W has the wrong sign, the image plane is behind the eye"
                                     : mistake.sentence;
    EXPECT_TRUE(std::count(sentences.begin(), sentences.end(), expected))
        << mistake.sentence << ": " << testing::PrintToString(sentences);
    EXPECT_LE(sentences.size(), 2u) << mistake.sentence;
  }
  EXPECT_GE(shown, 45);
}

TEST(ImageExplanation, NamesConventionsThatAreNotTheDefault) {
  scene::Scene scene = probe();
  scene.conventions = {scene::Rows::kTopFirst, scene::Samples::kCentres, scene::Origin::kFocal,
                       scene::Root::kSmaller, scene::Tangent::kHit};
  for (const char* sentence :
       {"pixels are sampled from edge to edge",
        "rays start on the image plane, so that spheres before it are not seen",
        "width and height are exchanged", "rows are divided by the width",
        "beta = bottom + j/h (top - bottom)", "U has the wrong sign",
        "directions are not normalised: D = P - E"}) {
    EXPECT_EQ(sentences_for(mistaken_image(sentence, scene), scene), Sentences{sentence});
  }
}

/// Formulas are tried on a part of the pixels first.
TEST(ImageExplanation, OfALargeImageIsThatOfASmallOne) {
  scene::Scene scene = probe();
  scene.camera->width = 360;
  scene.camera->height = 234;
  for (const char* sentence :
       {"U has the wrong sign", "the last sphere in the file wins",
        "E is not subtracted: D = P/|P|", "rows and columns are exchanged"}) {
    const Sentences sentences = sentences_for(mistaken_image(sentence, scene), scene);
    EXPECT_TRUE(std::count(sentences.begin(), sentences.end(), sentence))
        << sentence << ": " << testing::PrintToString(sentences);
  }
}

TEST(ImageExplanation, OfTwoMistakesAtOnceIsNone) {
  const Mistake& mirrored = *find_mistake("columns are mirrored");
  scene::Scene wrong = probe();
  wrong.camera->up = {0, 1, 0};
  const ImageAnswer image = image_of(mirrored.candidate, wrong);
  EXPECT_EQ(explanations(probe(), probe().conventions, image).size(), 0u);
}

TEST(ImageExplanation, OfNothingSeenIsNone) {
  const ImageAnswer nothing(all_pixels(*probe().camera).size());
  EXPECT_EQ(sentences_for(nothing, probe()), Sentences());
}

}  // namespace
}  // namespace raycheck::properties
