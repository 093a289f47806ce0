// Compares the decisions of reference/exact_ray.h with those of CGAL's kernel with square roots,
// which uses CORE's numbers. The kernel shares no arithmetic and no formula with reference/. CORE's
// reference counts are not atomic, so that a process has only one thread; ctest runs each test in a
// process.

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>

#include "reference/exact_ray.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using namespace scene;
using Number = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;
using Vector = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::Vector_3;
static_assert(std::is_same_v<Number, CORE::Expr>);

/// RAYCHECK_SECOND_OPINION_PERCENT changes the number of cases. 1250 makes a million decisions;
/// slow builds (sanitizers) use less.
int share_of(int count) {
  const char* const percent = std::getenv("RAYCHECK_SECOND_OPINION_PERCENT");
  return percent == nullptr ? count : count * std::atoi(percent) / 100;
}

template <class Triple>
Vector vector(const Triple& v) {
  return {Number(v.x), Number(v.y), Number(v.z)};
}
int sign_of(const Number& x) { return static_cast<int>(CGAL::sign(x)); }

/// The roots of |o + t d - C|^2 = r^2, if there are any.
struct Roots {
  Number a, b, disc;
  int disc_sign;

  Roots(const Vector& o, const Vector& d, const Sphere& sphere) : a(d * d) {
    const Vector f = vector(sphere.centre) - o;
    const Number r(sphere.radius);
    b = f * d;
    disc = b * b - a * (f * f - r * r);
    disc_sign = sign_of(disc);
  }
  Number smaller() const { return disc_sign == 0 ? b / a : (b - CGAL::sqrt(disc)) / a; }
  Number larger() const { return disc_sign == 0 ? b / a : (b + CGAL::sqrt(disc)) / a; }
  Number at(WhichRoot root) const { return root == WhichRoot::kSmaller ? smaller() : larger(); }

  Intersection intersection(Root convention) const {
    if (disc_sign < 0) return {};
    const HitClass hit = disc_sign == 0 ? HitClass::kTangent : HitClass::kHit;
    if (sign_of(smaller()) >= 0) return {hit, WhichRoot::kSmaller};
    if (convention == Root::kSmaller || sign_of(larger()) < 0) return {};
    return {hit, WhichRoot::kLarger};
  }
};

/// The numbers of decisions of each kind, to check that every kind is tested.
struct Counts {
  int decisions = 0, hits = 0, larger_roots = 0, tangents = 0, misses = 0, behind = 0;
  int order[3] = {0, 0, 0};  ///< The first sphere nearer, a tie, the second nearer.
};

void expect_same_intersections(const ExactRay& ray, const Vector& o, const Vector& d,
                               const Sphere& sphere, Counts& counts) {
  const Roots roots(o, d, sphere);
  for (const Root root : {Root::kNearest, Root::kSmaller}) {
    const Intersection second_opinion = roots.intersection(root);
    ASSERT_EQ(ray.intersect(sphere, root), second_opinion);
    ++counts.decisions;
    if (root == Root::kSmaller) continue;
    counts.hits += second_opinion.hit_class == HitClass::kHit ? 1 : 0;
    counts.larger_roots += second_opinion.root == WhichRoot::kLarger ? 1 : 0;
    counts.tangents += second_opinion.hit_class == HitClass::kTangent ? 1 : 0;
    counts.misses += second_opinion.hit_class == HitClass::kMiss ? 1 : 0;
    counts.behind += second_opinion.hit_class == HitClass::kMiss && roots.disc_sign >= 0 ? 1 : 0;
  }
}

