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

const double kSamples[] = {1,
                           -1,
                           2,
                           0.5,
                           1.0 / 3,
                           -10,
                           1e6,
                           1e300,
                           Limits::min(),
                           Limits::denorm_min(),
                           -Limits::max(),
                           1 + Limits::epsilon(),
                           M_PI,
                           12345.678};

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

TEST(Shrink, FindsTheSmallestImageByHalving) {
  const CaseSource& source = *find_case_source("image-size");
  Case the_case = source.make(source.dial->highest, 1);
  ASSERT_EQ(the_case.scene.camera->width, scene::kMostPixelsAcross);
  const auto is_wide = [](const Case& c) { return c.scene.camera->width > 46340; };
  the_case = smallest(the_case, 10000, is_wide);
  EXPECT_EQ(the_case.scene.camera->width, 46341);
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

}  // namespace
}  // namespace raycheck::properties
