// Plans worked by hand.

#include "scene/plan/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace raycheck::scene {
namespace {

constexpr PixelRectangle kImage = {0, 17, 0, 17};

/// At the origin, looking along -Z: W = Z, U = X, V = Y. alpha(i) = i/2 - 4, beta(j) = j/2 - 4.
Camera plain_camera() {
  Camera camera;
  camera.look_at = {0, 0, -1};
  camera.up = {0, 1, 0};
  camera.near = -1;
  camera.left = camera.bottom = -4;
  camera.right = camera.top = 4;
  camera.width = camera.height = 17;
  return camera;
}

Scene scene_of(std::vector<Sphere> spheres, const Camera& camera = plain_camera()) {
  Scene scene;
  scene.camera = camera;
  scene.spheres = std::move(spheres);
  return scene;
}

/// x along U, y along V, z the way the camera looks.
Sphere ahead(double x, double y, double z, double radius) { return {{x, y, -z}, radius}; }

ScenePlan plan_of(const Scene& scene, const PlanItems& items = {}) {
  return plan_scene(scene, scene.conventions, Wanted::kNearest, items);
}

SpherePlan plan_of(const Sphere& sphere, const Camera& camera = plain_camera(),
                   const Conventions& conventions = {}, const PlanItems& items = {}) {
  return plan_scene(scene_of({sphere}, camera), conventions, Wanted::kNearest, items).spheres[0];
}

// The tangents from the eye to the circle of centre (3, 4) and radius 3 have slopes 0 and 24/7, as
// q = sqrt(3^2 + 4^2 - 3^2) = 4; to that of centre (0, 4), -+3/sqrt(7) = -+1.134.
const Sphere kTouchingTheAxis = ahead(3, 0, 4, 3);

TEST(Rectangle, OfASphereOnTheAxisIsItsSilhouette) {
  // Slopes up to tan(asin(0.6)) = 0.75: alpha = -0.5, 0 and 0.5.
  const SpherePlan plan = plan_of(ahead(0, 0, 10, 6));
  EXPECT_EQ(plan.pixels, (PixelRectangle{7, 10, 7, 10}));
  EXPECT_FALSE(plan.left_out);
  EXPECT_FALSE(plan.origin_inside);
  EXPECT_FALSE(plan.reaches_behind);
  EXPECT_LE(plan.nearest_distance, 4);
  EXPECT_GT(plan.nearest_distance, 4 - 1e-14);
}

TEST(Rectangle, FollowsTheConventions) {
  const Sphere above = ahead(0, 3, 4, 3);
  EXPECT_EQ(plan_of(above, plain_camera(), {.rows = Rows::kTopFirst}).pixels,
            (PixelRectangle{6, 11, 2, 9}));
  // alpha(i) = (i + 1/2)/2 - 4
  Camera camera = plain_camera();
  camera.width = camera.height = 16;
  EXPECT_EQ(plan_of(above, camera, {.samples = Samples::kCentres}).pixels,
            (PixelRectangle{6, 10, 8, 15}));
}

TEST(Rectangle, FollowsMirroredBounds) {
  Camera camera = plain_camera();
  std::swap(camera.left, camera.right);
  EXPECT_EQ(plan_of(kTouchingTheAxis, camera).pixels, (PixelRectangle{2, 9, 6, 11}));
  std::swap(camera.bottom, camera.top);
  EXPECT_EQ(plan_of(ahead(0, 3, 4, 3), camera).pixels, (PixelRectangle{6, 11, 2, 9}));
}

TEST(Rectangle, FollowsAnImagePlaneBehindTheEye) {
  Camera camera = plain_camera();
  camera.near = 1;
  EXPECT_EQ(plan_of(ahead(3, 0, -4, 3), camera).pixels, (PixelRectangle{8, 15, 6, 11}));
  EXPECT_EQ(plan_of(kTouchingTheAxis, camera).left_out, LeftOut::kBehind);
}

TEST(Rectangle, OfASphereAcrossTheEyesPlaneReachesTheImagesEdge) {
  // One tangent goes backwards, the other has slope sqrt(5)/2 = 1.118: alpha = 1.5 and more.
  const SpherePlan plan = plan_of(ahead(3, 0, 0, 2));
  EXPECT_EQ(plan.pixels, (PixelRectangle{11, 17, 0, 17}));
  EXPECT_TRUE(plan.reaches_behind);
}

TEST(Rectangle, OfASphereAroundTheEyeIsTheImage) {
  const SpherePlan plan = plan_of(ahead(0.25, -0.5, 0.125, 3));
  EXPECT_EQ(plan.pixels, kImage);
  EXPECT_TRUE(plan.origin_inside);
  EXPECT_TRUE(plan.reaches_behind);
  EXPECT_EQ(plan.nearest_distance, 0);
}

TEST(Rectangle, OfAnImageOfOnePixelIsItOrNothing) {
  Camera camera = plain_camera();
  camera.width = camera.height = 1;
  const Conventions centres{.samples = Samples::kCentres};
  EXPECT_EQ(plan_of(ahead(0, 0, 10, 6), camera, centres).pixels, (PixelRectangle{0, 1, 0, 1}));
  EXPECT_EQ(plan_of(kTouchingTheAxis, camera, centres).pixels, (PixelRectangle{0, 1, 0, 1}));
  EXPECT_EQ(plan_of(ahead(3.5, 0, 4, 3), camera, centres).left_out, LeftOut::kOutsideView);
}

TEST(Plan, LeavesOutWhatIsOutsideTheView) {
  EXPECT_EQ(plan_of(ahead(50, 0, 10, 2)).left_out, LeftOut::kOutsideView);
  EXPECT_EQ(plan_of(ahead(0, -50, 10, 2)).left_out, LeftOut::kOutsideView);
  // Between the rays of two columns.
  EXPECT_EQ(plan_of(ahead(2.5, 0, 10, 0.5)).left_out, LeftOut::kOutsideView);
  EXPECT_TRUE(plan_of(ahead(50, 0, 10, 2)).pixels.empty());
}

TEST(Plan, LeavesOutWhatIsBehindTheOrigins) {
  Camera camera = plain_camera();
  camera.near = -5;
  const Sphere between = ahead(0, 0, 2, 1), touching = ahead(0, 0, 4, 1),
               behind = ahead(0, 0, -2, 1);
  EXPECT_EQ(plan_of(between, camera).left_out, LeftOut::kBehind);
  EXPECT_FALSE(plan_of(touching, camera).left_out);
  EXPECT_EQ(plan_of(behind, camera).left_out, LeftOut::kBehind);
  const Conventions focal{.origin = Origin::kFocal};
  EXPECT_FALSE(plan_of(between, camera, focal).left_out);
  EXPECT_FALSE(plan_of(ahead(0, 0, -1, 1), camera, focal).left_out);
  EXPECT_EQ(plan_of(behind, camera, focal).left_out, LeftOut::kBehind);
}

TEST(Plan, WantsTheFarRootOnlyWhereAnOriginMayBeInside) {
  const Conventions focal{.origin = Origin::kFocal};
  // Around the corner of the image plane, around the eye, across the plane beside the image.
  EXPECT_TRUE(plan_of(ahead(5, 5, 1, 2)).origin_inside);
  EXPECT_FALSE(plan_of(ahead(5, 5, 1, 2), plain_camera(), focal).origin_inside);
  EXPECT_TRUE(plan_of(ahead(0, 0, 0.5, 1), plain_camera(), focal).origin_inside);
  EXPECT_FALSE(plan_of(ahead(6.5, 0, 2.5, 2)).origin_inside);
  EXPECT_TRUE(plan_of(ahead(6.5, 0, 2.5, 2)).reaches_behind);
  EXPECT_FALSE(plan_of(ahead(6.5, 0, 2.5, 2), plain_camera(), focal).reaches_behind);
  // An origin on the surface counts as inside; and nothing where the smaller root is the rule.
  EXPECT_TRUE(plan_of(ahead(0, 0, 3, 2)).origin_inside);
  EXPECT_TRUE(plan_of(ahead(0, 0, 3, 2)).reaches_behind);
  EXPECT_FALSE(plan_of(ahead(0, 0, 1, 2), plain_camera(), {.root = Root::kSmaller}).origin_inside);
}

TEST(Plan, LeavesOutWhatANearerSphereHides) {
  const Sphere big = ahead(0, 0, 10, 3), small = ahead(0, 0, 20, 1);
  const ScenePlan plan = plan_of(scene_of({small, big}));
  EXPECT_EQ(plan.spheres[0].left_out, LeftOut::kHidden);
  EXPECT_EQ(plan.spheres[0].hidden_by, 1u);
  EXPECT_TRUE(plan.spheres[0].pixels.empty());
  EXPECT_FALSE(plan.spheres[1].left_out);
  for (const Wanted wanted : {Wanted::kClass, Wanted::kParameter, Wanted::kPoint}) {
    EXPECT_FALSE(plan_scene(scene_of({small, big}), {}, wanted).spheres[0].left_out);
  }
}

TEST(Plan, LeavesOutWhatIsInsideASphereThatIsEnteredFirst) {
  const Sphere big = ahead(0, 0, 10, 3), inside = ahead(1, 0.5, 9, 1);
  EXPECT_EQ(plan_of(scene_of({inside, big})).spheres[0].hidden_by, 1u);
  // From inside both, the inner one is met first.
  const Sphere around = ahead(0, 0, 0, 9), inner = ahead(0, 0, 0, 6);
  EXPECT_FALSE(plan_of(scene_of({inner, around})).spheres[0].left_out);
}

TEST(Plan, LeavesOutAllButTheFirstOfEqualSpheres) {
  const Sphere sphere = ahead(0, 0, 10, 3);
  const Sphere same{{-0.0, 0.0, -10}, 3};
  const ScenePlan plan = plan_of(scene_of({sphere, same, ahead(1, 0, 10, 3), sphere}));
  EXPECT_FALSE(plan.spheres[0].left_out);
  EXPECT_EQ(plan.spheres[1].hidden_by, 0u);
  EXPECT_FALSE(plan.spheres[2].left_out);
  EXPECT_EQ(plan.spheres[3].hidden_by, 0u);
}

TEST(Plan, IsTheSameAtEveryScale) {
  const std::vector<Sphere> spheres = {
      kTouchingTheAxis,    ahead(0, 0, 10, 3),  ahead(0, 0, 20, 1),    ahead(0.25, 0, 0.125, 3),
      ahead(0, 0, -20, 1), ahead(50, 0, 10, 2), ahead(6.5, 0, 2.5, 2), ahead(3, 0, 0, 2)};
  const ScenePlan plain = plan_of(scene_of(spheres));
  for (const double scale : {0x1p532, 0x1p-532, 0x1p1000, 0x1p-1000}) {
    Scene scene = scene_of(spheres);
    Camera& camera = *scene.camera;
    camera.look_at.z *= scale;
    for (double* x : {&camera.near, &camera.left, &camera.right, &camera.bottom, &camera.top}) {
      *x *= scale;
    }
    for (Sphere& sphere : scene.spheres) {
      sphere = {{scale * sphere.centre.x, scale * sphere.centre.y, scale * sphere.centre.z},
                scale * sphere.radius};
    }
    const ScenePlan scaled = plan_of(scene);
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      EXPECT_EQ(scaled.spheres[k].pixels, plain.spheres[k].pixels) << k << " at " << scale;
      EXPECT_EQ(scaled.spheres[k].left_out, plain.spheres[k].left_out) << k << " at " << scale;
      EXPECT_EQ(scaled.spheres[k].origin_inside, plain.spheres[k].origin_inside) << k;
      EXPECT_EQ(scaled.spheres[k].reaches_behind, plain.spheres[k].reaches_behind) << k;
    }
    EXPECT_NE(scaled.eye.scaling(), Scaling{});
  }
  EXPECT_EQ(plain.eye.scaling(), Scaling{});
}

