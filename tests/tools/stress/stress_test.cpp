#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

void expect_refused(const std::string& arguments, const std::string& why) {
  const Outcome result = run(arguments);
  EXPECT_EQ(result.exit_code, 2) << arguments;
  EXPECT_NE(result.err.find(why), std::string::npos) << arguments << "\n" << result.err;
  EXPECT_EQ(result.out, "") << arguments;
}

const std::string kFew = " --cases 60 --severity 0..9 ";

TEST(StressCommand, reports_the_severity_at_which_the_textbook_first_fails) {
  const Outcome result =
      run("stress --family distance --method quadratic,cross --format json" + kFew);
  EXPECT_EQ(result.exit_code, 1);
  const json report = json::parse(result.out);
  const json& methods = report["families"][0]["methods"];
  ASSERT_EQ(methods.size(), 2u);
  EXPECT_EQ(methods[0]["name"], "quadratic");
  EXPECT_GT(methods[0]["first_failing"].get<int>(), 0);
  EXPECT_NEAR(methods[0]["slope"].get<double>(), 1, 0.2);  // as the distance over the radius
  EXPECT_EQ(methods[1]["name"], "cross");
  EXPECT_TRUE(methods[1]["first_failing"].is_null());
  EXPECT_EQ(methods[0]["severities"].size(), 10u);
}

TEST(StressCommand, is_the_same_for_the_same_seed) {
  const std::string arguments = "stress --family up,tangency --format json --seed 5" + kFew;
  EXPECT_EQ(run(arguments).out, run(arguments).out);
}

TEST(StressCommand, prints_csv_and_markdown_with_as_many_cells_in_every_line) {
  const std::string arguments = "stress --family distance --method cross" + kFew;
  std::istringstream csv(run(arguments + " --format csv").out);
  std::string line;
  std::size_t lines = 0;
  std::size_t commas = 0;
  for (; std::getline(csv, line); ++lines) {
    const auto here = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
    if (lines == 0) commas = here;
    EXPECT_EQ(here, commas) << line;
  }
  EXPECT_EQ(lines, 11u);
  EXPECT_NE(run(arguments + " --format markdown").out.find("|---|"), std::string::npos);
}

TEST(StressCommand, fails_with_2_and_says_why) {
  expect_refused("stress --family moon",
                 "family moon: no such family; the families are far-camera");
  expect_refused("stress --method magic", "method magic: no such method");
  expect_refused("stress --severity 5..2", "--severity 5..2");
  expect_refused("stress --family distance --severity 99", "the severities of distance are 0..");
  expect_refused("stress --cases 0", "--cases");
  expect_refused("stress --plot picture.bmp", "plot picture.bmp");
  expect_refused("stress --plot nowhere/picture.svg", "there is no folder nowhere");
}

TEST(StressCommand, draws_a_plot_or_says_that_there_is_no_gnuplot) {
  const std::string path = temporary_file("stress.svg", "");
  const Outcome result =
      run("stress --family distance --method quadratic,cross --plot " + path + kFew);
  EXPECT_NE(result.out.find("first failing severity"), std::string::npos);
  std::ifstream file(path);
  std::stringstream picture;
  picture << file.rdbuf();
  if (result.err.empty()) {
    EXPECT_NE(picture.str().find("</svg>"), std::string::npos);
    EXPECT_NE(picture.str().find("quadratic"), std::string::npos);
  } else {
    EXPECT_NE(result.err.find("apt-get install gnuplot-nox"), std::string::npos) << result.err;
  }
  std::filesystem::remove(path);
}

TEST(StressCommand, proves_what_it_found) {
  const std::string path = temporary_file("stress.certificates", "");
  EXPECT_EQ(run("stress --family distance,up --method quadratic,rays/lecture --certificates " +
                path + kFew)
                .exit_code,
            1);
  const std::string proofs = contents(path);
  EXPECT_GT(std::count(proofs.begin(), proofs.end(), '\n'), 20);
  const Outcome confirmed = run_python("tools/verify_certificates.py " + path);
  EXPECT_EQ(confirmed.exit_code, 0) << confirmed.out;
  std::filesystem::remove(path);
}

