// How large rectangles are.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

#include "scene/plan/plan.h"

namespace raycheck::scene {
namespace {

/// What is asserted: in the indices of pixels, as real numbers, each side of a silhouette's box
/// lies x; a rectangle then begins at ceil(x) and ends after floor(x), or up to kRectangleSlack
/// farther out where x is so near to a whole number that its bounds hold that.
class Tightness {
 public:
  explicit Tightness(const Camera& camera) : camera_(camera) {}

  void compare(const Sphere& sphere, const PixelRectangle& pixels) {
    const long double z = -sphere.centre.z;
    compare(sides(sphere.centre.x, z, sphere.radius), camera_.left, camera_.right, camera_.width,
            pixels.i_begin, pixels.i_end);
    compare(sides(sphere.centre.y, z, sphere.radius), camera_.bottom, camera_.top, camera_.height,
            pixels.j_begin, pixels.j_end);
  }
  int sides_compared() const { return sides_compared_; }
  int as_tight_as_can_be() const { return tight_; }

 private:
  using Range = std::pair<long double, long double>;

  /// The slopes at the angles of the tangents.
  static Range sides(long double x, long double z, long double r) {
    const long double middle = std::atan2(x, z);
    const long double half = std::asin(r / std::hypot(x, z));
    return {std::tan(middle - half), std::tan(middle + half)};
  }

  void compare(const Range& slopes, double first, double last, std::int64_t count,
               std::int64_t begin, std::int64_t end) {
    const auto index = [&](long double slope) {
      return (slope * -static_cast<long double>(camera_.near) - first) /
             (static_cast<long double>(last) - first) * static_cast<long double>(count - 1);
    };
    const auto low = static_cast<std::int64_t>(std::ceil(index(slopes.first)));
    const auto high = static_cast<std::int64_t>(std::floor(index(slopes.second))) + 1;
    if (low > 0) side(low, begin, begin);
    if (high < count) side(-high, -end, end);
  }
  void side(std::int64_t exact, std::int64_t got, std::int64_t shown) {
    ++sides_compared_;
    tight_ += got == exact ? 1 : 0;
    EXPECT_LE(got, exact) << shown;
    EXPECT_GE(got, exact - kRectangleSlack) << shown;
  }

  Camera camera_;
  int sides_compared_ = 0, tight_ = 0;
};

TEST(Rectangle, IsNoLargerThanTheSilhouettesBoxCallsFor) {
  std::mt19937_64 engine(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  int compared = 0, tight = 0;
  for (int k = 0; k < 4000; ++k) {
    Camera camera;
    camera.look_at = {0, 0, -1};
    camera.up = {0, 1, 0};
    camera.near = -between(0.1, 10);
    camera.left = camera.near * between(0.2, 2);
    camera.right = -camera.near * between(0.2, 2);
    camera.bottom = camera.near * between(0.2, 2);
    camera.top = -camera.near * between(0.2, 2);
    camera.width = 2 + static_cast<std::int64_t>(engine() % 2000);
    camera.height = 2 + static_cast<std::int64_t>(engine() % 2000);
    const double z = between(12, 100);
    const double x = z * between(-1, 1), y = z * between(-1, 1);
    Scene scene;
    scene.camera = camera;
    scene.spheres.push_back({{x, y, -z}, z * between(0.01, 0.3)});
    const SpherePlan plan =
        plan_scene(scene, {}, Wanted::kClass, {.basis = k % 2 == 0}).spheres.front();
    if (plan.left_out) continue;
    Tightness tightness(camera);
    tightness.compare(scene.spheres.front(), plan.pixels);
    compared += tightness.sides_compared();
    tight += tightness.as_tight_as_can_be();
  }
  EXPECT_GT(compared, 4000);
  EXPECT_GT(1000 * tight, 999 * compared);
}

}  // namespace
}  // namespace raycheck::scene
