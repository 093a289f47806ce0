#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

constexpr const char* kFarSphereScene = R"(
[camera]
eye = [0, 0, 0]
look_at = [0, 0, -1]
up = [0, 1, 0]
near = -1
left = -0.001
right = 0.001
bottom = -0.001
top = 0.001
width = 16
height = 16
[[sphere]]
centre = [0.3, 0.2, -1e8]
radius = 60000
)";

const json* find_named(const json& list, const std::string& name) {
  for (const json& entry : list) {
    if (entry.at("name") == name) return &entry;
  }
  return nullptr;
}

TEST(Check, runs_on_every_example_scene) {
  int scenes = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(RAYCHECK_SOURCE_DIR) + "/scene/examples")) {
    const Outcome result = run("check " + entry.path().string() + " --format json");
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 1)
        << entry.path() << " " << result.exit_code << result.err;
    const json report = json::parse(result.out);
    EXPECT_EQ(result.exit_code == 1, report.at("discrepancies") > 0) << entry.path();
    EXPECT_GT(report.at("rays_judged"), 0) << entry.path();
    ++scenes;
  }
  EXPECT_GE(scenes, 18);
}

TEST(Check, finds_nothing_on_the_optical_axis) {
  const Outcome result = run("check scene/examples/optical-axis.toml");
  EXPECT_EQ(result.exit_code, 0) << result.out;
  EXPECT_NE(result.out.find("no discrepancy"), std::string::npos);
  EXPECT_NE(result.out.find("9 of 9 rays judged"), std::string::npos);
  EXPECT_EQ(result.out.find('\033'), std::string::npos) << "colours without a terminal";
  EXPECT_EQ(result.err, "");
}

TEST(Check, judges_every_pair_with_all) {
  const json report =
      json::parse(run("check scene/examples/first-camera.toml --all --format json").out);
  EXPECT_EQ(report.at("candidates").size(),
            fast::pixel_ray_methods().size() * fast::intersect_methods().size());
}

TEST(Check, judges_as_many_pixels_as_asked_and_says_what_it_left_out) {
  const json report =
      json::parse(run("check scene/examples/ten-spheres.toml --pixels 10 --format json").out);
  EXPECT_EQ(report.at("rays_judged"), 10);
  EXPECT_NE(report.at("left_out").dump().find("246 of 256 pixels"), std::string::npos);
}

TEST(Check, reports_the_same_whatever_the_number_of_threads) {
  std::string scene = kFarSphereScene;
  scene.replace(scene.find("width = 16"), 10, "width = 90");
  scene.replace(scene.find("height = 16"), 11, "height = 70");
  scene += "[[sphere]]\ncentre = [0, 0, -2e8]\nradius = 2e5\n";
  const std::string path = temporary_file("threads.toml", scene);
  const auto report = [&](const std::string& threads) {
    const Outcome result =
        run("check " + path + " --intersect quadratic --intersect cross --top 1000 --format json" +
            threads);
    EXPECT_EQ(result.exit_code, 1) << result.err;
    json parsed = json::parse(result.out);
    for (json& candidate : parsed["candidates"]) candidate.erase("ns_per_ray");
    return parsed;
  };
  const json by_one = report(" --threads 1");
  EXPECT_EQ(by_one.at("rays_judged"), 90 * 70);
  EXPECT_EQ(by_one["candidates"][0]["worst"].size(), 1000u);
  for (const char* threads : {" --threads 2", " --threads 3", ""}) {
    EXPECT_EQ(report(threads), by_one) << threads;
  }
  std::filesystem::remove(path);
}

TEST(Check, takes_another_bound) {
  EXPECT_EQ(run("check scene/examples/ten-spheres.toml").exit_code, 0);
  EXPECT_EQ(run("check scene/examples/ten-spheres.toml --max-ulp 0.001").exit_code, 1);
}

TEST(Check, names_a_driver_files_dialect_and_what_is_not_needed_of_it) {
  const Outcome result = run("check scene/examples/driver-a.txt");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err.find("warning"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("driver-a.txt (driver file of dialect A): 16 x 16 pixels, 2 spheres\n"
                            "not needed here: ambient, numbers after a sphere's first 4\n"),
            std::string::npos)
      << result.out;
  const auto report =
      nlohmann::json::parse(run("check scene/examples/driver-c.txt --format json").out);
  EXPECT_EQ(report["dialect"], "C");
  EXPECT_EQ(report["warnings"].size(), 0u);
  const auto toml = nlohmann::json::parse(run("check scene/examples/probe.toml --format json").out);
  EXPECT_TRUE(toml["dialect"].is_null());
  EXPECT_EQ(toml["not_needed"].size(), 0u);
}

