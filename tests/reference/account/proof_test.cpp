#include "reference/account/proof.h"

#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using namespace scene;

void expect_dyadic(const Dyadic& got, const char* integer, std::int64_t exponent) {
  EXPECT_EQ(got.integer, integer);
  EXPECT_EQ(got.exponent, exponent);
}

void expect_bracket(const Bracket& got, const char* low, const char* high, std::int64_t exponent) {
  EXPECT_EQ(got.low, low);
  EXPECT_EQ(got.high, high);
  EXPECT_EQ(got.exponent, exponent);
}

TEST(Proof, WritesDoublesAsOddIntegersTimesPowersOfTwo) {
  expect_dyadic(dyadic(0), "0", 0);
  expect_dyadic(dyadic(-0.0), "0", 0);
  expect_dyadic(dyadic(1), "1", 0);
  expect_dyadic(dyadic(-0.75), "-3", -2);
  expect_dyadic(dyadic(48), "3", 4);
  expect_dyadic(dyadic(0.1), "3602879701896397", -55);
  expect_dyadic(dyadic(kSmallest), "1", -1074);
  expect_dyadic(dyadic(kLargest), "9007199254740991", 971);
}

TEST(Proof, StatesOnlyWhatDecides) {
  const auto proven = [](const Sphere& sphere, scene::Tangent tangent) {
    Conventions conventions;
    conventions.tangent = tangent;
    const std::vector<Sphere> spheres = {sphere};
    Proposition wanted;
    wanted.spheres = spheres;
    wanted.other_roots = true;
    return Prover(Ray{{0, 0, 0}, {1, 0, 0}}, conventions).prove(wanted).value().meetings.at(0);
  };
  const ProvenMeeting beside = proven({{9, 5, 0}, 4}, scene::Tangent::kHit);
  EXPECT_FALSE(beside.met);
  expect_bracket(beside.discriminant, "-9", "-9", 0);
  EXPECT_FALSE(beside.c || beside.b || beside.s || beside.other_s);

  const ProvenMeeting inside = proven({{1, 0, 0}, 4}, scene::Tangent::kHit);
  EXPECT_TRUE(inside.met);
  EXPECT_EQ(inside.intersection.root, WhichRoot::kLarger);
  EXPECT_TRUE(inside.c.has_value());
  EXPECT_FALSE(inside.b.has_value()) << "c < 0 says it all";
  expect_bracket(inside.s.value(), "5", "5", 0);
  expect_bracket(inside.other_s.value(), "-3", "-3", 0);

  const ProvenMeeting behind = proven({{-9, 0, 0}, 4}, scene::Tangent::kHit);
  EXPECT_FALSE(behind.met);
  EXPECT_TRUE(behind.c && behind.b && !behind.s);

  const ProvenMeeting touched = proven({{9, 4, 0}, 4}, scene::Tangent::kHit);
  EXPECT_TRUE(touched.met);
  expect_bracket(touched.discriminant, "0", "0", 0);
  expect_bracket(touched.s.value(), "9", "9", 0);
  EXPECT_FALSE(touched.other_s.has_value()) << "a double root";

  const ProvenMeeting missed = proven({{9, 4, 0}, 4}, scene::Tangent::kMiss);
  EXPECT_FALSE(missed.met);
  EXPECT_FALSE(missed.c || missed.b || missed.s);
}

/// A camera with the eye at the origin. Pixel (0, 0) is at 3 U - 4 W, 5 away from the eye.
Camera camera_345(const scene::Point3& look_at) {
  return {{0, 0, 0}, look_at, {0, 1, 0}, -4, {}, 3, 6, 0, 1, 2, 2};
}

// The pixel point lies on the sphere of radius 5 about the eye. For an oblique camera this is so
// because |3 U - 4 W| = 5 for orthonormal axes, which no bracket of sqrt(3) and sqrt(2) shows.
TEST(Proof, IsEmptyIfOnlySquareRootsMakeATie) {
  const std::vector<Sphere> spheres = {{{0, 0, 0}, 5}};
  Proposition wanted;
  wanted.spheres = spheres;
  const auto plain = Prover(camera_345({0, 0, -2}), {}, scene::Pixel{0, 0}).prove(wanted);
  ASSERT_TRUE(plain.has_value());
  EXPECT_TRUE(plain->meetings.at(0).met);
  expect_bracket(plain->meetings.at(0).s.value(), "0", "0", 0);
  EXPECT_FALSE(Prover(camera_345({1, 1, 1}), {}, scene::Pixel{0, 0}).prove(wanted).has_value());
  const std::vector<Sphere> larger = {{{0, 0, 0}, std::nextafter(5.0, 6.0)}};
  wanted.spheres = larger;
  EXPECT_TRUE(Prover(camera_345({1, 1, 1}), {}, scene::Pixel{0, 0}).prove(wanted).has_value());
}

TEST(Proof, ShowsTheOrderOfSpheres) {
  const Prover prover(Ray{{-5, 0, 0}, {3, 0, 0}}, Conventions{});
  const auto is_shown = [&](const std::vector<Sphere>& spheres) {
    Proposition wanted;
    wanted.order = true;
    wanted.spheres = spheres;
    return prover.prove(wanted).has_value();
  };
  EXPECT_TRUE(is_shown({{{0, 0, 0}, 1}, {{0, 0, 0}, 1}})) << "the same sphere twice";
  EXPECT_TRUE(is_shown({{{0, 0, 0}, 1}, {{0, 0, 0}, std::nextafter(1.0, 2.0)}}));
  // Both are met at s = 4/3, which no dyadic bracket shows.
  EXPECT_FALSE(is_shown({{{0, 0, 0}, 1}, {{1, 0, 0}, 2}}));
}

TEST(Proof, RefusesInvalidInput) {
  EXPECT_THROW(Prover(Ray{{0, 0, 0}, {0, 0, 0}}, Conventions{}), std::invalid_argument);
  EXPECT_THROW(Prover(camera_345({0, 0, 0}), {}, scene::Pixel{0, 0}), std::invalid_argument);
  EXPECT_THROW(Prover(camera_345({0, 0, -2}), {}, scene::Pixel{2, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace raycheck::reference
