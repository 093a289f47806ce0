// Sources make the kinds of cases for which they exist (families_test.cpp tests severities); and
// tests of shrinking cases and varying scenes.

#include "properties/cases/case_source.h"

#include "properties/cases/random.h"
#include "properties/cases/shrink.h"
#include "properties/cases/varied_scene.h"
#include "properties/mistakes/shown_picture.h"
#include "properties/trial.h"
#include "reference/exact_ray.h"
#include "scene/number.h"
#include "scene/validate.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

using scene::Scene;

/// The number of pairs of a ray and a sphere, by exact hit class.
struct Mixture {
  int pairs = 0, hits = 0, misses = 0, tangents = 0;
};

Mixture count(const CaseSource& source, int severity, std::uint64_t seeds) {
  Mixture counts;
  const Candidate no_functions;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Case the_case = source.make(severity, seed);
    Trial trial(the_case, no_functions);
    for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
      for (std::size_t sphere = 0; sphere < the_case.scene.spheres.size(); ++sphere) {
        ++counts.pairs;
        const auto hit_class = trial.exact_intersection(ray, sphere).hit_class;
        counts.hits += hit_class == reference::HitClass::kHit ? 1 : 0;
        counts.misses += hit_class == reference::HitClass::kMiss ? 1 : 0;
        counts.tangents += hit_class == reference::HitClass::kTangent ? 1 : 0;
      }
    }
  }
  return counts;
}

/// The number of rays that meet two spheres first, at the same parameter.
int count_ties(const CaseSource& source, std::uint64_t seeds) {
  int ties = 0;
  const Candidate no_functions;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Case the_case = ChosenSource{&source}.make(seed);
    Trial trial(the_case, no_functions);
    for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
      const auto nearest =
          trial.exact_ray(ray).nearest(the_case.scene.spheres, the_case.scene.conventions);
      ties += nearest && nearest->ties.size() > 1 ? 1 : 0;
    }
  }
  return ties;
}

TEST(CaseSource, KeepsMakingBothHitsAndMisses) {
  for (const CaseSource& source : case_sources()) {
    const int highest = source.severities ? source.severities->highest : 0;
    std::set<int> severities;
    for (int k = 0; k <= 16; ++k) severities.insert(highest * k / 16);
    for (const int severity : severities) {
      SCOPED_TRACE(std::string(source.name) + "@" + std::to_string(severity));
      const Mixture counts = count(source, severity, 120);
      EXPECT_GE(counts.pairs, 120);
      EXPECT_GT(20 * (counts.hits + counts.tangents), counts.pairs);
      // tangent-ulps has only tangents at its highest severity.
      const bool only_tangents = source.name == "tangent-ulps" && severity == highest;
      EXPECT_GT(20 * (only_tangents ? counts.tangents : counts.misses), counts.pairs);
    }
  }
}

TEST(CaseSource, OfTiesHasTangentsAndTies) {
  const CaseSource& source = *find_case_source("ties");
  const Mixture counts = count(source, 0, 2000);
  EXPECT_GT(10 * counts.tangents, counts.pairs);
  EXPECT_GT(count_ties(source, 2000), 100);
  EXPECT_GT(count_ties(*find_case_source("plain-cameras"), 2000), 40);
}

TEST(CaseSource, UsesEveryConvention) {
  for (const CaseSource& source : case_sources()) {
    SCOPED_TRACE(source.name);
    std::set<int> seen;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const scene::Conventions c = ChosenSource{&source}.make(seed).scene.conventions;
      seen.insert({static_cast<int>(c.rows), 10 + static_cast<int>(c.samples),
                   30 + static_cast<int>(c.root), 40 + static_cast<int>(c.tangent)});
      if (source.name != "near-plane") seen.insert(20 + static_cast<int>(c.origin));
    }
    seen.insert({20, 21});
    EXPECT_EQ(seen, (std::set<int>{0, 1, 10, 11, 12, 20, 21, 30, 31, 40, 41, 42}));
  }
}

