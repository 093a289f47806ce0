// Decisions of reference/exact_ray.h over the whole double range, under small changes of the input,
// and on input that is no problem.

#include "reference/exact_ray.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

#include "reference/interval_ray.h"
#include "tests/numbers.h"
#include "tests/reference/random_cases.h"

namespace raycheck::reference {
namespace {

using scene::Camera;
using scene::Conventions;
using scene::Ray;
using scene::Root;
using scene::Sphere;

/// Compares the engines on one ray and two spheres.
void expect_engines_agree(const ExactRay& ray, const Sphere& first, const Sphere& second, int& hits,
                          int& pairs) {
  for (const Root root : {Root::kNearest, Root::kSmaller}) {
    const Intersection at_first = ray.intersect(first, root);
    const Intersection at_second = ray.intersect(second, root);
    ASSERT_EQ(at_first, ray.intersect(first, root, {Engine::kFieldOnly}));
    ASSERT_EQ(at_second, ray.intersect(second, root, {Engine::kFieldOnly}));
    hits += at_first.hit_class != HitClass::kMiss ? 1 : 0;
    if (at_first.hit_class == HitClass::kMiss || at_second.hit_class == HitClass::kMiss) continue;
    ++pairs;
    ASSERT_EQ(ray.compare(first, at_first, second, at_second),
              ray.compare(first, at_first, second, at_second, {Engine::kFieldOnly}));
  }
}

TEST(Engines, AgreeOnRaysAndCamerasOfAllSizes) {
  Random random(2);
  int hits = 0, pairs = 0, seen = 0, pairs_seen = 0;
  for (int k = 0; k < 1600 && !HasFailure(); ++k) {
    const Sizes sizes = random.one_in(4) ? Sizes::kSmallIntegers : Sizes::kAll;
    const Ray ray = random_ray(random, sizes);
    const Sphere first = random_sphere(random, sizes);
    const Sphere second = random_sphere(random, sizes);
    SCOPED_TRACE(spelled(ray) + spelled(first) + spelled(second));
    expect_engines_agree(ExactRay(ray), first, second, hits, pairs);
    if (k % 13 != 0) continue;
    const Camera camera = random_camera(random, sizes);
    SCOPED_TRACE(spelled(camera));
    const ExactRay through(ExactCamera(camera, random_conventions(random)),
                           random_pixel(random, camera));
    expect_engines_agree(through, first, second, seen, pairs_seen);
  }
  EXPECT_GE(hits, 200);
  EXPECT_GE(pairs, 80);
  EXPECT_GE(seen, 16);
  EXPECT_GE(pairs_seen, 4);
}

TEST(Engines, AgreeWhenUpIsParallelButForTheLastOf800Bits) {
  // E - A = (1e200 - 1e-100, 1e200, 0): at 256 bits it looks parallel to up.
  const Camera camera{{1e200, 1e200, 0}, {1e-100, 0, 0}, {1, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 3};
  const ExactCamera exact(camera, {});
  EXPECT_EQ(exact.rounded_frame().U, (scene::UnitVector3{0, 0, 1}));
  int hits = 0;
  int pairs = 0;
  for (std::int64_t i = 0; i < 3; ++i) {
    for (std::int64_t j = 0; j < 3; ++j) {
      const ExactRay ray(exact, {i, j});
      for (const Sphere& sphere : {Sphere{{0, 0, 0}, 1}, Sphere{{0, 0, 0}, 1e200},
                                   Sphere{{0, 0, 0}, 1e201}, Sphere{{1e200, 1e200, 0}, 3}}) {
        expect_engines_agree(ray, sphere, {{1e200, 1e200, 0}, 3}, hits, pairs);
      }
    }
  }
  EXPECT_GE(hits, 9);
  EXPECT_GE(pairs, 9);
}

void expect_refused(const std::function<void()>& action, const std::string& field) {
  try {
    action();
    ADD_FAILURE() << field << ": nothing thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
  }
}

TEST(InvalidInput, IsRefusedByTheNameOfItsField) {
  expect_refused([] { ExactRay(Ray{{0, kNaN, 0}, {1, 0, 0}}); }, "ray.origin");
  expect_refused([] { ExactRay(Ray{{0, 0, 0}, {0, 0, 0}}); }, "ray.direction");
  Camera camera{{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 2};
  const ExactCamera exact(camera, {});
  EXPECT_NO_THROW(ExactRay(exact, {2, 1}));
  for (const scene::Pixel& pixel : {scene::Pixel{3, 0}, {0, 2}, {-1, 0}, {0, -1}}) {
    expect_refused([&] { ExactRay(exact, pixel); }, "pixel");
  }
  camera.up = {0, 0, 1e-300};
  expect_refused([&] { ExactCamera(camera, {}); }, "camera.up");
  camera.width = 1;
  expect_refused([&] { ExactCamera(camera, {}); }, "camera.width");
}

TEST(InvalidInput, OfASphereIsRefusedByEveryFunctionThatTakesOne) {
  const Camera camera{{0, 0, 9}, {0, 0, 0}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 3, 3};
  const Sphere good{{0, 0, 0}, 2};
  for (const Sphere& bad : {Sphere{{0, 0, 0}, -1}, Sphere{{0, 0, 0}, kNaN}}) {
    for (const ExactRay& ray :
         {ExactRay(Ray{{-5, 0, 0}, {1, 0, 0}}), ExactRay(ExactCamera(camera, {}), {1, 1})}) {
      const auto refuses = [&](auto call) { expect_refused(call, "sphere.radius"); };
      refuses([&] { ray.intersect(bad); });
      refuses([&] { ray.compare(bad, kSmallerHit, good, kSmallerHit); });
      refuses([&] { ray.compare(good, kSmallerHit, bad, kSmallerHit); });
      refuses([&] { ray.nearest(std::vector<Sphere>{good, bad}, {}); });
      refuses([&] { ray.parameter(bad, kSmallerHit); });
      refuses([&] { ray.point(bad, kSmallerHit); });
      refuses([&] { ray.rounded_parameter(bad, kSmallerHit); });
      refuses([&] { ray.rounded_point(bad, kSmallerHit); });
      refuses([&] { ray.enclose(128).half_chord_sq(bad); });
    }
  }
}

const Ray kFromZero{{0, 0, 0}, {1, 0, 0}};

TEST(IntervalRay, TouchesAtItsOriginByTheSmallerRoot) {
  const Ray along{{1, 0, 0}, {0, 1, 0}};
  for (const Root root : {Root::kNearest, Root::kSmaller}) {
    const auto found = intersect_by_intervals(along, {{0, 0, 0}, 1}, root);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->intersection, (Intersection{HitClass::kTangent, WhichRoot::kSmaller}));
  }
}

TEST(Nearest, IsEmptyWhenNothingIsMet) {
  const ExactRay ray(kFromZero);
  EXPECT_FALSE(ray.nearest({}, {}).has_value());
  const std::vector<Sphere> spheres{{{-5, 0, 0}, 1}, {{5, 5, 0}, 1}};
  EXPECT_FALSE(ray.nearest(spheres, {}).has_value());
}

TEST(Nearest, ReportsEveryTieAndTheFirstOfThem) {
  // All but the first two are met at s = 4; the fifth from inside.
  const std::vector<Sphere> spheres{{{9, 0, 0}, 1}, {{-3, 0, 0}, 1}, {{6, 0, 0}, 2}, {{5, 0, 0}, 1},
                                    {{0, 0, 0}, 4}, {{4, 3, 0}, 3},  {{8, 0, 0}, 4}};
  const auto nearest = ExactRay(kFromZero).nearest(spheres, {});
  ASSERT_TRUE(nearest.has_value());
  EXPECT_EQ(nearest->index, 2u);
  EXPECT_EQ(nearest->intersection, kSmallerHit);
  EXPECT_EQ(nearest->ties, (std::vector<std::size_t>{2, 3, 4, 5, 6}));
}

TEST(Nearest, EqualSpheresTieWithoutTheField) {
  const ExactRay ray(Ray{{0, 0, 0}, {1, 0.1, 0.2}});
  const Sphere sphere = {{5, 0.3, 1}, 1};
  const Intersection at = ray.intersect(sphere);
  ASSERT_EQ(at, kSmallerHit);
  Rung highest = Rung::kIntervals;
  EXPECT_EQ(ray.compare(sphere, at, sphere, at, {Engine::kFiltered, &highest}), 0);
  EXPECT_EQ(highest, Rung::kIntervals);
  EXPECT_EQ(ray.compare(sphere, at, sphere, at, {Engine::kFieldOnly}), 0);
  EXPECT_EQ(ray.compare(sphere, at, sphere, {HitClass::kHit, WhichRoot::kLarger}), -1);
}

TEST(Nearest, FollowsTheConventions) {
  const std::vector<Sphere> spheres{{{0, 0, 0}, 3}, {{4, 2, 0}, 2}, {{9, 0, 0}, 1}};
  const ExactRay ray(kFromZero);
  Conventions conventions;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 0u);
  conventions.root = Root::kSmaller;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 1u);
  conventions.tangent = scene::Tangent::kEither;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 1u);
  conventions.tangent = scene::Tangent::kMiss;
  EXPECT_EQ(ray.nearest(spheres, conventions)->index, 2u);
}

}  // namespace
}  // namespace raycheck::reference