void expect_same_order(const ExactRay& ray, const Vector& o, const Vector& d, const Sphere& first,
                       const Sphere& second, Counts& counts) {
  const Intersection at_first = ray.intersect(first);
  const Intersection at_second = ray.intersect(second);
  if (at_first.hit_class == HitClass::kMiss || at_second.hit_class == HitClass::kMiss) return;
  const Number difference =
      Roots(o, d, first).at(at_first.root) - Roots(o, d, second).at(at_second.root);
  const int order = sign_of(difference);
  EXPECT_EQ(ray.compare(first, at_first, second, at_second), order)
      << spelled(first) << spelled(second);
  ++counts.decisions;
  ++counts.order[order + 1];
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

/// Half of the time, moves one of the sphere's four numbers by up to 3 doubles. A 0 is moved by
/// multiples of 2^-52, since CORE's filter takes squares that underflow for 0.
void nudge(Random& random, Sphere& sphere) {
  if (random.one_in(2)) return;
  const std::array<double*, 4> numbers{&sphere.centre.x, &sphere.centre.y, &sphere.centre.z,
                                       &sphere.radius};
  double& number = *numbers[static_cast<std::size_t>(random.integer(0, 3))];
  const std::int64_t steps = random.integer(-3, 3);
  number = number == 0 ? static_cast<double>(steps) * 0x1p-52 : nudged(number, steps);
  sphere.radius = std::abs(sphere.radius);
}

// The number of cases of each test, and of their decisions.
constexpr int kOrdinaryRays = 12800;
constexpr int kTangents = 12000;
constexpr int kOrigins = 9600;
constexpr int kTies = 11200;
constexpr int kCameras = 2400;
static_assert(2 * (kOrdinaryRays + kTangents + kOrigins) + kTies >= 80000);

/// The decisions on `cases` rays and spheres from `make`.
template <class Make>
Counts decided(std::uint64_t seed, int cases, Make make) {
  Random random(seed);
  Counts counts;
  for (int k = 0; k < cases && !testing::Test::HasFailure(); ++k) {
    const auto& [ray, sphere] = make(random);
    SCOPED_TRACE(spelled(ray) + spelled(sphere));
    expect_same_intersections(ExactRay(ray), vector(ray.origin), vector(ray.direction), sphere,
                              counts);
  }
  EXPECT_EQ(counts.decisions, 2 * cases);
  return counts;
}

TEST(SecondOpinion, OnOrdinaryRays) {
  const int cases = share_of(kOrdinaryRays);
  const Counts counts = decided(1, cases, [](Random& random) {
    const Ray ray = random_ray(random, Sizes::kOrdinary);
    return std::pair(ray, random_sphere(random, Sizes::kOrdinary));
  });
  EXPECT_GE(counts.hits, cases / 20);
  EXPECT_GE(counts.larger_roots, cases / 50);
  EXPECT_GE(counts.misses, cases / 4);
  EXPECT_GE(counts.behind, cases / 50);
}

TEST(SecondOpinion, OnTangentsAndTheirNeighbours) {
  const int cases = share_of(kTangents);
  const Counts counts = decided(2, cases, [](Random& random) {
    const IntegerFrame frame = random_integer_frame(random);
    const double sideways = random.small_integer(4);
    const Ray ray{triple<scene::Point3>(random, Sizes::kSmallIntegers), frame.axis[0]};
    Sphere sphere{moved(ray.origin, frame, random.small_integer(5), sideways, 0),
                  std::abs(sideways) * frame.length};
    nudge(random, sphere);
    return std::pair(ray, sphere);
  });
  EXPECT_GE(counts.tangents, cases / 5);
  EXPECT_GE(counts.hits, cases / 20);
  EXPECT_GE(counts.misses, cases / 20);
  EXPECT_GE(counts.behind, cases / 20);
}

TEST(SecondOpinion, OnOriginsAtTheSurface) {
  int on_surface = 0;
  const int cases = share_of(kOrigins);
  const Counts counts = decided(3, cases, [&](Random& random) {
    const IntegerFrame frame = random_integer_frame(random);
    Ray ray = random_ray(random, Sizes::kSmallIntegers);
    const double size = static_cast<double>(random.integer(1, 5));
    Sphere sphere{moved(ray.origin, frame, 2 * size, -size, 2 * size), 3 * size * frame.length};
    nudge(random, sphere);
    const Vector f = vector(sphere.centre) - vector(ray.origin);
    on_surface += sign_of(f * f - Number(sphere.radius) * Number(sphere.radius)) == 0 ? 1 : 0;
    return std::pair(ray, sphere);
  });
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
      // Instead, a mirrored pair of spheres that is met at one irrational parameter.
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

/// low + part (high - low)
Number coordinate(double low, double high, std::int64_t index, std::int64_t count,
                  scene::Samples samples) {
  const Number extent = Number(high) - Number(low);
  if (samples == scene::Samples::kEdges) {
    return Number(low) +
           Number(static_cast<int>(index)) * extent / Number(static_cast<int>(count - 1));
  }
  if (samples == scene::Samples::kCorners) {
    return Number(low) + Number(static_cast<int>(index)) / Number(static_cast<int>(count)) * extent;
  }
  return Number(low) +
         Number(static_cast<int>(2 * index + 1)) * extent / Number(static_cast<int>(2 * count));
}

/// A pixel's ray, computed from the camera's numbers.
struct PixelLine {
  Camera camera;
  ExactRay ray;
  Vector origin, to_pixel;

  PixelLine(const Camera& of, const scene::Conventions& conventions, const scene::Pixel& pixel)
      : camera(of), ray(ExactCamera(of, conventions), pixel), origin(vector(of.eye)) {
    const Vector w = origin - vector(camera.look_at);
    const Vector W = Number(1) / CGAL::sqrt(w * w) * w;
    const Vector u = CGAL::cross_product(vector(camera.up), w);
    const Vector U = Number(1) / CGAL::sqrt(u * u) * u;
    const bool bottom_first = conventions.rows == scene::Rows::kBottomFirst;
    const Number alpha =
        coordinate(camera.left, camera.right, pixel.i, camera.width, conventions.samples);
    const Number beta = coordinate(bottom_first ? camera.bottom : camera.top,
                                   bottom_first ? camera.top : camera.bottom, pixel.j,
                                   camera.height, conventions.samples);
    to_pixel = Number(camera.near) * W + alpha * U + beta * CGAL::cross_product(W, U);
    if (conventions.origin == scene::Origin::kPixel) origin = origin + to_pixel;
  }

  void expect_same(const Sphere& sphere, Counts& counts) const {
    SCOPED_TRACE(spelled(camera) + spelled(sphere));
    expect_same_intersections(ray, origin, to_pixel, sphere, counts);
  }
};

TEST(SecondOpinion, OnCamerasEndToEnd) {
  const int cases = share_of(kCameras);
  for (const auto& [seed, sizes] :
       {std::pair(11u, Sizes::kOrdinary), {12u, Sizes::kSmallIntegers}}) {
    Random random(seed);
    Counts counts;
    for (int k = 0; k < cases && !HasFailure(); ++k) {
      const Camera camera = random_camera(random, sizes);
      const scene::Conventions conventions = random_conventions(random);
      const scene::Pixel pixel = random_pixel(random, camera);
      const PixelLine line(camera, conventions, pixel);
      for (int n = 0; n < 2; ++n) line.expect_same(random_sphere(random, sizes), counts);
    }
    EXPECT_EQ(counts.decisions, 4 * cases);
    EXPECT_GE(counts.hits, cases / 10);
    EXPECT_GE(counts.misses, cases / 4);
    if (sizes == Sizes::kSmallIntegers) continue;
    EXPECT_GE(counts.larger_roots, cases / 20);
    EXPECT_GE(counts.behind, cases / 20);
  }
}

TEST(SecondOpinion, OnCamerasAlongAnAxisWhoseRaysAreTangent) {
  // The ray of the centre pixel is along -z; the sphere touches it or misses touching it by an ulp.
  Random random(13);
  Counts counts;
  const int cases = share_of(kCameras);
  for (int k = 0; k < cases && !HasFailure(); ++k) {
    const scene::Point3 eye = triple<scene::Point3>(random, Sizes::kSmallIntegers);
    const double step = static_cast<double>(random.integer(1, 4));
    const Camera camera{
        eye,       {eye.x, eye.y, eye.z - static_cast<double>(random.integer(1, 9))},
        {0, 1, 0}, -step,
        {},        -step,
        step,      -step,
        step,      3,
        3};
    const scene::Conventions conventions = {
        scene::Rows::kBottomFirst, scene::Samples::kEdges,
        random.one_in(2) ? scene::Origin::kPixel : scene::Origin::kFocal};
    const double radius = static_cast<double>(random.integer(0, 3));
    const Sphere sphere{
        {nudged(eye.x + radius, random.integer(-1, 1)), eye.y, eye.z + random.small_integer(9)},
        radius};
    PixelLine(camera, conventions, {1, 1}).expect_same(sphere, counts);
  }
  EXPECT_EQ(counts.decisions, 2 * cases);
  EXPECT_GE(counts.tangents, cases / 10);
  EXPECT_GE(counts.hits, cases / 20);
  EXPECT_GE(counts.misses, cases / 4);
}

}  // namespace
}  // namespace raycheck::reference
