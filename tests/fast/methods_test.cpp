// Properties of every method, also of exact methods, that the laws do not test: batches, refusals,
// ranking.

#include "fast/camera_frame.h"
#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/candidates/reference_methods.h"
#include "properties/cases/case_source.h"
#include "tests/method_names.h"
#include "tests/testing.h"

namespace raycheck::fast {
namespace {

using namespace scene;

Rays batch_of(const std::vector<Ray>& given) {
  Rays rays;
  rays.resize(given.size());
  for (std::size_t k = 0; k < given.size(); ++k) rays.set(k, given[k]);
  return rays;
}

/// A batch has the answers of single calls, to the bit. Returns the number of hits.
int expect_batch_is_single_calls(const IntersectMethod& method, const std::vector<Ray>& rays,
                                 const Sphere& sphere, scene::HitRule rule) {
  Hits hits;
  method.intersect(batch_of(rays), sphere, rule, hits);
  EXPECT_EQ(hits.size(), rays.size()) << method.name;
  if (hits.size() != rays.size()) return 0;
  int count = 0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto one = method.intersect_one(rays[k], sphere, rule);
    EXPECT_EQ(one.has_value(), hits.hit[k] != 0) << method.name << " ray " << k;
    if (!one || hits.hit[k] == 0) continue;
    ++count;
    const auto expect_same = [&](double a, double b) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b))
          << method.name << " ray " << k;
    };
    expect_same(one->parameter, hits.parameter[k]);
    expect_same(one->point.x, hits.point.x[k]);
    expect_same(one->point.y, hits.point.y[k]);
    expect_same(one->point.z, hits.point.z[k]);
  }
  return count;
}

/// Invalid input is refused, naming the field, and valid input is not.
void expect_refusals(const IntersectMethod& method) {
  const Ray good = {{-5, 0, 0}, {1, 0, 0}};
  const auto expect_says = [&](const std::vector<Ray>& rays, const Sphere& sphere,
                               const std::vector<std::string>& parts) {
    Hits hits;
    const auto ask = [&] { method.intersect(batch_of(rays), sphere, {}, hits); };
    for (const std::string& part : parts) EXPECT_TRUE(has(thrown_by(ask), part)) << method.name;
  };
  const Sphere sphere = {{0, 0, 0}, 1};
  expect_says({good, good}, sphere, {"no error"});
  expect_says({}, sphere, {"no error"});
  expect_says({good}, {{0, 0, 0}, -1}, {"radius"});
  expect_says({}, {{0, kNaN, 0}, 1}, {"centre"});
  expect_says({good, {{0, 0, 0}, {0, 0, 0}}}, sphere, {"ray 1", "direction"});
  expect_says({good, good, {{0, 0, kNaN}, {1, 0, 0}}}, sphere, {"ray 2", "origin"});
}

class EachMethod : public testing::TestWithParam<const IntersectMethod*> {};

TEST_P(EachMethod, TakesBatchesOfAnySize) {
  std::vector<Ray> many;
  for (int k = 0; k < 1000; ++k) many.push_back({{-5, k * 0.002, 0}, {1, 0.001 * k, 0.5}});
  const Sphere sphere = {{0, 0, 2}, 2};
  EXPECT_GT(expect_batch_is_single_calls(*GetParam(), many, sphere, {}), 100);
  Hits hits;
  GetParam()->intersect(batch_of(many), sphere, {}, hits);
  GetParam()->intersect(Rays(), sphere, {}, hits);
  EXPECT_EQ(hits.size(), 0u);
  EXPECT_EQ(hits.point.size(), 0u);
}

TEST_P(EachMethod, AnswersSingleRaysAsBatches) {
  int hits = 0, asked = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    for (const properties::CaseSource& source : properties::case_sources()) {
      if (source.has_camera) continue;
      const scene::Scene scene = properties::ChosenSource{&source}.make(seed).scene;
      for (const Sphere& sphere : scene.spheres) {
        asked += 2;
        hits += expect_batch_is_single_calls(*GetParam(), {scene.rays.front(), scene.rays.front()},
                                             sphere, scene.conventions.hit_rule());
      }
    }
  }
  EXPECT_GT(hits, 600);
  EXPECT_GT(asked - hits, 600);
}

TEST_P(EachMethod, NamesTheFieldOfInvalidInput) { expect_refusals(*GetParam()); }

