// Candidates that require unit directions, intersect lines, have ends in scene lengths, or return
// less than s and Q are judged by their declarations.

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/interfaces.h"
#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

json laws_of(const std::string& candidate, const std::string& more = "", int exit_code = 0) {
  return report_of("properties --cases 60 " + more, candidate, exit_code)["campaigns"];
}

/// The finding of a law.
std::string finding(const json& campaigns, const std::string& law) {
  const json& one = found(campaigns, "law", law);
  return one.is_null() ? "" : one["finding"];
}

TEST(Contracts, that_return_less_are_judged_by_their_results) {
  struct Contract {
    const char *says, *returns;
    bool gives_parameter, gives_point;
  };
  for (const auto& [says, returns, parameter, point] :
       {Contract{"parameter", "s", true, false}, Contract{"point", "point", false, true},
        Contract{"distance", "s * length", true, false},
        Contract{"squared-distance", "(s * length) ** 2", true, false},
        Contract{"class", "True", false, false}}) {
    const json laws =
        laws_of(tracer("returns.py", "s >= 0", returns, std::string("returns='") + says + "'"));
    EXPECT_EQ(finding(laws, "class"), "holds") << says;
    EXPECT_EQ(finding(laws, "parameter"), parameter ? "holds" : "left out") << says;
    EXPECT_EQ(finding(laws, "hit-point"), point ? "holds" : "left out") << says;
    EXPECT_EQ(finding(laws, "nearest-root"), parameter || point ? "holds" : "left out") << says;
  }
}

TEST(Contracts, that_return_something_else_than_declared_are_broken) {
  const std::string number = tracer("number.py", "s >= 0", "0", "returns='class'");
  expect_parts(report_of("properties --filter class", number, 1)["campaigns"][0].dump(),
               {"neither True nor False: 0"});
  const std::string far =
      tracer("far.py", "s >= 0", "[x + 1e-3 for x in point]", "returns='point'");
  EXPECT_EQ(finding(laws_of(far, "--filter hit-point", 1), "hit-point"), "broken");
  const std::string plain = tracer("plain.py", "s >= 0", "s", "returns='distance'");
  EXPECT_EQ(finding(laws_of(plain, "--filter parameter", 1), "parameter"), "broken");
}

TEST(Contracts, are_declared_by_users_of_code_that_stays_as_it_is) {
  const std::string at_one = tracer("at_one.py", "s >= 1", "(s, point)", "");
  const std::string laws = "--filter class --source rays ";
  EXPECT_EQ(finding(laws_of(at_one, laws, 1), "class"), "broken");
  EXPECT_EQ(finding(laws_of(at_one, laws + "--declare 't_min 1; root nearest' "), "class"),
            "holds");
  const auto refused = [&](const std::string& statements, const std::string& says) {
    const Outcome outcome =
        run("properties --candidate '" + at_one + "' --declare '" + statements + "'", 2);
    expect_parts(outcome.err, {"--declare '" + statements + "': ", says});
  };
  refused("t_mim 1", "declares 't_mim', not one of rows, samples");
  refused("rays end; directions unit", "rays = end: cannot be combined with directions unit");
  refused("returns class", "what functions return must be declared in their code");
  const Outcome replayed =
      run("properties --candidate '" + at_one + "' --declare 't_min 2' " + laws, 1);
  expect_parts(replayed.out, {"--declare \"t_min 2\" --replay 'class:"});
}

