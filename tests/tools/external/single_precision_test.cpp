// Candidates of every kind that declare single precision, through the built program: their errors
// are in ulp and u of float, and their inputs are floats.

#include "properties/case.h"
#include "scene/files/scene_file.h"
#include "tests/tools/external/judged.h"
#include "tools/implementations/built_in.h"
#include "tools/stress/stress.h"
#include "tools/tradeoff/tradeoff.h"
#include "tools/view/chart/chart.h"

namespace raycheck::tests {
namespace {

const std::string& float_tracer() { return compiled("tests/submissions/float_rays.cpp"); }
const std::string& float_textbook() { return compiled("tests/candidates/float_quadratic.cpp"); }

TEST(SinglePrecision, passes_all_laws_with_careful_float_code) {
  const std::string said =
      run("properties --cases 300 --candidate source:tests/submissions/float_rays.cpp", 0).out;
  EXPECT_FALSE(has(said, "0 comparisons; of the cases: 100 left out"));
}

TEST(SinglePrecision, judges_a_textbook_formula_in_ulp_of_float) {
  const json campaign = report_of("properties --filter parameter --level demanding",
                                  float_textbook(), 1)["campaigns"][0];
  expect_values(
      campaign,
      {{"finding", "broken"}, {"precision", "single"}, {"quantities/0/unit", "ulp of float"}});
  // Its hit class is right far from the limits of floats.
  report_of("properties --filter class --source rays", float_textbook(), 0);
}

TEST(SinglePrecision, is_judged_on_the_scene_rounded_to_floats) {
  const std::string scene = temporary_file(
      "tenths.toml", ray_text("0, 0.1, 0", "1, 0, 0") + sphere_text("3, 0.1, 0.3", "0.7"));
  // Together with a candidate in doubles, each candidate is judged on its own inputs.
  const json both = report_of("check " + scene + " --rays direct", float_tracer(), 0)["candidates"];
  ASSERT_EQ(both.size(), 2u);
  expect_values(both,
                {{"0/precision", "double"}, {"0/rounded_numbers", 0}, {"1/rounded_numbers", 4}});
  EXPECT_LT(quantity_of(both[1]["quantities"], "parameter")["max"], 4);
  expect_parts(run("check " + scene + " --candidate " + float_tracer()).out,
               {"4 numbers of the scene are not floats: judged on the rounded scene"});
}

TEST(SinglePrecision, is_not_judged_if_floats_cannot_represent_the_scene) {
  const std::string scene =
      temporary_file("wide.toml", ray_text("0, 0, 0", "1, 0, 0") + sphere_text("1e60, 0, 0", "1"));
  const Outcome words = run("check " + scene + " --candidate " + float_tracer(), 4);
  expect_parts(words.out,
               {"not judged here: rounded to floats: 1e+60 is outside the range of floats"});
}

TEST(SinglePrecision, has_valid_certificates) {
  const std::string scene = temporary_file(
      "far.toml", ray_text("0, 0, 0", "1, 0.1, 0") + ray_text("0, 1, 0", "1, 0, 0") +
                      sphere_text("300, 30, 0.3", "0.7") + sphere_text("3, 0, 0.3", "0.5"));
  const std::string proofs = temporary_file("proofs", "");
  const json report =
      judged(scene, float_textbook(), "--max-ulp 0 --top 50 --certificates " + proofs);
  EXPECT_GT(report["discrepancies"], 3);
  const Outcome verified = run_python("tools/verify_certificates.py " + proofs, 0);
  expect_parts(verified.out, {"confirmed"});
  EXPECT_FALSE(has(verified.out, "not certified:")) << verified.out;
}

TEST(SinglePrecision, of_a_renderer_is_an_option) {
  const std::string renderer = "renderer:python3 tests/candidates/rt.py none {scene} {image}";
  const std::string probe = "scene/examples/probe.toml";
  EXPECT_EQ(judged(probe, renderer)["precision"], "double");
  const json single = judged(probe, renderer, "--precision single");
  EXPECT_EQ(single["precision"], "single");
  EXPECT_GT(single["quantities"][0]["cases"], 1000);
}

/// Expects that all numbers of a report's scene are floats.
void expect_floats(const std::string& toml) {
  const scene::Scene scene = scene::load_scene(temporary_file("found.toml", toml)).scene;
  EXPECT_TRUE(properties::is_of_format(scene, scene::Precision::kSingle)) << toml;
}

TEST(OwnUnits, AreUsedByStress) {
  const std::string distance = "stress --family distance --severity 0..2 --cases 40";
  const json good = report_of(distance, float_tracer(), 0)["families"][0]["methods"][0];
  expect_values(
      good, {{"precision", "single"}, {"bounds_of", "direct/cross"}, {"first_failing", nullptr}});
  for (const json& severity : good["severities"]) {
    const json s = quantity_of(severity["inside"], "parameter");
    EXPECT_EQ(s["unit"], "ulp of float");
    EXPECT_LT(s["median"], 4);
    EXPECT_EQ(quantity_of(severity["inside"], "backward error")["unit"], "u of float");
  }
  const json bad = report_of("stress --family distance --severity 0..4 --cases 40",
                             float_textbook(), 1)["families"][0]["methods"][0];
  EXPECT_GT(bad["max_ratio"], 16);
  const json s = quantity_of(bad["severities"].back()["inside"], "parameter");
  EXPECT_EQ(s["unit"], "ulp of float");
  EXPECT_GT(s["max"], 88);
  EXPECT_LT(s["max"], 1e8);  // there are no more than 2^24 of them in s
  // Its rays are judged, too, from cameras rounded to floats.
  const json rays = report_of("stress --family far-camera --severity 0..1 --cases 20",
                              float_tracer(), 0)["families"][0]["methods"];
  ASSERT_EQ(rays.size(), 2u);
  for (const json& stage : rays) {
    const bool makes_rays = stage["stage"] == "rays";
    const json main =
        quantity_of(stage["severities"][0]["inside"], makes_rays ? "direction" : "parameter");
    EXPECT_EQ(main["unit"], makes_rays ? "u of float" : "ulp of float");
    EXPECT_LT(main["max"], 64);
  }
}

TEST(OwnUnits, OfDoublesAreUnchangedBesideFloats) {
  const std::string stress = "stress --family distance --severity 1 --cases 20 --method cross";
  const Outcome alone = run(stress + " --format json");
  const json beside = report_of(stress, float_tracer(), 0)["families"][0]["methods"];
  EXPECT_EQ(json::parse(alone.out)["families"][0]["methods"][0], beside[0]);
  expect_values(beside, {{"0/precision", "double"}, {"1/precision", "single"}});
  expect_parts(run(stress + " --candidate " + float_tracer()).out,
               {"judged in single precision: u = 2^-24, ulp of float", "ulp of float\n"});
}

TEST(OwnUnits, LeaveOutAndCountCasesThatFloatsCannotRepresent) {
  const std::string scale = "stress --family scale --cases 10";
  const json method = report_of(scale, float_tracer(), 0)["families"][0]["methods"].back();
  EXPECT_GT(method["severities"].back()["left_out"], 0);
  EXPECT_EQ(method["severities"][0]["left_out"], 0);
  expect_parts(run(scale + " --candidate " + float_tracer()).out,
               {"left out, not representable in floats"});
}

TEST(OwnUnits, AreUsedByWorst) {
  const std::string few = "worst --cases 60 --steps 200 --family ";
  const json good = report_of(few + "distance", float_tracer(), 0);
  expect_values(good, {{"unit", "ulp of float"}, {"precision", "single"}});
  EXPECT_GT(good["error"], 0.5);
  EXPECT_LT(good["error"], 88);
  expect_floats(good["scene"]);
  EXPECT_EQ(good["discrepancy"]["unit"], "ulp of float");
  EXPECT_EQ(report_of(few + "cameras --quantity direction", float_tracer(), 0)["unit"],
            "u of float");
  const json bad = report_of(few + "distance@4", float_textbook(), 1);
  EXPECT_GT(bad["error"], 88);
  EXPECT_EQ(bad["outcome"], "unstable");
  expect_floats(bad["scene"]);
}

TEST(OwnUnits, AreUsedByTradeoff) {
  const std::string arguments = "tradeoff --family distance@4 --cases 60 --method cross";
  const json report = report_of(arguments, float_textbook(), 0);
  const json& mine = report["intersections"][1];
  EXPECT_EQ(quantity_of(mine["inside"], "parameter")["unit"], "ulp of float");
  EXPECT_EQ(mine["unstable_on"], json::array({"distance@4"}));
  EXPECT_EQ(report["intersections"][0]["precision"], "double");
  const json good = report_of(arguments, float_tracer(), 0)["intersections"][1];
  EXPECT_EQ(good["unstable_on"], json::array());
  EXPECT_LT(quantity_of(good["inside"], "parameter")["max"], 16);
  expect_parts(
      run(arguments + " --candidate " + float_tracer()).out,
      {"\nintersections\n", "\nintersections, in single precision\n", "median ulp of float",
       "backward u of float", "u and ulp are those of float, 2^29 times those of double"});
}

/// It exits if an input is not a float.
TEST(OwnUnits, ReceiveOnlyFloats) {
  const std::string library = compiled(temporary_file("floats_alone.cpp", R"(
#include <raycheck/candidate.hpp>
#include <unistd.h>
#include <initializer_list>
using namespace raycheck;
static std::optional<Hit> intersect(const Ray& r, const Sphere& s, const Conventions&) {
  for (const double x : {r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y,
                         r.direction.z, s.centre.x, s.centre.y, s.centre.z, s.radius}) {
    if (x != double(float(x))) _exit(3);
  }
  return {};
}
RAYCHECK_CANDIDATE(.intersect = intersect, .precision = Precision::single)
)"));

  const std::string picture = temporary_file("floats.png", "");
  const std::string scene = "scene/examples/ten-spheres.toml";
  for (const std::string& command :
       {std::string("stress --family distance --severity 1 --cases 20 --method cross"),
        std::string("stress --family field-of-view --severity 1 --cases 20 --method direct,cross"),
        std::string("worst --family distance --cases 20 --steps 40"),
        "tradeoff --cases 40 --method direct,cross" + kUnkept, "explain " + scene + " --pixel 3,4",
        "image " + scene + " --what error --out " + picture,
        std::string("properties --filter class --source rays --cases 20")}) {
    const Outcome outcome = run(command + " --candidate " + library + " --format json");
    EXPECT_FALSE(has(outcome.out, "exited with 3")) << command << outcome.out;
    EXPECT_TRUE(json::accept(outcome.out)) << command << outcome.err;
    if (command.starts_with("tradeoff")) {
      const json mine = json::parse(outcome.out)["intersections"][1];
      EXPECT_EQ(mine["called_in_process"], true) << mine["note"];
      EXPECT_GT(mine["batch"]["median_ns"], 0);
    }
  }
}

TEST(OwnUnits, AreUsedByExplain) {
  const std::string far = "explain --ray 0,0.1,0,1,0,0 --sphere 3000,0.1,0.3,0.7";
  const std::string near = "explain --ray 0,0.1,0,1,0,0 --sphere 3,0.1,0.3,0.7";
  const json good = report_of(near, float_tracer(), 0);
  EXPECT_EQ(good["rounded_numbers"], 4);
  const json& mine = good["methods"].back();
  EXPECT_EQ(mine["unit"], "ulp of float");
  EXPECT_LT(mine["ulp_error"], 4);
  EXPECT_EQ(mine["steps"][1]["unit"], "u of float");
  EXPECT_EQ(good["methods"][0]["unit"], "ulp");
  const json bad = report_of(far, float_textbook(), 1)["methods"].back();
  EXPECT_EQ(bad["goes_wrong_at"], "s");
  EXPECT_GT(bad["ulp_error"], 88);
  EXPECT_LT(bad["ulp_error"], 1e8);
  expect_parts(run(near + " --candidate " + float_tracer()).out,
               {"4 numbers of the scene are not floats", " ulp of float\n"});
  // With a camera, every step that it implements is shown.
  const json pixel = report_of("explain scene/examples/ten-spheres.toml --pixel 11,7 --sphere 2",
                               float_tracer(), 0);
  for (const json& step : pixel["ray_methods"].back()["steps"]) {
    EXPECT_EQ(step["unit"], "u of float");
    EXPECT_LT(step["error"], 16) << step;
  }
}

TEST(OwnUnits, AreUsedByErrorPictures) {
  const std::string picture = temporary_file("floats.png", "");
  const std::string scene = "scene/examples/ten-spheres.toml";
  const std::string image = "image " + scene + " --what error --out " + picture;
  const json good = report_of(image, float_tracer(), 0)["error"];
  EXPECT_EQ(good["unit"], "ulp of float");
  const json& steps = good["steps"];
  EXPECT_EQ(steps.back()["pixels"], 0);
  EXPECT_EQ(steps[steps.size() - 2]["pixels"], 0);  // up to 65536
  EXPECT_GT(steps[0]["pixels"].get<int>() + steps[1]["pixels"].get<int>(), 0);
  expect_parts(run(image + " --candidate " + float_tracer()).out, {"up to 0.5 ulp of float"});
  // If it makes no rays, it receives raycheck's, rounded to floats.
  const json textbook = report_of(image, float_textbook(), 0)["error"];
  EXPECT_EQ(textbook["failed"]["pixels"], 0);
  EXPECT_EQ(textbook["steps"].back()["pixels"], 0);
}

/// A chart has one unit, so floats have a separate chart.
TEST(OwnUnits, HaveASeparateChart) {
  const auto expect_units = [](const tools::ViewDocument& document) {
    const auto chart = chart_json(document.chart.value());
    std::set<std::string> units;
    for (const auto& facet : chart["facets"]) units.insert(facet["quantities"][0]["unit"]);
    EXPECT_EQ(units, (std::set<std::string>{"ulp", "ulp of float"}));
  };
  tools::StressOptions options;
  options.families = {"distance"};
  options.implementations = tools::find_methods({"cross"});
  options.implementations.push_back(
      {.name = "floats",
       .stages = {properties::Stage::kIntersection},
       .precision = scene::Precision::kSingle,
       .make =
           [] {
             properties::Candidate mine = tools::candidate_of(tools::kDefaultMethods);
             mine.name = "floats";
             return judged_in(scene::Precision::kSingle, std::move(mine));
           },
       .in_process = []() -> tools::InProcess { throw std::invalid_argument("not timed"); }});
  options.cases = 5;
  options.severities = {{0, 1}};
  expect_units(stress_document(run_stress(options)));
  tools::TradeoffOptions tradeoff;
  tradeoff.sources = {properties::chosen_source("distance")};
  tradeoff.implementations = options.implementations;
  tradeoff.cases = 10;
  tools::TradeoffReport report = run_tradeoff(tradeoff);
  report.intersections[1].batch = report.intersections[0].batch;  // not timed
  expect_units(tradeoff_document(report));
  // They are ranked in one unit: an ulp of float is 2^29 ulp of double.
  const auto& costs = report.intersections;
  ASSERT_EQ(costs.size(), 2u);
  EXPECT_EQ(costs[1].badness()->second,
            *costs[1].accuracy.inside.tally(costs[1].quantity()).quantile(0.999) * 0x1p29);
}

}  // namespace
}  // namespace raycheck::tests
