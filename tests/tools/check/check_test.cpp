#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

std::string far_sphere_scene(std::int64_t width, std::int64_t height) {
  return camera_text(width, height, 0.001) + sphere_text("0.3, 0.2, -1e8", "60000");
}

TEST(Check, runs_on_every_example_scene) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator(RAYCHECK_SOURCE_DIR "/scene/examples")) {
    const Outcome result = run("check " + entry.path().string() + " --format json");
    const json report = json::parse(result.out);
    const json& candidate = report.at("candidates").at(0);
    const bool is_broken = candidate.at("discrepancies_by_standing").at("defect") > 0;
    EXPECT_EQ(result.exit_code, is_broken ? 1 : 0) << entry << result.err;
    EXPECT_GT(report.at("rays_judged"), 0) << entry.path();
    ++scenes;
  }
  EXPECT_GE(scenes, 18);
}

/// A right tracer passes each scene that is about a case of other projects' tests; a slip about
/// this case shows there. A wrong hit of a point is excused, as any wrong tangent.
TEST(Check, scenes_of_the_fields_own_tests_show_slips) {
  const std::string right = "roots.t_min <= s < roots.t_max";
  const auto wrong = [](const std::string& scene, const std::string& counts) {
    const std::string candidate =
        tracer(scene + ".py", counts, "(s, point)", "roots='as-asked', tangent='hit'");
    const json report =
        json::parse(check("scene/examples/" + scene + ".toml", candidate).out)["candidates"][0];
    EXPECT_GT(quantity_of(report.at("quantities"), "class").at("cases"), 0) << scene;
    const json standing = report.at("discrepancies_by_standing");
    return standing.at(scene == "points" ? "excused" : "defect").get<int>();
  };
  const std::pair<const char*, std::string> slips[] = {
      {"eye-inside-off-centre", right + " and s == min(q / a, other)"},  // only the near root
      {"limb-across-picture", right + " and under > 1e-2"},              // an epsilon
      {"far-tiny-huge", right + " and s * math.sqrt(a) < 1e9"},          // a largest distance
      {"points", right + " and under > 0"},                              // no tangents
      {"half-open-range", "roots.t_min <= s <= roots.t_max"},            // a closed range
  };
  for (const auto& [scene, slip] : slips) {
    EXPECT_EQ(wrong(scene, right), 0) << scene;
    EXPECT_GT(wrong(scene, slip), 0) << scene;
  }
}

TEST(Check, judges_the_chosen_candidates) {
  const std::size_t methods = fast::intersect_methods().size();
  EXPECT_EQ(printed_json("check scene/examples/first-camera.toml --all").at("candidates").size(),
            fast::pixel_ray_methods().size() * methods);
  EXPECT_EQ(  // no ray method is asked about given rays
      printed_json("check scene/examples/lecture-examples.toml --all").at("candidates").size(),
      methods);
  const json few = printed_json("check scene/examples/ten-spheres.toml --pixels 10", 0);
  EXPECT_EQ(few.at("rays_judged"), 10);
  EXPECT_TRUE(has(few.at("left_out").dump(), "246 of 256 pixels"));
  printed_json("check scene/examples/ten-spheres.toml --max-ulp 0.001", 1);
}

/// Rays are judged by 512: the last ones hit nothing, which leaves out no law.
TEST(Check, leaves_out_laws_of_hits_only_if_no_ray_hits) {
  const std::string ahead = ray_text("0, 0, 0", "1, 0, 0"),
                    behind = ray_text("0, 0, 0", "-1, 0, 0");
  const auto left_out = [&](const std::string& rays) {
    const std::string path = temporary_file("hits.toml", rays + sphere_text("5, 0, 0", "1"));
    return run("check " + path + " --format json").out;
  };
  EXPECT_FALSE(has(left_out(repeated(ahead, 512) + repeated(behind, 512)), "no ray hits a sphere"));
  EXPECT_TRUE(has(left_out(behind), "no ray hits a sphere"));
}

