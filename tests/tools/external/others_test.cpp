// External candidates in the commands that compare raycheck's methods: stress, worst, tradeoff,
// explain and image.

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

const std::string kFarRoot = "command:python3 tests/candidates/meets.py far-root";
const std::string kFailing = "command:python3 tests/candidates/fails.py ";
const std::string kSpheresScene = "scene/examples/ten-spheres.toml";

TEST(OthersStress, are_judged_stage_by_stage) {
  const json right =
      report_of("stress --family distance --severity 0..1 --cases 20", right_library(), 0);
  const json& method = right["families"][0]["methods"][0];
  EXPECT_EQ(method["name"], right_library());
  expect_values(method, {{"first_failing", nullptr}, {"bounds_of", "direct/cross"}});
  EXPECT_FALSE(method["isolated_by"].get<std::string>().empty());
  for (const std::string& wrong : {kFarRoot, kFailing + "exit all"}) {
    const json report = report_of("stress --family distance --severity 0 --cases 10", wrong, 1);
    EXPECT_EQ(report["families"][0]["methods"][0]["first_failing"], 0) << wrong;
  }
}

TEST(OthersStress, that_fail_are_reported_with_the_first_failure) {
  const std::string candidate = " --candidate '" + kFailing + "exit all'";
  const std::string failed = " failed, first: intersect: it exited with 3\n";
  expect_parts(run("stress --family distance --severity 0 --cases 10" + candidate, 1).out,
               {" on distance (intersections): ", " answers" + failed});
  expect_parts(run("tradeoff --family distance --cases 10" + candidate).out,
               {" (intersections): ", " answers" + failed});
  expect_parts(run("worst --cases 10 --steps 0 --family distance" + candidate, 1).out,
               {"first: intersect: it exited with 3\n", "nothing was measured"});
}

TEST(OthersWorst, are_searched_by_the_stage_of_the_quantity) {
  const std::string few = "worst --cases 20 --steps 20 --family ";
  const json s = report_of(few + "distance", right_library(), 0);
  EXPECT_EQ(s["method"], right_library());
  expect_values(s, {{"unit", "ulp"}, {"failures/count", 0}});
  EXPECT_EQ(report_of(few + "cameras --quantity direction", right_library(), 0)["unit"], "u");
  const json failing = report_of(few + "distance", kFailing + "exit all", 1);
  EXPECT_GT(failing["failures"]["count"], 0);
  EXPECT_EQ(failing["failures"]["first"], "intersect: it exited with 3");
}

TEST(OthersTradeoff, are_timed_only_in_process_and_otherwise_a_reason_is_given) {
  const std::string arguments = "tradeoff --cases 40 --method direct,cross";
  const json kept = report_of(arguments, right_library(), 0);
  const json& judged = kept["intersections"][1];
  expect_values(judged, {{"batch", nullptr}, {"called_in_process", false}});
  expect_parts(judged["note"], {"runs in a sandbox"});
  EXPECT_GT(judged["inside"].size(), 0u);
  const json here = report_of(arguments + kUnkept, right_library(), 0);
  for (const char* stage : {"rays", "intersections"}) {
    const json& timed = here[stage][1];
    EXPECT_EQ(timed["called_in_process"], true) << stage;
    EXPECT_GT(timed["batch"]["median_ns"], 0) << stage;
    EXPECT_GT(timed["call"]["median_ns"], 0) << stage;
    EXPECT_EQ(here[stage][0]["called_in_process"], false);
  }
  // The isolation does not change the results.
  EXPECT_EQ(judged["inside"], here["intersections"][1]["inside"]);
}

TEST(OthersTradeoff, are_not_timed_if_they_answer_differently_or_fail) {
  // The name of the program shows the process in which it runs.
  const std::string source = temporary_file("otherwise.cpp", R"(
#include <raycheck/candidate.hpp>
#include <unistd.h>
#include <string>
using namespace raycheck;
static std::optional<Hit> intersect(const Ray&, const Sphere&, const Conventions&) {
  char name[4096] = {};
  if (readlink("/proc/self/exe", name, sizeof name - 1) < 0) return std::nullopt;
  if (std::string(name).ends_with("raycheck-study")) return Hit{1, {1, 1, 1}};
#ifdef FAILS
  _exit(3);
#endif
  return std::nullopt;
}
RAYCHECK_CANDIDATE(.intersect = intersect)
)");
  const auto note = [&](const std::string& candidate) {
    return report_of("tradeoff --family distance --cases 20" + kUnkept, candidate,
                     0)["intersections"][0]["note"];
  };
  expect_parts(note("command:python3 tests/candidates/meets.py none"), {"it is not a library"});
  expect_parts(note("source:" + source),
               {"its answers in the timed calls differ from the judged ones"});
  const std::string failing =
      temporary_file("failing.cpp", "#define FAILS\n#include \"" + source + "\"\n");
  expect_parts(note("source:" + failing), {"not timed: intersect: it exited with 3"});
}

