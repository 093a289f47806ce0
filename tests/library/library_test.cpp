// The library's answers are those of the reference, and its forms of a number agree. Right linked
// candidates, in doubles and in floats, pass; degenerate and wrong candidates do not.

#include <raycheck/cases.h>
#include <raycheck/exact.h>
#include <raycheck/judge.h>
#include <raycheck/law_tests.h>

#include "examples/tracer.h"
#include "tests/testing.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace raycheck::tests {
namespace {

/// The lecture's answers for the eye (0, 0, 0) and the sphere ((0, 0, 5), 1).
TEST(Exact, MeetsTheSphereAhead) {
  const exact::Intersection met = exact::hit({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, 1});
  EXPECT_EQ(met.hit_class, exact::HitClass::hit);
  EXPECT_EQ(met.root, exact::WhichRoot::smaller);
  EXPECT_TRUE(met.is_hit);
  ASSERT_TRUE(met.parameter && met.point);
  EXPECT_EQ(met.parameter->rounded(), 4);
  EXPECT_EQ(met.parameter->closed_form(), "4");
  EXPECT_EQ(met.parameter->ulp_error(std::nextafter(4.0, 5.0)), 1);
  EXPECT_EQ(met.point->rounded().z, 4);
}

#if defined(__SSE2__)
/// Flushes subnormals like a program that is linked with -ffast-math.
TEST(Exact, KeepsSubnormalsWhereTheProgramFlushesThem) {
  constexpr unsigned kFlush = 0x8040;
  constexpr double kUnit = 0x1p-1000;
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | kFlush);
  const exact::Intersection met =
      exact::hit({{0, 0, 0}, {0, 0, 1}}, {{0, kUnit / 2, 5 * kUnit}, kUnit});
  const double s = met.parameter ? met.parameter->rounded() : 0;
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_EQ(after & kFlush, kFlush);
  EXPECT_EQ(met.hit_class, exact::HitClass::hit);
  EXPECT_EQ(s / kUnit, exact::hit({{0, 0, 0}, {0, 0, 1}}, {{0, 0.5, 5}, 1}).parameter->rounded());
}
#endif

TEST(Exact, WritesARootInEveryWay) {
  // |s (1, 2, 0) - (3, 1, 0)| = 3: 5 s^2 - 10 s + 1 = 0, s = 1 - sqrt(20)/5.
  const exact::Intersection met = exact::hit({{0, 0, 0}, {1, 2, 0}}, {{3, 1, 0}, 3});
  ASSERT_TRUE(met.parameter);
  const exact::Number& s = *met.parameter;
  const long double value = 1 - std::sqrt(20.0L) / 5;
  EXPECT_EQ(s.rounded(), static_cast<double>(value));
  EXPECT_EQ(s.closed_form(), "-2/5*sqrt(5) + 1");
  EXPECT_LE(s.interval().lower, s.rounded());
  EXPECT_GE(s.interval().upper, s.rounded());
  EXPECT_LE(s.interval().upper, std::nextafter(std::nextafter(s.interval().lower, 1.0), 1.0));
  EXPECT_EQ(s.enclosure(60).substr(0, 20), "[0.10557280900008412");
  EXPECT_LT(s.ulp_error(s.rounded()), 0.5);
  EXPECT_GT(s.condition(), 1);
  EXPECT_EQ(s.ulp_error(kInfinity), kInfinity);
  EXPECT_THROW((void)s.enclosure(1), std::invalid_argument);
  EXPECT_THROW((void)s.enclosure(1 << 20), std::invalid_argument);
}

