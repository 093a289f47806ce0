// Candidates in float that are linked in.

#include <gtest/gtest.h>
#include <raycheck/judge.h>

#include <cmath>
#include <string>

namespace raycheck::tests {
namespace {

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
  EXPECT_NE(verdict.text.find("ulp of float"), std::string::npos) << verdict.text;
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
  EXPECT_NE(verdict.reason.find("1e+60"), std::string::npos) << verdict.reason;
}

}  // namespace
}  // namespace raycheck::tests