/// This code takes s for a length, which is right only for unit directions.
TEST(Contracts, that_require_unit_directions_receive_no_others) {
  const std::string says = "returns='parameter', directions='unit'";
  const std::string unit = tracer("unit.py", "s >= 0 and abs(length - 1) < 1e-15", "s", says);
  const json laws = laws_of(unit, "--level demanding --source direction-length --source rays");
  EXPECT_EQ(finding(laws, "class"), "holds");
  EXPECT_EQ(finding(laws, "parameter"), "holds");
  const std::string scene = temporary_file("long.toml", ray_text("0, 0, 0", "1024, 0, 0") +
                                                            ray_text("0, 0, 0", "0.6, 0, 0.8") +
                                                            sphere_text("3, 0, 0", "1"));
  const json report = judged(scene, unit);
  expect_values(report, {{"made_unit", 1}, {"discrepancies", 0}});
  expect_parts(run("check " + scene + " --candidate '" + unit + "'").out,
               {"takes only unit directions: 1 direction normalised"});
}

/// The most common epsilon.
TEST(Contracts, may_have_ends_in_scene_lengths) {
  const std::string roots = "roots=rc.Roots('()', 1e-3, float('inf'), 'length', 'none')";
  const std::string epsilon = tracer("epsilon.py", "s * length > 1e-3", "(s, point)", roots);
  const json laws = laws_of(epsilon, "--source direction-length --source surface --source rays");
  EXPECT_EQ(finding(laws, "class"), "holds");
  EXPECT_EQ(finding(laws, "nearest-root"), "holds");
  const std::string scene = temporary_file(
      "longer.toml", ray_text("0, 0, 0", "1024, 0, 0") + sphere_text("3, 0, 0", "2"));
  EXPECT_EQ(judged(scene, epsilon)["discrepancies"], 0);
  EXPECT_GT(judged(scene, tracer("wrong.py", "s > 1e-3", "(s, point)", roots))["discrepancies"], 0);
}

TEST(Contracts, may_be_for_lines) {
  const std::string roots = "roots=rc.Roots('[]', float('-inf'), float('inf'), 'absolute', 'none')";
  const json laws = laws_of(tracer("line.py", "True", "(s, point)", roots), "--source rays");
  EXPECT_EQ(finding(laws, "class"), "holds");
  EXPECT_EQ(finding(laws, "parameter"), "holds");
  const std::string ray = tracer("ray.py", "s >= 0", "(s, point)", roots);
  EXPECT_EQ(finding(laws_of(ray, "--filter class --source rays", 1), "class"), "broken");
}

/// Declared ends are exact doubles: the float 0.001f is not 0.001.
TEST(Contracts, in_floats_keep_their_ends_in_doubles) {
  const std::string scene =
      temporary_file("float-end.toml", ray_text("0, 0, 0", "1, 0, 0") +
                                           sphere_text("3.0010001659393310546875, 0, 0", "3"));
  const std::string says =
      "precision='single', roots=rc.Roots('()', 1e-3, float('inf'), 'absolute', 'none')";
  const json report = judged(scene, tracer("float.py", "s > 1e-3", "(s, point)", says));
  expect_values(report, {{"discrepancies", 0}, {"precision", "single"}});
}

/// A hit class without s cannot be excluded by an end, so nearby inputs decide.
TEST(Contracts, of_only_a_class_are_undecided_at_an_end) {
  const std::string scene =
      temporary_file("exit.toml", ray_text("0, 0, 0", "1, 0, 0") + ray_text("0, 0, 0", "0, 1, 0") +
                                      sphere_text("-1, 0, 0", "2"));
  const std::string roots = "roots=rc.Roots('()', 1.0, float('inf'), 'length', 'none')";
  const std::string closed = tracer("closed.py", "s >= 1", "True", "returns='class', " + roots);
  const Outcome outcome = check(scene, closed);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.out;
  const json report = json::parse(outcome.out)["candidates"][0];
  EXPECT_EQ(report["discrepancies_by_standing"]["undecided"], 1);
  const std::string text = run("check " + scene + " --candidate '" + closed + "'").out;
  EXPECT_TRUE(text.find("got   a hit\n") != std::string::npos) << text;
  // The declared interval excludes its s.
  EXPECT_EQ(check(scene, tracer("s.py", "s >= 1", "s", "returns='parameter', " + roots)).exit_code,
            1);
}

