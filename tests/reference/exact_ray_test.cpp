#include "reference/exact_ray.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/reference/big_float.h"

namespace raycheck::reference {
namespace {

using scene::Camera;
using scene::Conventions;
using scene::Origin;
using scene::Point3;
using scene::Ray;
using scene::Root;
using scene::Sphere;
using scene::Vector3;

const Intersection kMiss{};
const Intersection kSmallerHit{HitClass::kHit, WhichRoot::kSmaller};
const Intersection kLargerHit{HitClass::kHit, WhichRoot::kLarger};
const Intersection kTangent{HitClass::kTangent, WhichRoot::kSmaller};
const Sphere kUnitSphere{{0, 0, 0}, 1};

Ray along_x(double x, double y) { return {{x, y, 0}, {1, 0, 0}}; }

/// Both engines must find the intersection, and, of a hit, the parameter.
void expect_meets(const ExactRay& ray, const Sphere& sphere, const Intersection& expected,
                  double parameter = 0, Root root = Root::kNearest) {
  EXPECT_EQ(ray.intersect(sphere, root, Engine::kFiltered), expected);
  EXPECT_EQ(ray.intersect(sphere, root, Engine::kFieldOnly), expected);
  if (expected.hit_class != HitClass::kMiss) {
    EXPECT_EQ(ray.rounded_parameter(sphere, expected), parameter);
  }
}
void expect_meets(const Ray& ray, const Sphere& sphere, const Intersection& expected,
                  double parameter = 0, Root root = Root::kNearest) {
  expect_meets(ExactRay(ray), sphere, expected, parameter, root);
}

TEST(ReportedRays, TheClassTurnsOnTheLastBit) {
  expect_meets(along_x(-5, 1), kUnitSphere, kTangent, 5);
  expect_meets(along_x(-5, 1 - 0x1p-53), kUnitSphere, kSmallerHit, 4.9999999850988388);
  expect_meets(along_x(-5, 1 + 0x1p-52), kUnitSphere, kMiss);
}

TEST(ReportedRays, OriginsOnAndInsideTheSphere) {
  expect_meets(along_x(-1, 0), kUnitSphere, kSmallerHit, 0);
  EXPECT_EQ(ExactRay(along_x(-1, 0)).rounded_parameter(kUnitSphere, kLargerHit), 2);
  expect_meets(along_x(0, 0), kUnitSphere, kLargerHit, 1);
  expect_meets(along_x(0, 0.5), kUnitSphere, kLargerHit, 0.8660254037844386);
}

TEST(ReportedRays, FarOrigin) {
  expect_meets(along_x(-1e7, 0.095), {{0, 0, 0}, 0.1}, kSmallerHit, 9999999.9687750097);
}

TEST(ReportedRays, HorizonOfTheEarth) {
  const Sphere earth{{0, -6371000, 0}, 6371000};
  const double slope = -0.0007305260126504702;
  expect_meets(Ray{{0, 1.7, 0}, {1, slope, 0}}, earth, kSmallerHit, 4654.1799293292679);
  expect_meets(Ray{{0, 1.7, 0}, {1, std::nextafter(slope, 0), 0}}, earth, kMiss);
}

TEST(ReportedRays, SquaresBeyondTheDoubleRange) {
  expect_meets(along_x(-5e160, 0.3e160), {{0, 0, 0}, 1e160}, kSmallerHit, 4.0460607985830547e160);
}

TEST(LectureSphere, FirstExample) {
  const ExactRay ray(Ray{{1, 1, 3}, {4, 3, 0}});
  const Sphere sphere{{5, 5, 5}, 3};
  const Big root = sqrt(Big(109));
  EXPECT_EQ(ray.rounded_direction(), (scene::UnitVector3{0.8, 0.6, 0}));
  EXPECT_EQ(ray.intersect(sphere), kSmallerHit);
  // s counts multiples of the given direction, which is 5 long.
  EXPECT_TRUE(is_nearest(ray.rounded_parameter(sphere, kSmallerHit), (28 - root) / 25));
  EXPECT_TRUE(is_nearest(ray.rounded_point(sphere, kSmallerHit),
                         Big3{(137 - 4 * root) / 25, (109 - 3 * root) / 25, 3}));
  EXPECT_TRUE(contains(ray.enclose(256).half_chord_sq(sphere), Big(109) / 25));
}

TEST(LectureSphere, Example1IsAMiss) {
  const ExactRay ray(Ray{{0, 0, 0}, {1, 3, 4}});
  const Sphere sphere{{5, 5, 5}, 3};
  const Big root = sqrt(Big(26));
  expect_meets(ray, sphere, kMiss);
  EXPECT_TRUE(is_nearest(ray.rounded_direction(), Big3{root / 26, 3 * root / 26, 2 * root / 13}));
  EXPECT_TRUE(contains(ray.enclose(256).half_chord_sq(sphere), Big(-58) / 13));
}

TEST(LectureSphere, Example2HitsAtAnIntegerPoint) {
  const ExactRay ray(Ray{{1, 0, 1}, {1, 2, 1}});
  const Sphere sphere{{5, 5, 5}, 3};
  expect_meets(ray, sphere, kSmallerHit, 2);  // 2 sqrt(6), in multiples of sqrt(6)
  EXPECT_EQ(ray.rounded_point(sphere, kSmallerHit), (Point3{3, 4, 3}));
}

Camera first_camera() {
  return {{8, 8, 100}, {8, 8, 54}, {0, 1, 0}, -30, -75, -30, 30, -20, 20, 2, 2};
}
Camera optical_axis(std::int64_t pixels) {
  return {{8, 8, 100}, {8, 8, 54}, {0, 1, 0}, -30, -75, -20, 20, -20, 20, pixels, pixels};
}

TEST(LectureCamera, FirstCamera) {
  const ExactCamera camera(first_camera(), {});
  const RoundedFrame frame = camera.rounded_frame();
  EXPECT_EQ(frame.U, (scene::UnitVector3{1, 0, 0}));
  EXPECT_EQ(frame.V, (scene::UnitVector3{0, 1, 0}));
  EXPECT_EQ(frame.W, (scene::UnitVector3{0, 0, 1}));
  const ExactRay corner(camera, {0, 0});
  const Big root = sqrt(Big(22));
  EXPECT_EQ(corner.rounded_pixel_point(), (Point3{-22, -12, 70}));
  EXPECT_TRUE(
      is_nearest(corner.rounded_direction(), Big3{-3 * root / 22, -root / 11, -3 * root / 22}));
  EXPECT_EQ(ExactRay(camera, {1, 1}).rounded_pixel_point(), (Point3{38, 28, 70}));
}

TEST(LectureCamera, OpticalAxisWithItsTopAtMinus20) {
  Camera upside_down = optical_axis(3);
  std::swap(upside_down.bottom, upside_down.top);
  const ExactCamera camera(upside_down, {});
  const Big root = sqrt(Big(17));
  const ExactRay corner(camera, {0, 0});
  EXPECT_EQ(corner.rounded_pixel_point(), (Point3{-12, 28, 70}));
  EXPECT_TRUE(
      is_nearest(corner.rounded_direction(), Big3{-2 * root / 17, 2 * root / 17, -3 * root / 17}));
  const ExactRay centre(camera, {1, 1});
  EXPECT_EQ(centre.rounded_pixel_point(), (Point3{8, 8, 70}));
  EXPECT_EQ(centre.rounded_direction(), (scene::UnitVector3{0, 0, -1}));
}

TEST(LectureCamera, RowsAndSamplesChooseThePixelPoint) {
  Conventions conventions;
  conventions.rows = scene::Rows::kTopFirst;
  EXPECT_EQ(ExactRay(ExactCamera(first_camera(), conventions), {0, 0}).rounded_pixel_point(),
            (Point3{-22, 28, 70}));
  conventions.samples = scene::Samples::kCentres;
  EXPECT_EQ(ExactRay(ExactCamera(first_camera(), conventions), {0, 0}).rounded_pixel_point(),
            (Point3{-7, 18, 70}));
}

/// The centre ray of the optical-axis view: along -z from (8, 8, 100), or from (8, 8, 70).
ExactRay centre_ray(Origin origin) {
  Conventions conventions;
  conventions.origin = origin;
  return ExactRay(ExactCamera(optical_axis(9), conventions), {4, 4});
}

TEST(RayOrigins, PixelAndFocalRaysStartAtThePlaneAndAtTheEye) {
  EXPECT_EQ(centre_ray(Origin::kPixel).rounded_origin(), (Point3{8, 8, 70}));
  EXPECT_EQ(centre_ray(Origin::kFocal).rounded_origin(), (Point3{8, 8, 100}));
}

TEST(RayOrigins, ASphereBehindTheEyeIsMissed) {
  const Sphere behind{{8, 8, 120}, 8};
  for (const Root root : {Root::kNearest, Root::kSmaller}) {
    expect_meets(centre_ray(Origin::kPixel), behind, kMiss, 0, root);
    expect_meets(centre_ray(Origin::kFocal), behind, kMiss, 0, root);
  }
}

TEST(RayOrigins, ASphereBetweenEyeAndPlaneIsMetOnlyFromTheEye) {
  const Sphere between{{8, 8, 85}, 6};
  expect_meets(centre_ray(Origin::kPixel), between, kMiss);
  expect_meets(centre_ray(Origin::kFocal), between, kSmallerHit, 9);
}

TEST(RayOrigins, ASphereAcrossThePlaneIsMetAtDifferentRoots) {
  const Sphere across{{8, 8, 70}, 6};
  expect_meets(centre_ray(Origin::kPixel), across, kLargerHit, 6);
  expect_meets(centre_ray(Origin::kPixel), across, kMiss, 0, Root::kSmaller);
  expect_meets(centre_ray(Origin::kFocal), across, kSmallerHit, 24);
}

TEST(RayOrigins, ASphereAroundTheEyeIsMetAtTheLargerRoot) {
  const Sphere around{{8, 8, 100}, 50};
  expect_meets(centre_ray(Origin::kFocal), around, kLargerHit, 50);
  expect_meets(centre_ray(Origin::kPixel), around, kLargerHit, 20);
  expect_meets(centre_ray(Origin::kFocal), around, kMiss, 0, Root::kSmaller);
}

TEST(Roots, SmallerTakesANegativeSmallerRootForAMiss) {
  expect_meets(along_x(-5, 0), kUnitSphere, kSmallerHit, 4, Root::kSmaller);
  expect_meets(along_x(0, 0), kUnitSphere, kMiss, 0, Root::kSmaller);
  expect_meets(along_x(1, 0), kUnitSphere, kLargerHit, 0, Root::kNearest);
  expect_meets(along_x(1, 0), kUnitSphere, kMiss, 0, Root::kSmaller);
  expect_meets(along_x(-1, 0), kUnitSphere, kSmallerHit, 0, Root::kSmaller);
}

TEST(Roots, ATangentHasOnlyOne) {
  for (const Root root : {Root::kNearest, Root::kSmaller}) {
    expect_meets(along_x(-5, 1), kUnitSphere, kTangent, 5, root);
    expect_meets(along_x(0, 1), kUnitSphere, kTangent, 0, root);
    expect_meets(along_x(5, 1), kUnitSphere, kMiss, 0, root);
  }
}

TEST(Roots, ASphereOfRadiusZeroIsAPoint) {
  const Sphere point{{3, 4, 0}, 0};
  for (const Root root : {Root::kNearest, Root::kSmaller}) {
    expect_meets(along_x(1, 4), point, kTangent, 2, root);
    expect_meets(along_x(3, 4), point, kTangent, 0, root);
    expect_meets(along_x(4, 4), point, kMiss, 0, root);
    expect_meets(along_x(1, std::nextafter(4, 5)), point, kMiss, 0, root);
  }
}

TEST(Nearest, IsEmptyWhenNothingIsMet) {
  const ExactRay ray(along_x(0, 0));
  EXPECT_FALSE(ray.nearest({}, {}).has_value());
  const std::vector<Sphere> spheres{{{-5, 0, 0}, 1}, {{5, 5, 0}, 1}};
  EXPECT_FALSE(ray.nearest(spheres, {}).has_value());
}

TEST(Nearest, ReportsEveryTieAndTheFirstOfThem) {
  // All but the first two are met at s = 4; the fifth from inside.
  const std::vector<Sphere> spheres{{{9, 0, 0}, 1}, {{-3, 0, 0}, 1}, {{6, 0, 0}, 2}, {{5, 0, 0}, 1},
                                    {{0, 0, 0}, 4}, {{4, 3, 0}, 3},  {{8, 0, 0}, 4}};
  const auto nearest = ExactRay(along_x(0, 0)).nearest(spheres, {});
  ASSERT_TRUE(nearest.has_value());
  EXPECT_EQ(nearest->index, 2u);
  EXPECT_EQ(nearest->intersection, kSmallerHit);
  EXPECT_EQ(nearest->ties, (std::vector<std::size_t>{2, 3, 4, 5, 6}));
}

TEST(Nearest, FollowsTheConventions) {
  const std::vector<Sphere> spheres{{{0, 0, 0}, 3}, {{4, 2, 0}, 2}, {{9, 0, 0}, 1}};
  const ExactRay ray(along_x(0, 0));
  Conventions conventions;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 0u);
  conventions.root = Root::kSmaller;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 1u);
  conventions.tangent = scene::Tangent::kEither;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 1u);
  conventions.tangent = scene::Tangent::kMiss;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 2u);
}

