#include "scene/plan/plan.h"

#include "scene/files/scene_file.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using scene::Wanted;

const std::vector<std::string> kItems = {"view",      "behind",   "hidden",      "rectangles",
                                         "constants", "far-root", "behind-test", "scaling",
                                         "filter",    "basis",    "quantities"};

/// Spheres of every kind: in view, outside the view, behind, hidden, around an origin.
const std::string kEveryKind = camera_text(41, 31) + sphere_text("0, 0, -10", "3") +
                               sphere_text("100, 0, -10", "3") + sphere_text("0, 0, 10", "3") +
                               sphere_text("0.1, 0, -30", "1") +
                               sphere_text("0.5, 0.5, -1", "0.25");

json planned(const std::string& path, const std::string& options = "") {
  return printed_json("plan " + path + " " + options, 0);
}

json item(const json& report, const std::string& name) {
  return found(report["items"], "name", name);
}

TEST(Plan, reports_the_plan_of_every_sphere) {
  const std::string every_kind = temporary_file("every_kind.toml", kEveryKind);
  std::size_t left_out = 0, spheres = 0;
  for (const std::string& path :
       {std::string(RAYCHECK_SOURCE_DIR "/scene/examples/ten-spheres.toml"), every_kind}) {
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
  // Sphere 1 is outside the view, 2 is behind the eye, 3 is hidden by sphere 0. Spheres 0 and 4
  // remain; rays may start inside 4.
  std::int64_t pairs = 0;
  for (const json& sphere : report["spheres"]) pairs += sphere["pixels"].get<std::int64_t>();
  for (const auto& [name, left_out] :
       std::map<std::string, std::int64_t>{{"view", 1},
                                           {"behind", 1},
                                           {"hidden", 1},
                                           {"far-root", 1},
                                           {"behind-test", 1},
                                           {"scaling", 1},
                                           {"basis", 1},
                                           {"rectangles", 2 * 41 * 31 - pairs}}) {
    EXPECT_EQ(item(report, name)["left_out"], left_out) << name;
  }
  EXPECT_EQ(item(report, "hidden")["why"],
            "sphere 3: every ray that meets it meets another sphere first or at the same point");
  EXPECT_EQ(item(report, "far-root")["of"], 2);
  EXPECT_EQ(item(report, "far-root")["why"], "rays may start inside sphere 4");
  EXPECT_EQ(item(report, "rectangles")["of"], 2 * 41 * 31);
  EXPECT_EQ(report["pixels_timed"], 41 * 31);
  EXPECT_EQ(item(report, "filter")["of"], 41 * 31);
  const json classes = planned(path, "--wanted class");
  EXPECT_EQ(item(classes, "hidden")["left_out"], 0);
  EXPECT_EQ(item(classes, "filter")["of"], 3 * 41 * 31);
}

TEST(Plan, reports_items_that_only_some_scenes_need) {
  const std::string askew = replaced(kEveryKind, "look_at = [0, 0, -1]", "look_at = [1, 2, -9]");
  const json report = planned(temporary_file(
      "general.toml", replaced(askew, "centre = [100, 0, -10]", "centre = [0, 0, -1e90]")));
  EXPECT_EQ(item(report, "scaling")["left_out"], 0);
  EXPECT_TRUE(
      has(item(report, "scaling")["why"].get<std::string>(), "lengths are divided by 2^29"));
  EXPECT_EQ(item(report, "basis")["left_out"], 0);
}

TEST(Plan, prints_items_and_spheres) {
  const Outcome result = run("plan scene/examples/ten-spheres.toml --top 3", 0);
  for (const std::string& name : kItems) EXPECT_TRUE(has(result.out, "  " + name + " "));
  expect_parts(result.out, {"wanted: nearest", "and 7 spheres more; --top N shows more"});
  EXPECT_TRUE(has(run("plan scene/examples/sphere-behind-eye.toml").out, "behind the rays"));
}

TEST(Plan, is_empty_for_given_rays) {
  const Outcome result = run("plan scene/examples/lecture-examples.toml", 0);
  EXPECT_TRUE(has(result.out, "no plan: a plan needs a camera"));
  const json report = planned("scene/examples/lecture-examples.toml");
  EXPECT_TRUE(report["no_plan"].is_string());
  EXPECT_TRUE(report["items"].empty());
}

}  // namespace
}  // namespace raycheck::tests
