#include "properties/tolerance.h"

#include <algorithm>
#include <limits>

#include "properties/sphere_choice.h"
#include "tests/properties/one_ray.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

using contract::Tolerances;

constexpr double kOff = 0x1p-20;
const scene::Sphere kBall = {{0, 0, 0}, 2};

/// Rays with directions of length 2: one passes 2 - kOff from the centre; one starts kOff outside.
const scene::Ray kGrazing = {{-5, 2 - kOff, 0}, {2, 0, 0}};
const scene::Ray kOffSurface = {{-2 - kOff, 0, 0}, {2, 0, 0}};

/// A kind, its ray, and how large the ray's value of it is.
struct Measure {
  double Tolerances::*size;
  const scene::Ray& ray;
  double value;
  double tangent_or_origin;  ///< The s of the tangent's point or of the origin.
};
const Measure kMeasures[] = {{&Tolerances::discriminant, kGrazing, 16 * kOff*(4 - kOff), 2.5},
                             {&Tolerances::d_sq, kGrazing, kOff*(4 - kOff), 2.5},
                             {&Tolerances::distance, kGrazing, kOff, 2.5},
                             {&Tolerances::radii, kGrazing, kOff / 2, 2.5},
                             {&Tolerances::c, kOffSurface, kOff*(4 + kOff), 0},
                             {&Tolerances::surface, kOffSurface, kOff, 0},
                             {&Tolerances::s, kOffSurface, kOff / 2, 0},
                             {&Tolerances::s_radii, kOffSurface, kOff / 4, 0}};

TEST(Tolerance, HasASizeAndAnswersAsNearToTheSurface) {
  for (const Measure& one : kMeasures) {
    const reference::ExactRay ray(one.ray);
    const ChangedPair pair = {ray, kBall, 0x1p-49};
    Tolerances declared;
    declared.*one.size = one.value * 0.999;
    EXPECT_EQ(tolerance_of(declared, pair), 0);
    EXPECT_EQ(tolerance_of(declared, pair, one.tangent_or_origin), 0);
    declared.*one.size = one.value * 1.001;
    const double size = declared.*one.size, s = one.tangent_or_origin;
    const auto& [x, y, z] = one.ray.origin;
    EXPECT_EQ(tolerance_of(declared, pair), size);
    EXPECT_EQ(tolerance_of(declared, pair, s), size);
    EXPECT_EQ(tolerance_of(declared, pair, scene::Point3{x + 2 * s, y, z}), size);
    for (const double far : {s + 0.1, s - 0.1, std::numeric_limits<double>::quiet_NaN()}) {
      EXPECT_EQ(tolerance_of(declared, pair, far), 0);
      EXPECT_EQ(tolerance_of(declared, pair, scene::Point3{x + 2 * far, y, z}), 0);
    }
    // A tolerance of tangents does not allow near origins, and the reverse.
    const reference::ExactRay other(&one.ray == &kGrazing ? kOffSurface : kGrazing);
    EXPECT_EQ(tolerance_of(declared, {other, kBall, 0x1p-49}), 0);
  }
  const reference::ExactRay outside(kOffSurface);
  Tolerances c;
  c.c = 1;
  EXPECT_EQ(tolerance_of(c, {outside, kBall, 0}, 2 + kOff / 2), 1) << "the far root";
}

/// Answers with the sphere of this radius.
Candidate that_sees(double radius, const Tolerances& tolerances) {
  Candidate candidate;
  candidate.tolerances = tolerances;
  candidate.nearest = [radius](Candidate::Rays rays, Candidate::Spheres spheres, const auto&) {
    const auto seen = std::ranges::find(spheres, radius, &scene::Sphere::radius);
    return std::vector(rays.size(), Index(static_cast<std::size_t>(seen - spheres.begin())));
  };
  return candidate;
}

TEST(Tolerance, ExcusesTheNearestOfTheOtherSpheres) {
  Case three = one_ray(kGrazing, kBall);
  three.scene.spheres.push_back({{10, 0, 0}, 3});
  three.scene.spheres.push_back({{20, 0, 0}, 4});
  Tolerances grazing;
  grazing.distance = 2 * kOff;
  const auto seen = [&](double radius, const Tolerances& tolerances) {
    return judge("nearest-sphere", three, that_sees(radius, tolerances));
  };
  EXPECT_TRUE(seen(2, {}).holds(true));
  EXPECT_FALSE(seen(3, {}).holds());
  EXPECT_TRUE(seen(3, grazing).holds());
  EXPECT_EQ(seen(3, grazing).tolerated(), 1u);
  EXPECT_EQ(seen(3, grazing).worst(1).front().excuse, (Excuse{ExcuseKind::kTolerance, 2 * kOff}));
  EXPECT_FALSE(seen(4, grazing).holds());
}

}  // namespace
}  // namespace raycheck::properties
