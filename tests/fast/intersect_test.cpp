#include "fast/intersect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "properties/cases/case_source.h"
#include "properties/domain.h"
#include "properties/quantity.h"
#include "reference/account/condition.h"
#include "reference/account/nearby_answer.h"
#include "reference/error_measure.h"
#include "reference/ray_error.h"
#include "tests/method_names.h"

namespace raycheck::fast {
namespace {

using scene::Ray;
using scene::Root;
using scene::Sphere;
using scene::Tangent;

Rays batch(const std::vector<Ray>& rays) {
  Rays result;
  result.resize(rays.size());
  for (std::size_t k = 0; k < rays.size(); ++k) {
    result.origin.x[k] = rays[k].origin.x;
    result.origin.y[k] = rays[k].origin.y;
    result.origin.z[k] = rays[k].origin.z;
    result.direction.x[k] = rays[k].direction.x;
    result.direction.y[k] = rays[k].direction.y;
    result.direction.z[k] = rays[k].direction.z;
  }
  return result;
}

Hits intersect(const IntersectMethod& method, const std::vector<Ray>& rays, const Sphere& sphere,
               Root root = Root::kNearest, Tangent tangent = Tangent::kHit) {
  Hits hits;
  method.intersect(batch(rays), sphere, root, tangent, hits);
  return hits;
}

const Sphere kUnitSphere = {{0, 0, 0}, 1};

class EachMethod : public testing::TestWithParam<const IntersectMethod*> {};

TEST_P(EachMethod, TakesBatchesOfAnySize) {
  std::vector<Ray> many;
  for (int k = 0; k < 1000; ++k) many.push_back({{-5, k * 0.002, 0}, {1, 0.001 * k, 0.5}});
  Hits hits = intersect(*GetParam(), many, {{0, 0, 2}, 2});
  ASSERT_EQ(hits.size(), 1000u);
  for (const std::size_t k : {std::size_t{0}, std::size_t{500}, std::size_t{999}}) {
    const Hits alone = intersect(*GetParam(), {many[k]}, {{0, 0, 2}, 2});
    ASSERT_EQ(alone.size(), 1u);
    EXPECT_EQ(alone.hit[0], hits.hit[k]);
    if (alone.hit[0]) {
      EXPECT_EQ(alone.parameter[0], hits.parameter[k]);
    }
  }
  GetParam()->intersect(Rays(), kUnitSphere, Root::kNearest, Tangent::kHit, hits);
  EXPECT_EQ(hits.size(), 0u);
  EXPECT_EQ(hits.point.size(), 0u);
}

TEST_P(EachMethod, AnswersOneRayAsItDoesABatch) {
  int hits_seen = 0;
  int misses_seen = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    for (const properties::CaseSource& source : properties::case_sources()) {
      if (source.has_camera) continue;
      const auto the_case = properties::any_case(source, seed);
      const scene::Conventions& conventions = the_case.scene.conventions;
      for (const Sphere& sphere : the_case.scene.spheres) {
        const Ray& ray = the_case.scene.rays.front();
        const Hits hits =
            intersect(*GetParam(), {ray, ray}, sphere, conventions.root, conventions.tangent);
        const auto hit =
            GetParam()->intersect_one(ray, sphere, conventions.root, conventions.tangent);
        ASSERT_EQ(hit.has_value(), hits.hit[1] == 1) << source.name << " " << seed;
        (hit ? hits_seen : misses_seen) += 1;
        if (!hit) continue;
        const double alone[] = {hit->parameter, hit->point.x, hit->point.y, hit->point.z};
        const double batched[] = {hits.parameter[1], hits.point.x[1], hits.point.y[1],
                                  hits.point.z[1]};
        EXPECT_EQ(std::memcmp(alone, batched, sizeof alone), 0) << source.name << " " << seed;
      }
    }
  }
  EXPECT_GT(hits_seen, 1000);
  EXPECT_GT(misses_seen, 1000);
}

TEST_P(EachMethod, RefusesByTheNameOfTheField) {
  const auto refusal = [&](const std::vector<Ray>& rays, const Sphere& sphere) -> std::string {
    try {
      intersect(*GetParam(), rays, sphere);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  const Ray good = {{0, 0, 0}, {1, 0, 0}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal({good}, kUnitSphere), "none");
  EXPECT_NE(refusal({good}, {{0, 0, 0}, -1}).find("radius"), std::string::npos);
  EXPECT_NE(refusal({}, {{0, nan, 0}, 1}).find("centre"), std::string::npos);
  const std::string zero = refusal({good, {{0, 0, 0}, {0, 0, 0}}}, kUnitSphere);
  EXPECT_NE(zero.find("ray 1"), std::string::npos) << zero;
  EXPECT_NE(zero.find("direction"), std::string::npos) << zero;
  const std::string origin = refusal({good, good, {{0, 0, nan}, {1, 0, 0}}}, kUnitSphere);
  EXPECT_NE(origin.find("ray 2"), std::string::npos) << origin;
  EXPECT_NE(origin.find("origin"), std::string::npos) << origin;
}

TEST_P(EachMethod, RanksTheFirstOfEqualSpheresFirst) {
  const std::vector<Sphere> spheres = {
      {{9, 0, 0}, 1}, {{5, 0, 0}, 1}, {{5, 0, 0}, 1}, {{-5, 0, 0}, 1}};
  const Rays rays =
      batch({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {-1, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}});
  using Index = std::optional<std::size_t>;
  const auto nearest = nearest_spheres(*GetParam(), rays, spheres, Root::kNearest, Tangent::kHit);
  EXPECT_EQ(nearest, (std::vector<Index>{1, 3, Index()}));
  EXPECT_EQ(nearest_spheres(*GetParam(), rays, {}, Root::kNearest, Tangent::kHit),
            (std::vector<Index>(3)));
}

std::optional<double> parameter(const std::optional<Hit>& hit) {
  return hit ? std::optional(hit->parameter) : std::nullopt;
}

/// What a method's answers to given rays come to. A class or root that is not the exact one is that
/// of inputs close by.
struct Audit {
  int hits = 0;
  double worst_parameter = 0;  ///< Over the growth that the condition number allows.
  double worst_point = 0;
};

void audit(const IntersectMethod& method, const properties::CaseSource& source, Audit& found) {
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    const auto the_case = properties::any_case(source, seed);
    if (!properties::lengths_are_within(the_case.scene, method.domain.smallest_length,
                                        method.domain.largest_length)) {
      continue;
    }
    const Ray& ray = the_case.scene.rays.front();
    const scene::Conventions& conventions = the_case.scene.conventions;
    const reference::ExactRay exact(ray);
    const reference::Neighbourhood around{conventions.root, conventions.tangent,
                                          properties::excused_change(method.unit_roundoff)};
    for (const Sphere& sphere : the_case.scene.spheres) {
      const reference::Intersection at = exact.intersect(sphere, conventions.root);
      const auto hit = method.intersect_one(ray, sphere, conventions.root, conventions.tangent);
      const bool is_hit = counts_as_hit(at.hit_class, conventions.tangent);
      if (hit.has_value() != is_hit ||
          (is_hit && is_at_other_root(exact, sphere, at, hit->parameter))) {
        const bool is_unjudged = at.hit_class == reference::HitClass::kTangent &&
                                 conventions.tangent == Tangent::kEither;
        // A double root at 0 is met under root = smaller by one radius alone: that is undecided.
        EXPECT_TRUE(is_unjudged || right_nearby(exact, sphere, around, parameter(hit)).found !=
                                       reference::Nearby::kRefuted)
            << method.name << " " << source.name << " " << seed;
        continue;
      }
      if (!hit || at.hit_class != reference::HitClass::kHit) continue;
      ++found.hits;
      const auto worse = [](double& worst, double error, double condition) {
        worst = std::max(worst, error / properties::bound_growth(condition));
      };
      worse(found.worst_parameter,
            reference::ulp_error(hit->parameter, exact.parameter(sphere, at)),
            reference::condition_of_parameter(exact, sphere, at));
      worse(found.worst_point, reference::relative_error(hit->point, exact.point(sphere, at)),
            reference::condition_of_point(exact, sphere, at));
    }
  }
}

void expect_within_bounds(const IntersectMethod& method, const Audit& found, int least_hits) {
  EXPECT_LE(found.worst_parameter, method.max_ulp) << method.name;
  EXPECT_LE(found.worst_point, method.max_point_ulp) << method.name;
  EXPECT_GE(found.hits, least_hits) << method.name;
}

TEST(IntersectBounds, HoldOnEveryGivenRayForTheMethodsThatKeepThem) {
  int methods = 0;
  for (const IntersectMethod* method : intersect_methods()) {
    if (!method->not_kept.empty()) continue;
    ++methods;
    Audit found;
    for (const properties::CaseSource& source : properties::case_sources()) {
      if (!source.has_camera) audit(*method, source, found);
    }
    expect_within_bounds(*method, found, 3500);
  }
  EXPECT_GE(methods, 7);
}

TEST(IntersectBounds, OfTheOthersHoldNextToTheSurface) {
  for (const IntersectMethod* method : {&kQuadratic, &kLecture, &kStableQuadratic, &kKahan}) {
    Audit found;
    audit(*method, *properties::find_case_source("surface"), found);
    expect_within_bounds(*method, found, 200);
  }
}

TEST(IntersectBounds, OfSinglePrecisionHoldOnTies) {
  for (const IntersectMethod* method : {&kSingleQuadratic, &kSingleLecture}) {
    Audit found;
    audit(*method, *properties::find_case_source("ties"), found);
    expect_within_bounds(*method, found, 200);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, EachMethod,
                         testing::ValuesIn(intersect_methods().begin(), intersect_methods().end()),
                         test_name);

}  // namespace
}  // namespace raycheck::fast