TEST(Nearest, AMirroredPairTiesAtAnIrrationalParameter) {
  const ExactRay ray(Ray{{0, 0, 0}, {1, 0, 2}});
  const Sphere left{{3, 1, 5}, 2};
  const Sphere right{{3, -1, 5}, 2};
  const Sphere nearer{{3, -1, 5}, std::nextafter(2, 3)};
  for (const Engine engine : {Engine::kFiltered, Engine::kFieldOnly}) {
    EXPECT_EQ(ray.compare(left, kSmallerHit, right, kSmallerHit, engine), 0);
    EXPECT_EQ(ray.compare(left, kSmallerHit, nearer, kSmallerHit, engine), 1);
    EXPECT_EQ(ray.compare(left, kLargerHit, nearer, kLargerHit, engine), -1);
    EXPECT_EQ(ray.compare(left, kSmallerHit, right, kLargerHit, engine), -1);
  }
}

TEST(Nearest, TiesAreFoundThroughACamera) {
  for (const Origin origin : {Origin::kPixel, Origin::kFocal}) {
    Conventions conventions;
    conventions.origin = origin;
    // An oblique camera that looks along the diagonal; the spheres are each other's mirror images.
    const Camera camera{{7, 7, 7}, {0, 0, 0}, {0, 0, 1}, -2, {}, -1, 1, -1, 1, 3, 3};
    const ExactRay centre(ExactCamera(camera, conventions), {1, 1});
    const std::vector<Sphere> spheres{{{2, 1, 1}, 2}, {{1, 2, 1}, 2}, {{1, 1, 2}, 2}};
    const auto nearest = centre.nearest(spheres, conventions);
    ASSERT_TRUE(nearest.has_value());
    EXPECT_EQ(nearest->ties, (std::vector<std::size_t>{0, 1, 2}));
  }
}

}  // namespace
}  // namespace raycheck::reference