TEST(AnyCase, HasEverySeverityAboutAsOften) {
  const CaseSource& source = *find_case_source("distance");
  std::vector<int> found(static_cast<std::size_t>(source.severities->highest) + 1);
  for (std::uint64_t seed = 0; seed < 1600; ++seed) {
    const Case the_case = ChosenSource{&source}.make(seed);
    for (int severity = 0; severity <= source.severities->highest; ++severity) {
      if (source.make(severity, seed).scene == the_case.scene) {
        ++found[static_cast<std::size_t>(severity)];
      }
    }
  }
  for (const int count : found) EXPECT_NEAR(count, 100, 40);
}

TEST(ChosenSource, IsASourceOrOneOfItsSeverities) {
  for (const char* name : {"rays", "distance", "distance@0", "distance@15", "scale@1074"}) {
    EXPECT_EQ(chosen_source(name).name(), name);
  }
  const CaseSource& distance = *find_case_source("distance");
  EXPECT_EQ(chosen_source("distance@7").make(3).scene, distance.make(7, 3).scene);
}

TEST(ChosenSource, NamesWhatIsWrong) {
  const auto error_of = [](std::string_view name) {
    return thrown_by([&] { chosen_source(name); });
  };
  EXPECT_EQ(error_of("moon"), "no source of cases is called 'moon'");
  EXPECT_EQ(error_of("moon@3"), "no source of cases is called 'moon'");
  EXPECT_EQ(error_of("rays@3"), "'rays' has no severities to choose from");
  for (const std::string severity : {"", "-1", "16", "x", "3x", "+3", "99999999999"}) {
    EXPECT_EQ(error_of("distance@" + severity),
              "severities of 'distance' are 0 to 15, not '" + severity + "'");
  }
}

TEST(ChosenBy, ChoosesAllSourcesAboutEquallyOften) {
  std::vector<ChosenSource> all;
  for (const CaseSource& source : case_sources()) all.push_back({&source});
  constexpr std::uint64_t kMean = 1000;
  std::map<std::string, std::uint64_t> counts;
  for (std::uint64_t seed = 0; seed < kMean * all.size(); ++seed) {
    ++counts[chosen_by(all, seed).name()];
  }
  EXPECT_EQ(counts.size(), all.size());
  for (const auto& [name, count] : counts) {
    EXPECT_NEAR(static_cast<double>(count), kMean, 5 * std::sqrt(kMean)) << name;
  }
}

TEST(ChosenBy, KeepsItsChoiceUnlessAnAddedSourceIsChosen) {
  std::vector<ChosenSource> all;
  for (const CaseSource& source : case_sources()) all.push_back({&source});
  Random seeds(1);
  for (std::size_t added = 0; added < all.size(); ++added) {
    std::vector<ChosenSource> fewer = all;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(added));
    std::uint64_t taken_over = 0;
    constexpr std::uint64_t kSeeds = 500;
    for (std::uint64_t k = 0; k < kSeeds; ++k) {
      const std::uint64_t seed = seeds.bits();
      const ChosenSource& now = chosen_by(all, seed);
      if (now.source == all[added].source) {
        ++taken_over;
      } else {
        EXPECT_EQ(chosen_by(fewer, seed).name(), now.name());
      }
    }
    EXPECT_GT(taken_over, 0u) << all[added].name();
    EXPECT_LT(taken_over, kSeeds / 5) << all[added].name();
  }
}

const std::vector<double> kSamples = {
    1,         -1,        2,           0.5,  1.0 / 3,  -10, 1e6, 1e300, kSmallestNormal,
    kSmallest, -kLargest, 1 + 0x1p-52, M_PI, 12345.678};

