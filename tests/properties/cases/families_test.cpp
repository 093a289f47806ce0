// The severity of a source sets the documented quantity. Enclosures measure it from the doubles of
// the cases, never with the generator's arithmetic.

#include "properties/cases/case_source.h"
#include "properties/trial.h"
#include "reference/enclosure.h"
#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "tests/names.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

using namespace reference;
using scene::Camera;
using scene::Sphere;

/// With this precision, short products of doubles are exact if the doubles are within a factor of
/// 2^50 of each other.
constexpr int kSeverityBits = 512;
constexpr double kUnitRoundoff = 0x1p-53;

Enclosure lift(double x) { return {x, kSeverityBits}; }
template <class Triple>
Enclosure3 lift(const Triple& v) {
  return {lift(v.x), lift(v.y), lift(v.z)};
}

/// The quantity that severity sets, at one place of a case, and the largest change of it by
/// rounding the case's numbers. If that change exceeds the value of the severity, it limits the
/// test.
struct Measured {
  Enclosure value;
  double noise = 0;
};

/// Factors that allow for two roundings.
constexpr double kBelow = 1 - 0x1p-40;
constexpr double kAbove = 1 + 0x1p-40;

/// A source whose severity k sets a value to base^k (or its inverse, or either), up to a factor.
struct SeverityRow {
  std::string_view family;
  enum class Sets { kPower, kInverse, kEither } sets;
  double least;  ///< Values are at least this times the power.
  double most;   ///< Values are at most this times the power.
  int highest;   ///< Higher severities are tested separately.
  std::vector<Measured> (*measure)(const Case&);
};

using Sets = SeverityRow::Sets;
void PrintTo(const SeverityRow& row, std::ostream* out) { *out << row.family; }

/// Severities to try: 0, `highest`, and others between, in at most 16 steps.
std::vector<int> severities(int highest) {
  std::vector<int> result;
  for (int k = 0; k < highest; k += std::max(1, highest / 16)) result.push_back(k);
  result.push_back(highest);
  return result;
}

Enclosure power(int base, int exponent) {
  Enclosure result = lift(1.0);
  for (int k = 0; k < std::abs(exponent); ++k) result *= Enclosure(base);
  return exponent < 0 ? Enclosure(1) / result : result;
}

bool is_around(const Measured& measured, const Enclosure& scale, const SeverityRow& row) {
  const Enclosure noise = lift(measured.noise);
  const auto is_at_least = [](const Enclosure& a, const Enclosure& b) {
    return (a - b).certain_sign().value_or(-1) >= 0;
  };
  return is_at_least(measured.value, lift(row.least) * scale - noise) &&
         is_at_least(lift(row.most) * scale + noise, measured.value);
}

constexpr std::uint64_t kSeveritySeeds = 100;

void expect_dial(const SeverityRow& row) {
  const CaseSource& source = *find_case_source(row.family);
  for (const int severity : severities(row.highest)) {
    SCOPED_TRACE(std::string(row.family) + "@" + std::to_string(severity));
    const Enclosure up = power(source.severities->base, severity);
    const Enclosure down = power(source.severities->base, -severity);
    std::size_t measured = 0;
    for (std::uint64_t seed = 0; seed < kSeveritySeeds; ++seed) {
      for (const Measured& value : row.measure(source.make(severity, seed))) {
        ++measured;
        const bool fits_up = row.sets != SeverityRow::Sets::kInverse && is_around(value, up, row);
        const bool fits_down = row.sets != SeverityRow::Sets::kPower && is_around(value, down, row);
        EXPECT_TRUE(fits_up || fits_down) << value.value.lower() << ", seed " << seed;
      }
    }
    EXPECT_GE(measured, kSeveritySeeds);
  }
}

/// The numbers of rays that start outside or inside a sphere, and point towards its centre or away
/// from it.
struct Sides {
  std::array<int, 4> counts = {};

  void count(const Enclosure& to_centre, const Enclosure& axial, const Enclosure& radius) {
    const bool outside = (to_centre - radius).certain_sign() == 1;
    ++counts[(outside ? 2u : 0u) + (axial.certain_sign() == 1 ? 1u : 0u)];
  }
};

template <class Count>
void expect_every_side(std::string_view family, std::initializer_list<int> some, Count count) {
  for (const int severity : some) {
    Sides sides;
    for (std::uint64_t seed = 0; seed < 2 * kSeveritySeeds; ++seed) {
      count(find_case_source(family)->make(severity, seed), sides);
    }
    for (const int side : sides.counts) EXPECT_GT(side, 40) << family << "@" << severity;
  }
}

