// Compares what may be seen in a pixel's square with what rays through a lattice of its points
// meet: the pixels of a camera with more of them, whose outermost samples are on the edges.

#include "reference/account/nearby_choice.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using namespace scene;
using What = FirstMet::What;

constexpr std::int64_t kFiner = 8;
/// Claims that no point of the lattice shows may be true between its points, but only of slivers.
constexpr double kLeastRefuted = 0.98;

TEST(PixelSquare, claims_seen_at_some_point_are_not_refuted_and_nearly_all_others_are) {
  Random random(45);
  std::size_t unseen = 0, refuted = 0, seen = 0;
  for (int round = 0; round < 300; ++round) {
    Camera camera = random_camera(random, Sizes::kOrdinary);
    camera.left = camera.bottom = -(camera.right = camera.top = -0.3 * camera.near);
    std::vector<Sphere> spheres;
    for (int k = 0; k < 3; ++k) {
      const auto off = triple<Vector3>(random, Sizes::kOrdinary, 3);
      const Point3& middle = camera.look_at;
      spheres.push_back(
          {{middle.x + off.x, middle.y + off.y, middle.z + off.z}, random.between(0.5, 4)});
    }
    Conventions conventions = random_conventions(random);
    const ExactCamera exact(camera, conventions);
    conventions.samples = Samples::kEdges;
    camera.width = camera.width * kFiner + 1;
    camera.height = camera.height * kFiner + 1;
    const ExactCamera finer(camera, conventions);
    for (int n = 0; n < 4; ++n) {
      const Pixel pixel = random_pixel(random, exact.camera());
      std::vector<bool> shown(spheres.size() + 1);  // the last: nothing
      for (std::int64_t row = 0; row <= kFiner; ++row) {
        for (std::int64_t column = 0; column <= kFiner; ++column) {
          const ExactRay ray(finer, {pixel.i * kFiner + column, pixel.j * kFiner + row});
          const auto met = ray.nearest(spheres, conventions);
          shown[met ? met->index : spheres.size()] = true;
        }
      }
      const ExactRay ray(exact, pixel);
      const auto may_be = [&](const FirstMet& claim) {
        return may_be_right_in_pixel(ray, spheres, {.relative_change = 0}, claim);
      };
      for (std::size_t k = 0; k <= spheres.size(); ++k) {
        const bool may = k < spheres.size() ? may_be({What::kSphere, k}) : may_be({What::kNothing});
        if (shown[k]) {
          ++seen;
          EXPECT_TRUE(may) << k << " " << spelled(exact.camera());
        } else {
          ++unseen;
          refuted += may ? 0 : 1;
        }
      }
      shown.pop_back();
      if (std::ranges::find(shown, true) != shown.end()) {
        EXPECT_TRUE(may_be({What::kSomething}));
      }
    }
  }
  EXPECT_GT(seen, 1800U);
  EXPECT_GT(unseen, 2500U);
  EXPECT_GT(static_cast<double>(refuted), kLeastRefuted * static_cast<double>(unseen))
      << refuted << " of " << unseen;
}

TEST(PixelSquare, is_open_for_given_rays_and_other_valid_roots) {
  const ExactRay given(Ray{{0, 0, 5}, {0, 0, 1}});
  EXPECT_TRUE(may_be_right_in_pixel(given, std::vector{kUnit}, {}, {What::kSphere, 0}));
  const Camera camera{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 3};
  const ExactRay middle(ExactCamera(camera, {}), {1, 1});
  Neighbourhood around;
  EXPECT_TRUE(may_be_right_in_pixel(middle, std::vector{kUnit}, around, {What::kNothing}));
  const Sphere wide{{0, 0, 0}, 3};
  EXPECT_FALSE(may_be_right_in_pixel(middle, std::vector{wide}, around, {What::kNothing}));
  around.valid.t_max = 1;
  EXPECT_TRUE(may_be_right_in_pixel(middle, std::vector{wide}, around, {What::kNothing}));
}

}  // namespace
}  // namespace raycheck::reference