TEST(Plan, DoesWhatItIsToldToLeaveAlone) {
  const Sphere outside = ahead(50, 0, 10, 2), behind = ahead(0, 0, -4, 1);
  const Sphere big = ahead(0, 0, 10, 3), hidden = ahead(0, 0, 20, 1);
  const auto all = [&](const PlanItems& items) {
    return plan_of(scene_of({outside, behind, big, hidden}), items);
  };
  const ScenePlan whole = all({});
  EXPECT_EQ(whole.spheres[0].left_out, LeftOut::kOutsideView);
  EXPECT_EQ(whole.spheres[1].left_out, LeftOut::kBehind);
  EXPECT_EQ(whole.spheres[3].left_out, LeftOut::kHidden);
  EXPECT_EQ(all({.view = false}).spheres[0].left_out, std::nullopt);
  EXPECT_EQ(all({.view = false}).spheres[0].pixels, kImage);
  // What is behind is outside the view too.
  EXPECT_EQ(all({.behind = false}).spheres[1].left_out, LeftOut::kOutsideView);
  EXPECT_EQ(all({.view = false, .behind = false}).spheres[1].left_out, std::nullopt);
  EXPECT_EQ(all({.hidden = false}).spheres[3].left_out, std::nullopt);
  EXPECT_EQ(all({.rectangles = false}).spheres[2].pixels, kImage);
  EXPECT_TRUE(all({.far_root = false}).spheres[2].origin_inside);
  EXPECT_TRUE(all({.behind_test = false}).spheres[2].reaches_behind);
  EXPECT_NE(all({.scaling = false}).eye.scaling(), Scaling{});
  EXPECT_FALSE(all({.basis = false}).eye.axis_aligned());
}

