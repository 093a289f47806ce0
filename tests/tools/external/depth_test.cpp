// Renderers that write depth pictures: tests/candidates/rt.py depth:KIND:MISS writes them.

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

std::string depth_of(const std::string& kind) {
  return "renderer:python3 tests/candidates/rt.py depth:" + kind + " {scene} out.pfm";
}

json depths(const std::string& kind, const std::string& declared, const std::string& more = "",
            const std::string& scene = kProbeScene) {
  return judged(scene, depth_of(kind), "--depth \"" + declared + "\" " + more);
}

std::uint64_t defects(const json& report) {
  return report["discrepancies_by_standing"]["defect"].get<std::uint64_t>();
}

TEST(Depth, is_judged_as_it_is_declared) {
  const std::vector<std::string> kinds = {"s", "distance", "z", "image-plane"};
  for (const std::string& kind : kinds) {
    const json right = depths(kind, kind, "--image-change 0");
    EXPECT_EQ(right["discrepancies"], 0) << kind << right["worst"].dump(2);
    const json depth = quantity_of(right["quantities"], "depth");
    EXPECT_EQ(depth["cases"], 142) << kind;
    EXPECT_LE(depth["max"], 0.5001) << kind;
    EXPECT_GT(depth["max"], 0.4) << kind;
    for (const std::string& other : kinds) {
      if (other != kind) {
        const json wrong = depths(kind, other);
        EXPECT_GT(defects(wrong), 100u) << kind << " as " << other;
        expect_parts(wrong["explanations"].dump(), {"the numbers of the picture are " + kind +
                                                    ", and are declared to be " + other});
      }
    }
  }
}

TEST(Depth, is_right_on_every_scene_that_driver_files_can_express) {
  for (const char* scene : {"probe", "ten-spheres", "example-4", "sphere-around-eye",
                            "sphere-between-eye-and-plane", "far-sphere"}) {
    const json report =
        depths("distance", "distance", "", "scene/examples/" + std::string(scene) + ".toml");
    EXPECT_EQ(defects(report), 0u) << scene;
    EXPECT_EQ(report["discrepancies_by_standing"]["undecided"], 0) << scene;
  }
}

TEST(Depth, mistakes_are_defects) {
  for (const char* mistake : {"far-root", "half-pixel", "constant", "off"}) {
    const json report = depths(mistake, "distance");
    EXPECT_GE(defects(report), 50u) << mistake;
    EXPECT_FALSE(has(report["explanations"].dump(), "declared to be")) << mistake;
    expect_parts(report["worst"].dump(), {"depth"});
  }
}

TEST(Depth, of_a_miss_is_declared) {
  EXPECT_EQ(depths("z:0", "z miss 0")["discrepancies"], 0);
  EXPECT_EQ(depths("z:-1", "z miss -1")["discrepancies"], 0);
  EXPECT_EQ(depths("z:1e30", "z miss 1e30")["discrepancies"], 0);
  const json undeclared = depths("z:0", "z"), without_miss = depths("z", "z miss 0");
  expect_parts(undeclared["worst"].dump(), {"false hit"});
  expect_parts(undeclared.dump(), {"no pixel is a miss: pixels without a sphere have another "
                                   "number than the one declared"});
  EXPECT_FALSE(has(undeclared.dump(), "colour")) << undeclared;
  EXPECT_GT(defects(without_miss), 100u);
}

TEST(Depth, is_read_only_from_floats) {
  const json report = judged(
      kProbeScene, "renderer:python3 tests/candidates/rt.py right {scene} {image}", "--depth z");
  expect_parts(report["worst"].dump(),
               {"its depth picture is not a PFM, the one format read here that keeps floats"});
  for (const char* wrong : {"y", "z 0", "z miss", "z miss near", "z miss 0 0"}) {
    const Outcome outcome =
        check(kProbeScene, depth_of("z"), "--depth \"" + std::string(wrong) + '"');
    EXPECT_EQ(outcome.exit_code, 2) << wrong << outcome.err;
    expect_parts(outcome.err, {"--depth '" + std::string(wrong) +
                               "': must be s or distance or z or image-plane, and may be followed "
                               "by 'miss VALUE', as in 'z miss 0'"});
  }
}

TEST(Depth, is_judged_on_random_cases) {
  const json campaign = printed_json(
      "properties --filter image --source course --cases 20 --depth distance --candidate '" +
      depth_of("distance") + "'")["campaigns"][1];
  EXPECT_EQ(campaign["finding"], "holds");
  EXPECT_GT(quantity_of(campaign["quantities"], "depth")["cases"], 10);
}

}  // namespace
}  // namespace raycheck::tests
