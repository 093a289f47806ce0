// Candidates that declare or follow t_min, t_max and culling, and the hits that an epsilon
// excludes.

#include "tests/tools/external/judged.h"
#include "tools/external/protocol/protocol.h"

namespace raycheck::tests {
namespace {

/// A tracer whose roots lie between ends: its own epsilon, or the scene's ends.
std::string with_ends(const std::string& name, const std::string& counts,
                      const std::string& roots) {
  return tracer(name, counts, "(s, point)", "tangent='hit', roots=" + roots);
}

/// The condition for roots beyond this end, which is excluded.
std::string beyond(const std::string& end) {
  return "rc.Roots('()', " + end + ", float('inf'), 'absolute', 'none')";
}

const std::string kThreeRays = ray_text("0, 0, 0", "1, 0, 0") + ray_text("1.75, 0, 0", "1, 0, 0") +
                               ray_text("3.75, 0, 0", "1, 0, 0") + sphere_text("3, 0, 0", "1");

/// Expects that it is undecided whether nearby inputs make the answer right: that is not a success,
/// and with --strict a failure.
void expect_off_at_the_ends(const std::string& scene, const std::string& candidate) {
  const Outcome outcome = check(scene, candidate);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.out << outcome.err;
  EXPECT_GT(json::parse(outcome.out)["candidates"][0]["discrepancies"], 0);
  EXPECT_EQ(check(scene, candidate, "--strict").exit_code, 1);
}

/// If hardly any root counts by declaration, missing all of them is right, but proves nothing.
TEST(ValidRoots, that_nothing_reaches_do_not_count_as_success) {
  const std::string candidate =
      with_ends("misses.py", "False", beyond("1e9") + ", lengths=(1e-3, 1e3)");
  const json checked =
      report_of("check " + temporary_file("ends.toml", kThreeRays), candidate, 4)["candidates"][0];
  EXPECT_EQ(checked["too_few_judged"]["question"], "hit");
  const json report = report_of("properties --filter class --cases 200", candidate, 4);
  EXPECT_EQ(report["campaigns"][0]["finding"], "too few judged");
}

TEST(ValidRoots, that_are_declared_are_judged_and_their_cost_is_reported) {
  const std::string scene = temporary_file("ends.toml", kThreeRays);
  const std::string candidate = with_ends("eps.py", "s > 0.5", beyond("0.5"));
  const json report = judged(scene, candidate);
  EXPECT_EQ(report["discrepancies"], 0) << report.dump(2);
  expect_values(report["conventions"], {{"t_min", 0.5}, {"interval", "(t_min, t_max)"}});
  // Roots 2 and 4; 1/4 and 9/4; only 1/4.
  const json& excluded = report["excluded"];
  expect_values(excluded, {{"hits", 3}, {"excluded", 1}, {"moved", 1}, {"spheres/0/excluded", 1}});
  ASSERT_EQ(excluded["worst"].size(), 1u);
  expect_values(excluded["worst"][0], {{"ray", 2}, {"s", "0x1p-2"}});
  expect_parts(run("check " + scene + " --candidate '" + candidate + "'").out,
               {"s in (0.5, inf) excludes 1 of 3 exact hits and moves 1 to the other "
                "root",
                "excluded: ray 2, sphere 0 at s = 0.25"});
}

/// A root behind the origin, which counts only by the declared interval.
TEST(ValidRoots, behind_the_origin_are_exact_hits) {
  const std::string scene = temporary_file("behind.toml",
                                           "sphere = [{centre = [-5, 0, 0], radius = 1}]\n"
                                           "ray = [{origin = [0, 0, 0], direction = [1, 0, 0]}]\n");
  const json report = judged(scene, with_ends("line.py", "True", beyond("float('-inf')")));
  expect_values(report, {{"discrepancies", 0}, {"excluded/hits", 1}, {"excluded/excluded", 0}});
}

TEST(ValidRoots, that_are_declared_but_not_followed_are_defects) {
  const std::string scene = temporary_file("ends.toml", kThreeRays);
  const std::string candidate = with_ends("none.py", "s >= 0", beyond("0.5"));
  const json report = judged(scene, candidate);
  EXPECT_EQ(report["discrepancies_by_standing"]["defect"], 2) << report.dump(2);
  // Without a declaration, every root >= 0 counts.
  const std::string undeclared = with_ends("undeclared.py", "s >= 0", "None");
  expect_values(judged(scene, undeclared), {{"discrepancies", 0}, {"excluded", nullptr}});
}

TEST(ValidRoots, of_a_scene_are_sent_to_candidates_that_follow_them) {
  const std::string scene =
      temporary_file("asked.toml",
                     "[conventions]\nt_min = 0.25\nt_max = 2.25\ninterval = \"(t_min, t_max]\"\n"
                     "t_unit = \"radius\"\n" +
                         kThreeRays);
  const std::string right =
      with_ends("right.py", "unit * roots.t_min < s <= unit * roots.t_max", "'as-asked'");
  const json report = judged(scene, right);
  EXPECT_EQ(report["discrepancies"], 0) << report.dump(2);
  expect_values(report, {{"conventions/t_unit", "radius"}, {"excluded/moved", 1}});
  // With < for <=, the candidate misses hits that nearby inputs may miss.
  const std::string off =
      with_ends("off.py", "unit * roots.t_min < s < unit * roots.t_max", "'as-asked'");
  expect_off_at_the_ends(scene, off);
  // With <= for <, the candidate returns roots that the interval excludes.
  const std::string closed =
      with_ends("closed.py", "unit * roots.t_min <= s <= unit * roots.t_max", "'as-asked'");
  EXPECT_EQ(check(scene, closed).exit_code, 1);
}

TEST(ValidRoots, are_followed_in_cpp) {
  const std::string scene = temporary_file(
      "cull.toml", "[conventions]\nculling = \"front-faces\"\nt_max = 4\n" + kThreeRays);
  const auto source = [](const std::string& name, const std::string& end) {
    return compiled(temporary_file(name, R"(
#include <raycheck/candidate.hpp>
using namespace raycheck;
std::optional<Hit> intersect(const Ray& ray, const Sphere& s, const Conventions& by) {
  const double x = s.centre.x - ray.origin.x;
  const double first = x + (by.valid.culling == Culling::front_faces ? s.radius : -s.radius);
  if (first < by.valid.t_min || !(first )" + end +
                                             R"( by.valid.t_max)) return {};
  return Hit{first, {ray.origin.x + first, 0, 0}};
}
RAYCHECK_CANDIDATE(.intersect = intersect, .roots = Roots::as_asked)
)"));
  };
  const std::string right = source("right.cpp", "<="), wrong = source("wrong.cpp", "<");
  EXPECT_EQ(judged(scene, right)["discrepancies"], 0);
  expect_off_at_the_ends(scene, wrong);
}

/// >= for > at an end: a defect that no witness excuses, in doubles and in floats.
TEST(ValidRoots, that_the_declared_interval_excludes_are_defects) {
  const std::string scene = temporary_file("ends.toml", kThreeRays);
  const std::string mutant = with_ends("at_end.py", "s >= 2", beyond("2"));
  const Outcome outcome = run("check " + scene + " --candidate '" + mutant + "'", 1);
  expect_parts(outcome.out, {"root, ray 0, sphere 0: wrong root\n",
                             "the answer s = 2 lies outside the interval (2, inf)"});

  // 0.1f, which is twice its half: the near root is the end itself.
  const std::string floats = temporary_file("floats.toml", ray_text("0, 0, 0", "1, 0, 0") +
                                                               ray_text("-1, 0, 0", "1, 0, 0") +
                                                               sphere_text("0.2, 0, 0", "0.1"));
  const std::string end = "0.10000000149011612", of_end = end + ", float('inf'), 'absolute'";
  const std::string of_radius = "1, float('inf'), 'radius'";
  for (const auto& [counts, from, exit_code] : {std::tuple("s >= " + end, of_end, 1),
                                                {"s > " + end, of_end, 0},
                                                {"s >= r", of_radius, 1},
                                                {"s > r", of_radius, 0}}) {
    const std::string mine =
        tracer("floats.py", counts, "(s, point)",
               "tangent='hit', precision='single', roots=rc.Roots('()', " + from + ", 'none')");
    const Outcome found = check(floats, mine);
    EXPECT_EQ(found.exit_code, exit_code) << counts << found.out << found.err;
  }
}

/// `explain` under the interval that a candidate declares.
TEST(ValidRoots, are_explained_as_check_judges_them) {
  const std::string right = with_ends("eps.py", "s > 0.5", beyond("0.5"));
  const std::string wrong = with_ends("none.py", "s >= 0", beyond("0.5"));
  const std::string ray = "explain --ray 3.75,0,0,1,0,0 --sphere 3,0,0,1";
  const json report = report_of(ray, right, 0);
  expect_values(
      report["exact"],
      {{"class", "miss"}, {"left_out/0/why", "before t_min"}, {"left_out/0/s", "0x1p-2"}});
  const json& miss = report["methods"].back();
  expect_values(miss, {{"hit", false}, {"class_error", false}, {"goes_wrong_at", nullptr}});
  // For raycheck's methods, every root >= 0 counts.
  EXPECT_EQ(report["exact"]["by_every_root"]["s"], "0x1p-2");
  for (const json& method : report["methods"]) {
    EXPECT_EQ(method["class_error"], false) << method["name"];
    EXPECT_EQ(method["goes_wrong_at"], nullptr) << method["name"];
  }
  const json false_hit = report_of(ray, wrong, 1)["methods"].back();
  expect_values(false_hit, {{"class_error", true}, {"standing", "defect"}, {"goes_wrong_at", "s"}});
  expect_parts(run(ray + " --candidate '" + wrong + "'").out,
               {"does not count: s = 0.25 lies before t_min = 0.5\n",
                "false hit, which the interval (0.5, inf) excludes; goes wrong at s"});
}

/// The reasons why a root does not count, each under a scene's conventions.
TEST(ValidRoots, that_do_not_count_are_explained) {
  const auto says = [](const std::string& conventions, const std::string& part) {
    const std::string scene =
        temporary_file("explained.toml", "[conventions]\n" + conventions + "\n" +
                                             camera_text(3, 3) + sphere_text("0, 0, -5", "2"));
    expect_parts(run("explain " + scene + " --pixel 1,1", 0).out, {part});
  };
  // From the pixel at z = -1 the roots are 2 and 6.
  says("t_min = 2.5", "s = 2 lies before t_min = 2.5");
  says("t_min = 2\ninterval = \"(t_min, t_max)\"",
       "s = 2 lies on t_min = 2, which does not belong to (2, inf)");
  says("t_max = 2\ninterval = \"[t_min, t_max)\"",
       "s = 2 lies on t_max = 2, which does not belong to [0, 2)");
  says("t_max = 0.5\nt_unit = \"radius\"", "s = 6 lies beyond t_max = 0.5 radii");
  says("culling = \"front-faces\"", "s = 2 lies on a front face, which is culled");
  says("culling = \"back-faces\"\nt_min = 3", "s = 6 lies on a back face, which is culled");
}

/// The picture under an interval, where another sphere is the nearest one that counts.
TEST(ValidRoots, define_the_reference_picture_of_errors) {
  const std::string scene =
      temporary_file("seen.toml", camera_text(9, 9, 0.25) + sphere_text("0, 0, -2", "0.5") +
                                      sphere_text("0, 0, -10", "1.5"));
  const std::string picture = temporary_file("seen.png", "");
  const auto shown = [&](const std::string& condition, int exit_code) {
    return report_of("image " + scene + " --what error --out " + picture,
                     with_ends("seen.py", condition, beyond("3")), exit_code);
  };
  const json right = shown("s > 3", 0);
  EXPECT_EQ(right["error"]["wrong"]["defect"]["pixels"], 0) << right.dump(2);
  EXPECT_EQ(right["spheres_seen"], 1);  // only the far one
  EXPECT_GT(right["pixels_that_see"], 20);
  EXPECT_GT(shown("s >= 0", 1)["error"]["wrong"]["defect"]["pixels"], 20);
}

/// Whether another point of a pixel's square may show what it shows is known only where every root
/// >= 0 counts.
TEST(ValidRoots, leave_out_pictures_with_any_sample) {
  const std::string scene = temporary_file(
      "any.toml", contents(RAYCHECK_SOURCE_DIR "/" + kProbeScene) + "[conventions]\nt_min = 0.5\n");
  const std::string mirrored = "renderer:python3 tests/candidates/rt.py mirrored {scene} {image}";
  EXPECT_EQ(check(scene, mirrored).exit_code, 1);
  const Outcome any = check(scene, mirrored, "--any-sample");
  EXPECT_EQ(any.exit_code, 4);
  const json report = json::parse(any.out)["candidates"][0];
  EXPECT_EQ(report["discrepancies"], 0);
  expect_parts(report.dump(), {"any point of a pixel may be its sample, but not every root"});
}

TEST(ValidRoots, are_declared_in_a_line) {
  using tools::parse_introduction;
  const auto declared = [](const std::string& line) {
    return parse_introduction("raycheck 1 mine\nfunction frame\n" + line + "ready\n")
        .declared.conventions.valid;
  };
  EXPECT_TRUE(declared("")->is_usual());
  EXPECT_FALSE(declared("roots as-asked\n"));
  const auto own = declared("roots [) 0x1p-10 inf radius back-faces\n");
  EXPECT_EQ(own->t_min, 0x1p-10);
  EXPECT_EQ(own->ends, scene::Ends::kOpenMax);
  EXPECT_EQ(own->unit, scene::TUnit::kRadius);
  EXPECT_EQ(own->culling, scene::Culling::kBackFaces);
  EXPECT_EQ(contract::roots_line(*own), "roots [) 0.0009765625 inf radius back-faces\n");
  for (const char* wrong :
       {"", " [[ 0 1 absolute none", " [] 2 1 absolute none", " [] 0 1 metres none",
        " [] -1 1 absolute none", " [] 0 1 absolute none more"}) {
    EXPECT_THROW(declared("roots" + std::string(wrong) + "\n"), tools::ProtocolError) << wrong;
  }
}

}  // namespace
}  // namespace raycheck::tests