const scene::Ray& ray_of(const Case& the_case) { return the_case.scene.rays.front(); }

/// A ray and a sphere, as enclosures.
struct RayMeeting {
  Enclosure3 T;          ///< C - L
  Enclosure distance;    ///< |T|
  Enclosure axial;       ///< T.d/|d|
  Enclosure impact;      ///< |T x d|/|d|
  Enclosure half_chord;  ///< sqrt(r^2 - impact^2), if the line meets the sphere
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

/// value(meeting) for each sphere, all with this noise.
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

/// Distances from tangency, divided by the power of two below the radius.
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

/// The differences of centres, along the ray.
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

/// The longest length. Each rounding loses at most half the smallest double.
std::vector<Measured> longest(const std::vector<Enclosure>& lengths) {
  Enclosure most = lengths.front();
  for (const Enclosure& x : lengths) {
    if ((x - most).certain_sign().value_or(0) > 0) most = x;
  }
  return {{most, 0x1p-1074}};
}

std::vector<Measured> scale(const Case& the_case) {
  std::vector<Enclosure> lengths = {norm(lift(ray_of(the_case).origin))};
  for (const Sphere& sphere : the_case.scene.spheres) {
    lengths.insert(lengths.end(), {norm(lift(sphere.centre)), lift(sphere.radius)});
  }
  return longest(lengths);
}

std::vector<Measured> direction_length(const Case& the_case) {
  return {{norm(lift(ray_of(the_case).direction)), 0x1p-1074}};
}

const Camera& camera_of(const Case& the_case) { return *the_case.scene.camera; }

std::vector<Measured> far_camera(const Case& the_case) {
  return {{norm(lift(camera_of(the_case).eye))}};
}

std::vector<Measured> camera_scale(const Case& the_case) {
  const Camera& camera = camera_of(the_case);
  return longest({norm(lift(camera.eye)), norm(lift(camera.look_at)), abs(lift(camera.near))});
}

/// The sine of the angle between `up` and the view.
std::vector<Measured> up(const Case& the_case) {
  const Camera& camera = camera_of(the_case);
  const Enclosure3 view = lift(camera.eye) - lift(camera.look_at);
  const Enclosure3 the_up = lift(camera.up);
  return {{norm(cross(the_up, view)) / (norm(the_up) * norm(view)), 8 * kUnitRoundoff}};
}

std::vector<Measured> field_of_view(const Case& the_case) {
  const Camera& camera = camera_of(the_case);
  std::vector<Measured> result;
  for (const double bound : {camera.left, camera.right, camera.bottom, camera.top}) {
    result.push_back({abs(lift(bound) / lift(camera.near))});
  }
  return result;
}

std::vector<Measured> image_size(const Case& the_case) {
  return {{lift(static_cast<double>(camera_of(the_case).width))}};
}

/// |C - P| and r of a sphere, where P is the exact point of the first pixel.
struct PixelMeeting {
  Enclosure to_centre, axial, radius;
  double noise;  ///< The generator's P is off by some roundings of |E| and |P - E|.
};
std::vector<PixelMeeting> meetings(const Case& the_case) {
  const reference::ExactCamera camera(camera_of(the_case), the_case.scene.conventions);
  const ExactRay ray(camera, the_case.pixels.front());
  const Enclosure3 P = ray.pixel_point(200);
  const Enclosure3 E = lift(camera_of(the_case).eye);
  std::vector<PixelMeeting> result;
  for (const Sphere& sphere : the_case.scene.spheres) {
    const Enclosure3 T = lift(sphere.centre) - P;
    const Enclosure radius = lift(sphere.radius);
    result.push_back({norm(T), dot(T, ray.direction(200)), radius,
                      64 * kUnitRoundoff * ((norm(E) + norm(P - E)) / radius).upper()});
  }
  return result;
}

std::vector<Measured> near_plane(const Case& the_case) {
  std::vector<Measured> result;
  for (const PixelMeeting& m : meetings(the_case)) {
    result.push_back({abs(m.to_centre / m.radius - Enclosure(1)), m.noise});
  }
  return result;
}

/// share_of() is 0.4 to 0.9 times 10^-k.
const SeverityRow kRows[] = {
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
    {"far-camera", Sets::kPower, 0.5 * kBelow, 2 * kAbove, 15, far_camera},
    {"camera-scale", Sets::kEither, 0x1p-3, 0x1p6, 1074, camera_scale},
    // A tangent of at most 0.9 is a sine of at most 0.67.
    {"up", Sets::kInverse, 0.37, 0.9, 15, up},
    {"field-of-view", Sets::kEither, 0.5 * kBelow, 2 * kAbove, 15, field_of_view},
    {"image-size", Sets::kPower, 1, 1, 30, image_size},
    {"near-plane", Sets::kInverse, 0.4, 0.9, 15, near_plane},
};

class Family : public testing::TestWithParam<SeverityRow> {};
TEST_P(Family, SetsWhatItsDialSays) { expect_dial(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Families, Family, testing::ValuesIn(kRows),
                         [](const auto& the_test) { return identifier(the_test.param.family); });

/// Calls visit(case, meetings) for many seeds of a source's highest severity.
template <class Visit>
void for_each_at_highest(std::string_view family, Visit visit) {
  const CaseSource& source = *find_case_source(family);
  for (std::uint64_t seed = 0; seed < 500; ++seed)
    visit(source.make(source.severities->highest, seed));
}

TEST(FamilyHighest, OfTangentUlpsIsExactlyTangent) {
  const Candidate no_functions;
  std::set<std::size_t> spheres;
  for_each_at_highest("tangent-ulps", [&](const Case& the_case) {
    Trial trial(the_case, no_functions);
    spheres.insert(the_case.scene.spheres.size());
    for (std::size_t k = 0; k < the_case.scene.spheres.size(); ++k) {
      EXPECT_EQ(trial.exact_intersection(0, k).hit_class, HitClass::kTangent);
    }
  });
  EXPECT_EQ(spheres, (std::set<std::size_t>{1, 2, 3}));
}

TEST(FamilyHighest, OfSurfaceStartsExactlyOnIt) {
  int entering = 0, leaving = 0, full_width = 0;
  for_each_at_highest("surface", [&](const Case& the_case) {
    for (const Sphere& sphere : the_case.scene.spheres) {
      const RayMeeting m = meeting(ray_of(the_case), sphere);
      EXPECT_EQ((dot(m.T, m.T) - m.radius * m.radius).certain_sign(), 0);
      ++(m.axial.certain_sign() == 1 ? entering : leaving);
      // r^2 is not a double, so code that squares r rounds.
      full_width += std::fma(sphere.radius, sphere.radius, -sphere.radius * sphere.radius) != 0;
    }
  });
  for (const int count : {entering, leaving, full_width}) EXPECT_GT(count, 250);
}

TEST(FamilyHighest, OfCoincidentIsATieOfAllSpheres) {
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

TEST(FamilySides, OfSurfaceStartsOnEverySideOfIt) {
  expect_every_side("surface", {0, 7, 15}, [](const Case& the_case, Sides& sides) {
    for (const Sphere& sphere : the_case.scene.spheres) {
      const RayMeeting m = meeting(ray_of(the_case), sphere);
      sides.count(m.distance, m.axial, m.radius);
    }
  });
}

TEST(FamilyHighest, OfImageSizesReachesTheMostPixelsAndEveryCorner) {
  std::array<int, 4> corners = {};
  int square = 0, elsewhere = 0;
  for_each_at_highest("image-size", [&](const Case& the_case) {
    const Camera& camera = camera_of(the_case);
    ASSERT_EQ(camera.width, scene::kMostPixelsAcross);
    square += camera.height == camera.width ? 1 : 0;
    for (const auto& [i, j] : the_case.pixels) {
      const bool is_corner =
          (i == 0 || i == camera.width - 1) && (j == 0 || j == camera.height - 1);
      ++(is_corner ? corners[(i == 0 ? 0u : 2u) + (j == 0 ? 0u : 1u)] : elsewhere);
    }
  });
  for (const int count : corners) EXPECT_GT(count, 50);
  EXPECT_GT(square, 100);
  EXPECT_GT(elsewhere, 100);
}

TEST(FamilySides, OfNearPlanesStartsOnEverySideOfTheSurface) {
  expect_every_side("near-plane", {0, 7, 13}, [](const Case& the_case, Sides& sides) {
    ASSERT_EQ(the_case.scene.conventions.origin, scene::Origin::kPixel);
    for (const PixelMeeting& m : meetings(the_case)) sides.count(m.to_centre, m.axial, m.radius);
  });
}

}  // namespace
}  // namespace raycheck::properties
