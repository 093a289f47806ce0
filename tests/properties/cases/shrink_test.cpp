#include "properties/cases/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "properties/cases/case_source.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

using Limits = std::numeric_limits<double>;

const std::vector<double> kSamples = {1,
                                      -1,
                                      2,
                                      3,
                                      0.5,
                                      1.0 / 3,
                                      -10,
                                      1e6,
                                      1e-6,
                                      1e300,
                                      -1e300,
                                      Limits::min(),
                                      Limits::denorm_min(),
                                      Limits::max(),
                                      -Limits::max(),
                                      1 + Limits::epsilon(),
                                      1 - Limits::epsilon() / 2,
                                      M_PI,
                                      12345.678};

TEST(Shrink, ComplexityCountsBitsExponentAndSign) {
  EXPECT_EQ(complexity(0), 0);
  EXPECT_EQ(complexity(1), 1);
  EXPECT_EQ(complexity(-1), 2);
  EXPECT_EQ(complexity(2), 2);
  EXPECT_EQ(complexity(3), 3);
  EXPECT_EQ(complexity(0.5), 2);
  EXPECT_GT(complexity(1.0 / 3), 50);
  EXPECT_GT(complexity(1e300), complexity(1e6));
}

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

/// Follows the first offer that still satisfies `keeps`, to the end.
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

/// The whole of what shrinking lowers.
std::int64_t total(const Case& the_case) {
  std::int64_t sum = 0;
  const auto add = [&](double x) { sum += complexity(x); };
  const auto add_triple = [&](const auto& t) {
    add(t.x);
    add(t.y);
    add(t.z);
  };
  const auto& scene = the_case.scene;
  if (scene.camera) {
    add_triple(scene.camera->eye);
    add_triple(scene.camera->look_at);
    add_triple(scene.camera->up);
    for (const double x : {scene.camera->near, scene.camera->left, scene.camera->right,
                           scene.camera->bottom, scene.camera->top}) {
      add(x);
    }
    sum += scene.camera->width + scene.camera->height;
  }
  for (const auto& ray : scene.rays) {
    add_triple(ray.origin);
    add_triple(ray.direction);
    ++sum;
  }
  for (const auto& sphere : scene.spheres) {
    add_triple(sphere.centre);
    add(sphere.radius);
    ++sum;
  }
  for (const auto& pixel : the_case.pixels) sum += 1 + pixel.i + pixel.j;
  const scene::Conventions plain;
  sum += scene.conventions.rows != plain.rows;
  sum += scene.conventions.samples != plain.samples;
  sum += scene.conventions.origin != plain.origin;
  sum += scene.conventions.root != plain.root;
  sum += scene.conventions.tangent != plain.tangent;
  return sum;
}

TEST(Shrink, MakesValidCasesThatAreSimplerInTotal) {
  std::size_t offered = 0;
  for (const CaseSource& source : case_sources()) {
    SCOPED_TRACE(source.name);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Case from = any_case(source, seed);
      for (const Case& offer : simpler(from)) {
        ++offered;
        ASSERT_TRUE(scene::defects(offer.scene).empty());
        ASSERT_LT(total(offer), total(from));
        ASSERT_EQ(offer.scene.camera.has_value(), from.scene.camera.has_value());
        if (!offer.scene.camera) continue;
        ASSERT_FALSE(offer.pixels.empty());
        for (const auto& pixel : offer.pixels) {
          ASSERT_TRUE(pixel.i >= 0 && pixel.i < offer.scene.camera->width);
          ASSERT_TRUE(pixel.j >= 0 && pixel.j < offer.scene.camera->height);
        }
      }
    }
  }
  EXPECT_GT(offered, 5000u);
}

TEST(Shrink, FindsTheSmallestImageByHalving) {
  const CaseSource& source = *find_case_source("image-size");
  Case the_case = source.make(source.dial->highest, 1);
  ASSERT_EQ(the_case.scene.camera->width, scene::kMostPixelsAcross);
  const auto is_wide = [](const Case& c) { return c.scene.camera->width > 46340; };
  int steps = 0;
  for (;;) {
    const auto offers = simpler(the_case);
    const auto next = std::find_if(offers.begin(), offers.end(), is_wide);
    if (next == offers.end()) break;
    the_case = *next;
    ASSERT_LT(++steps, 1000);
  }
  EXPECT_EQ(the_case.scene.camera->width, 46341);
}

TEST(Shrink, EndsAtAPlainCase) {
  for (const CaseSource& source : case_sources()) {
    SCOPED_TRACE(source.name);
    Case the_case = any_case(source, 7);
    int steps = 0;
    for (auto offers = simpler(the_case); !offers.empty(); offers = simpler(the_case)) {
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

}  // namespace
}  // namespace raycheck::properties
