// Compares plans with plans by hand, and tests the sizes of rectangles.

#include "scene/plan/plan.h"

#include "tests/testing.h"

namespace raycheck::scene {
namespace {

constexpr PixelRectangle kImage = {0, 17, 0, 17};

/// A camera at the origin that looks along -Z: W = Z, U = X, V = Y. alpha(i) = i/2 - 4, beta(j) =
/// j/2 - 4.
Camera plain_camera() { return {{}, {0, 0, -1}, {0, 1, 0}, -1, {}, -4, 4, -4, 4, 17, 17}; }

Scene scene_of(std::vector<Sphere> spheres, const Camera& camera = plain_camera()) {
  Scene scene;
  scene.camera = camera;
  scene.spheres = std::move(spheres);
  return scene;
}

/// A sphere at x along U, y along V, z along -W.
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
const Sphere kAboveTheAxis = ahead(0, 3, 4, 3);

/// plain_camera() with another image plane, other bounds or another size.
Camera plain_but(const std::function<void(Camera&)>& change) {
  Camera camera = plain_camera();
  change(camera);
  return camera;
}
const Camera kFarPlane = plain_but([](Camera& c) { c.near = -5; });
const Camera kPlaneBehind = plain_but([](Camera& c) { c.near = 1; });
const Camera kOnePixel = plain_but([](Camera& c) { c.width = c.height = 1; });
const Conventions kFocal{.origin = Origin::kFocal};
const Conventions kCentres{.samples = Samples::kCentres};
const Conventions kCorners{.samples = Samples::kCorners};

TEST(Rectangle, FitsTheSilhouette) {
  struct Row {
    const char* what;
    Sphere sphere;
    PixelRectangle pixels;
    Camera camera = plain_camera();
    Conventions conventions = {};
  };
  const auto mirrored = [](bool up) {
    return plain_but(
        [&](Camera& c) { up ? std::swap(c.bottom, c.top) : std::swap(c.left, c.right); });
  };
  for (const auto& [what, sphere, pixels, camera, conventions] : std::vector<Row>{
           // Slopes up to tan(asin(0.6)) = 0.75: alpha = -0.5, 0 and 0.5.
           {"on the axis", ahead(0, 0, 10, 6), {7, 10, 7, 10}},
           {"touching the axis", kTouchingTheAxis, {8, 15, 6, 11}},
           {"rows from the top", kAboveTheAxis, {6, 11, 2, 9}, plain_camera(), {Rows::kTopFirst}},
           // alpha(i) = (i + 1/2)/2 - 4
           {"centres",
            kAboveTheAxis,
            {6, 10, 8, 15},
            plain_but([](Camera& c) { c.width = c.height = 16; }),
            kCentres},
           // alpha(i) = i/2 - 4, as of 17 pixels at edges
           {"corners",
            kAboveTheAxis,
            {6, 11, 8, 15},
            plain_but([](Camera& c) { c.width = c.height = 16; }),
            kCorners},
           {"corners, rows from the top",
            kAboveTheAxis,
            {6, 11, 2, 9},
            plain_but([](Camera& c) { c.width = c.height = 16; }),
            {Rows::kTopFirst, Samples::kCorners}},
           {"mirrored columns", kTouchingTheAxis, {2, 9, 6, 11}, mirrored(false)},
           {"mirrored rows", kAboveTheAxis, {6, 11, 2, 9}, mirrored(true)},
           {"image plane behind the eye", ahead(3, 0, -4, 3), {8, 15, 6, 11}, kPlaneBehind},
           // One tangent goes backwards, the other has slope sqrt(5)/2 = 1.118: alpha = 1.5 and
           // more.
           {"across the eye's plane", ahead(3, 0, 0, 2), {11, 17, 0, 17}},
           {"around the eye", ahead(0.25, -0.5, 0.125, 3), kImage},
           {"of one pixel", kTouchingTheAxis, {0, 1, 0, 1}, kOnePixel, kCentres}}) {
    EXPECT_EQ(plan_of(sphere, camera, conventions).pixels, pixels) << what;
  }
}

TEST(Plan, BoundsTheDistancesOfSpheres) {
  const ScenePlan plan = plan_of(scene_of(
      {ahead(0, 0, 10, 6), ahead(0.25, -0.5, 0.125, 3), ahead(0, 0, -2, 1), ahead(0, 0, 20, 1)}));
  EXPECT_LE(plan.nearest_distance[0], 4);
  EXPECT_GT(plan.nearest_distance[0], 4 - 1e-14);
  EXPECT_EQ(plan.nearest_distance[1], 0);
  for (const std::size_t left_out : {2U, 3U}) {  // behind, and hidden
    EXPECT_TRUE(plan.spheres[left_out].left_out);
    EXPECT_EQ(plan.nearest_distance[left_out], std::numeric_limits<double>::infinity());
  }
}

TEST(Plan, LeavesOutSpheresOutsideTheViewOrBehindTheOrigins) {
  struct Row {
    const char* what;
    Sphere sphere;
    std::optional<LeftOut> left_out;
    Camera camera = plain_camera();
    Conventions conventions = {};
  };
  const Sphere between = ahead(0, 0, 2, 1), behind = ahead(0, 0, -2, 1);
  for (const auto& [what, sphere, left_out, camera, conventions] : std::vector<Row>{
           {"beside", ahead(50, 0, 10, 2), LeftOut::kOutsideView},
           {"below", ahead(0, -50, 10, 2), LeftOut::kOutsideView},
           {"between the rays of two columns", ahead(2.5, 0, 10, 0.5), LeftOut::kOutsideView},
           {"beside one pixel", ahead(3.5, 0, 4, 3), LeftOut::kOutsideView, kOnePixel, kCentres},
           {"of a plane behind the eye", kTouchingTheAxis, LeftOut::kBehind, kPlaneBehind},
           {"between eye and plane", between, LeftOut::kBehind, kFarPlane},
           {"touching the plane", ahead(0, 0, 4, 1), {}, kFarPlane},
           {"behind the eye", behind, LeftOut::kBehind, kFarPlane},
           {"between, from the eye", between, {}, kFarPlane, kFocal},
           {"touching the eye", ahead(0, 0, -1, 1), {}, kFarPlane, kFocal},
           {"behind, from the eye", behind, LeftOut::kBehind, kFarPlane, kFocal}}) {
    const SpherePlan plan = plan_of(sphere, camera, conventions);
    EXPECT_EQ(plan.left_out, left_out) << what;
    EXPECT_EQ(plan.pixels.empty(), left_out.has_value()) << what;
  }
}

TEST(Plan, NeedsTheFarRootOnlyIfAnOriginMayBeInside) {
  struct Row {
    const char* what;
    Sphere sphere;
    bool origin_inside, reaches_behind;
    Conventions conventions = {};
  };
  for (const auto& [what, sphere, inside, behind, conventions] : std::vector<Row>{
           {"ahead", ahead(0, 0, 10, 6), false, false},
           {"around the eye", ahead(0.25, -0.5, 0.125, 3), true, true},
           {"across the eye's plane", ahead(3, 0, 0, 2), true, true},
           {"around the corner of the plane", ahead(5, 5, 1, 2), true, true},
           {"around that, from the eye", ahead(5, 5, 1, 2), false, true, kFocal},
           {"around the eye, from it", ahead(0, 0, 0.5, 1), true, true, kFocal},
           {"across the plane beside the image", ahead(6.5, 0, 2.5, 2), false, true},
           {"across that, from the eye", ahead(6.5, 0, 2.5, 2), false, false, kFocal},
           {"an origin on the surface", ahead(0, 0, 3, 2), true, true},
           {"the smaller root", ahead(0, 0, 1, 2), false, true, {.root = Root::kSmaller}}}) {
    const SpherePlan plan = plan_of(sphere, plain_camera(), conventions);
    EXPECT_EQ(plan.origin_inside, inside) << what;
    EXPECT_EQ(plan.reaches_behind, behind) << what;
  }
}

TEST(Plan, LeavesOutSpheresHiddenByANearerOne) {
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

TEST(Plan, LeavesOutSpheresInsideOneThatIsEnteredFirst) {
  const Sphere big = ahead(0, 0, 10, 3), inside = ahead(1, 0.5, 9, 1);
  EXPECT_EQ(plan_of(scene_of({inside, big})).spheres[0].hidden_by, 1u);
  // From inside both spheres, the inner one is met first.
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

TEST(Plan, DoesNotDependOnTheOrderOfItsParts) {
  Scene scene = scene_of({});
  std::mt19937 bits(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits()) * 0x1p-32;
  };
  for (int k = 0; k < 20'000; ++k) {
    scene.spheres.push_back(
        ahead(between(-9, 9), between(-9, 9), between(-2, 20), between(.01, 1)));
  }
  std::size_t parts = 0;
  const ForEach last_first = [&](std::size_t count, const std::function<void(std::size_t)>& body) {
    for (std::size_t k = count; k > 0; --k) body(k - 1);
    parts += count;
  };
  EXPECT_EQ(plan_scene(scene, {}, Wanted::kNearest, {}, last_first).spheres,
            plan_of(scene).spheres);
  EXPECT_GT(parts, 8U);
}

TEST(Plan, CanSwitchOffEachOptimisation) {
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
  // A sphere behind is also outside the view.
  EXPECT_EQ(all({.behind = false}).spheres[1].left_out, LeftOut::kOutsideView);
  EXPECT_EQ(all({.view = false, .behind = false}).spheres[1].left_out, std::nullopt);
  EXPECT_EQ(all({.hidden = false}).spheres[3].left_out, std::nullopt);
  EXPECT_EQ(all({.rectangles = false}).spheres[2].pixels, kImage);
  EXPECT_TRUE(all({.far_root = false}).spheres[2].origin_inside);
  EXPECT_TRUE(all({.behind_test = false}).spheres[2].reaches_behind);
  EXPECT_NE(all({.scaling = false}).eye.scaling(), Scaling{});
  EXPECT_FALSE(all({.basis = false}).eye.axis_aligned());
}

TEST(Plan, RefusesGivenRays) {
  Scene scene;
  scene.rays.push_back({{0, 0, 0}, {0, 0, 1}});
  EXPECT_TRUE(has(thrown_by([&] { plan_of(scene); }), "camera"));
  scene = scene_of({ahead(0, 0, 10, -1)});
  EXPECT_THROW(plan_of(scene), std::invalid_argument);
}

/// The number of compared sides of rectangles, and of sides that are equal to the exact ones.
struct Tightness {
  int sides = 0, exact = 0;

  void side(std::int64_t where, std::int64_t got) {
    ++sides;
    exact += got == where ? 1 : 0;
    EXPECT_LE(got, where);
    EXPECT_GE(got, where - kRectangleSlack);
  }
  /// Compares two opposite sides. A side of a silhouette's box lies at a real number x, in indices
  /// of pixels. The rectangle begins at ceil(x), or ends after floor(x). If x is so near to a whole
  /// number that its bounds contain it, the side may be up to kRectangleSlack farther out.
  void compare(long double x, long double z, long double r, long double near, long double first,
               long double last, std::int64_t count, std::int64_t begin, std::int64_t end) {
    const long double middle = std::atan2(x, z), half = std::asin(r / std::hypot(x, z));
    const auto index = [&](long double angle) {
      return (std::tan(angle) * -near - first) / (last - first) *
             static_cast<long double>(count - 1);
    };
    const auto low = static_cast<std::int64_t>(std::ceil(index(middle - half)));
    const auto high = static_cast<std::int64_t>(std::floor(index(middle + half))) + 1;
    if (low > 0) side(low, begin);
    if (high < count) side(-high, -end);
  }
};

TEST(Rectangle, IsNoLargerThanTheSilhouettesBoxRequires) {
  std::mt19937_64 engine(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  Tightness tightness;
  for (int k = 0; k < 4000; ++k) {
    Camera camera = plain_camera();
    camera.near = -between(0.1, 10);
    for (double* bound : {&camera.left, &camera.bottom}) *bound = camera.near * between(0.2, 2);
    for (double* bound : {&camera.right, &camera.top}) *bound = -camera.near * between(0.2, 2);
    camera.width = 2 + static_cast<std::int64_t>(engine() % 2000);
    camera.height = 2 + static_cast<std::int64_t>(engine() % 2000);
    const double z = between(12, 100);
    const double x = z * between(-1, 1), y = z * between(-1, 1);
    const double r = z * between(0.01, 0.3);
    const SpherePlan plan =
        plan_scene(scene_of({ahead(x, y, z, r)}, camera), {}, Wanted::kClass, {.basis = k % 2 == 0})
            .spheres.front();
    if (plan.left_out) continue;
    const PixelRectangle& box = plan.pixels;
    tightness.compare(x, z, r, camera.near, camera.left, camera.right, camera.width, box.i_begin,
                      box.i_end);
    tightness.compare(y, z, r, camera.near, camera.bottom, camera.top, camera.height, box.j_begin,
                      box.j_end);
  }
  EXPECT_GT(tightness.sides, 4000);
  EXPECT_GT(1000 * tightness.exact, 999 * tightness.sides);
}

}  // namespace
}  // namespace raycheck::scene
