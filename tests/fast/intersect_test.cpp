// What every method does beyond what the laws say of its answers: batches, refusals, ranking.

#include "fast/intersect.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "properties/cases/case_source.h"
#include "tests/method_expectations.h"
#include "tests/method_names.h"

namespace raycheck::fast {
namespace {

using scene::Ray;
using scene::Root;
using scene::Sphere;
using scene::Tangent;

class EachMethod : public testing::TestWithParam<const IntersectMethod*> {};

TEST_P(EachMethod, TakesBatchesOfAnySize) {
  std::vector<Ray> many;
  for (int k = 0; k < 1000; ++k) many.push_back({{-5, k * 0.002, 0}, {1, 0.001 * k, 0.5}});
  const Sphere sphere = {{0, 0, 2}, 2};
  EXPECT_GT(expect_batch_is_single_calls(*GetParam(), many, sphere, Root::kNearest, Tangent::kHit),
            100);
  Hits hits;
  GetParam()->intersect(batch_of(many), sphere, Root::kNearest, Tangent::kHit, hits);
  GetParam()->intersect(Rays(), sphere, Root::kNearest, Tangent::kHit, hits);
  EXPECT_EQ(hits.size(), 0u);
  EXPECT_EQ(hits.point.size(), 0u);
}

TEST_P(EachMethod, AnswersOneRayAsItDoesABatch) {
  int hits = 0, asked = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    for (const properties::CaseSource& source : properties::case_sources()) {
      if (source.has_camera) continue;
      const scene::Scene scene = properties::any_case(source, seed).scene;
      for (const Sphere& sphere : scene.spheres) {
        asked += 2;
        hits +=
            expect_batch_is_single_calls(*GetParam(), {scene.rays.front(), scene.rays.front()},
                                         sphere, scene.conventions.root, scene.conventions.tangent);
      }
    }
  }
  EXPECT_GT(hits, 2000);
  EXPECT_GT(asked - hits, 2000);
}

TEST_P(EachMethod, RefusesByTheNameOfTheField) { expect_refusals(*GetParam()); }

TEST_P(EachMethod, RanksTheFirstOfEqualSpheresFirst) {
  const std::vector<Sphere> spheres = {
      {{9, 0, 0}, 1}, {{5, 0, 0}, 1}, {{5, 0, 0}, 1}, {{-5, 0, 0}, 1}};
  const Rays rays =
      batch_of({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {-1, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}});
  using Index = std::optional<std::size_t>;
  const auto nearest = nearest_spheres(*GetParam(), rays, spheres, Root::kNearest, Tangent::kHit);
  EXPECT_EQ(nearest, (std::vector<Index>{1, 3, Index()}));
  EXPECT_EQ(nearest_spheres(*GetParam(), rays, {}, Root::kNearest, Tangent::kHit),
            (std::vector<Index>(3)));
}

INSTANTIATE_TEST_SUITE_P(Methods, EachMethod,
                         testing::ValuesIn(intersect_methods().begin(), intersect_methods().end()),
                         test_name);

}  // namespace
}  // namespace raycheck::fast