TEST_P(EachMethod, RanksTheFirstOfEqualSpheresFirst) {
  const std::vector<Sphere> spheres = {
      {{9, 0, 0}, 1}, {{5, 0, 0}, 1}, {{5, 0, 0}, 1}, {{-5, 0, 0}, 1}};
  const Rays rays =
      batch_of({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {-1, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}});
  const auto nearest = nearest_spheres(*GetParam(), rays, spheres, {});
  ASSERT_EQ(nearest.size(), 3u);
  EXPECT_EQ(nearest[0].value().sphere, 1u);
  EXPECT_EQ(nearest[1].value().sphere, 3u);
  EXPECT_FALSE(nearest[2]);
  for (const auto& none : nearest_spheres(*GetParam(), rays, {}, {})) EXPECT_FALSE(none);
}

INSTANTIATE_TEST_SUITE_P(Methods, EachMethod,
                         testing::ValuesIn(intersect_methods().begin(), intersect_methods().end()),
                         test_name);

INSTANTIATE_TEST_SUITE_P(ExactMethods, EachMethod,
                         testing::ValuesIn(properties::exact_methods().begin(),
                                           properties::exact_methods().end()),
                         test_name);

const Camera kFirst = {{8, 8, 100}, {8, 8, 54}, {0, 1, 0}, -30, {}, -30, 30, -20, 20, 2, 2};

UnitVector3 direction(const Rays& rays, std::size_t k) {
  return {rays.direction.x.at(k), rays.direction.y.at(k), rays.direction.z.at(k)};
}

TEST(PixelRay, TakesBatchesOfAnySize) {
  Camera camera = kFirst;
  camera.width = camera.height = 200;
  std::vector<Pixel> many;
  for (std::int64_t k = 0; k < 1000; ++k) many.push_back({k % 200, k / 200});
  for (const PixelRayMethod* method : pixel_ray_methods()) {
    Rays rays;
    method->focal_rays(camera, {}, many, rays);
    ASSERT_EQ(rays.size(), 1000u);
    Rays single;
    for (const std::size_t k :
         {std::size_t{0}, std::size_t{31}, std::size_t{64}, std::size_t{127}, std::size_t{999}}) {
      method->focal_rays(camera, {}, std::span(&many[k], 1), single);
      ASSERT_EQ(single.size(), 1u);
      EXPECT_EQ(direction(single, 0), direction(rays, k)) << method->name;
    }
    // An answer does not depend on the pixels before it.
    const std::vector<Pixel> scattered = {{7, 1},  {8, 2},  {10, 2}, {9, 2},
                                          {63, 2}, {64, 2}, {65, 2}};
    method->focal_rays(camera, {}, scattered, single);
    for (std::size_t k = 0; k < scattered.size(); ++k) {
      const auto in_order = static_cast<std::size_t>(scattered[k].j * 200 + scattered[k].i);
      EXPECT_EQ(direction(single, k), direction(rays, in_order)) << method->name;
    }
    method->focal_rays(camera, {}, {}, rays);  // rays that are in use shrink
    EXPECT_EQ(rays.size(), 0u);
    EXPECT_EQ(rays.direction.size(), 0u);
  }
}

TEST(PixelRay, NamesTheFieldOfInvalidInput) {
  Camera flat = kFirst, narrow = kFirst, parallel = kFirst, nowhere = kFirst;
  flat.right = flat.left;
  narrow.width = 1;  // i/(w-1) is 0/0 on the edges, and well defined at the centres
  parallel.up = {0, 0, -3};
  nowhere.look_at = nowhere.eye;
  const std::vector<Pixel> pixels = {{0, 0}};
  Conventions centres;
  centres.samples = scene::Samples::kCentres;
  Rays rays;
  for (const PixelRayMethod* method : pixel_ray_methods()) {
    EXPECT_TRUE(
        has(thrown_by([&] { method->focal_rays(flat, {}, pixels, rays); }), "camera.right"));
  }
  EXPECT_NE(thrown_by([&] { kDirectRays.focal_rays(narrow, {}, pixels, rays); }), "no error");
  EXPECT_EQ(thrown_by([&] { kDirectRays.focal_rays(narrow, centres, pixels, rays); }), "no error");
  EXPECT_TRUE(has(thrown_by([&] { camera_frame(parallel); }), "camera.up"));
  EXPECT_TRUE(has(thrown_by([&] { camera_frame(nowhere); }), "camera.look_at"));
}

}  // namespace
}  // namespace raycheck::fast