TEST(Shrink, OffersOnlySimplerFiniteDoubles) {
  EXPECT_TRUE(simpler(0.0).empty());
  for (const double value : kSamples) {
    const auto offers = simpler(value);
    EXPECT_FALSE(offers.empty()) << value;
    for (const double offer : offers) {
      EXPECT_LT(complexity(offer), complexity(value)) << value << " to " << offer;
      EXPECT_TRUE(std::isfinite(offer)) << value;
    }
    EXPECT_EQ(offers.front(), 0) << value;
  }
}

/// Replaces the value by the first simpler one that satisfies `keeps`, as often as there is one.
double shrunk(double value, const std::function<bool(double)>& keeps) {
  for (;;) {
    const auto offers = simpler(value);
    const auto next = std::find_if(offers.begin(), offers.end(), keeps);
    if (next == offers.end()) return value;
    value = *next;
  }
}

TEST(Shrink, LeadsToSmallIntegersAndFewBits) {
  for (const double value : kSamples) {
    EXPECT_EQ(shrunk(value, [](double) { return true; }), 0);
    EXPECT_EQ(std::abs(shrunk(value, [](double x) { return x != 0; })), 1) << value;
  }
  EXPECT_LE(complexity(shrunk(12345.678, [](double x) { return x > 1000; })), 12);
  EXPECT_EQ(shrunk(-7.25, [](double x) { return x < 0; }), -1);
  EXPECT_EQ(shrunk(M_PI, [](double x) { return x > 2.5 && x < 3.5; }), 3);
}

TEST(Shrink, FindsTheSmallestImageByHalving) {
  const CaseSource& source = *find_case_source("image-size");
  Case the_case = source.make(source.severities->highest, 1);
  ASSERT_EQ(the_case.scene.camera->width, scene::kMostPixelsAcross);
  const auto is_wide = [](const Case& c) { return c.scene.camera->width > 46340; };
  ShrinkBudget budget = {.tries = 10000};
  the_case = smallest(the_case, budget, is_wide);
  EXPECT_EQ(the_case.scene.camera->width, 46341);
}

