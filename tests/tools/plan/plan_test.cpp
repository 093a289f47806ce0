#include "scene/plan/plan.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "scene/files/scene_file.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;
using scene::Wanted;

const std::vector<std::string> kItems = {"view",      "behind",   "hidden",      "rectangles",
                                         "constants", "far-root", "behind-test", "scaling",
                                         "filter",    "basis",    "quantities"};

/// Spheres of every kind: in view, outside it, behind, hidden, around an origin.
constexpr const char* kEveryKind = R"(
[camera]
eye = [0, 0, 0]
look_at = [0, 0, -1]
up = [0, 1, 0]
near = -1
left = -1
right = 1
bottom = -1
top = 1
width = 41
height = 31
[[sphere]]
centre = [0, 0, -10]
radius = 3
[[sphere]]
centre = [100, 0, -10]
radius = 3
[[sphere]]
centre = [0, 0, 10]
radius = 3
[[sphere]]
centre = [0.1, 0, -30]
radius = 1
[[sphere]]
centre = [0.5, 0.5, -1]
radius = 0.25
)";

json planned(const std::string& path, const std::string& options = "") {
  const Outcome result = run("plan " + path + " --format json " + options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return json::parse(result.out);
}

const json& item(const json& report, const std::string& name) {
  for (const json& one : report["items"]) {
    if (one["name"] == name) return one;
  }
  throw std::runtime_error("no item " + name);
}

TEST(Plan, reports_the_plan_of_every_sphere) {
  const std::string every_kind = temporary_file("every_kind.toml", kEveryKind);
  std::size_t left_out = 0, spheres = 0;
  for (const std::string& path :
       {RAYCHECK_SOURCE_DIR "/scene/examples/ten-spheres.toml" + std::string(), every_kind}) {
    const scene::Scene scene = scene::load_scene(path).scene;
    for (const Wanted wanted :
         {Wanted::kClass, Wanted::kParameter, Wanted::kPoint, Wanted::kNearest}) {
      const std::string name(scene::kWantedNames[static_cast<std::size_t>(wanted)]);
      const json report = planned(path, "--wanted " + name);
      EXPECT_EQ(report["wanted"], name);
      const scene::ScenePlan plan = scene::plan_scene(scene, scene.conventions, wanted);
      ASSERT_EQ(report["spheres"].size(), plan.spheres.size());
      for (std::size_t k = 0; k < plan.spheres.size(); ++k) {
        const json& said = report["spheres"][k];
        const scene::SpherePlan& sphere = plan.spheres[k];
        EXPECT_EQ(said["left_out"],
                  sphere.left_out
                      ? json(scene::kLeftOutNames[static_cast<std::size_t>(*sphere.left_out)])
                      : json(nullptr));
        EXPECT_EQ(said["hidden_by"], sphere.hidden_by ? json(*sphere.hidden_by) : json(nullptr));
        EXPECT_EQ(said["columns"], (json{sphere.pixels.i_begin, sphere.pixels.i_end}));
        EXPECT_EQ(said["rows"], (json{sphere.pixels.j_begin, sphere.pixels.j_end}));
        EXPECT_EQ(said["pixels"], sphere.pixels.count());
        EXPECT_EQ(said["far_root"], sphere.origin_inside);
        EXPECT_EQ(said["behind_test"], sphere.reaches_behind);
        left_out += sphere.left_out ? 1 : 0;
        ++spheres;
      }
    }
  }
  EXPECT_GT(left_out, 8u);
  EXPECT_EQ(spheres, 60u);
  std::filesystem::remove(every_kind);
}

TEST(Plan, counts_what_each_item_leaves_out) {
  const std::string path = temporary_file("kinds.toml", kEveryKind);
  const json report = planned(path);
  ASSERT_EQ(report["items"].size(), kItems.size());
  for (std::size_t k = 0; k < kItems.size(); ++k) {
    const json& one = report["items"][k];
    EXPECT_EQ(one["name"], kItems[k]);
    EXPECT_LE(one["left_out"], one["of"]);
    EXPECT_NE(one["why"], "") << kItems[k];
    if (one["left_out"] == 0) {
      EXPECT_TRUE(one["without_ms"].is_null()) << kItems[k];
      continue;
    }
    EXPECT_GT(one["without_ms"], 0) << kItems[k];
    EXPECT_GT(one["with_plan_ms"], 0) << kItems[k];
  }
  // Sphere 1 is outside the view, 2 behind, 3 behind sphere 0; 0 and 4 remain, and rays may start
  // inside 4.
  EXPECT_EQ(item(report, "view")["left_out"], 1);
  EXPECT_EQ(item(report, "behind")["left_out"], 1);
  EXPECT_EQ(item(report, "hidden")["left_out"], 1);
  EXPECT_EQ(item(report, "hidden")["why"], "sphere 3: a ray that meets it meets another no later");
  EXPECT_EQ(item(report, "far-root")["left_out"], 1);
  EXPECT_EQ(item(report, "far-root")["of"], 2);
  EXPECT_EQ(item(report, "far-root")["why"], "rays may start inside sphere 4");
  EXPECT_EQ(item(report, "behind-test")["left_out"], 1);
  EXPECT_EQ(item(report, "rectangles")["of"], 2 * 41 * 31);
  std::int64_t pairs = 0;
  for (const json& sphere : report["spheres"]) pairs += sphere["pixels"].get<std::int64_t>();
  EXPECT_EQ(item(report, "rectangles")["left_out"], 2 * 41 * 31 - pairs);
  EXPECT_EQ(item(report, "scaling")["left_out"], 1);
  EXPECT_EQ(item(report, "basis")["left_out"], 1);
  EXPECT_EQ(report["pixels_timed"], 41 * 31);
  EXPECT_EQ(item(report, "filter")["of"], 41 * 31);
  const json classes = planned(path, "--wanted class");
  EXPECT_EQ(item(classes, "hidden")["left_out"], 0);
  EXPECT_EQ(item(classes, "filter")["of"], 3 * 41 * 31);
  std::filesystem::remove(path);
}

TEST(Plan, says_what_a_scene_needs_that_others_do_not) {
  std::string scene = kEveryKind;
  scene.replace(scene.find("look_at = [0, 0, -1]"), 20, "look_at = [1, 2, -9]");
  scene.replace(scene.find("centre = [100, 0, -10]"), 22, "centre = [0, 0, -1e90]");
  const std::string path = temporary_file("general.toml", scene);
  const json report = planned(path);
  EXPECT_EQ(item(report, "scaling")["left_out"], 0);
  EXPECT_NE(item(report, "scaling")["why"].get<std::string>().find("lengths are divided by 2^29"),
            std::string::npos);
  EXPECT_EQ(item(report, "basis")["left_out"], 0);
  std::filesystem::remove(path);
}

TEST(Plan, prints_items_and_spheres) {
  const Outcome result = run("plan scene/examples/ten-spheres.toml --top 3");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const std::string& name : kItems) {
    EXPECT_NE(result.out.find("  " + name + " "), std::string::npos) << name;
  }
  EXPECT_NE(result.out.find("wanted: nearest"), std::string::npos);
  EXPECT_NE(result.out.find("and 7 spheres more; --top N shows more"), std::string::npos)
      << result.out;
  const Outcome behind = run("plan scene/examples/sphere-behind-eye.toml");
  EXPECT_NE(behind.out.find("behind the rays"), std::string::npos) << behind.out;
}

TEST(Plan, has_nothing_to_say_of_given_rays) {
  const Outcome result = run("plan scene/examples/lecture-examples.toml");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("rays that are given one by one share nothing"), std::string::npos);
  const json report = planned("scene/examples/lecture-examples.toml");
  EXPECT_TRUE(report["no_plan"].is_string());
  EXPECT_TRUE(report["items"].empty());
}

TEST(Plan, fails_with_2_and_says_why) {
  const auto fails = [](const std::string& arguments, const std::string& why) {
    const Outcome result = run("plan " + arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_NE(result.err.find(why), std::string::npos) << arguments << "\n" << result.err;
    EXPECT_EQ(result.out, "") << arguments;
  };
  fails("", "SCENE");
  fails("nowhere.toml", "nowhere.toml");
  fails("scene/examples/ten-spheres.toml --wanted all", "--wanted");
  fails("scene/examples/ten-spheres.toml --top -1", "--top");
  fails("scene/examples/ten-spheres.toml --format csv", "--format");
  fails("scene/examples/ten-spheres.toml --dialect D", "--dialect D");
}

}  // namespace
}  // namespace raycheck::tests