/// From version 3 of the header on, they follow the conventions.
TEST(OthersTradeoff, receive_the_valid_roots_when_they_are_timed) {
  const std::string source = temporary_file("roots.cpp", R"(
#include <raycheck/candidate.hpp>
#include <cmath>
using namespace raycheck;
static std::optional<Hit> intersect(const Ray&, const Sphere&, const Conventions& asked) {
  if (asked.valid.t_min != 0 || !std::isinf(asked.valid.t_max)) return std::nullopt;
  return Hit{1, {1, 1, 1}};
}
RAYCHECK_CANDIDATE(.intersect = intersect, .roots = Roots::as_asked)
)");
  const json timed = report_of("tradeoff --family distance --cases 20" + kUnkept,
                               "source:" + source, 0)["intersections"][0];
  EXPECT_EQ(timed["called_in_process"], true) << timed["note"];
}

TEST(OthersExplain, are_shown_beside_the_exact_value_of_every_implemented_step) {
  const std::string pixel = "explain " + kSpheresScene + " --pixel 11,7 --sphere 2";
  const json report = report_of(pixel, right_library(), 0);
  const auto steps_of = [](const json& methods) {
    std::string symbols;
    for (const json& step : methods.back()["steps"]) {
      symbols += (symbols.empty() ? "" : " ") + step["symbol"].get<std::string>();
    }
    return symbols;
  };
  EXPECT_EQ(report["methods"].back()["name"], right_library());
  EXPECT_EQ(steps_of(report["ray_methods"]), "W U V P D");
  EXPECT_EQ(steps_of(report["methods"]), "s Q");
  EXPECT_EQ(report["methods"].back()["failed"], nullptr);
  const json wrong = report_of("explain --ray 0,0,0,0,0,1 --sphere 0,0,5,1", kFarRoot, 1);
  EXPECT_EQ(wrong["methods"].back()["goes_wrong_at"], "s");
  EXPECT_EQ(wrong["methods"].back()["s"], "0x1.8p+2");
  const json failed = report_of(pixel, kFailing + "exit one", 1);
  EXPECT_EQ(failed["methods"].back()["failed"], "intersect: it exited with 3");
}

TEST(OthersExplain, are_explained_under_their_declared_conventions) {
  const std::string source = temporary_file("top_first.cpp", R"(
#include <raycheck/candidate.hpp>
using namespace raycheck;
static Ray pixel_ray(const Camera& c, const Conventions&, Pixel) { return {c.eye, {0, 0, -1}}; }
RAYCHECK_CANDIDATE(.rows = Rows::top_first, .pixel_ray = pixel_ray)
)");
  const json report = report_of("explain " + kSpheresScene + " --pixel 0,0", "source:" + source, 1);
  EXPECT_EQ(report["conventions"]["rows"], "top-first");
  EXPECT_EQ(report["ray_methods"].back()["goes_wrong_at"], "D");
}

TEST(OthersImage, have_a_picture_of_their_error) {
  const std::string picture = temporary_file("others.png", "");
  const std::string image = "image " + kSpheresScene + " --what error --out " + picture;
  const json right = report_of(image, right_library(), 0);
  EXPECT_EQ(right["error"]["candidate"], right_library());
  EXPECT_EQ(right["error"]["failed"]["pixels"], 0);
  // Candidates without nearest() or without rays are shown, too.
  EXPECT_EQ(report_of(image, kFailing + "none none", 0)["error"]["wrong"]["defect"]["pixels"], 0);
  EXPECT_GT(report_of(image, kFarRoot, 1)["error"]["wrong"]["defect"]["pixels"], 0);
  const json failed = report_of(image, kFailing + "exit one", 1);
  expect_values(failed["error"], {{"failed/pixels", 1}, {"wrong/defect/pixels", 1}});
}

}  // namespace
}  // namespace raycheck::tests