/// The scene is so large that copies with one simpler number each do not fit into memory.
TEST(Shrink, TakesHalvesOfManySpheresFirstAndGivesUpWhereAllAreNeeded) {
  Case many;
  many.scene.rays = {{{}, {0, 0, 1}}};
  many.scene.spheres.assign(20'000, {{1.3, 2.7, 9.1}, 2.9});
  many.scene.spheres[12'345].radius = 8.5;
  ShrinkBudget budget;
  const Case one = smallest(many, budget, [](const Case& next) {
    return std::any_of(next.scene.spheres.begin(), next.scene.spheres.end(),
                       [](const scene::Sphere& sphere) { return sphere.radius == 8.5; });
  });
  EXPECT_EQ(one.scene.spheres, (std::vector<scene::Sphere>{{{0, 0, 0}, 8.5}}));
  EXPECT_FALSE(budget.is_spent());
  budget = {};
  std::int64_t tries = 0;
  const Case all = smallest(many, budget, [&](const Case& next) {
    ++tries;
    return next.scene.spheres.size() == many.scene.spheres.size();
  });
  EXPECT_TRUE(budget.is_spent());
  EXPECT_LE(tries, ShrinkBudget::kParts / std::ssize(many.scene.spheres) * 2 + 1);
  EXPECT_EQ(all.scene.spheres.size(), many.scene.spheres.size());
}

TEST(Shrink, EndsAtAPlainCaseByValidOnes) {
  for (const CaseSource& source : case_sources()) {
    SCOPED_TRACE(source.name);
    Case the_case = ChosenSource{&source}.make(7);
    int steps = 0;
    for (auto offers = simpler(the_case); !offers.empty(); offers = simpler(the_case)) {
      for (const Case& offer : offers) {
        ASSERT_TRUE(scene::defects(offer.scene).empty());
        ASSERT_EQ(offer.scene.camera.has_value(), the_case.scene.camera.has_value());
        for (const auto& pixel : offer.pixels) {
          ASSERT_TRUE(pixel.i < offer.scene.camera->width && pixel.j < offer.scene.camera->height);
        }
      }
      the_case = offers.front();
      ASSERT_LT(++steps, 20000);
    }
    EXPECT_TRUE(the_case.scene.spheres.empty());
    EXPECT_EQ(the_case.scene.conventions, scene::Conventions{});
    if (the_case.scene.camera) {
      EXPECT_EQ(the_case.pixels, (std::vector<scene::Pixel>{{0, 0}}));
      EXPECT_EQ(the_case.scene.camera->width, 2);
      EXPECT_EQ(the_case.scene.camera->eye, scene::Point3{});
    } else {
      ASSERT_EQ(the_case.scene.rays.size(), 1u);
      EXPECT_EQ(the_case.scene.rays.front().origin, scene::Point3{});
    }
  }
}

constexpr std::uint64_t kSeeds = 200;
constexpr std::array kAll = {Variation::kScale, Variation::kSize, Variation::kSpheres};

/// A scene whose eye is not at the origin, with four spheres that are mirror images, one above, one
/// below, and one that hides another.
Scene mirrored() {
  Scene result;
  result.camera = scene::Camera{{1, 2, 3}, {1, 2, 2}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 21, 21};
  for (const double x : {-2.0, 2.0}) {
    for (const double y : {-2.0, 2.0}) result.spheres.push_back({{1 + x, 2 + y, -2}, 0.75});
  }
  for (const double y : {-2.0, 2.0}) result.spheres.push_back({{1, 2 + y, -1}, 0.5});
  result.spheres.push_back({{1, 2, -2}, 0.5});
  result.spheres.push_back({{1, 2, -7}, 0.5});
  return result;
}

/// A scene with four spheres in the corners, one in the middle of the left border, two more on that
/// border, and two on the top border.
Scene bordered() {
  Scene result;
  result.camera = scene::Camera{{}, {0, 0, -1}, {0, 1, 0}, -1, {}, -1.75, 1.25, -1, 1.5, 13, 13};
  for (const double x : {-17.5, 12.5}) {
    for (const double y : {-10.0, 15.0}) result.spheres.push_back({{x, y, -10}, 0.75});
  }
  result.spheres.push_back({{-17.5, 2.5, -10}, 0.75});
  for (const double y : {-3.75, 8.75}) result.spheres.push_back({{-17.5, y, -10}, 0.75});
  for (const double x : {-7.0, 2.0}) result.spheres.push_back({{x, 15, -10}, 0.75});
  return result;
}

TEST(VariedScene, FollowsFromItsSeedAndIsValid) {
  std::set<double> radii;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Scene one = varied_scene(mirrored(), kAll, seed);
    EXPECT_EQ(one, varied_scene(mirrored(), kAll, seed));
    EXPECT_TRUE(scene::defects(one).empty());
    radii.insert(one.spheres[0].radius / one.camera->near);
  }
  EXPECT_GE(radii.size(), kSeeds - 5);
}

TEST(VariedScene, IsUnchangedIfNothingVaries) {
  EXPECT_EQ(varied_scene(bordered(), {}, 7), bordered());
}

TEST(VariedScene, KeepsMirrorImagesDepthsAndEqualSizes) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Scene one = varied_scene(mirrored(), kAll, seed);
    const scene::Camera& c = *one.camera;
    EXPECT_EQ(c.width, c.height);
    EXPECT_EQ((c.width - 21) % 2, 0);
    EXPECT_GE(c.width, 21);
    EXPECT_LE(c.width, 21 + kMostVariedPixels);
    const double scale = -c.near;
    const auto at = [&](std::size_t k) {
      const scene::Vector3 T = one.spheres[k].centre - c.eye;
      return scene::Vector3{T.x / scale, T.y / scale, T.z / scale};
    };
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(std::abs(at(k).x), std::abs(at(0).x), 1e-5);
      EXPECT_NEAR(std::abs(at(k).y), std::abs(at(0).y), 1e-5);
      EXPECT_EQ(at(k).x < 0, k < 2);
      EXPECT_EQ(at(k).y < 0, k % 2 == 0);
      EXPECT_EQ(one.spheres[k].radius, one.spheres[0].radius);
    }
    EXPECT_NEAR(at(4).y, -at(5).y, 1e-5);
    for (std::size_t k = 4; k < 8; ++k) EXPECT_NEAR(at(k).x, 0, 1e-12);
    const Scene was = mirrored();
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_NEAR(at(k).z, was.spheres[k].centre.z - 3, 1e-5);
      const double factor = one.spheres[k].radius / scale / was.spheres[k].radius;
      EXPECT_GE(factor, kLeastVariedFactor * (1 - 1e-5));
      EXPECT_LE(factor, kMostVariedFactor * (1 + 1e-5));
    }
  }
}

