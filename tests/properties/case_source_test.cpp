// What the sources of cases make: a generator that never gives what it is for tests nothing.

#include "properties/case_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "scene/validate.h"

namespace raycheck::properties {
namespace {

constexpr std::uint64_t kSeeds = 2000;

/// How many pairs of a ray and a sphere there are in kSeeds cases, by their exact class.
struct Counts {
  int pairs = 0;
  int hits = 0;
  int misses = 0;
  int tangents = 0;
  int ties = 0;  ///< Cases with two spheres met first at the same parameter.
};

Counts count(const CaseSource& source) {
  Counts counts;
  const Candidate nobody;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Case the_case = source.make(seed);
    Trial trial(the_case, nobody);
    for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
      for (std::size_t sphere = 0; sphere < the_case.scene.spheres.size(); ++sphere) {
        ++counts.pairs;
        switch (trial.exact_intersection(ray, sphere).hit_class) {
          case reference::HitClass::kHit:
            ++counts.hits;
            break;
          case reference::HitClass::kMiss:
            ++counts.misses;
            break;
          case reference::HitClass::kTangent:
            ++counts.tangents;
            break;
        }
      }
      const auto nearest =
          trial.exact_ray(ray).nearest(the_case.scene.spheres, the_case.scene.conventions);
      if (nearest && nearest->ties.size() > 1) ++counts.ties;
    }
  }
  return counts;
}

/// Calls visit(origin distance, impact, radius) in long double, good enough to tell what was meant.
template <class Visit>
void for_each_aim(std::string_view source, Visit visit) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Case the_case = find_case_source(source)->make(seed);
    const scene::Ray& ray = the_case.scene.rays.front();
    for (const scene::Sphere& sphere : the_case.scene.spheres) {
      using Real = long double;
      const Real t[] = {Real(sphere.centre.x) - ray.origin.x, Real(sphere.centre.y) - ray.origin.y,
                        Real(sphere.centre.z) - ray.origin.z};
      const Real d[] = {ray.direction.x, ray.direction.y, ray.direction.z};
      const Real c[] = {t[1] * d[2] - t[2] * d[1], t[2] * d[0] - t[0] * d[2],
                        t[0] * d[1] - t[1] * d[0]};
      const auto norm = [](const Real* v) {
        return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      };
      visit(norm(t), norm(c) / norm(d), Real(sphere.radius));
    }
  }
}

TEST(CaseSource, MakesValidCasesWithPixelsInTheImage) {
  for (const CaseSource& source : case_sources()) {
    SCOPED_TRACE(source.name);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Case the_case = source.make(seed);
      ASSERT_TRUE(scene::problems(the_case.scene).empty()) << seed;
      ASSERT_EQ(the_case.scene.camera.has_value(), source.has_camera);
      if (!source.has_camera) continue;
      ASSERT_FALSE(the_case.pixels.empty());
      for (const auto& pixel : the_case.pixels) {
        ASSERT_TRUE(pixel.i >= 0 && pixel.i < the_case.scene.camera->width);
        ASSERT_TRUE(pixel.j >= 0 && pixel.j < the_case.scene.camera->height);
      }
    }
  }
}

TEST(CaseSource, MakesTheSameCaseFromTheSameSeed) {
  for (const CaseSource& source : case_sources()) {
    std::set<std::string> differ;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const Case first = source.make(seed);
      const Case second = source.make(seed);
      EXPECT_EQ(first.scene, second.scene) << source.name;
      EXPECT_EQ(first.pixels, second.pixels) << source.name;
      if (!(first.scene == source.make(seed + 1).scene)) differ.insert(std::to_string(seed));
    }
    EXPECT_GT(differ.size(), 45u) << source.name;
  }
}

TEST(CaseSource, KeepsMakingBothHitsAndMisses) {
  for (const CaseSource& source : case_sources()) {
    const Counts counts = count(source);
    EXPECT_GT(counts.pairs, static_cast<int>(kSeeds)) << source.name;
    EXPECT_GT(10 * (counts.hits + counts.tangents), counts.pairs) << source.name;
    EXPECT_GT(10 * counts.misses, counts.pairs) << source.name;
  }
}

