// What the library says is what the reference says, and its own ways of writing a number agree.

#include <gtest/gtest.h>
#include <raycheck/cases.h>
#include <raycheck/exact.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "tests/has.h"

namespace raycheck::tests {
namespace {

/// From shared lecture answers: eye (0, 0, 0), sphere ((0, 0, 5), 1).
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
/// As a program has it that is linked with -ffast-math.
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
  // |(2, 1, 0) - s (1, 1, 0)| = 1: s = (3 - 1)/2 or 2, so the direction (1, 2, 0) is taken: 5 s^2 -
  // 8 s + 4 = 0 has s = (4 - 2)/5 at radius sqrt(...); by hand for the sphere ((3, 1, 0), 2):
  // 5 s^2 - 10 s + 6 = 0 has no root, and ((3, 1, 0), 3): 5 s^2 - 10 s + 1 = 0, s = 1 - sqrt(20)/5.
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
  EXPECT_EQ(s.ulp_error(std::numeric_limits<double>::infinity()),
            std::numeric_limits<double>::infinity());
  EXPECT_THROW(s.enclosure(1), std::invalid_argument);
  EXPECT_THROW(s.enclosure(1 << 20), std::invalid_argument);
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

TEST(Exact, FindsTheNearestAndItsTies) {
  const Ray ray{{0, 0, 0}, {0, 0, 1}};
  const auto found = exact::nearest(ray, {{{0, 0, 9}, 1}, {{0, 0, 5}, 1}, {{0, 0, 6}, 2}});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->index, 1u);
  EXPECT_EQ(found->ties, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(found->intersection.parameter->rounded(), 4);
  EXPECT_FALSE(exact::nearest(ray, {{{0, 0, -9}, 1}}));
}

Camera square_camera() {
  Camera camera;
  camera.eye = {0, 0, 10};
  camera.up = {0, 1, 0};
  camera.near_plane = -2;
  camera.left = camera.bottom = -1;
  camera.right = camera.top = 1;
  camera.width = camera.height = 3;
  return camera;
}

TEST(Exact, KnowsACamera) {
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

TEST(Exact, RefusesWhatIsNoProblem) {
  const Ray none{{0, 0, 0}, {0, 0, 0}};
  EXPECT_THROW(exact::hit(none, {{0, 0, 5}, 1}), std::invalid_argument);
  EXPECT_THROW(exact::hit({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, -1}), std::invalid_argument);
  EXPECT_THROW(exact::Camera{Camera{}}, std::invalid_argument);
  std::vector<Conventions> wrong(5);
  wrong[0].valid.t_min = std::nan("");
  wrong[1].valid.t_min = -1;
  wrong[2].valid = {7, 3};
  wrong[3].valid.ends = static_cast<Ends>(9);
  wrong[4].root = static_cast<Root>(9);
  for (const Conventions& one : wrong) {
    EXPECT_THROW(exact::hit({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, 1}, one), std::invalid_argument);
  }
}

TEST(Cases, AreTheSameByTheirSeed) {
  for (const Source& source : sources()) {
    const Case one = make_case(source.name, 7, 3, source.highest);
    EXPECT_EQ(scene_text(one), scene_text(make_case(source.name, 7, 3, source.highest)));
    EXPECT_NE(scene_text(one), scene_text(make_case(source.name, 7, 4, source.highest)))
        << source.name;
    EXPECT_EQ(one.scene.camera.has_value(), source.has_camera);
    EXPECT_THROW(make_case(source.name, 7, 3, source.highest + 1), std::invalid_argument);
  }
  EXPECT_THROW(make_case("nowhere", 1), std::invalid_argument);
}

/// Every double has a spelling of its own, -0 and subnormal ones, too.
TEST(Cases, ReadBackAsTheyAreWritten) {
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

TEST(Cases, AreMadeOfAnyBytes) {
  std::string bytes;
  int made = 0;
  for (int k = 0; k < 500; ++k) {
    bytes.push_back(static_cast<char>(k * k * 37 + k));
    const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    if (case_of_bytes(data, bytes.size() % 40)) ++made;
  }
  EXPECT_GT(made, 50);
}

}  // namespace
}  // namespace raycheck::tests
