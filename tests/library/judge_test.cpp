// Candidates that are linked in, in doubles and in floats: what is right passes, what is dull or
// wrong does not.

#include <gtest/gtest.h>
#include <raycheck/judge.h>
#include <raycheck/law_tests.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "examples/tracer.h"
#include "tests/has.h"

namespace raycheck::tests {
namespace {

TEST(Judge, LetsAGoodTracerPassEveryLaw) {
  const LawTests tests(tracer());
  EXPECT_GT(tests.checks().size(), 100u);
  std::size_t told = 0;
  for (const Check& check : tests.checks()) {
    const LawOutcome outcome = tests.run(check);
    EXPECT_TRUE(outcome.passes) << outcome.text;
    told += outcome.says_too_little ? 0 : 1;
  }
  EXPECT_GT(told, tests.checks().size() * 2 / 3);
}

TEST(Judge, BreaksWhatIsDull) {
  Candidate misses("misses");
  misses.intersect = [](const Ray&, const Sphere&, const Conventions&) {
    return std::optional<Hit>();
  };
  Candidate at_zero("at-zero");
  at_zero.intersect = [](const Ray& ray, const Sphere&, const Conventions&) {
    return std::optional<Hit>({0, ray.origin});
  };
  for (const Candidate& dull : {misses, at_zero}) {
    const Verdict verdict = judge(dull, "class");
    EXPECT_EQ(verdict.finding, Finding::broken) << verdict.text;
    EXPECT_FALSE(verdict.passes());
    for (const char* source : {"rays", "distance", "tangency", "surface"}) {
      EXPECT_EQ(judge(dull, "class", source).finding, Finding::broken) << source;
    }
  }
}

/// >= for > at the end that a candidate declares, which the root of every case lies on.
TEST(Judge, BreaksWhatItsOwnIntervalExcludes) {
  Case one;
  one.scene.rays = {{{0, 0, 0}, {1, 0, 0}}};
  one.scene.spheres = {{{3, 0, 0}, 1}};
  const auto judged = [&](double least, Precision precision) {
    Candidate candidate("at-end");
    candidate.roots = Roots::declared;
    candidate.declares.valid = {.t_min = 2, .ends = Ends::open};
    candidate.precision = precision;
    candidate.intersect = [least](const Ray&, const Sphere&, const Conventions&) {
      return std::optional<Hit>({least, {least, 0, 0}});
    };
    return judge_case(candidate, "nearest-root", one);
  };
  for (const Precision precision : {Precision::double_, Precision::single}) {
    const Verdict wrong = judged(2, precision);
    EXPECT_EQ(wrong.finding, Finding::broken) << wrong.text;
    EXPECT_TRUE(has(wrong.text, "answers s = 2, which its own interval (2, inf) excludes"));
    EXPECT_NE(judged(4, precision).finding, Finding::broken);
  }
}

TEST(Judge, HoldsACandidateToWhatItReturnsOnTheDirectionsThatItAccepts) {
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
  distances.returns = Returns::parameter;  // on unit directions both are one
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

TEST(Judge, CountsWhatIsThrownAsNoAnswer) {
  Candidate throws("throws");
  throws.intersect = [](const Ray&, const Sphere&, const Conventions&) -> std::optional<Hit> {
    throw std::runtime_error("no idea");
  };
  const Verdict verdict = judge(throws, "class", "rays");
  EXPECT_EQ(verdict.finding, Finding::broken);
  EXPECT_TRUE(has(verdict.text, "no idea"));
}

TEST(Judge, AsksOnlyAboutWhatThereIs) {
  Candidate frames("frames");
  frames.frame = [](const Camera&) { return Frame{}; };
  const auto all = checks(frames);
  ASSERT_FALSE(all.empty());
  EXPECT_TRUE(
      std::none_of(all.begin(), all.end(), [](const Check& one) { return one.law == "class"; }));
  EXPECT_THROW(checks(Candidate("nothing")), std::invalid_argument);
  const auto refused = [](auto change) {
    Candidate candidate("mine");
    candidate.intersect = [](const Ray&, const Sphere&, const Conventions&) {
      return std::optional<Hit>();
    };
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
  EXPECT_TRUE(refused([](Candidate& c) {
    c.roots = Roots::declared;
    c.declares.valid.t_min = std::nan("");
  }));
  EXPECT_FALSE(refused([](Candidate&) {}));
  EXPECT_THROW(judge(frames, "nothing"), std::invalid_argument);
  EXPECT_THROW(judge(frames, "class", "nowhere"), std::invalid_argument);
  EXPECT_THROW(replay(frames, "nothing"), std::invalid_argument);
}

/// The good tracer's answers, s off by a share, rounded to floats.
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

TEST(SinglePrecision, BreaksWhatIsOffInUlpsOfFloat) {
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