TEST(VariedScene, ShowsTheSameSpheresAndNoRayNearAnEdge) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Scene one = varied_scene(mirrored(), kAll, seed);
    std::set<std::size_t> seen;
    for (const auto& sphere : exact_image(one, one.conventions)) {
      if (sphere) seen.insert(*sphere);
    }
    for (const std::int64_t j : {0, 10, 20}) {
      for (std::int64_t i = 0; i < one.camera->width; ++i) {
        const reference::ExactRay ray(reference::ExactCamera(*one.camera, one.conventions), {i, j});
        for (const scene::Sphere& sphere : one.spheres) {
          const double half_chord_sq = ray.enclose(64).half_chord_sq(sphere).upper();
          EXPECT_GE(std::abs(half_chord_sq) / (sphere.radius * sphere.radius),
                    0.99 * kClearOfEdges);
        }
      }
    }
    EXPECT_EQ(seen, (std::set<std::size_t>{0, 1, 2, 3, 4, 5, 6})) << "the last is hidden";
  }
}

TEST(VariedScene, HasNumbersOfFewDigits) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    for (const auto& [centre, radius] :
         varied_scene(mirrored(), std::array{Variation::kSpheres}, seed).spheres) {
      for (const double x : {centre.x, centre.y, centre.z, radius}) {
        EXPECT_LE(scene::shortest(x).size(), std::size_t{kVariedDigits + 3}) << x;
      }
    }
  }
}

TEST(VariedScene, MovesSpheresAlongTheBorderToRaysOfItsPixels) {
  std::set<double> left, top;
  constexpr std::array kBorder = {Variation::kSize, Variation::kBorder};
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Scene one = varied_scene(bordered(), kBorder, seed);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(one.spheres[k], bordered().spheres[k]);
    const auto gaps = static_cast<double>(one.camera->width - 1);
    const auto& at = one.spheres;
    EXPECT_EQ(at[5].centre.x, -17.5);
    EXPECT_EQ(at[7].centre.y, 15);
    EXPECT_NEAR(at[5].centre.y + at[6].centre.y, 5, 1e-4) << "mirror images";
    EXPECT_NEAR(at[7].centre.x + at[8].centre.x, -5, 1e-4) << "mirror images";
    const double row = (at[5].centre.y + 10) / 25 * gaps;
    const double column = (at[7].centre.x + 17.5) / 30 * gaps;
    for (const double pixel : {row, column}) {
      EXPECT_NEAR(pixel, std::round(pixel), 1e-4);
      EXPECT_GE(pixel, 0.9);
      EXPECT_LE(pixel, gaps / 2 + 0.1);
    }
    left.insert(row / gaps);
    top.insert(column / gaps);
  }
  EXPECT_GE(left.size(), 20u);
  EXPECT_GE(top.size(), 20u);
}

}  // namespace
}  // namespace raycheck::properties