/// How many answers of a quantity were compared.
std::uint64_t cases_of(const json& tallies, const std::string& quantity) {
  for (const json& tally : tallies) {
    if (tally["name"] == quantity) return tally["cases"];
  }
  return 0;
}

TEST(TradeoffCommand, reports_error_and_time_of_each_method) {
  const Outcome result = run("tradeoff --methods quadratic,cross,direct --cases 300 --format json");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  ASSERT_EQ(report["rays"].size(), 1u);
  ASSERT_EQ(report["intersections"].size(), 2u);
  for (const json& method : report["intersections"]) {
    EXPECT_GT(method["call"]["median_ns"].get<double>(), 0);
    EXPECT_GT(method["batch"]["median_ns"].get<double>(), 0);
    EXPECT_GE(cases_of(method["inside"], "class"), 300u);
    EXPECT_GE(cases_of(method["inside"], "parameter"), 50u);
    EXPECT_GE(cases_of(method["inside"], "backward error"), 50u);
  }
  // Something is on the front.
  EXPECT_TRUE(report["intersections"][0]["pareto"].get<bool>() ||
              report["intersections"][1]["pareto"].get<bool>());
}

TEST(TradeoffCommand, prints_one_csv_table) {
  std::istringstream csv(
      run("tradeoff --methods quadratic,robust,direct --cases 100 --format csv").out);
  std::string line;
  std::size_t lines = 0;
  for (; std::getline(csv, line); ++lines) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 18) << line;
  }
  EXPECT_EQ(lines, 4u);
}

TEST(TradeoffCommand, compares_only_what_a_scene_needs) {
  const auto report = [](const std::string& scene) {
    return json::parse(run("tradeoff " + scene +
                           " --methods quadratic,cross,direct,focal --cases 100 "
                           "--format json")
                           .out);
  };
  const json both = report("scene/examples/far-sphere.toml");
  EXPECT_EQ(both["rays"].size(), 2u);
  EXPECT_EQ(both["intersections"].size(), 2u);
  EXPECT_GE(both["pixels"].size(), 1u);
  const json given = report("tests/regressions/tangent.toml");
  EXPECT_EQ(given["rays"].size(), 0u);
  EXPECT_EQ(given["pixels"].size(), 0u);
  EXPECT_EQ(given["intersections"].size(), 2u);
}

TEST(TradeoffCommand, fails_with_2_and_says_why) {
  expect_refused("tradeoff nowhere.toml", "nowhere.toml");
  expect_refused("tradeoff scene/examples/far-sphere.toml --all-families", "one of SCENE");
  expect_refused("tradeoff --family moon", "family moon");
  expect_refused("tradeoff --plot picture.txt", "plot picture.txt");
}

TEST(WorstCommand, finds_an_input_that_check_accepts) {
  const std::string path = temporary_file("worst.toml", "");
  const Outcome result =
      run("worst --method intersect/quadratic --family rays --by rho --cases 200 "
          "--steps 400 --save " +
          path);
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_NE(result.out.find("unstable"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("0x1"), std::string::npos);
  EXPECT_EQ(run("check " + path + " --intersect quadratic").exit_code, 1);
  std::filesystem::remove(path);
}

TEST(WorstCommand, fails_with_2_and_says_why) {
  expect_refused("worst --method lecture --family rays", "rays/lecture or intersect/lecture");
  expect_refused("worst --method direct --family rays", "has no camera");
  expect_refused("worst --method cross --family rays --quantity colour",
                 "quantity colour: no such quantity");
  expect_refused("worst --method cross --family distance@77", "0 to 15");
  expect_refused("worst --method cross", "--family");
}

}  // namespace
}  // namespace raycheck::tests