TEST(Plan, OfGivenRaysIsRefused) {
  Scene scene;
  scene.rays.push_back({{0, 0, 0}, {0, 0, 1}});
  try {
    plan_of(scene);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("camera"), std::string::npos);
  }
  scene = scene_of({ahead(0, 0, 10, -1)});
  EXPECT_THROW(plan_of(scene), std::invalid_argument);
}

TEST(EyeSpace, IsExactWhereTheAxesAreTheWorlds) {
  Camera camera = plain_camera();
  camera.eye = {1, 2, 3};
  camera.look_at = {1, 9, 3};
  camera.up = {0, 5, -2};
  const EyeSpace eye(camera, {}, {});
  ASSERT_TRUE(eye.axis_aligned());
  // W = -Y, V = -Z, U = V x W = -X.
  const EyeSphere seen = eye.sphere({{4, 12, -8}, 2});
  for (const auto& [got, exact] :
       {std::pair(seen.u, -3.0), std::pair(seen.v, 11.0), std::pair(seen.w, -10.0)}) {
    EXPECT_LE(got.low, exact);
    EXPECT_GE(got.high, exact);
    EXPECT_LT(got.high - got.low, 1e-14);
  }
  EXPECT_FALSE(EyeSpace(camera, {}, {}, true).axis_aligned());
  camera.up.x = 1e-30;
  EXPECT_FALSE(EyeSpace(camera, {}, {}).axis_aligned());
}

}  // namespace
}  // namespace raycheck::scene
