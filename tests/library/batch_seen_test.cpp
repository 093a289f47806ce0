// Nearest spheres and images of the flat interface are those of the exact rays, with their ties.

#include "tests/library/batch.h"

namespace raycheck::tests {
namespace {

/// The answers about nearest spheres.
struct Seen {
  std::vector<std::int32_t> sphere, ties;
  std::vector<double> s, s_error, x, y, z;
  explicit Seen(std::size_t count)
      : sphere(count), ties(count), s(count), s_error(count), x(count), y(count), z(count) {}
  raycheck_seen to() {
    return {batch::output(sphere), batch::output(ties), batch::output(s), batch::output(x, y, z),
            batch::output(s_error)};
  }
  void compare(std::size_t k, const std::optional<exact::Nearest>& truth) {
    ASSERT_EQ(sphere[k], truth ? static_cast<int>(truth->index) : -1) << k;
    ASSERT_EQ(ties[k], truth ? static_cast<int>(truth->ties.size()) : 0) << k;
    if (!truth) {
      ASSERT_EQ(s[k], kInfinity);
      return;
    }
    ASSERT_LE(error_of(s[k], *truth->intersection.parameter), s_error[k] * (1 + 1e-4));
    ASSERT_LE(error_of(z[k], truth->intersection.point->z), 1e-5);
  }
};

TEST(Batch, FindsTheNearestSpheresAndTheirTies) {
  Many many;
  std::mt19937 random(8);
  const auto any = [&] { return static_cast<double>(static_cast<int>(random() % 7)) - 3; };
  while (many.rays.size() < 3000) {
    const Ray ray{{any(), any(), any() - 8}, {any() / 4, any() / 4, 1 + any() / 16}};
    many.rays.push_back(ray);
  }
  many.spheres = some_spheres(20);
  for (int k = 0; k < 30; ++k) many.spheres.push_back({{any(), any(), any()}, std::abs(any())});
  for (const auto& [tangent, t_max] :
       {std::pair(Tangent::hit, kInfinity), {Tangent::miss, kInfinity}, {Tangent::hit, 8.0}}) {
    Conventions conventions;
    conventions.tangent = tangent;
    conventions.valid.t_max = t_max;
    const raycheck_asked asked = asked_of(conventions);
    many.options.asked = &asked;
    const raycheck_rays rays = many.given();
    const raycheck_spheres spheres = many.balls();
    for (const int threads : {1, 2}) {
      many.options.threads = threads;
      Seen seen(many.rays.size());
      const raycheck_seen to = seen.to();
      ASSERT_EQ(raycheck_nearest(&rays, &spheres, &many.options, &to, &batch::error()),
                RAYCHECK_OK);
      int tied = 0;
      for (std::size_t k = 0; k < many.rays.size(); ++k) {
        seen.compare(k, exact::nearest(many.rays[k], many.spheres, conventions));
        if (HasFatalFailure()) return;
        tied += seen.ties[k] > 1 ? 1 : 0;
      }
      EXPECT_GT(tied, 50);
    }
  }
  many.spheres[3].radius = -1;  // is left out, and named
  many.rays[7].direction = {0, 0, 0};
  const raycheck_rays rays = many.given();
  const raycheck_spheres spheres = many.balls();
  many.options.asked = nullptr;
  Seen seen(many.rays.size());
  const raycheck_seen to = seen.to();
  ASSERT_EQ(raycheck_nearest(&rays, &spheres, &many.options, &to, &batch::error()),
            RAYCHECK_INVALID_INPUT);
  EXPECT_EQ(batch::error().index, 7u);
  EXPECT_TRUE(std::isnan(seen.s[7]) && seen.sphere[7] == -1);
  many.spheres[3] = {{1e6, 0, 0}, 1};
  seen.compare(8, exact::nearest(many.rays[8], many.spheres));
}

TEST(Batch, DrawsTheImageOfTheExactRays) {
  Camera camera = small_camera();
  std::vector<Sphere> spheres = some_spheres(12);
  // Two spheres that meet in a plane through the eye, in a column of pixels.
  for (const Origin origin : {Origin::pixel, Origin::focal}) {
    Conventions conventions;
    conventions.origin = origin;
    const raycheck_asked asked = asked_of(conventions);
    raycheck_options options = batch::options(2, &asked);
    const raycheck_camera seen_by = in_c(camera);
    Many many;
    many.spheres = spheres;
    const raycheck_spheres balls = many.balls();
    const std::size_t pixels = 48 * 35;
    Seen seen(pixels);
    const raycheck_seen to = seen.to();
    ASSERT_EQ(raycheck_image(&seen_by, &balls, &options, &to, &batch::error()), RAYCHECK_OK)
        << batch::error().reason;
    const exact::Camera known(camera, conventions);
    int tied = 0, seen_pixels = 0;
    for (std::size_t k = 0; k < pixels; ++k) {
      const auto pixel = static_cast<std::int64_t>(k);
      seen.compare(k, known.ray({pixel % 48, pixel / 48}).nearest(spheres, conventions));
      if (HasFatalFailure()) return;
      tied += seen.ties[k] > 1 ? 1 : 0;
      seen_pixels += seen.sphere[k] >= 0 ? 1 : 0;
    }
    EXPECT_GT(tied, 20);
    EXPECT_GT(seen_pixels, 80);
  }
}

/// Mirror images: every pixel of the middle column meets both spheres at one s.
TEST(Batch, CountsTheTiesOfDifferentSpheresInAnImage) {
  const Camera camera{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, -1, -.2, .2, -.2, .2, 33, 33};
  Many many;
  many.spheres = {{{-0.5, 0, 0}, 1}, {{0.5, 0, 0}, 1}, {{0.5, 0, 0}, 1}, {{7, 7, 7}, -1}};
  const raycheck_camera seen_by = in_c(camera);
  const raycheck_spheres balls = many.balls();
  const raycheck_options options = batch::options();
  std::vector<std::int64_t> sphere(33 * 33), ties(33 * 33);
  raycheck_seen to = {};
  to.ties = batch::output(ties);
  to.sphere = batch::output(sphere);
  ASSERT_EQ(raycheck_image(&seen_by, &balls, &options, &to, &batch::error()),
            RAYCHECK_INVALID_INPUT);
  EXPECT_EQ(batch::error().index, 3u);
  EXPECT_EQ(ties[16 * 33 + 16], 3);
  EXPECT_EQ(sphere[16 * 33 + 16], 0);
  EXPECT_EQ(ties[16 * 33 + 17], 2);
  EXPECT_EQ(sphere[16 * 33 + 17], 1);
  EXPECT_EQ(ties[16 * 33 + 15], 1);
  EXPECT_EQ(ties[0], 0);
  EXPECT_EQ(sphere[0], -1);
}

}  // namespace
}  // namespace raycheck::tests
