// The dials of the families of given rays.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "properties/trial.h"
#include "tests/properties/cases/dial.h"

namespace raycheck::properties {
namespace {

using reference::HitClass;
using scene::Sphere;
using Sets = DialRow::Sets;

const scene::Ray& ray_of(const Case& the_case) { return the_case.scene.rays.front(); }

/// A ray and a sphere, as enclosures.
struct RayMeeting {
  Enclosure3 T;          ///< C - L
  Enclosure distance;    ///< |T|
  Enclosure axial;       ///< T.d/|d|
  Enclosure impact;      ///< |T x d|/|d|
  Enclosure half_chord;  ///< sqrt(r^2 - impact^2), of lines that meet the sphere
  Enclosure radius;
};
RayMeeting meeting(const scene::Ray& ray, const Sphere& sphere) {
  RayMeeting m;
  const Enclosure3 d = lift(ray.direction);
  m.T = lift(sphere.centre) - lift(ray.origin);
  m.radius = lift(sphere.radius);
  m.distance = norm(m.T);
  m.axial = dot(m.T, d) / norm(d);
  m.impact = norm(cross(m.T, d)) / norm(d);
  m.half_chord = sqrt(m.radius * m.radius - m.impact * m.impact);
  return m;
}

/// value(meeting) of each sphere, with the same noise.
template <class Value>
std::vector<Measured> of_each_sphere(const Case& the_case, double noise, Value value) {
  std::vector<Measured> result;
  for (const Sphere& sphere : the_case.scene.spheres) {
    result.push_back({value(meeting(ray_of(the_case), sphere)), noise});
  }
  return result;
}

Enclosure share_off(const Enclosure& value, const Enclosure& whole) {
  return abs(value / whole - Enclosure(1));
}

std::vector<Measured> distance(const Case& the_case) {
  return of_each_sphere(the_case, 0, [](const RayMeeting& m) { return m.distance / m.radius; });
}

std::vector<Measured> tangency(const Case& the_case) {
  return of_each_sphere(the_case, 8 * kUnitRoundoff,
                        [](const RayMeeting& m) { return share_off(m.impact, m.radius); });
}

/// Over the power of two below the radius.
std::vector<Measured> tangent_ulps(const Case& the_case) {
  return of_each_sphere(the_case, 0, [](const RayMeeting& m) {
    return abs(m.impact - m.radius) / lift(std::ldexp(1.0, std::ilogb(m.radius.lower())));
  });
}

std::vector<Measured> surface(const Case& the_case) {
  return of_each_sphere(the_case, 64 * kUnitRoundoff,
                        [](const RayMeeting& m) { return share_off(abs(m.axial), m.half_chord); });
}

std::vector<Measured> inside(const Case& the_case) {
  const RayMeeting m = meeting(ray_of(the_case), the_case.scene.spheres.front());
  return {{m.distance / m.radius}};
}

std::vector<Measured> horizon(const Case& the_case) {
  return of_each_sphere(the_case, 8 * kUnitRoundoff,
                        [](const RayMeeting& m) { return m.distance / m.radius - Enclosure(1); });
}

/// The parts of the differences of centres that lie along the ray.
std::vector<Measured> coincident(const Case& the_case) {
  std::vector<Measured> result;
  const auto& spheres = the_case.scene.spheres;
  const Enclosure3 d = lift(ray_of(the_case).direction);
  for (std::size_t k = 1; k < spheres.size(); ++k) {
    const Enclosure3 apart = lift(spheres[k].centre) - lift(spheres[0].centre);
    const Enclosure largest = norm(lift(spheres[0].centre)) + norm(lift(spheres[k].centre));
    const Enclosure radius = lift(spheres[0].radius);
    result.push_back(
        {abs(dot(apart, d)) / norm(d) / radius, 4 * kUnitRoundoff * (largest / radius).upper()});
  }
  return result;
}

std::vector<Measured> far_world(const Case& the_case) {
  return {{norm(lift(ray_of(the_case).origin))}};
}

/// The longest of |L|, |C| and r; half the smallest double is lost in each rounding.
std::vector<Measured> scale(const Case& the_case) {
  Enclosure longest = norm(lift(ray_of(the_case).origin));
  const auto take = [&](const Enclosure& x) {
    if ((x - longest).certain_sign().value_or(0) > 0) longest = x;
  };
  for (const Sphere& sphere : the_case.scene.spheres) {
    take(norm(lift(sphere.centre)));
    take(lift(sphere.radius));
  }
  return {{longest, 0x1p-1074}};
}

std::vector<Measured> direction_length(const Case& the_case) {
  return {{norm(lift(ray_of(the_case).direction)), 0x1p-1074}};
}

/// A share of 10^-k is between 0.4 and 0.9 of it.
const DialRow kRayRows[] = {
    {"distance", Sets::kPower, 0.5 * kBelow, 2 * kAbove, 15, distance},
    {"tangency", Sets::kInverse, 0.4, 0.9, 16, tangency},
    {"tangent-ulps", Sets::kInverse, kBelow, kAbove, 52, tangent_ulps},
    {"surface", Sets::kInverse, 0.4, 0.9, 15, surface},
    {"inside", Sets::kInverse, 0.4 * kBelow, 0.9 * kAbove, 15, inside},
    {"horizon", Sets::kInverse, 0.4, 0.9, 15, horizon},
    {"coincident", Sets::kInverse, 0.4, 1.8, 15, coincident},
    {"far-world", Sets::kPower, 0.5 * kBelow, 2 * kAbove, 15, far_world},
    {"scale", Sets::kEither, 0x1p-4, 0x1p6, 1074, scale},
    {"direction-length", Sets::kEither, kBelow, 2 * kAbove, 1074, direction_length},
};

class RayFamily : public testing::TestWithParam<DialRow> {};
TEST_P(RayFamily, SetsWhatItsDialSays) { expect_dial(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Families, RayFamily, testing::ValuesIn(kRayRows), test_name);

/// Calls visit(case, spheres as met) for many seeds of a family's highest severity.
template <class Visit>
void for_each_at_highest(std::string_view family, Visit visit) {
  const CaseSource& source = *find_case_source(family);
  for (std::uint64_t seed = 0; seed < 500; ++seed) visit(source.make(source.dial->highest, seed));
}

TEST(RayFamilyHighest, OfTangentUlpsIsExactlyTangent) {
  const Candidate nobody;
  std::set<std::size_t> spheres;
  for_each_at_highest("tangent-ulps", [&](const Case& the_case) {
    Trial trial(the_case, nobody);
    spheres.insert(the_case.scene.spheres.size());
    for (std::size_t k = 0; k < the_case.scene.spheres.size(); ++k) {
      EXPECT_EQ(trial.exact_intersection(0, k).hit_class, HitClass::kTangent);
    }
  });
  EXPECT_EQ(spheres, (std::set<std::size_t>{1, 2, 3}));
}

TEST(RayFamilyHighest, OfSurfaceStartsExactlyOnIt) {
  int entering = 0;
  int leaving = 0;
  int full_width = 0;
  for_each_at_highest("surface", [&](const Case& the_case) {
    for (const Sphere& sphere : the_case.scene.spheres) {
      const RayMeeting m = meeting(ray_of(the_case), sphere);
      EXPECT_EQ((dot(m.T, m.T) - m.radius * m.radius).certain_sign(), 0);
      ++(m.axial.certain_sign() == 1 ? entering : leaving);
      // r^2 does not fit a double: those who square it round.
      full_width += std::fma(sphere.radius, sphere.radius, -sphere.radius * sphere.radius) != 0;
    }
  });
  for (const int count : {entering, leaving, full_width}) EXPECT_GT(count, 250);
}

TEST(RayFamilyHighest, OfCoincidentIsATieOfAllSpheres) {
  int ties = 0;
  for_each_at_highest("coincident", [&](const Case& the_case) {
    const reference::ExactRay ray(ray_of(the_case));
    const auto nearest = ray.nearest(the_case.scene.spheres, the_case.scene.conventions);
    if (!nearest) return;
    ++ties;
    EXPECT_EQ(nearest->ties.size(), the_case.scene.spheres.size());
  });
  EXPECT_GT(ties, 250);
}

TEST(RayFamily, OfSurfaceStartsOnEverySideOfIt) {
  expect_every_side("surface", {0, 7, 15}, [](const Case& the_case, Sides& sides) {
    for (const Sphere& sphere : the_case.scene.spheres) {
      const RayMeeting m = meeting(ray_of(the_case), sphere);
      sides.count(m.distance, m.axial, m.radius);
    }
  });
}

}  // namespace
}  // namespace raycheck::properties