TEST(Exact, FollowsTheConventions) {
  const Ray touching{{0, 1, 0}, {1, 0, 0}};
  const Sphere sphere{{5, 0, 0}, 1};
  Conventions asked;
  EXPECT_EQ(exact::hit(touching, sphere).hit_class, exact::HitClass::tangent);
  EXPECT_TRUE(exact::hit(touching, sphere).is_hit);
  asked.tangent = Tangent::miss;
  EXPECT_FALSE(exact::hit(touching, sphere, asked).is_hit);
  const Ray inside{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(exact::hit(inside, {{0, 0, 0}, 2}).parameter->rounded(), 2);
  asked.root = Root::smaller;
  EXPECT_FALSE(exact::hit(inside, {{0, 0, 0}, 2}, asked).is_hit);
}

TEST(Exact, FindsTheNearestSphereAndItsTies) {
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  const auto found = exact::nearest(ray, {{{0, 0, 9}, 1}, {{0, 0, 5}, 1}, {{0, 0, 6}, 2}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->index, 1u);
  EXPECT_EQ(found->ties, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(found->intersection.parameter->rounded(), 4);
  EXPECT_FALSE(exact::nearest(ray, {{{0, 0, -9}, 1}}));
}

Camera square_camera() { return {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, -2, -1, 1, -1, 1, 3, 3}; }

TEST(Exact, AnswersForCameras) {
  const exact::Camera camera(square_camera());
  EXPECT_EQ(camera.axes().w.rounded().z, 1);
  EXPECT_EQ(camera.axes().u.rounded().x, 1);
  const Vector corner = camera.pixel_point({0, 2}).rounded();
  EXPECT_EQ(corner.x, -1);
  EXPECT_EQ(corner.y, 1);
  EXPECT_EQ(corner.z, 8);
  EXPECT_EQ(camera.ray({0, 2}).direction().z.closed_form(), "-1/3*sqrt(6)");
  EXPECT_EQ(camera.ray({0, 2}).origin().rounded().z, 8);
  Conventions focal;
  focal.origin = Origin::focal;
  EXPECT_EQ(exact::Camera(square_camera(), focal).ray({0, 2}).origin().rounded().z, 10);
  EXPECT_THROW((void)camera.ray({3, 0}), std::invalid_argument);
}

TEST(Exact, RefusesInvalidInput) {
  const Ray none{{0, 0, 0}, {0, 0, 0}};
  EXPECT_THROW((void)exact::hit(none, {{0, 0, 5}, 1}), std::invalid_argument);
  EXPECT_THROW((void)exact::hit({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, -1}), std::invalid_argument);
  EXPECT_THROW(exact::Camera{Camera{}}, std::invalid_argument);
  std::vector<Conventions> wrong(5);
  wrong[0].valid.t_min = std::nan("");
  wrong[1].valid.t_min = -1;
  wrong[2].valid = {7, 3};
  wrong[3].valid.ends = static_cast<Ends>(9);
  wrong[4].root = static_cast<Root>(9);
  for (const Conventions& one : wrong) {
    EXPECT_THROW((void)exact::hit({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, 1}, one),
                 std::invalid_argument);
  }
}

TEST(Cases, AreDeterminedByTheirSeed) {
  for (const Source& source : sources()) {
    const Case one = make_case(source.name, 7, 3, source.highest);
    EXPECT_EQ(scene_text(one), scene_text(make_case(source.name, 7, 3, source.highest)));
    EXPECT_NE(scene_text(one), scene_text(make_case(source.name, 7, 4, source.highest)))
        << source.name;
    EXPECT_EQ(one.scene.camera.has_value(), source.has_camera);
    EXPECT_THROW((void)make_case(source.name, 7, 3, source.highest + 1), std::invalid_argument);
  }
  EXPECT_THROW((void)make_case("nowhere", 1), std::invalid_argument);
}

/// Every double, also -0 and subnormal ones, reads back from its text.
TEST(Cases, ReadBackAsWritten) {
  int subnormal = 0;
  for (const Source& source : sources()) {
    for (std::uint64_t number = 0; number < 400; ++number) {
      const auto severity = static_cast<int>(number) % (source.highest + 1);
      const Case one = make_case(source.name, 7, number, number < 20 ? source.highest : severity);
      const std::string text = scene_text(one);
      ASSERT_EQ(scene_text({read_scene(text), one.pixels}), text);
      subnormal += has(text, "e-31") ? 1 : 0;
    }
  }
  EXPECT_GT(subnormal, 20);
  EXPECT_FALSE(simpler(make_case("rays", 1)).empty());
}

TEST(Cases, AreMadeFromAnyBytes) {
  std::string bytes;
  int made = 0;
  for (int k = 0; k < 500; ++k) {
    bytes.push_back(static_cast<char>(k * k * 37 + k));
    const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    if (case_of_bytes(data, bytes.size() % 40)) ++made;
  }
  EXPECT_GT(made, 50);
}

TEST(Judge, LetsAGoodTracerPassEveryLaw) {
  const LawTests tests(tracer());
  EXPECT_GT(tests.checks().size(), 100u);
  std::size_t judged = 0;
  for (const Check& check : tests.checks()) {
    const LawOutcome outcome = tests.run(check);
    EXPECT_TRUE(outcome.passes) << outcome.text;
    judged += outcome.says_too_little ? 0 : 1;
  }
  EXPECT_GT(judged, tests.checks().size() * 2 / 3);
}

TEST(Judge, FindsDegenerateCandidatesBroken) {
  Candidate misses("misses");
  misses.intersect = [](const auto&...) { return std::optional<Hit>(); };
  Candidate at_zero("at-zero");
  at_zero.intersect = [](const Ray& ray, const auto&...) {
    return std::optional<Hit>({0, ray.origin});
  };
  for (const Candidate& degenerate : {misses, at_zero}) {
    const Verdict verdict = judge(degenerate, "class");
    EXPECT_EQ(verdict.finding, Finding::broken) << verdict.text;
    EXPECT_FALSE(verdict.passes());
    for (const char* source : {"rays", "distance", "tangency", "surface"}) {
      EXPECT_EQ(judge(degenerate, "class", source).finding, Finding::broken) << source;
    }
  }
}

/// The candidate uses >= instead of > at the declared end, on which the root of every case lies.
TEST(Judge, FindsRootsOutsideTheDeclaredIntervalBroken) {
  Case one;
  one.scene.rays = {{{0, 0, 0}, {1, 0, 0}}};
  one.scene.spheres = {{{3, 0, 0}, 1}};
  const auto judged = [&](double least, Precision precision) {
    Candidate candidate("at-end");
    candidate.roots = Roots::declared;
    candidate.declares.valid = {.t_min = 2, .ends = Ends::open};
    candidate.precision = precision;
    candidate.intersect = [least](const auto&...) {
      return std::optional<Hit>({least, {least, 0, 0}});
    };
    return judge_case(candidate, "nearest-root", one);
  };
  for (const Precision precision : {Precision::double_, Precision::single}) {
    const Verdict wrong = judged(2, precision);
    EXPECT_EQ(wrong.finding, Finding::broken) << wrong.text;
    EXPECT_TRUE(has(wrong.text, "the answer s = 2 lies outside the interval (2, inf)"));
    EXPECT_NE(judged(4, precision).finding, Finding::broken);
  }
}

TEST(Judge, JudgesOnlyDeclaredReturnsAndDirections) {
  Candidate distances("distances");
  distances.declares.tangent = Tangent::either;
  distances.intersect = [](const Ray& ray, const Sphere& sphere, const Conventions& asked) {
    auto hit = ::intersect(ray, sphere, asked);
    if (hit) *hit = {hit->parameter * std::sqrt(dot(ray.direction, ray.direction)), {}};
    return hit;
  };
  EXPECT_EQ(judge(distances, "parameter", "rays").finding, Finding::broken);
  distances.returns = Returns::distance;
  EXPECT_EQ(judge(distances, "parameter", "rays").finding, Finding::holds);
  EXPECT_EQ(judge(distances, "hit-point", "rays").finding, Finding::left_out);
  distances.returns = Returns::parameter;  // equal for unit directions
  distances.directions = Directions::unit;
  EXPECT_EQ(judge(distances, "parameter", "rays").finding, Finding::holds);
}

TEST(Judge, SaysWhereAndWhyALawIsBroken) {
  Candidate wrong = tracer();
  wrong.name = "far";
  wrong.intersect = [](const Ray& ray, const Sphere& sphere, const Conventions& asked) {
    auto hit = ::intersect(ray, sphere, asked);
    const Vector to = sphere.centre - ray.origin;
    if (hit)
      hit->parameter =
          2 * dot(to, ray.direction) / dot(ray.direction, ray.direction) - hit->parameter;
    if (hit) hit->point = ray.origin + hit->parameter * ray.direction;
    return hit;
  };
  const Verdict verdict = judge(wrong, "nearest-root", "rays");
  ASSERT_EQ(verdict.finding, Finding::broken) << verdict.text;
  ASSERT_TRUE(verdict.broken);
  EXPECT_EQ(verdict.broken->shrunk.scene.rays.size(), 1u);
  EXPECT_TRUE(has(verdict.broken->replay, "nearest-root:far:rays:"));
  ASSERT_FALSE(verdict.broken->sentences.empty()) << verdict.text;
  EXPECT_TRUE(has(verdict.broken->sentences[0], "far root"));
  for (const std::string& part :
       {verdict.broken->replay, verdict.broken->sentences[0], std::string("[[sphere]]")}) {
    EXPECT_TRUE(has(verdict.text, part));
  }
  const Verdict again = replay(wrong, verdict.broken->replay);
  EXPECT_EQ(again.finding, Finding::broken);
  EXPECT_EQ(again.broken->discrepancy, verdict.broken->discrepancy);
  EXPECT_EQ(replay(tracer(), verdict.broken->replay).finding, Finding::holds);
  EXPECT_EQ(judge_case(wrong, "nearest-root", verdict.broken->shrunk).finding, Finding::broken);
  EXPECT_EQ(judge_case(tracer(), "nearest-root", verdict.broken->shrunk).finding, Finding::holds);
}

TEST(Judge, CountsExceptionsAsNoAnswer) {
  Candidate why("throws"), seven("throws");
  why.intersect = [](const auto&...) -> std::optional<Hit> { throw std::runtime_error("no idea"); };
  seven.intersect = [](const auto&...) -> std::optional<Hit> { throw 7; };
  for (const auto& [throws, said] : {std::pair(why, "no idea"), {seven, "not a std::exception"}}) {
    const Verdict verdict = judge(throws, "class", "rays");
    EXPECT_EQ(verdict.finding, Finding::broken) << said;
    EXPECT_TRUE(has(verdict.text, said));
  }
}

TEST(Judge, JudgesOnlyFunctionsThatAreSet) {
  Candidate frames("frames");
  frames.frame = [](const Camera&) { return Frame{}; };
  const auto all = checks(frames);
  ASSERT_FALSE(all.empty());
  EXPECT_TRUE(
      std::none_of(all.begin(), all.end(), [](const Check& one) { return one.law == "class"; }));
  EXPECT_THROW((void)checks(Candidate("nothing")), std::invalid_argument);
  const auto refused = [](auto change) {
    Candidate candidate("mine");
    candidate.intersect = [](const auto&...) { return std::optional<Hit>(); };
    change(candidate);
    const LawTests tests(candidate);
    if (tests.checks().size() != 1) return false;
    const LawOutcome outcome = tests.run(tests.checks().front());
    return !outcome.passes && !outcome.text.empty();
  };
  EXPECT_TRUE(refused([](Candidate& c) { c.intersect = {}; }));
  EXPECT_TRUE(refused([](Candidate& c) { c.smallest_length = 10, c.largest_length = 1; }));
  EXPECT_TRUE(refused([](Candidate& c) { c.level = static_cast<Level>(99); }));
  EXPECT_TRUE(refused([](Candidate& c) { c.declares.root = static_cast<Root>(99); }));
  EXPECT_TRUE(refused([](Candidate& c) { c.returns = static_cast<Returns>(99); }));
  EXPECT_TRUE(refused([](Candidate& c) { c.precision = static_cast<Precision>(2); }));
  EXPECT_TRUE(refused([](Candidate& c) { c.directions = static_cast<Directions>(-1); }));
  EXPECT_TRUE(refused([](Candidate& c) { c.roots = static_cast<Roots>(3); }));
  EXPECT_TRUE(refused([](Candidate& c) {
    c.roots = Roots::declared;
    c.declares.valid.t_min = std::nan("");
  }));
  EXPECT_FALSE(refused([](Candidate&) {}));
  EXPECT_THROW((void)judge(frames, "nothing"), std::invalid_argument);
  EXPECT_THROW((void)judge(frames, "class", "nowhere"), std::invalid_argument);
  EXPECT_THROW((void)replay(frames, "nothing"), std::invalid_argument);
  for (const double bound : {-1.0, std::nan("")}) {
    EXPECT_THROW((void)judge(frames, "frame", "", {.max_error = bound}), std::invalid_argument)
        << bound;
  }
  const Verdict left_out = judge(frames, "class");
  static_assert(noexcept(left_out.passes()), "callers rely on it");
  static_assert(noexcept(left_out.holds()), "callers rely on it");
  EXPECT_TRUE(left_out.passes());
  EXPECT_FALSE(left_out.holds());
}

/// The good tracer's answers, with s off by a share, rounded to floats.
Candidate floats(double off = 0) {
  Candidate candidate("floats");
  candidate.precision = Precision::single;
  candidate.intersect = [off](const Ray& ray, const Sphere& sphere, const Conventions& by) {
    const auto in_float = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    auto hit = ::intersect(ray, sphere, by);
    if (!hit) return hit;
    hit->parameter = in_float(hit->parameter * (1 + off));
    for (double* x : {&hit->point.x, &hit->point.y, &hit->point.z}) *x = in_float(*x);
    return hit;
  };
  return candidate;
}

TEST(SinglePrecision, LetsGoodFloatsPassUnlessTheyAreUndeclared) {
  Candidate candidate = floats();
  EXPECT_EQ(judge(candidate, "parameter", "rays").finding, Finding::holds);
  candidate.precision = Precision::double_;
  EXPECT_EQ(judge(candidate, "parameter", "rays").finding, Finding::broken);
}

TEST(SinglePrecision, FindsErrorsInUlpsOfFloat) {
  const Verdict verdict = judge(floats(0x1p-15), "parameter");
  EXPECT_EQ(verdict.finding, Finding::broken);
  EXPECT_TRUE(has(verdict.text, "ulp of float"));
  ASSERT_TRUE(verdict.broken);
  const Sphere& sphere = verdict.broken->shrunk.scene.spheres.at(0);
  EXPECT_EQ(sphere.radius, static_cast<float>(sphere.radius));
  EXPECT_EQ(replay(floats(0x1p-15), verdict.broken->replay).finding, Finding::broken);
}

TEST(SinglePrecision, LeavesOutACaseThatFloatsCannotHold) {
  Case wide;
  wide.scene.rays = {{{0, 0, 0}, {1, 0, 0}}};
  wide.scene.spheres = {{{1e60, 0, 0}, 1}};
  const Verdict verdict = judge_case(floats(), "class", wide);
  EXPECT_EQ(verdict.finding, Finding::left_out);
  EXPECT_TRUE(has(verdict.reason, "1e+60"));
}

}  // namespace
}  // namespace raycheck::tests
