#include "reference/condition.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Camera;
using scene::Ray;
using scene::Sphere;

const Intersection kSmallerHit{HitClass::kHit, WhichRoot::kSmaller};
const Intersection kLargerHit{HitClass::kHit, WhichRoot::kLarger};
const Intersection kTangent{HitClass::kTangent, WhichRoot::kSmaller};

/// The analytic condition number is not exceeded by more than this: what the balls forget.
constexpr double kSlack = 4;

void expect_close(double estimate, double analytic) {
  EXPECT_GE(estimate, analytic * (1 - 1e-6));
  EXPECT_LE(estimate, analytic * kSlack);
}

Camera camera_at(double x) {
  return {{x, 0, 10}, {x, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 3};
}

TEST(Condition, OfAHeadOnParameterIsAnalytic) {
  // s = cx - ox - r for a ray along x: |cx| + |ox| + |r| + |dx| s, over s.
  const auto analytic = [](double o, double c, double r) {
    const double s = c - o - r;
    return (std::abs(c) + std::abs(o) + r + s) / s;
  };
  for (const double o : {-5.0, 0.0, 2.0}) {
    for (const double c : {4.0, 100.0}) {
      const ExactRay ray(Ray{{o, 0, 0}, {1, 0, 0}});
      expect_close(condition_of_parameter(ray, {{c, 0, 0}, 1}, kSmallerHit), analytic(o, c, 1));
    }
  }
}

TEST(Condition, OfAnObliqueParameterIsAnalytic) {
  // Along x from (0, y, 0) at the unit sphere round (5, 0, 0): s = 5 - q, q = sqrt(1 - y^2).
  // |ds/dcx| 5 + |ds/dr| r + |ds/doy| y + |ds/ddx| s = 5 + 1/q + y^2/q + s
  for (const double y : {0.25, 0.5, 0.75, 0.9375}) {
    const double q = std::sqrt(1 - y * y);
    const double s = 5 - q;
    const ExactRay ray(Ray{{0, y, 0}, {1, 0, 0}});
    expect_close(condition_of_parameter(ray, {{5, 0, 0}, 1}, kSmallerHit),
                 (5 + 1 / q + y * y / q + s) / s);
  }
}

TEST(Condition, IsInfiniteAtATangent) {
  const ExactRay ray(Ray{{-5, 1, 0}, {1, 0, 0}});
  EXPECT_TRUE(std::isinf(condition_of_parameter(ray, {{0, 0, 0}, 1}, kTangent)));
  EXPECT_TRUE(std::isinf(condition_of_point(ray, {{0, 0, 0}, 1}, kTangent)));
}

TEST(Condition, GrowsWithoutBoundTowardsATangent) {
  // With y = 1 - e, s depends on y and r like 1/sqrt(2 e).
  for (const double e : {0x1p-10, 0x1p-20, 0x1p-30, 0x1p-40}) {
    const ExactRay ray(Ray{{-5, 1 - e, 0}, {1, 0, 0}});
    const double q = std::sqrt(2 * e - e * e);
    const double analytic = (2 / q + 10) / (5 - q);
    const double estimate = condition_of_parameter(ray, {{0, 0, 0}, 1}, kSmallerHit);
    EXPECT_GE(estimate, analytic * 0.8);
    EXPECT_LE(estimate, analytic * kSlack);
  }
}

TEST(Condition, OfTheParameterGrowsLikeOneOverTheDistanceToTheSurface) {
  for (const double distance : {0x1p-10, 0x1p-20, 0x1p-40}) {
    const ExactRay ray(Ray{{-1 - distance, 0, 0}, {1, 0, 0}});
    const double estimate = condition_of_parameter(ray, {{0, 0, 0}, 1}, kSmallerHit);
    expect_close(estimate, (2 + 2 * distance) / distance);
  }
}

TEST(Condition, OfTheParameterIsInfiniteOnTheSurface) {
  const ExactRay ray(Ray{{-1, 0, 0}, {1, 0, 0}});
  EXPECT_TRUE(std::isinf(condition_of_parameter(ray, {{0, 0, 0}, 1}, kSmallerHit)));
  EXPECT_LT(condition_of_parameter(ray, {{0, 0, 0}, 1}, kLargerHit), 10);
}

TEST(Condition, OfThePixelPointOfAFarCameraIsTheEyes) {
  // E at distance |x| dwarfs the rest: P = E + ... moves as much as E does, relatively by 1;
  // looking from x to x the view direction loses |x| / |E - A|.
  for (const double x : {1e3, 1e6, 1e9}) {
    const ExactRay ray(ExactCamera(camera_at(x), {}), {1, 1});
    const double estimate = condition_of_pixel_point(ray);
    EXPECT_GE(estimate, 1);
    EXPECT_LE(estimate, 3);
  }
}

TEST(Condition, OfThePixelPointGrowsLikeTheEyeWhenThePlaneCrossesTheOrigin) {
  // E = (x, 0, 0) and the plane 1 from the world's origin: |P| = 1, so |dP/dE| |E| / |P| is about
  // x.
  for (const double x : {1e3, 1e6, 1e9}) {
    const Camera camera{{x, 0, 0}, {0, 0, 0}, {0, 1, 0}, -(x - 1), {}, -1, 1, -1, 1, 3, 3};
    const ExactRay ray(ExactCamera(camera, {}), {1, 1});
    expect_close(condition_of_pixel_point(ray), x + (x - 1));
  }
}

TEST(Condition, OfTheDirectionGrowsLikeTheEyeOverItsDistanceToTheTarget) {
  // |E - A| = 10 at distance x from the origin: W turns by |x| / 10 per relative change of E and A.
  for (const double x : {1e3, 1e6, 1e9}) {
    const ExactCamera camera(camera_at(x), {});
    const double frame = condition_of_frame(camera);
    const double direction = condition_of_direction(ExactRay(camera, {1, 1}));
    EXPECT_GE(frame, 2 * x / 10);
    EXPECT_LE(frame, kSlack * 2 * x / 10);
    EXPECT_GE(direction, 2 * x / 10);
    EXPECT_LE(direction, kSlack * 2 * x / 10);
  }
}

TEST(Condition, OfAWellPlacedCameraIsSmall) {
  const ExactCamera camera({{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 3}, {});
  EXPECT_LT(condition_of_frame(camera), 20);
  EXPECT_LT(condition_of_direction(ExactRay(camera, {0, 0})), 30);
  EXPECT_LT(condition_of_pixel_point(ExactRay(camera, {0, 0})), 30);
}

TEST(Condition, OfTheFrameGrowsAsUpNearsTheViewDirection) {
  for (const double angle : {0x1p-10, 0x1p-20, 0x1p-30}) {
    const Camera camera{{0, 0, 10}, {0, 0, 0}, {0, angle, 1}, -1, {}, -1, 1, -1, 1, 3, 3};
    Camera moved = camera;
    moved.eye.x = 1;
    moved.look_at.x = 1;
    // up x W keeps only `angle` of what it is made of; E.x - A.x is known to 2 ulp.
    EXPECT_GE(condition_of_frame(ExactCamera(moved, {})), 0.1 / angle);
    EXPECT_LE(condition_of_frame(ExactCamera(moved, {})), 20 / angle);
  }
}

/// Changes of the inputs move the parameter by no more than the condition number says.
TEST(Condition, BoundsWhatSmallChangesDo) {
  Random random(1);
  int compared = 0;
  while (compared < 300) {
    const Ray ray = random_ray(random, Sizes::kOrdinary);
    const Sphere sphere = random_sphere(random, Sizes::kOrdinary);
    const ExactRay exact(ray);
    const Intersection at = exact.intersect(sphere);
    const double change = 0x1p-40;
    if (at.hit_class != HitClass::kHit) continue;
    const double condition = condition_of_parameter(exact, sphere, at);
    if (condition > 0x1p10) continue;
    ++compared;
    const auto changed = [&](double x) { return x * (1 + change * random.sign()); };
    const auto& [o, d] = ray;
    const ExactRay other(Ray{{changed(o.x), changed(o.y), changed(o.z)},
                             {changed(d.x), changed(d.y), changed(d.z)}});
    const scene::Point3& c = sphere.centre;
    const Sphere other_sphere{{changed(c.x), changed(c.y), changed(c.z)}, changed(sphere.radius)};
    const Enclosure s = exact.parameter(sphere, at);
    const Enclosure difference = abs(other.parameter(other_sphere, at) - s) / abs(s);
    EXPECT_LE(difference.upper(), 1.01 * condition * change) << spelled(ray) << spelled(sphere);
  }
}

}  // namespace
}  // namespace raycheck::reference
