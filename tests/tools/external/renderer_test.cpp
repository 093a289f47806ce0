// Renderers, right and wrong, through `check --candidate`.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

const std::string kProbeScene = "scene/examples/probe.toml";

std::string renderer(const std::string& mistake) {
  return "renderer:python3 tests/candidates/rt.py " + mistake + " {scene} {image}";
}

TEST(Renderer, of_one_colour_is_said_not_to_be_judged_by_sphere) {
  const json report = judged(kProbeScene, renderer("grey"));
  EXPECT_EQ(report["discrepancies"], 0);
  EXPECT_NE(report["left_out"].dump().find("a colour is none of the spheres'"), std::string::npos);
}

TEST(Renderer, is_right_on_every_scene_that_its_driver_can_hold) {
  for (const char* scene : {"probe", "ten-spheres", "example-4", "sphere-around-eye",
                            "sphere-between-eye-and-plane", "far-sphere"}) {
    const json report = judged("scene/examples/" + std::string(scene) + ".toml", renderer("right"));
    EXPECT_EQ(report["discrepancies_by_standing"]["defect"], 0) << scene;
    EXPECT_EQ(report["discrepancies_by_standing"]["undecided"], 0) << scene;
    EXPECT_GT(report["quantities"][0]["cases"], 60) << scene;
    EXPECT_TRUE(report["explanations"].empty()) << scene;
  }
}

TEST(Renderer, whose_colours_are_dimmed_still_has_its_mask_judged) {
  EXPECT_EQ(judged(kProbeScene, renderer("dim"))["discrepancies"], 0);
  EXPECT_GT(judged(kProbeScene, renderer("dim-upside-down"))["discrepancies"], 0);
}

struct PictureMistake {
  const char* name;
  const char* sentence;
};
void PrintTo(const PictureMistake& mistake, std::ostream* out) { *out << mistake.name; }

class EachPictureMistake : public testing::TestWithParam<PictureMistake> {};

TEST_P(EachPictureMistake, IsNamed) {
  const json report = judged(kProbeScene, renderer(GetParam().name));
  EXPECT_GT(report["discrepancies_by_standing"]["defect"], 0);
  ASSERT_EQ(report["explanations"].size(), 1u) << report["explanations"].dump(2);
  const json& one = report["explanations"][0];
  EXPECT_NE(one["sentence"].get<std::string>().find(GetParam().sentence), std::string::npos)
      << one.dump(2);
  EXPECT_EQ(one["wrong"], one["explained"]);
}

INSTANTIATE_TEST_SUITE_P(
    Classic, EachPictureMistake,
    testing::Values(PictureMistake{"upside-down", "rows are upside down"},
                    PictureMistake{"mirrored", "columns are mirrored"},
                    PictureMistake{"turned", "turned by half a turn"},
                    PictureMistake{"centres", "sampled at their centres"},
                    PictureMistake{"focal", "start at the eye"},
                    PictureMistake{"near-root-only", "only the near root"},
                    PictureMistake{"first-wins", "the first sphere in the file"},
                    PictureMistake{"last-wins", "the last sphere in the file"},
                    PictureMistake{"top-from-right", "top is taken from right"},
                    PictureMistake{"width-height", "width and height are exchanged"},
                    PictureMistake{"w-flipped", "W has the wrong sign"},
                    PictureMistake{"no-up", "up is taken for (0, 1, 0)"}),
    [](const auto& the_test) {
      std::string name(the_test.param.name);
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

TEST(Renderer, that_makes_no_picture_fails_with_the_reason) {
  const auto expect_said = [](const std::string& mistake, const std::string& what) {
    const json report = judged(kProbeScene, renderer(mistake), "--timeout 5");
    EXPECT_GT(report["discrepancies"], 0);
    EXPECT_NE(report["worst"].dump().find(what), std::string::npos) << report["worst"].dump(2);
  };
  expect_said("transposed", "26 x 40 pixels, the scene 40 x 26: width and height are exchanged");
  expect_said("no-picture", "it made no picture");
  expect_said("half", "its PPM has a word that is no number, or ends");
  expect_said("crash", "exited with 1");
  expect_said("hang", "did not end within 5 s");
  expect_said("link", "its picture {image} is no file");
}

TEST(Renderer, keeps_the_law_of_images_on_random_scenes) {
  const std::string folder = temporary_file("renderers", "") + ".d";
  const auto judged_as = [&](const std::string& mistake) {
    return run("properties --filter image --source crowds --cases 40 --candidate 'renderer:" +
               built_submission("rt.cpp", mistake, folder) + " {scene} {image}'");
  };
  const Outcome right = judged_as("none");
  EXPECT_EQ(right.exit_code, 0) << right.out << right.err;
  const Outcome wrong = judged_as("mirrored");
  EXPECT_EQ(wrong.exit_code, 1) << wrong.out << wrong.err;
  std::filesystem::remove_all(folder);
}

TEST(Renderer, reads_the_dialect_that_it_is_written_in) {
  const json report = judged(kProbeScene, renderer("dialect-c"), "--dialect C");
  EXPECT_EQ(report["discrepancies"], 0);
}

TEST(Renderer, is_excused_for_hits_within_its_threshold) {
  // It takes no hit below 0.5: the sphere that the image plane cuts.
  EXPECT_FALSE(judged(kProbeScene, renderer("threshold"))["discrepancies"] == 0);
  const json report = judged(kProbeScene, renderer("threshold"), "--t-threshold 0.5");
  EXPECT_EQ(report["discrepancies"], report["discrepancies_by_standing"]["excused"]);
  EXPECT_GT(report["discrepancies"], 0);
}

}  // namespace
}  // namespace raycheck::tests
