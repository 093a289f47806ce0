// Sources of given rays whose line nearly touches the sphere, or whose origin is close to its
// surface.

#include <algorithm>
#include <array>
#include <cmath>

#include "properties/cases/case_list.h"
#include "properties/cases/generators.h"

namespace raycheck::properties {
namespace {

Case tangency(int severity, std::uint64_t seed) {
  Random random(seed);
  return ray_case(random, ordinary_origin(random), [severity](Random& draw, const Line& line) {
    const double size = draw.power_of_ten(-1, 1);
    const double distance = size * draw.power_of_ten(-1, 3);
    const double side = draw.one_in(8) ? -1 : 1;
    Sphere sphere = sphere_off(draw, line, side * distance, size, 0);
    const double off = signed_share_of(draw, severity);
    sphere.radius = impact_parameter(line.ray, sphere.centre) / (1 + off);
    return sphere;
  });
}

constexpr int kExactlyTangent = 53;

/// A ray along an axis, so that the impact parameter is a difference of coordinates. The ray is in
/// the plane y = 0, so that this is the centre's y, at any common z. Radii of 51 bits leave room
/// for r +- 2^-severity.
Case tangent_ulps(int severity, std::uint64_t seed) {
  Random random(seed);
  Case result;
  result.scene.conventions = any_conventions(random);
  const int exponent = static_cast<int>(random.integer(-4, 4));
  const double across_both = random.between(-8, 8);
  const double start = random.between(-8, 8);
  const double direction = random.signed_power_of_ten(-2, 2);
  const auto turns = random.integer(0, 2);
  result.scene.rays.push_back(
      {turned(Point3{start, 0, across_both}, turns), turned(Vector3{direction, 0, 0}, turns)});
  const auto spheres = random.one_in(2) ? 1 : random.integer(2, 3);
  for (std::int64_t k = 0; k < spheres; ++k) {
    const double radius = 1 + std::ldexp(static_cast<double>(random.bits() >> 13), -51);
    const double off = severity == kExactlyTangent ? 0 : std::ldexp(random.sign(), -severity);
    const double impact = random.sign() * (radius + off);
    const bool is_behind = severity != kExactlyTangent && random.one_in(8);
    const double ahead = std::copysign(random.between(0.1, 40), direction);
    result.scene.spheres.push_back({turned(Point3{is_behind ? start - ahead : start + ahead,
                                                  std::ldexp(impact, exponent), across_both},
                                           turns),
                                    std::ldexp(radius, exponent)});
  }
  return result;
}

/// An integer vector with an integer length: a Pythagorean quadruple, by Euler's parametrisation
/// with numbers up to `most`.
struct WholeVector {
  std::array<std::int64_t, 3> coordinates;
  std::int64_t length;
};
WholeVector whole_vector(Random& draw, std::int64_t most) {
  const std::int64_t m = draw.integer(1, most);
  const std::int64_t n = draw.integer(-most, most);
  const std::int64_t p = draw.integer(-most, most);
  const std::int64_t q = draw.integer(-most, most);
  const std::array<std::int64_t, 3> vector = {m * m + n * n - p * p - q * q, 2 * (m * q + n * p),
                                              2 * (n * q - m * p)};
  const auto turns = static_cast<std::size_t>(draw.integer(0, 2));
  return {{vector[turns], vector[(turns + 1) % 3], vector[(turns + 2) % 3]},
          m * m + n * n + p * p + q * q};
}

/// A ray along an axis, as reflections and shadows start: the origin is exactly on the sphere. All
/// numbers have few digits, so that the usual formulas are exact.
Case from_surface(int /*severity*/, std::uint64_t seed) {
  Random random(seed);
  Case result;
  result.scene.conventions = any_conventions(random);
  const auto [to_centre, radius] = whole_vector(random, 2);
  const int exponent = static_cast<int>(random.integer(-2, 2));
  std::array<double, 3> origin, centre;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t from = random.integer(-8, 8);
    origin[k] = std::ldexp(static_cast<double>(from), exponent);
    centre[k] = std::ldexp(static_cast<double>(from + to_centre[k]), exponent);
  }
  result.scene.rays.push_back({{origin[0], origin[1], origin[2]},
                               turned(Vector3{random.sign(), 0, 0}, random.integer(0, 2))});
  result.scene.spheres.push_back(
      {{centre[0], centre[1], centre[2]}, std::ldexp(static_cast<double>(radius), exponent)});
  return result;
}

constexpr int kExactlyOnSurface = 16;

/// All numbers are integers times one power of two, so that |C - L| = r exactly.
Case on_surface(Random& random) {
  const auto bits = random.integer(1, 25);
  const std::int64_t reach = std::int64_t{1} << std::min<std::int64_t>(52, 2 * bits + 4);
  const std::array<std::int64_t, 3> origin = {
      random.integer(-reach, reach), random.integer(-reach, reach), random.integer(-reach, reach)};
  const int exponent = -static_cast<int>(2 * bits + random.integer(-3, 3));
  const auto as_length = [exponent](std::int64_t x) {
    return std::ldexp(static_cast<double>(x), exponent);
  };
  const Point3 start = {as_length(origin[0]), as_length(origin[1]), as_length(origin[2])};
  return ray_case(random, start, [&](Random& draw, const Line&) {
    const auto [to_centre, radius] = whole_vector(draw, std::int64_t{1} << bits);
    return Sphere{{as_length(origin[0] + to_centre[0]), as_length(origin[1] + to_centre[1]),
                   as_length(origin[2] + to_centre[2])},
                  as_length(radius)};
  });
}

Case surface(int severity, std::uint64_t seed) {
  Random random(seed);
  if (severity == kExactlyOnSurface) return on_surface(random);
  return ray_case(random, ordinary_origin(random), [severity](Random& draw, const Line& line) {
    const double size = draw.power_of_ten(-1, 1);
    const double impact = size * draw.between(0, 0.9);
    const double to_middle = draw.sign() * std::sqrt(size * size - impact * impact);
    Sphere sphere = sphere_off(draw, line, to_middle, impact, 0);
    const double off = signed_share_of(draw, severity);
    const double half_chord = axial_distance(line.ray, sphere.centre) / (1 + off);
    const double off_line = impact_parameter(line.ray, sphere.centre);
    sphere.radius = std::sqrt(off_line * off_line + half_chord * half_chord);
    return sphere;
  });
}

constexpr int kExactlyAtCentre = 16;

/// The first sphere contains the origin; half of the time a second one lies entirely behind it.
Case inside(int severity, std::uint64_t seed) {
  Random random(seed);
  Case result;
  result.scene.conventions = any_conventions(random);
  const double from_centre = random.power_of_ten(-1, 1);
  const double from_world = from_centre * random.power_of_ten(-2, 6);
  const Point3 origin = along({}, from_world, random.direction());
  const Line line = any_line(random, origin);
  Sphere around = {origin, from_centre};
  if (severity != kExactlyAtCentre) {
    around.centre = along(origin, from_centre, random.direction());
    around.radius = distance_between(origin, around.centre) / share_of(random, severity);
  }
  result.scene.spheres.push_back(around);
  if (random.one_in(2)) {
    const double behind = from_centre * random.power_of_ten(0, 2);
    const double impact = behind * random.unit();
    const double radius = behind * random.between(0.1, 0.9);
    result.scene.spheres.push_back(sphere_off(random, line, -behind, impact, radius));
  }
  result.scene.rays.push_back(line.ray);
  return result;
}

/// A planet in a renderer's coordinates: the world's origin is near the eye, and the ray is above
/// or below the horizon by a fraction of the horizon's dip.
Case horizon(int severity, std::uint64_t seed) {
  Random random(seed);
  Case result;
  result.scene.conventions = any_conventions(random);
  const double size = random.power_of_ten(0, 7);
  const double altitude = share_of(random, severity);
  const Vector3 up = random.direction();
  const double from_world = size * altitude * random.between(0, 10);
  const Point3 eye = along({}, from_world, random.direction());
  Sphere planet = {along(eye, -size * (1 + altitude), up), 0};
  planet.radius = distance_between(eye, planet.centre) / (1 + altitude);
  const double sine_of_dip = std::sqrt(altitude * (2 + altitude)) / (1 + altitude);
  const double off = random.signed_power_of_ten(-6, 0);
  const double down = std::min(1.0, sine_of_dip * (1 + off));
  const Vector3 level = across(random, up);
  const Vector3 flat = times(std::sqrt((1 - down) * (1 + down)), level);
  const double direction_length = random.one_in(2) ? 1 : random.power_of_ten(-2, 2);
  result.scene.rays.push_back(
      {eye, times(direction_length,
                  {flat.x - down * up.x, flat.y - down * up.y, flat.z - down * up.z})});
  result.scene.spheres.push_back(planet);
  return result;
}

// ray_cases.cpp explains how the levels were measured.
constexpr CaseSource kContactSourceTable[] = {
    {"from-surface",
     "rays along an axis from exactly the surface, in numbers of few digits",
     false,
     // No method needs an excuse, except for hits at s = 0.
     {},
     from_surface},
    {"tangency", "rays that pass a centre at the distance r (1 +- 10^-k)", false,
     // The textbook's class is wrong from @10 on (kahan; quadratic, lecture: @11), its s and Q at
     // every severity, being up to 10^3 radii away. direct/cross needs excuses from @15 on.
     SeverityRange{"log10 of the radius over the ray's distance from tangency", 10, 16, 7, 13},
     tangency},
    {"tangent-ulps",
     "rays that pass a centre 2^(52-k) ulps off r; at the highest severity tangents", false,
     // The textbook's class is wrong from @42 on. direct/cross needs excuses at exact tangency; two
     // severities before it doubles cannot set the dial finer.
     SeverityRange{"log2 of the radius over the ray's distance from tangency", 2, kExactlyTangent,
                   30, 50},
     tangent_ulps},
    {"surface", "origins 10^-k half chords off the surface; at the highest severity on it", false,
     // All methods decide correctly; the textbook's (D - r)(D + r) keeps half of its digits at @8.
     SeverityRange{"log10 of the half chord over the distance from the surface", 10,
                   kExactlyOnSurface, 8, kExactlyOnSurface},
     surface},
    {"inside", "origins inside, 10^-k radii off the centre; at the highest severity at it", false,
     // Not hard for any method.
     SeverityRange{"log10 of the radius over the distance from the centre", 10, kExactlyAtCentre,
                   kExactlyAtCentre, kExactlyAtCentre},
     inside},
    {"horizon", "rays at the horizon from 10^-k radii above a huge sphere", false,
     // All methods decide correctly. direct/cross needs excuses from @12 on, the textbook's
     // formulas from @13 on.
     SeverityRange{"log10 of the radius over the altitude", 10, 15, 6, 11}, horizon}};

}  // namespace

constinit const std::span<const CaseSource> kContactSources = kContactSourceTable;

}  // namespace raycheck::properties
