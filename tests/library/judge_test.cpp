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
  EXPECT_GT(tests.questions().size(), 100u);
  std::size_t told = 0;
  for (const Question& question : tests.questions()) {
    const LawOutcome outcome = tests.run(question);
    EXPECT_TRUE(outcome.passes) << outcome.text;
    told += outcome.says_too_little ? 0 : 1;
  }
  EXPECT_GT(told, tests.questions().size() * 2 / 3);
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
  const auto all = questions(frames);
  ASSERT_FALSE(all.empty());
  EXPECT_TRUE(
      std::none_of(all.begin(), all.end(), [](const Question& one) { return one.law == "class"; }));
  EXPECT_THROW(questions(Candidate("nothing")), std::invalid_argument);
  const auto refused = [](auto change) {
    Candidate candidate("mine");
    candidate.intersect = [](const Ray&, const Sphere&, const Conventions&) {
      return std::optional<Hit>();
    };
    change(candidate);
    const LawTests tests(candidate);
    if (tests.questions().size() != 1) return false;
    const LawOutcome outcome = tests.run(tests.questions().front());
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

/// A sphere in float: by q where it is careful, by the textbook's differences where it is not.
std::optional<Hit> meet(const Ray& ray, const Sphere& sphere, const Conventions& by, bool careful) {
  const auto x = [](double value) { return static_cast<float>(value); };
  const float tx = x(sphere.centre.x) - x(ray.origin.x), ty = x(sphere.centre.y) - x(ray.origin.y),
              tz = x(sphere.centre.z) - x(ray.origin.z);
  const float dx = x(ray.direction.x), dy = x(ray.direction.y), dz = x(ray.direction.z);
  const float r = x(sphere.radius), a = dx * dx + dy * dy + dz * dz,
              b = tx * dx + ty * dy + tz * dz;
  float c = tx * tx + ty * ty + tz * tz - r * r, disc = b * b - a * c;
  if (careful) {
    const float mx = ty * dz - tz * dy, my = tz * dx - tx * dz, mz = tx * dy - ty * dx;
    const float t = std::sqrt(tx * tx + ty * ty + tz * tz);
    disc = a * r * r - (mx * mx + my * my + mz * mz);
    c = (t - r) * (t + r);
  }
  if (disc < 0 || (disc == 0 && by.tangent == Tangent::miss)) return {};
  const float q = b + std::copysign(std::sqrt(disc), b);
  float one = careful ? q / a : (b - std::sqrt(disc)) / a;
  float other = careful ? (q == 0 ? 0 : c / q) : (b + std::sqrt(disc)) / a;
  if (other < one) std::swap(one, other);
  const float s = one < 0 && by.root != Root::smaller ? other : one;
  if (s < 0) return {};
  return Hit{s, {x(ray.origin.x) + s * dx, x(ray.origin.y) + s * dy, x(ray.origin.z) + s * dz}};
}

Candidate floats(bool careful) {
  Candidate candidate(careful ? "careful" : "textbook");
  candidate.precision = Precision::single;
  candidate.intersect = [careful](const Ray& ray, const Sphere& sphere, const Conventions& by) {
    return meet(ray, sphere, by, careful);
  };
  return candidate;
}

TEST(SinglePrecision, LetsCarefulFloatsPassEveryLaw) {
  const Candidate candidate = floats(true);
  int held = 0;
  for (const Law& law : laws()) {
    const Verdict verdict = judge(candidate, law.name);
    EXPECT_TRUE(verdict.passes()) << verdict.text;
    held += verdict.finding == Finding::holds ? 1 : 0;
  }
  EXPECT_GE(held, 7);
}

TEST(SinglePrecision, BreaksATextbooksFormulaInUlpsOfFloat) {
  const Verdict verdict = judge(floats(false), "parameter");
  EXPECT_EQ(verdict.finding, Finding::broken);
  EXPECT_TRUE(has(verdict.text, "ulp of float"));
  ASSERT_TRUE(verdict.broken);
  const Sphere& sphere = verdict.broken->shrunk.scene.spheres.at(0);
  EXPECT_EQ(sphere.radius, static_cast<float>(sphere.radius));
  EXPECT_EQ(replay(floats(false), verdict.broken->replay).finding, Finding::broken);
}

TEST(SinglePrecision, OfDoublesIsNoneUnlessItIsDeclared) {
  Candidate undeclared = floats(true);
  undeclared.precision = Precision::double_;
  EXPECT_EQ(judge(undeclared, "parameter", "rays").finding, Finding::broken);
}

TEST(SinglePrecision, LeavesOutACaseThatFloatsCannotHold) {
  Case wide;
  wide.scene.rays = {{{0, 0, 0}, {1, 0, 0}}};
  wide.scene.spheres = {{{1e60, 0, 0}, 1}};
  const Verdict verdict = judge_case(floats(true), "class", wide);
  EXPECT_EQ(verdict.finding, Finding::left_out);
  EXPECT_TRUE(has(verdict.reason, "1e+60"));
}

}  // namespace
}  // namespace raycheck::tests
