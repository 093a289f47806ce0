// Enclosures, rounded values, condition numbers and the errors of given answers in arrays are
// those of exact.h.

#include "tests/library/batch.h"

namespace raycheck::tests {
namespace {

/// A number for each ray, and a vector for each ray.
struct Columns {
  std::array<std::vector<double>, 3> of;
  explicit Columns(std::size_t count) {
    for (auto& one : of) one.resize(count);
  }
  raycheck_output number() { return batch::output(of[0]); }
  raycheck_output3 vector() { return batch::output(of[0], of[1], of[2]); }
};

/// The values of rays of all sources are those of exact.h, for given rays and for a camera's.
TEST(Batch, EnclosesRoundsAndConditionsAsExactDoes) {
  Many many = hard_rays();
  many.rays.resize(1500);
  many.spheres.resize(1500);
  const raycheck_camera seen_by = in_c(small_camera());
  const exact::Camera known(small_camera());
  for (const bool is_of_camera : {false, true}) {
    if (is_of_camera) many.spheres.assign(1, {{0, 0, 0}, 4});
    raycheck_rays rays = many.given();
    if (is_of_camera) rays.camera = &seen_by;
    const std::size_t count = is_of_camera ? 48 * 35 : many.rays.size();
    const raycheck_spheres spheres = many.balls();
    const raycheck_options options = batch::options(2);
    Columns s_low(count), s_high(count), Q_low(count), Q_high(count), D_low(count), D_high(count),
        P_low(count), P_high(count), s(count), Q(count), D(count), P(count), s_k(count), Q_k(count),
        D_k(count), P_k(count);
    const raycheck_enclosed ends = {s_low.number(),  s_high.number(), Q_low.vector(),
                                    Q_high.vector(), D_low.vector(),  D_high.vector(),
                                    P_low.vector(),  P_high.vector()};
    const raycheck_values rounded = {s.number(), Q.vector(), D.vector(), P.vector()};
    const raycheck_values numbers = {s_k.number(), Q_k.vector(), D_k.vector(), P_k.vector()};
    ASSERT_EQ(raycheck_enclose(&rays, &spheres, &options, &ends, &batch::error()), RAYCHECK_OK);
    ASSERT_EQ(raycheck_round(&rays, &spheres, &options, &rounded, &batch::error()), RAYCHECK_OK);
    ASSERT_EQ(raycheck_condition(&rays, &spheres, &options, &numbers, &batch::error()),
              RAYCHECK_OK);
    int hits = 0;
    const auto compare = [&](std::size_t k, const exact::Number& number, const Columns& low,
                             const Columns& high, const Columns& value, const Columns& condition,
                             std::size_t axis) {
      const exact::Interval around = number.interval();
      ASSERT_EQ(low.of[axis][k], around.lower);
      ASSERT_EQ(high.of[axis][k], around.upper);
      ASSERT_EQ(value.of[axis][k], number.rounded());
      ASSERT_LE(low.of[axis][k], value.of[axis][k]);
      ASSERT_LE(value.of[axis][k], high.of[axis][k]);
      ASSERT_EQ(condition.of[axis][k], number.condition());
    };
    for (std::size_t k = 0; k < count; ++k) {
      const auto pixel = static_cast<std::int64_t>(k);
      const exact::Ray ray =
          is_of_camera ? known.ray({pixel % 48, pixel / 48}) : exact::Ray(many.rays[k]);
      const exact::Intersection met = ray.hit(many.spheres[is_of_camera ? 0 : k]);
      const exact::Numbers direction = ray.direction(), origin = ray.origin();
      compare(k, direction.y, D_low, D_high, D, D_k, 1);
      compare(k, origin.z, P_low, P_high, P, P_k, 2);
      if (HasFatalFailure()) return;
      if (!met.parameter) {
        ASSERT_TRUE(std::isnan(s.of[0][k]) && std::isnan(Q_high.of[2][k]));
        continue;
      }
      ++hits;
      compare(k, *met.parameter, s_low, s_high, s, s_k, 0);
      compare(k, met.point->x, Q_low, Q_high, Q, Q_k, 0);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(hits, 100);
  }
}

/// Floats are neighbours around the number, and rounded once.
TEST(Batch, RoundsOnceToFloats) {
  Many many;
  // s = 1 + 2^-24 + 2^-54 rounds to 1 + 2^-24 in double, and that to 1 in float.
  many.add({{0, 0, 0}, {1, 0, 0}}, {{3 + 0x1p-24, 0x1p-26, 0}, 2});
  const raycheck_rays rays = many.given();
  const raycheck_spheres spheres = many.balls();
  const raycheck_options options = batch::options();
  std::vector<float> s(1), low(1), high(1);
  raycheck_values to = {};
  to.s = batch::output(s);
  raycheck_enclosed ends = {};
  ends.s_lower = batch::output(low);
  ends.s_upper = batch::output(high);
  ASSERT_EQ(raycheck_round(&rays, &spheres, &options, &to, &batch::error()), RAYCHECK_OK);
  ASSERT_EQ(raycheck_enclose(&rays, &spheres, &options, &ends, &batch::error()), RAYCHECK_OK);
  EXPECT_EQ(s[0], std::nextafter(1.0F, 2.0F));
  EXPECT_EQ(low[0], 1.0F);
  EXPECT_EQ(high[0], std::nextafter(1.0F, 2.0F));
}

/// Bounds and condition numbers of floats are not below those of doubles.
TEST(Batch, RoundsBoundsOfFloatsUp) {
  const raycheck_camera camera = in_c(small_camera());
  Many many;
  many.spheres = some_spheres(12);
  raycheck_spheres spheres = many.balls();
  const raycheck_options options = batch::options();
  const std::size_t pixels = 48 * 35;
  std::vector<double> s(pixels), bound(pixels);
  std::vector<float> s_single(pixels), bound_single(pixels);
  raycheck_seen seen = {}, single = {};
  seen.s = batch::output(s);
  seen.s_error = batch::output(bound);
  single.s = batch::output(s_single);
  single.s_error = batch::output(bound_single);
  ASSERT_EQ(raycheck_image(&camera, &spheres, &options, &seen, nullptr), RAYCHECK_OK);
  ASSERT_EQ(raycheck_image(&camera, &spheres, &options, &single, nullptr), RAYCHECK_OK);
  int seen_pixels = 0;
  for (std::size_t k = 0; k < pixels; ++k) {
    if (!std::isfinite(s[k])) continue;
    ++seen_pixels;
    ASSERT_GE(static_cast<double>(bound_single[k]),
              std::abs(static_cast<double>(s_single[k]) - s[k]) + bound[k])
        << k;
  }
  EXPECT_GT(seen_pixels, 80);
  // The same bounds, whose s are doubles.
  single.s = batch::output(s);
  ASSERT_EQ(raycheck_image(&camera, &spheres, &options, &single, nullptr), RAYCHECK_OK);
  for (std::size_t k = 0; k < pixels; ++k)
    ASSERT_GE(static_cast<double>(bound_single[k]), bound[k]);
  raycheck_rays rays = {};
  rays.camera = &camera;
  spheres.centre.count = spheres.radius.count = 1;
  raycheck_values to = {}, to_single = {};
  to.s = batch::output(bound);
  to_single.s = batch::output(bound_single);
  ASSERT_EQ(raycheck_condition(&rays, &spheres, &options, &to, nullptr), RAYCHECK_OK);
  ASSERT_EQ(raycheck_condition(&rays, &spheres, &options, &to_single, nullptr), RAYCHECK_OK);
  int hits = 0;
  for (std::size_t k = 0; k < pixels; ++k) {
    if (std::isnan(bound[k])) continue;
    ++hits;
    ASSERT_GE(static_cast<double>(bound_single[k]), bound[k]);
  }
  EXPECT_GT(hits, 5);
}

/// Errors are those that exact.h measures; wrong classes, roots and excuses are found.
TEST(Batch, JudgesTheAnswersOfOthers) {
  Many many = hard_rays();
  ASSERT_EQ(many.decide(), RAYCHECK_OK);
  const std::size_t count = many.rays.size();
  std::vector<std::uint8_t> is_hit(count);
  std::vector<double> s = many.s;
  std::vector<int> wrong_class(count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    is_hit[k] = many.hit_class[k] == RAYCHECK_MISS ? 0 : 1;
    if (k % 5 == 0) s[k] = std::nextafter(std::nextafter(s[k], kInfinity), kInfinity);
    if (k % 11 == 0) {
      is_hit[k] = 1 - is_hit[k];
      wrong_class[k] = 1;
      if (is_hit[k] == 1) s[k] = 1;
    }
  }
  const raycheck_rays rays = many.given();
  const raycheck_spheres spheres = many.balls();
  std::vector<std::uint8_t> class_error(count), root_error(count), excused(count);
  std::vector<double> s_ulp(count), point_u(count);
  raycheck_answers answers = {};
  answers.is_hit = batch::array(is_hit);
  answers.s = batch::array(s);
  answers.point = batch::array(many.point[0], many.point[1], many.point[2]);
  const raycheck_errors to = {batch::output(class_error), batch::output(root_error),
                              batch::output(excused), batch::output(s_ulp), batch::output(point_u)};
  const raycheck_options options = batch::options(2);
  ASSERT_EQ(raycheck_error_of(&rays, &spheres, &options, &answers, &to, &batch::error()),
            RAYCHECK_OK);
  int compared = 0, excuses = 0, convicted = 0;
  for (std::size_t k = 0; k < count; ++k) {
    ASSERT_EQ(class_error[k], wrong_class[k]) << k;
    excuses += excused[k];
    convicted += class_error[k] != 0 && excused[k] == 0 ? 1 : 0;
    if (class_error[k] != 0 || is_hit[k] == 0) {
      ASSERT_EQ(s_ulp[k], 0);
      continue;
    }
    ASSERT_EQ(excused[k], 0);
    if (k % 3 != 0) continue;
    ++compared;
    const double expected = exact::hit(many.rays[k], many.spheres[k]).parameter->ulp_error(s[k]);
    ASSERT_GE(s_ulp[k], expected * (1 - 1e-4)) << k;
    ASSERT_LE(s_ulp[k], expected * (1 + 1e-4) + 0x1p-12) << k;
    if (!std::isfinite(many.s[k])) continue;
    const auto size = [&](const auto& of) { return std::hypot(of[0][k], of[1][k], of[2][k]); };
    ASSERT_LE(point_u[k] * 0x1p-53 * size(many.point), size(many.point_error) * 1.001) << k;
  }
  EXPECT_GT(compared, 5000);
  EXPECT_GT(excuses, 50);
  EXPECT_GT(convicted, 500);
  // The far root, and none that is near it.
  Many two;
  two.add({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, 1});
  two.add({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, 1});
  const std::vector<double> roots = {6, 4.4};
  const std::vector<std::int32_t> hits = {1, 1};
  const raycheck_rays its_rays = two.given();
  const raycheck_spheres its_spheres = two.balls();
  answers = {};
  answers.is_hit = batch::array(hits);
  answers.s = batch::array(roots);
  std::vector<std::int32_t> wrong(2);
  raycheck_errors only = {};
  only.root = batch::output(wrong);
  ASSERT_EQ(raycheck_error_of(&its_rays, &its_spheres, &options, &answers, &only, &batch::error()),
            RAYCHECK_OK);
  EXPECT_EQ(wrong[0], 1);
  EXPECT_EQ(wrong[1], 0);
}

/// The roots are 1 and 1 - 2/(D^2 + 1), which rounds to 1, too, or to the number below.
TEST(Batch, ConvictsNoRoundedRoot) {
  Many two;
  for (const double D : {0x1p28, 0x1p27}) two.add({{0, 0, 0}, {1, 0, D}}, {{0, 0, D}, 1});
  ASSERT_EQ(two.decide(), RAYCHECK_OK);
  EXPECT_EQ(two.root[0], 0);
  const std::vector<double> s = {1, 1 - 0x1p-53};
  const std::vector<std::uint8_t> hits = {1, 1};
  EXPECT_EQ(two.s[0], s[0]);
  const raycheck_rays rays = two.given();
  const raycheck_spheres spheres = two.balls();
  raycheck_answers answers = {};
  answers.is_hit = batch::array(hits);
  answers.s = batch::array(s);
  std::vector<std::uint8_t> wrong(2, 77);
  raycheck_errors to = {};
  to.root = batch::output(wrong);
  const raycheck_options options = batch::options();
  ASSERT_EQ(raycheck_error_of(&rays, &spheres, &options, &answers, &to, &batch::error()),
            RAYCHECK_OK);
  EXPECT_EQ(wrong[0], 0);
  EXPECT_EQ(wrong[1], 0);
}

/// The square of |Q| overflows; the second answer is off by 2^-30 of |Q|.
TEST(Batch, MeasuresPointsThatAreFarFromTheOrigin) {
  Many two;
  for (int k = 0; k < 2; ++k) two.add({{0x1p530, 0, 0}, {0, 1, 0}}, {{0x1p530, 5, 0}, 1});
  ASSERT_EQ(two.decide(), RAYCHECK_OK);
  const std::vector<std::uint8_t> hits = {1, 1};
  two.point[1] = {4, 0x1p500};
  const raycheck_rays rays = two.given();
  const raycheck_spheres spheres = two.balls();
  raycheck_answers answers = {};
  answers.is_hit = batch::array(hits);
  answers.point = batch::array(two.point[0], two.point[1], two.point[2]);
  std::vector<double> point_u(2);
  raycheck_errors to = {};
  to.point_u = batch::output(point_u);
  const raycheck_options options = batch::options();
  ASSERT_EQ(raycheck_error_of(&rays, &spheres, &options, &answers, &to, &batch::error()),
            RAYCHECK_OK);
  EXPECT_LE(point_u[0], 0x1p-12);
  EXPECT_NEAR(point_u[1], 0x1p23, 0x1p8);
}

/// Ray 0 passes the sphere at 2^-50, ray 1 at 1.
TEST(Batch, ExcusesHitsWithoutTheirS) {
  Many two;
  for (const double gap : {0x1p-50, 1.0}) two.add({{0, 1 + gap, 0}, {0, 0, 1}}, {{0, 0, 5}, 1});
  const std::vector<std::uint8_t> hits = {1, 1};
  const raycheck_rays rays = two.given();
  const raycheck_spheres spheres = two.balls();
  raycheck_answers answers = {};
  answers.is_hit = batch::array(hits);
  std::vector<std::uint8_t> wrong(2), excused(2, 77);
  raycheck_errors to = {};
  to.hit_class = batch::output(wrong);
  to.excused = batch::output(excused);
  const raycheck_options options = batch::options();
  ASSERT_EQ(raycheck_error_of(&rays, &spheres, &options, &answers, &to, &batch::error()),
            RAYCHECK_OK);
  EXPECT_EQ(wrong, (std::vector<std::uint8_t>{1, 1}));
  EXPECT_EQ(excused, (std::vector<std::uint8_t>{1, 0}));
}

}  // namespace
}  // namespace raycheck::tests