/// It misses tangents although only back faces count. In that case no witness is searched for.
TEST(Contracts, that_leave_a_law_undecided_show_the_case) {
  const std::string tracing =
      tracer("back.py", "s >= 0 and under > 0 and s == max(q / a, other)", "(s, point)",
             "roots=rc.Roots('[]', 0.0, float('inf'), 'absolute', 'front-faces'), tangent='hit'");
  const std::string tangent =
      "--filter class --source ties --cases 200 --candidate '" + tracing + "'";
  const Outcome outcome = run("properties " + tangent);
  EXPECT_EQ(outcome.exit_code, 4) << outcome.out;
  expect_parts(outcome.out, {"undecided", "# leaves undecided the law class with", "[[sphere]]",
                             "replay: raycheck properties"});
  for (const char* format : {"json", "junit", "markdown"}) {
    expect_parts(run("properties --format " + std::string(format) + " " + tangent).out,
                 {"[[sphere]]"});
  }
}

/// If nothing was decided, the first line is not praise.
TEST(Contracts, have_the_most_important_finding_first) {
  const auto first = [](const std::string& candidate, const std::string& more = "") {
    const std::string out =
        run("properties --cases 60 " + more + " --candidate '" + candidate + "'").out;
    return out.substr(0, out.find('\n'));
  };
  expect_parts(first(tracer("right.py", "s >= 0", "(s, point)", "tangent='hit'")),
               {"mine (command:", "): right on all ordinary cases"});
  expect_parts(first(tracer("open.py", "s > 0 and under > 0", "(s, point)", "tangent='either'"),
                     "--source from-surface"),
               {"no law is broken, ", "; takes all ", " exact tangents for misses; misses ",
                " at s = 0 exactly"});
  expect_parts(first(tracer("no_hit.py", "False", "(s, point)", "lengths=(1e-300, 1e-299)")),
               {"nothing judged: no case lies within the lengths that it declares"});
  // The candidate is in C++, so that shrinking is fast.
  const auto in_cpp = [&](const std::string& name, const std::string& body) {
    return first(compiled(temporary_file(name + ".cpp", R"(#include <raycheck/candidate.hpp>
#include <stdexcept>
using namespace raycheck;
static std::optional<Hit> intersect(const Ray& ray, const Sphere&, const Conventions&) {
  const Vector o = ray.origin, d = ray.direction;
  )" + body + R"(
}
RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::hit, .intersect = intersect)
)")));
  };
  expect_parts(in_cpp("never", "return {};"), {"no ray ever hits a sphere"});
  expect_parts(in_cpp("always", "return Hit{1, {o.x + d.x, o.y + d.y, o.z + d.z}};"),
               {"every ray hits every sphere, at s = 1"});
  expect_parts(in_cpp("unwritten", "throw std::logic_error(\"not yet\");"),
               {"gives no answers: ", "not yet"});
}

/// The textbook's difference, in code that requires unit directions.
TEST(Contracts, of_unit_directions_are_not_reported_as_a_mistake) {
  const std::string source = temporary_file("unit.cpp", R"(#include <cmath>
#include <raycheck/candidate.hpp>
using namespace raycheck;
static double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static std::optional<Hit> intersect(const Ray& ray, const Sphere& sphere, const Conventions&) {
  const Vector c = sphere.centre, o = ray.origin, to = {c.x - o.x, c.y - o.y, c.z - o.z};
  const double v = dot(to, ray.direction), rest = v * v - dot(to, to) + sphere.radius * sphere.radius;
  if (rest < 0) return {};
  const double near = v - std::sqrt(rest), far = v + std::sqrt(rest);
  if (far <= 1e-4) return {};
  return Hit{near > 1e-4 ? near : far, {}};
}
RAYCHECK_CANDIDATE(.root = Root::nearest, .tangent = Tangent::either, .intersect = intersect,
                   .roots = Roots::declared,
                   .valid = {.t_min = 1e-4, .ends = Ends::open, .unit = TUnit::length},
                   .directions = Directions::unit, .returns = Returns::distance))");
  const Outcome outcome =
      run("properties --level demanding --cases 300 --candidate " + compiled(source));
  EXPECT_EQ(outcome.exit_code, 1);
  expect_parts(outcome.out,
               {"d^2 loses its digits, because", "(the wrong cases examined are at 10^"});
  EXPECT_FALSE(has(outcome.out, "directions are taken for unit vectors"));
}

/// It is undecided whether a missed root within a rounding of the declared end counts.
TEST(Contracts, show_the_case_that_is_left_undecided) {
  const std::string misses = tracer("misses.py", "s > 1.0000000000000002 ", "(s, point)",
                                    "roots=rc.Roots('[]', 1.0, float('inf'), 'absolute', 'none')");
  const std::string scene =
      temporary_file("end.toml", ray_text("0, 0, 0", "1, 0, 0") + sphere_text("3, 0, 0", "2"));
  const Outcome outcome = run("check " + scene + " --candidate '" + misses + "'");
  EXPECT_EQ(outcome.exit_code, 4);
  expect_parts(outcome.out, {"undecided"});
}

TEST(Completed, AddsDerivedValues) {
  using properties::Returns;
  const scene::Ray ray{{1, 0, 0}, {4, 0, 0}};
  const scene::Sphere sphere{{9, 0, 0}, 4};  // from s = 1 on
  const auto of = [&](Returns returns, const properties::HitAnswer& given) {
    properties::Functions functions;
    functions.intersect = [&](auto, auto, const auto&) {
      return std::vector<properties::SphereHits>{{{0, given}}};
    };
    return adapted(functions, {.returns = returns}, scene::Precision::kDouble)
        .intersect({&ray, 1}, {&sphere, 1}, {})
        .at(0)
        .at(0)
        .hit;
  };
  EXPECT_EQ(of(Returns::kParameter, {1, {}}).point.x, 5);
  EXPECT_EQ(of(Returns::kDistance, {4, {}}).parameter, 1);
  EXPECT_EQ(of(Returns::kSquaredDistance, {16, {}}).parameter, 1);
  EXPECT_EQ(of(Returns::kPoint, {0, {5, 0, 0}}).parameter, 1);
  EXPECT_EQ(of(Returns::kClass, {}).parameter, 2);
  EXPECT_TRUE(std::isnan(of(Returns::kSquaredDistance, {-1, {}}).parameter));
}

TEST(RoundedCase, MakesDirectionsUnitIfRequired) {
  using scene::Precision;
  constexpr contract::Interface kUnit = {.directions = contract::Directions::kUnit};
  properties::Case one;
  one.scene.rays = {{{}, {0.6, 0, 0.8}}, {{}, {0x1p900, 0x1p900, 0}}, {{}, {0x1p-1074, 0, 0}}};
  one.scene.spheres = {{{3, 0, 0}, 1}};
  for (const Precision precision : {Precision::kDouble, Precision::kSingle}) {
    const auto rounded = properties::rounded_case(one, {precision, kUnit});
    EXPECT_EQ(rounded.made_unit, 2u);
    ASSERT_TRUE(rounded.the_case);
    EXPECT_EQ(rounded.the_case->scene.rays[2].direction.x, 1);
    EXPECT_TRUE(properties::is_of_format(rounded.the_case->scene, {precision, kUnit}));
    EXPECT_EQ(properties::rounded_case(*rounded.the_case, {precision, kUnit}).made_unit, 0u);
  }
  EXPECT_FALSE(properties::is_of_format(one.scene, {Precision::kDouble, kUnit}));
  EXPECT_TRUE(properties::is_of_format(one.scene, Precision::kDouble));
}

}  // namespace
}  // namespace raycheck::tests