TEST(Check, report_does_not_depend_on_the_number_of_threads) {
  const std::string path =
      temporary_file("threads.toml", far_sphere_scene(90, 70) + sphere_text("0, 0, -2e8", "2e5"));
  const auto report = [&](const std::string& threads) {
    return printed_json(
        "check " + path + " --intersect quadratic --intersect cross --top 1000" + threads, 1);
  };
  const json by_one = report(" --threads 1");
  EXPECT_EQ(by_one.at("rays_judged"), 90 * 70);
  EXPECT_EQ(by_one["candidates"][0]["worst"].size(), 1000u);
  for (const char* threads : {" --threads 2", " --threads 3", ""}) {
    EXPECT_EQ(report(threads), by_one) << threads;
  }
}

TEST(Check, names_a_driver_files_dialect_and_its_unneeded_settings) {
  const Outcome result = run("check scene/examples/driver-a.txt", 0);
  EXPECT_FALSE(has(result.err, "warning"));
  EXPECT_TRUE(has(result.out,
                  "driver-a.txt (format A): 16 x 16 pixels, 2 spheres\n"
                  "not needed here: ambient, numbers after a sphere's first 4\n"));
  const json report = printed_json("check scene/examples/driver-c.txt");
  EXPECT_EQ(report["dialect"], "C");
  EXPECT_EQ(report["warnings"].size(), 0u);
  const json toml = printed_json("check scene/examples/probe.toml");
  EXPECT_TRUE(toml["dialect"].is_null());
  EXPECT_EQ(toml["not_needed"].size(), 0u);
}

TEST(Check, judges_scenes_that_overflow_instead_of_refusing_them) {
  const std::string path = temporary_file(
      "overflow.toml", replaced(far_sphere_scene(16, 16), "left = -0.001", "left = -1e200"));
  const json candidate = printed_json("check " + path, 4)["candidates"][0];
  EXPECT_FALSE(candidate["inside_domain"]);
  EXPECT_EQ(candidate["discrepancies_by_standing"]["defect"], 0);
  EXPECT_GT(candidate["discrepancies_by_standing"]["not judged"], 0);
  EXPECT_EQ(quantity_of(candidate["quantities"], "direction")["max"], "infinity");
  EXPECT_EQ(quantity_of(candidate["quantities"], "class")["cases"], 256);
  const json explained = printed_json("explain " + path + " --pixel 0,0", 0);
  for (const json& method : explained["methods"]) {
    EXPECT_NE(method["standing"], "defect") << method["name"];
  }
  EXPECT_TRUE(explained["exact"]["direction"][0].is_string());
}

TEST(Check, spreads_the_pixels_it_judges_over_the_image) {
  constexpr std::int64_t kMost = 2147483647;
  const std::string path = temporary_file("wide.toml", far_sphere_scene(kMost, kMost));
  const json report = printed_json("check " + path + " --pixels 100 --top 100 --max-ulp 0");
  EXPECT_EQ(report.at("rays_judged"), 100);
  std::set<std::int64_t> columns, rows;
  for (const json& discrepancy : report["candidates"][0]["worst"]) {
    if (discrepancy["pixel"].is_null()) continue;
    columns.insert(discrepancy["pixel"][0].get<std::int64_t>());
    rows.insert(discrepancy["pixel"][1].get<std::int64_t>());
  }
  for (const auto& places : {columns, rows}) {
    EXPECT_GE(places.size(), 8u);
    EXPECT_GT(*places.rbegin(), 2000000000);
  }
}

TEST(Check, reports_unjudged_tangents) {
  const Outcome result =
      run("check " + temporary_file("tangent.toml", "[conventions]\ntangent = \"either\"\n" +
                                                        ray_text("-5, 1, 0", "1, 0, 0") +
                                                        sphere_text("0, 0, 0", "1")),
          4);
  EXPECT_TRUE(has(result.out, "tangent = either"));
}

}  // namespace
}  // namespace raycheck::tests
