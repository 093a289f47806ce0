#include "tests/reference/second_opinion.h"

#include <gtest/gtest.h>

#include <array>

namespace raycheck::reference {
namespace {

using scene::Ray;

void expect_same_intersections(const Ray& ray, const Sphere& sphere, Counts& counts) {
  SCOPED_TRACE(spelled(ray) + spelled(sphere));
  expect_same_intersections(ExactRay(ray), vector(ray.origin), vector(ray.direction), sphere,
                            counts);
}

/// Three orthogonal vectors of integers of one integer length, by Euler's four-square rotation.
struct IntegerFrame {
  std::array<scene::Vector3, 3> axis;
  double length;
};

IntegerFrame random_integer_frame(Random& random) {
  const double a = random.small_integer(6);
  const double b = random.small_integer(6);
  const double c = random.small_integer(6);
  const double d = static_cast<double>(random.integer(1, 6));
  return {{{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
            {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
            {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d}}},
          a * a + b * b + c * c + d * d};
}

scene::Point3 moved(const scene::Point3& p, const IntegerFrame& frame, double i, double j,
                    double k) {
  const auto& [x, y, z] = frame.axis;
  return {p.x + i * x.x + j * y.x + k * z.x, p.y + i * x.y + j * y.y + k * z.y,
          p.z + i * x.z + j * y.z + k * z.z};
}

/// One of the sphere's four numbers moved by up to 3 doubles, half of the time; 0 by multiples of
/// 2^-52, since CORE's filter takes squares that underflow for 0.
void nudge(Random& random, Sphere& sphere) {
  if (random.one_in(2)) return;
  const std::array<double*, 4> numbers{&sphere.centre.x, &sphere.centre.y, &sphere.centre.z,
                                       &sphere.radius};
  double& number = *numbers[static_cast<std::size_t>(random.integer(0, 3))];
  const std::int64_t steps = random.integer(-3, 3);
  number = number == 0 ? static_cast<double>(steps) * 0x1p-52 : nudged(number, steps);
  sphere.radius = std::abs(sphere.radius);
}

// Cases of each test, and what they decide together.
constexpr int kOrdinaryRays = 32000;
constexpr int kTangents = 30000;
constexpr int kOrigins = 24000;
constexpr int kTies = 28000;
static_assert(2 * (kOrdinaryRays + kTangents + kOrigins) + kTies >= 200000);

TEST(SecondOpinion, OnOrdinaryRays) {
  Random random(1);
  Counts counts;
  const int cases = share_of(kOrdinaryRays);
  for (int k = 0; k < cases && !HasFailure(); ++k) {
    const Ray ray = random_ray(random, Sizes::kOrdinary);
    expect_same_intersections(ray, random_sphere(random, Sizes::kOrdinary), counts);
  }
  EXPECT_EQ(counts.decisions, 2 * cases);
  EXPECT_GE(counts.hits, cases / 20);
  EXPECT_GE(counts.larger_roots, cases / 50);
  EXPECT_GE(counts.misses, cases / 4);
  EXPECT_GE(counts.behind, cases / 50);
}

TEST(SecondOpinion, OnTangentsAndTheirNeighbours) {
  Random random(2);
  Counts counts;
  const int cases = share_of(kTangents);
  for (int k = 0; k < cases && !HasFailure(); ++k) {
    const IntegerFrame frame = random_integer_frame(random);
    const double sideways = random.small_integer(4);
    const Ray ray{triple<scene::Point3>(random, Sizes::kSmallIntegers), frame.axis[0]};
    Sphere sphere{moved(ray.origin, frame, random.small_integer(5), sideways, 0),
                  std::abs(sideways) * frame.length};
    nudge(random, sphere);
    expect_same_intersections(ray, sphere, counts);
  }
  EXPECT_EQ(counts.decisions, 2 * cases);
  EXPECT_GE(counts.tangents, cases / 5);
  EXPECT_GE(counts.hits, cases / 20);
  EXPECT_GE(counts.misses, cases / 20);
  EXPECT_GE(counts.behind, cases / 20);
}

TEST(SecondOpinion, OnOriginsAtTheSurface) {
  Random random(3);
  Counts counts;
  int on_surface = 0;
  const int cases = share_of(kOrigins);
  for (int k = 0; k < cases && !HasFailure(); ++k) {
    const IntegerFrame frame = random_integer_frame(random);
    const scene::Vector3 direction = triple<scene::Vector3>(random, Sizes::kSmallIntegers);
    if (direction == scene::Vector3{}) {
      --k;
      continue;
    }
    const Ray ray{triple<scene::Point3>(random, Sizes::kSmallIntegers), direction};
    const double size = static_cast<double>(random.integer(1, 5));
    Sphere sphere{moved(ray.origin, frame, 2 * size, -size, 2 * size), 3 * size * frame.length};
    nudge(random, sphere);
    expect_same_intersections(ray, sphere, counts);
    const Intersection at = ExactRay(ray).intersect(sphere);
    if (at.hit_class == HitClass::kMiss) continue;
    on_surface += ExactRay(ray).rounded_parameter(sphere, at) == 0 ? 1 : 0;
  }
  EXPECT_EQ(counts.decisions, 2 * cases);
  EXPECT_GE(on_surface, cases / 4);
  EXPECT_GE(counts.hits, cases / 4);
  EXPECT_GE(counts.larger_roots, cases / 4);
  EXPECT_GE(counts.misses + counts.tangents, cases / 100);
}

TEST(SecondOpinion, OnTiesOfTwoSpheresAndTheirNeighbours) {
  // (x, y, z) of integer length: a sphere's centre, seen from where the ray enters it.
  constexpr std::array<std::array<double, 4>, 5> kEntries{
      {{1, 2, 2, 3}, {2, -3, 6, 7}, {2, 1, -2, 3}, {4, 4, 7, 9}, {6, -2, 3, 7}}};
  Random random(5);
  Counts counts;
  const int cases = share_of(kTies);
  while (counts.decisions < cases && !HasFailure()) {
    const IntegerFrame frame = random_integer_frame(random);
    const Ray ray{triple<scene::Point3>(random, Sizes::kSmallIntegers), frame.axis[0]};
    const double entry = static_cast<double>(random.integer(0, 6));
    const auto met_at_entry = [&] {
      const auto& [x, y, z, length] = kEntries[static_cast<std::size_t>(random.integer(0, 4))];
      const double size = static_cast<double>(random.integer(1, 3));
      return Sphere{moved(ray.origin, frame, entry + size * x, size * y, size * z),
                    size * length * frame.length};
    };
    Sphere first = met_at_entry();
    Sphere second = met_at_entry();
    if (random.one_in(2)) {
      // A mirrored pair instead, met at one irrational parameter.
      const double i = entry + static_cast<double>(random.integer(5, 9));
      const double radius = static_cast<double>(random.integer(3, 5)) * frame.length;
      first = {moved(ray.origin, frame, i, 2, 1), radius};
      second = {moved(ray.origin, frame, i, 1, -2), radius};
    }
    nudge(random, first);
    SCOPED_TRACE(spelled(ray));
    expect_same_order(ExactRay(ray), vector(ray.origin), vector(ray.direction), first, second,
                      counts);
  }
  EXPECT_GE(counts.decisions, cases);
  EXPECT_GE(counts.order[0], cases / 20);
  EXPECT_GE(counts.order[1], cases / 4);
  EXPECT_GE(counts.order[2], cases / 20);
}

}  // namespace
}  // namespace raycheck::reference