TEST(Check, fails_with_2_and_says_why_on_bad_input) {
  const auto fails = [](const std::string& arguments, const std::string& why) {
    const Outcome result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_NE(result.err.find(why), std::string::npos) << arguments << "\n" << result.err;
  };
  fails("", "subcommand");
  fails("chekc", "there is no command 'chekc'");
  fails("check", "SCENE");
  fails("check nowhere.toml", "nowhere.toml");
  fails("check scene/examples/optical-axis.toml --rays fast", "rays fast: no such method");
  fails("check scene/examples/optical-axis.toml --intersect best",
        "intersect best: no such method");
  fails("check scene/examples/optical-axis.toml --pixels 0", "--pixels 0");
  fails("check scene/examples/optical-axis.toml --pixels some", "--pixels some");
  fails("check scene/examples/optical-axis.toml --threads 0", "--threads");
  fails("check scene/examples/optical-axis.toml --max-ulp -1", "--max-ulp");
  fails("check scene/examples/optical-axis.toml --max-ulp nan", "--max-ulp");
  fails("check scene/examples/optical-axis.toml --top 5000", "--top");
  fails("check scene/examples/optical-axis.toml --dialect D", "--dialect D");
  fails("check scene/examples/optical-axis.toml --all --rays direct", "--all");
  const std::string path =
      temporary_file("flat.toml",
                     "[camera]\neye=[0,0,0]\nlook_at=[0,0,-1]\nup=[0,0,1]\nnear=-1\nleft=-1\n"
                     "right=1\nbottom=-1\ntop=1\nwidth=2\nheight=2\n");
  fails("check " + path, path + ":4: camera.up");
  std::filesystem::remove(path);
}

TEST(Check, judges_what_overflows_instead_of_refusing_it) {
  std::string scene = kFarSphereScene;
  scene.replace(scene.find("left = -0.001"), 13, "left = -1e200");
  const std::string path = temporary_file("overflow.toml", scene);
  const Outcome result = run("check " + path + " --format json");
  EXPECT_EQ(result.exit_code, 4) << result.err;  // outside the stated domain
  const json report = json::parse(result.out);
  EXPECT_FALSE(report["candidates"][0]["inside_domain"]);
  EXPECT_EQ(report["candidates"][0]["discrepancies_by_standing"]["defect"], 0);
  EXPECT_GT(report["candidates"][0]["discrepancies_by_standing"]["not judged"], 0);
  const json& quantities = report["candidates"][0]["quantities"];
  EXPECT_EQ(find_named(quantities, "direction")->at("max"), "infinity");
  EXPECT_EQ(find_named(quantities, "class")->at("cases"), 256);
  const Outcome explained = run("explain " + path + " --pixel 0,0 --format json");
  EXPECT_EQ(explained.exit_code, 0) << explained.err;
  for (const json& method : json::parse(explained.out)["methods"]) {
    EXPECT_NE(method["standing"], "defect") << method["name"];
  }
  EXPECT_TRUE(json::parse(explained.out)["exact"]["direction"][0].is_string());
  std::filesystem::remove(path);
}

TEST(Check, spreads_the_pixels_it_judges_over_the_image) {
  std::string scene = kFarSphereScene;
  scene.replace(scene.find("width = 16"), 10, "width = 2147483647");
  scene.replace(scene.find("height = 16"), 11, "height = 2147483647");
  const std::string path = temporary_file("wide.toml", scene);
  const json report = json::parse(run("check " + path +
                                      " --pixels 100 --top 100 --max-ulp 0 "
                                      "--format json")
                                      .out);
  EXPECT_EQ(report.at("rays_judged"), 100);
  std::set<std::int64_t> columns;
  std::set<std::int64_t> rows;
  for (const json& discrepancy : report["candidates"][0]["worst"]) {
    if (discrepancy["pixel"].is_null()) continue;
    columns.insert(discrepancy["pixel"][0].get<std::int64_t>());
    rows.insert(discrepancy["pixel"][1].get<std::int64_t>());
  }
  EXPECT_GE(columns.size(), 8u);
  EXPECT_GE(rows.size(), 8u);
  EXPECT_GT(*columns.rbegin(), 2000000000);
  EXPECT_GT(*rows.rbegin(), 2000000000);
  std::filesystem::remove(path);
}

TEST(Check, asks_no_ray_method_about_given_rays) {
  const json report =
      json::parse(run("check scene/examples/lecture-examples.toml --all --format json").out);
  EXPECT_EQ(report.at("candidates").size(), fast::intersect_methods().size());
}

TEST(Check, says_when_tangents_are_left_unjudged) {
  const std::string path =
      temporary_file("tangent.toml",
                     "[conventions]\ntangent = \"either\"\n[[ray]]\norigin = [-5, 1, 0]\n"
                     "direction = [1, 0, 0]\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n");
  const Outcome result = run("check " + path);
  EXPECT_EQ(result.exit_code, 4) << result.out;
  EXPECT_NE(result.out.find("tangent = either"), std::string::npos) << result.out;
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace raycheck::tests