TEST(CaseSource, OfTiesHasTangentsAndTies) {
  const Counts counts = count(*find_case_source("ties"));
  EXPECT_GT(10 * counts.tangents, counts.pairs);
  EXPECT_GT(counts.ties, static_cast<int>(kSeeds) / 20);
  EXPECT_GT(count(*find_case_source("plain-cameras")).ties, static_cast<int>(kSeeds) / 50);
}

TEST(CaseSource, OfFarSpheresSpansElevenDecades) {
  std::set<int> decades;
  for_each_aim("far", [&](auto distance, auto, auto radius) {
    decades.insert(static_cast<int>(std::floor(std::log10(distance / radius))));
  });
  for (int decade = 1; decade < 12; ++decade) EXPECT_TRUE(decades.contains(decade)) << decade;
}

TEST(CaseSource, OfGrazingRaysSpansFourteenDecadesOnBothSides) {
  std::set<int> inside;
  std::set<int> outside;
  for_each_aim("grazing", [&](auto, auto impact, auto radius) {
    const auto depth = impact / radius - 1;
    if (depth != 0) {
      (depth < 0 ? inside : outside)
          .insert(static_cast<int>(std::floor(std::log10(std::abs(depth)))));
    }
  });
  for (int decade = -15; decade < -1; ++decade) {
    EXPECT_TRUE(inside.contains(decade)) << decade;
    EXPECT_TRUE(outside.contains(decade)) << decade;
  }
}

TEST(CaseSource, OfSurfacesStartsInsideOutsideAndWithinRoundingOfIt) {
  int inside = 0;
  int outside = 0;
  int on = 0;
  for_each_aim("surface", [&](auto distance, auto, auto radius) {
    const auto off = distance / radius - 1;
    ++(std::abs(off) < 1e-14 ? on : off < 0 ? inside : outside);
  });
  for (const int part : {inside, outside, on}) EXPECT_GT(part, static_cast<int>(kSeeds) / 10);
}

TEST(CaseSource, OfMagnitudesReachesTheEndsOfTheDoubleRange) {
  int smallest = 0;
  int largest = 0;
  int smallest_direction = 0;
  int largest_direction = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Case the_case = find_case_source("magnitudes")->make(seed);
    for (const scene::Sphere& sphere : the_case.scene.spheres) {
      if (sphere.radius == 0) continue;
      smallest = std::min(smallest, std::ilogb(sphere.radius));
      largest = std::max(largest, std::ilogb(sphere.radius));
    }
    const double x = the_case.scene.rays.front().direction.x;
    if (x == 0) continue;
    smallest_direction = std::min(smallest_direction, std::ilogb(x));
    largest_direction = std::max(largest_direction, std::ilogb(x));
  }
  EXPECT_LT(smallest, -1022);
  EXPECT_LT(smallest_direction, -1022);
  EXPECT_GT(largest, 900);
  EXPECT_GT(largest_direction, 900);
}

TEST(CaseSource, OfFarCamerasSpansTheEyesDistance) {
  double nearest = 1e300;
  double farthest = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const scene::Point3 eye = find_case_source("far-cameras")->make(seed).scene.camera->eye;
    const double distance = std::hypot(eye.x, eye.y, eye.z);
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  EXPECT_LT(nearest, 30);
  EXPECT_GT(farthest, 5e7);
}

TEST(CaseSource, UsesEveryConvention) {
  std::set<int> seen;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const scene::Conventions c = find_case_source("cameras")->make(seed).scene.conventions;
    seen.insert({static_cast<int>(c.rows), 10 + static_cast<int>(c.samples),
                 20 + static_cast<int>(c.origin), 30 + static_cast<int>(c.root),
                 40 + static_cast<int>(c.tangent)});
  }
  EXPECT_EQ(seen, (std::set<int>{0, 1, 10, 11, 20, 21, 30, 31, 40, 41, 42}));
}

TEST(CaseSource, IsFoundByItsName) {
  for (const CaseSource& source : case_sources()) {
    EXPECT_EQ(find_case_source(source.name), &source);
  }
  EXPECT_EQ(find_case_source("nowhere"), nullptr);
}

}  // namespace
}  // namespace raycheck::properties
