#include "reference/visibility/visibility.h"

#include <hwy/highway.h>

#include <thread>

#include "tests/testing.h"

namespace raycheck::reference {

std::int64_t kernel_targets();  // in visibility_kernel.h, whose other names clash with those here

namespace {

struct Seen {
  std::vector<std::int32_t> sphere;
  std::vector<double> parameter, x, y, z;
  DecidedBy decided_by;

  explicit Seen(std::size_t pixels)
      : sphere(pixels), parameter(pixels), x(pixels), y(pixels), z(pixels) {}
  SeenRows rows() { return {sphere, parameter, x, y, z}; }
  auto all() const { return std::tie(sphere, parameter, x, y, z, decided_by); }
};

std::size_t pixels_of(const scene::Scene& scene) {
  return static_cast<std::size_t>(scene.camera->width * scene.camera->height);
}

Seen see(const Visibility& visibility) {
  Seen seen(pixels_of(visibility.scene()));
  seen.decided_by = visibility.nearest(0, visibility.scene().camera->height, seen.rows());
  return seen;
}

Visibility visibility_of(const scene::Scene& scene) {
  return {scene, scene::plan_scene(scene, scene.conventions, scene::Wanted::kNearest)};
}

ExactRay ray_at(const ExactCamera& camera, std::size_t pixel) {
  const auto index = static_cast<std::int64_t>(pixel), width = camera.camera().width;
  return {camera, {index % width, index / width}};
}

/// Compares every step-th pixel with the exact ray; returns the number of pixels that meet a
/// sphere.
int expect_exact(const scene::Scene& scene, const Seen& seen, std::size_t step = 1) {
  const ExactCamera camera(*scene.camera, scene.conventions);
  const scene::Point3& E = scene.camera->eye;
  int hits = 0;
  for (std::size_t at = 0; at < pixels_of(scene); at += step) {
    const ExactRay ray = ray_at(camera, at);
    const auto exact = ray.nearest(scene.spheres, scene.conventions);
    const std::int32_t expected = exact ? static_cast<std::int32_t>(exact->index) : kNoSphere;
    if (seen.sphere[at] != expected) {
      ADD_FAILURE() << "pixel " << at << ": " << seen.sphere[at] << ", exactly " << expected;
      return hits;
    }
    if (!exact) {
      EXPECT_EQ(seen.parameter[at], kNoParameter);
      EXPECT_EQ(seen.x[at], kNoParameter);
      continue;
    }
    ++hits;
    const scene::Sphere& sphere = scene.spheres[exact->index];
    const scene::Point3 Q = ray.rounded_point(sphere, exact->intersection);
    const double distance = std::hypot(Q.x - E.x, Q.y - E.y, Q.z - E.z);
    const double bound = kVisibleParameterError * distance + kSmallest;
    EXPECT_LE(std::abs(seen.parameter[at] - ray.rounded_parameter(sphere, exact->intersection)),
              bound);
    EXPECT_LE(std::abs(seen.x[at] - Q.x), bound + 0x1p-51 * std::abs(Q.x));
    EXPECT_LE(std::abs(seen.y[at] - Q.y), bound + 0x1p-51 * std::abs(Q.y));
    EXPECT_LE(std::abs(seen.z[at] - Q.z), bound + 0x1p-51 * std::abs(Q.z));
  }
  return hits;
}

/// Compares the hit classes of every pixel with every step-th sphere.
void expect_exact_classes(const scene::Scene& scene, std::size_t step) {
  const ExactCamera camera(*scene.camera, scene.conventions);
  const Visibility of_all(scene,
                          scene::plan_scene(scene, scene.conventions, scene::Wanted::kClass));
  std::vector<HitClass> classes(pixels_of(scene));
  for (std::size_t k = 0; k < scene.spheres.size(); k += step) {
    of_all.classes(k, 0, scene.camera->height, classes);
    for (std::size_t at = 0; at < classes.size(); ++at) {
      const ExactRay ray = ray_at(camera, at);
      const HitClass exact = ray.intersect(scene.spheres[k], scene.conventions).hit_class;
      ASSERT_EQ(classes[at], exact) << "sphere " << k << " pixel " << at;
    }
  }
}

struct Uniform {
  std::mt19937_64 bits;
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }
};

/// Spheres of all sizes, in front of the eye and behind it; some are around the eye or cut by the
/// image plane.
scene::Scene random_scene(unsigned seed, double scale = 1) {
  Uniform between{std::mt19937_64(seed)};
  scene::Scene scene;
  scene.camera = scene::Camera{{scale * between(-3, 3), scale * between(-3, 3), scale * 5},
                               {scale * between(-1, 1), scale * between(-1, 1), 0},
                               {between(-.3, .3), 1, between(-.3, .3)},
                               -scale,
                               std::nullopt,
                               -.7 * scale,
                               .9 * scale,
                               seed % 3 == 0 ? .8 * scale : -.8 * scale,
                               seed % 3 == 0 ? -.6 * scale : .6 * scale,
                               66 + seed % 5,
                               19 + seed % 7};
  scene.conventions.rows = seed % 2 == 0 ? scene::Rows::kTopFirst : scene::Rows::kBottomFirst;
  scene.conventions.samples = seed % 5 == 0   ? scene::Samples::kCentres
                              : seed % 5 == 1 ? scene::Samples::kCorners
                                              : scene::Samples::kEdges;
  for (int k = 0; k < 40; ++k) {
    const double size = std::exp2(between(-6, 2));
    scene.spheres.push_back(
        {{scale * between(-9, 9), scale * between(-9, 9), scale * between(-40, 8)}, scale * size});
  }
  if (seed % 4 == 0) scene.spheres.push_back({scene.camera->eye, 30 * scale});
  scene.spheres.push_back(scene.spheres.front());
  return scene;
}

TEST(Visibility, IsExactAtTheEndOfTheRange) {
  // |Q - E| is out of range, but s, which counts from the pixel, is not.
  constexpr double kFar = 1.7e308;
  scene::Scene scene;
  scene.camera =
      scene::Camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, -kFar, {}, -kFar, kFar, -kFar, kFar, 5, 5};
  scene.spheres = {{{0, 0, -kFar}, kFar}};
  const Seen seen = see(visibility_of(scene));
  const ExactCamera camera(*scene.camera, scene.conventions);
  int hits = 0;
  for (std::size_t at = 0; at < pixels_of(scene); ++at) {
    const ExactRay ray = ray_at(camera, at);
    const auto exact = ray.nearest(scene.spheres, scene.conventions);
    ASSERT_EQ(seen.sphere[at], exact ? 0 : kNoSphere) << at;
    if (!exact) continue;
    ++hits;
    EXPECT_EQ(seen.parameter[at], ray.rounded_parameter(scene.spheres[0], exact->intersection))
        << at;
  }
  EXPECT_EQ(hits, 13);
}

TEST(Visibility, IsExactUnderEveryConvention) {
  int hits = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    scene::Scene scene = random_scene(seed);
    for (const auto origin : {scene::Origin::kPixel, scene::Origin::kFocal}) {
      for (const auto root : {scene::Root::kNearest, scene::Root::kSmaller}) {
        for (const auto tangent : {scene::Tangent::kHit, scene::Tangent::kMiss}) {
          scene.conventions.origin = origin;
          scene.conventions.root = root;
          scene.conventions.tangent = tangent;
          SCOPED_TRACE(seed);
          hits += expect_exact(scene, see(visibility_of(scene)), 3);
        }
      }
    }
  }
  EXPECT_GT(hits, 1'700);
}

/// The smallest lengths are subnormal. The filter decides these, too.
TEST(Visibility, IsExactAtEveryScale) {
  int hits = 0;
  for (const double scale : {0x1p1000, 0x1p500, 0x1p300, 0x1p-300, 0x1p-480, 0x1p-1000, 0x1p-1020,
                             0x1p-1040, 0x1p-1060, 0x1p-1068}) {
    SCOPED_TRACE(scale);
    for (const auto origin : {scene::Origin::kPixel, scene::Origin::kFocal}) {
      scene::Scene scene = random_scene(1, scale);
      scene.conventions.origin = origin;
      const Seen seen = see(visibility_of(scene));
      const bool is_subnormal = scale < 0x1p-1000;
      EXPECT_TRUE(!is_subnormal || seen.decided_by.fallback() * 10 < seen.sphere.size());
      hits += expect_exact(scene, seen);
    }
  }
  EXPECT_GT(hits, 2000);
}

TEST(Visibility, IsExactWithMoreSpheresThanAreListedAtFirst) {
  // Many near spheres on the left, few far spheres on the right; almost all are behind the eye.
  Uniform between{std::mt19937_64(1)};
  scene::Scene scene;
  scene.camera = scene::Camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 70, 18};
  for (int k = 0; k < 18'000; ++k) {
    if (k % 60 == 0) {
      scene.spheres.push_back({{between(-7, -4), between(-4, 4), between(-11, -9)}, 3});
    } else if (k % 60 == 30) {
      scene.spheres.push_back({{between(-60, 60), between(-60, 60), between(-60, -50)}, 2});
    } else {
      scene.spheres.push_back({{0, 0, 9.0 + k}, 1});
    }
  }
  const Seen seen = see(visibility_of(scene));
  const int hits = expect_exact(scene, seen);
  const auto meets = [&](int kind) {
    return std::any_of(seen.sphere.begin(), seen.sphere.end(),
                       [kind](std::int32_t sphere) { return sphere % 60 == kind; });
  };
  EXPECT_TRUE(meets(0) && meets(30));
  EXPECT_LT(hits, 70 * 18);

  // In parts, by several threads, each of which may be the first to list more; and for other roots.
  const Visibility fresh = visibility_of(scene);
  Seen parts(pixels_of(scene));
  std::vector<std::thread> threads;
  for (std::int64_t j = 0; j < 18; j += 5) {
    threads.emplace_back([&, j] {
      const std::int64_t end = std::min<std::int64_t>(j + 5, 18);
      const auto from = static_cast<std::size_t>(70 * j),
                 count = static_cast<std::size_t>(70 * (end - j));
      fresh.nearest(j, end, {std::span(parts.sphere).subspan(from, count), {}, {}, {}, {}});
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(parts.sphere, seen.sphere);
  scene.conventions.root = scene::Root::kSmaller;
  scene.conventions.origin = scene::Origin::kFocal;
  EXPECT_GT(expect_exact(scene, see(visibility_of(scene)), 11), 30);
  scene.conventions.valid.t_min = 10;
  EXPECT_GT(expect_exact(scene, see(visibility_of(scene)), 11), 30);
}

TEST(Visibility, SkipsNoVisibleSphere) {
  // The surfaces are equally near everywhere, so that some of the later spheres are visible.
  for (const int count : {300, 5'000}) {
    for (const std::uint64_t seed : {1U, 2U}) {
      SCOPED_TRACE(seed);
      Uniform between{std::mt19937_64(seed)};
      scene::Scene scene;
      scene.camera =
          scene::Camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, -1, {}, -.05, .05, -.015, .015, 70, 18};
      for (int k = 0; k < count; ++k) {
        const double radius = between(1, 3);
        scene.spheres.push_back(
            {{between(-2, 2), between(-1, 1), -10 - radius - between(0, .5)}, radius});
      }
      const std::size_t step = count > 1000 ? 3 : 1;
      EXPECT_GT(expect_exact(scene, see(visibility_of(scene)), step),
                1000 / static_cast<int>(step));
    }
  }
}

TEST(Visibility, LeavesAlmostAllPixelsOfOrdinaryScenesToTheFilter) {
  const Seen seen = see(visibility_of(random_scene(1)));
  EXPECT_LT(seen.decided_by.fallback() * 100, seen.sphere.size());
}

TEST(Visibility, DecidesTangentsAndTiesExactly) {
  scene::Scene scene = random_scene(1);
  scene.camera = scene::Camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 9, 9};
  scene.conventions = {};
  // A point on the ray of pixel (4, 8), and two spheres that touch the axis at one point.
  scene.spheres = {{{0, 8, -8}, 0}, {{3, 0, -5}, 3}, {{-3, 0, -5}, 3}};
  const Seen seen = see(visibility_of(scene));
  EXPECT_GT(expect_exact(scene, seen), 2);
  EXPECT_EQ(seen.sphere[8 * 9 + 4], 0);
  EXPECT_EQ(seen.sphere[4 * 9 + 4], 1);
  EXPECT_GE(seen.decided_by.fallback(), 2U);
}

/// A row of pixels in a plane that touches a sphere at the eye; the radius is larger by the share
/// `above`.
scene::Scene tangent_row(double above, scene::Samples samples, const scene::Point3& look_at) {
  scene::Scene scene;
  scene.camera = scene::Camera{{0, 0, 0}, look_at, {0, 1, 0}, -1, {}, -.7, .8, -.5, .5, 131, 1};
  if (samples == scene::Samples::kEdges) {
    scene.camera->height = 2;
    scene.camera->bottom = 0;
  }
  scene.conventions.samples = samples;
  scene.conventions.origin = scene::Origin::kFocal;
  const RoundedFrame frame = ExactCamera(*scene.camera, scene.conventions).rounded_frame();
  scene.spheres = {{{-2 * frame.V.x, -2 * frame.V.y, -2 * frame.V.z}, 2 * (1 + above)}};
  return scene;
}

TEST(Visibility, DecidesWholeRowsOfTangents) {
  for (const auto samples : {scene::Samples::kCentres, scene::Samples::kEdges}) {
    for (const auto tangent : {scene::Tangent::kHit, scene::Tangent::kMiss}) {
      scene::Scene scene = tangent_row(0, samples, {0, 0, -1});
      scene.conventions.tangent = tangent;
      const Seen first = see(visibility_of(scene));
      const bool is_hit = tangent == scene::Tangent::kHit;
      EXPECT_EQ(std::count(first.sphere.begin(), first.sphere.begin() + 131, 0), is_hit ? 131 : 0);
      expect_exact(scene, first);
      EXPECT_GE(first.decided_by.fallback(), 131U);
      // A sphere from which some of the rays start, before the other in the file.
      scene.spheres.insert(scene.spheres.begin(), {{1, 0, -1}, std::sqrt(2.0)});
      scene.spheres.push_back({{3, 0, -6}, 1});
      expect_exact(scene, see(visibility_of(scene)));
    }
  }
}

/// Has pixels that would count as tangent if fewer columns were checked, or if tangents of other
/// rows or spheres counted.
TEST(Visibility, FindsNoTangentsInOtherRows) {
  scene::Scene scene = tangent_row(0, scene::Samples::kEdges, {0, 0, -1});
  const scene::Sphere below = scene.spheres.front(), aside = {{3, 0, -5}, 3};
  scene.camera->width = 11;
  scene.camera->height = 33;
  scene.conventions.tangent = scene::Tangent::kMiss;
  expect_exact(scene, see(visibility_of(scene)));
  scene.camera->width = 131;
  scene.camera->height = 2;
  scene.spheres = {below, {{3, 0, -6}, 1}};
  EXPECT_GT(expect_exact(scene, see(visibility_of(scene))), 30);
  scene.conventions.tangent = scene::Tangent::kHit;
  scene.camera->left = 0;
  scene.camera->right = 0x1p-100;
  scene.camera->width = 9;
  scene.spheres = {aside};
  expect_exact(scene, see(visibility_of(scene)));
}

/// If roots behind the eye count, tangents of one row are at different s.
TEST(Visibility, DecidesTangentsOfLinesOneByOne) {
  for (const double t_max : {kInfinity, -1.05}) {
    scene::Scene scene = tangent_row(0, scene::Samples::kCentres, {0, 0, -1});
    scene.conventions.origin = scene::Origin::kPixel;
    scene.conventions.valid = {-kInfinity, t_max, {}, {}, {}};
    EXPECT_GT(expect_exact(scene, see(visibility_of(scene))), 20);
  }
}

/// Spheres whose surfaces pass within some ulps of the eye, of pixel points, or of rays.
TEST(Visibility, IsExactNearSurfaces) {
  std::uint64_t pairs = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    Uniform between{std::mt19937_64(seed)};
    scene::Scene scene = random_scene(seed);
    scene.camera->width = 9;
    scene.camera->height = 7;
    scene.conventions.origin = seed % 2 == 0 ? scene::Origin::kFocal : scene::Origin::kPixel;
    scene.conventions.root = seed % 3 == 0 ? scene::Root::kSmaller : scene::Root::kNearest;
    scene.conventions.rows = seed % 7 < 3 ? scene::Rows::kTopFirst : scene::Rows::kBottomFirst;
    scene.spheres.clear();
    const ExactCamera camera(*scene.camera, scene.conventions);
    const ExactRay ray(camera, {static_cast<std::int64_t>(seed % 9), 3});
    for (const scene::Point3& at : {scene.camera->eye, ray.rounded_pixel_point()}) {
      const double r = std::exp2(between(-3, 3)), x = between(-1, 1), y = between(-1, 1);
      const double z = std::sqrt(1 - x * x / 2 - y * y / 2);
      const double off = r * (1 + std::exp2(between(-52, -25)));
      const double size = std::hypot(x, y, z);
      scene.spheres.push_back(
          {{at.x + off * x / size, at.y + off * y / size, at.z + off * z / size}, r});
      scene.spheres.push_back({scene.spheres.back().centre, r * (1 + 0x1p-50)});
    }
    const Seen seen = see(visibility_of(scene));
    expect_exact(scene, seen);
    pairs += seen.decided_by.stages[1];
  }
  EXPECT_GT(pairs, 300U);
}

TEST(Visibility, DecidesNearTangentsInPairs) {
  for (const scene::Point3& look_at : {scene::Point3{0, 0, -1}, {1, -2, -3}}) {
    for (const double above : {1e-12, 1e-14, 1e-15, -1e-12, -1e-15}) {
      for (const auto origin : {scene::Origin::kFocal, scene::Origin::kPixel}) {
        scene::Scene scene = tangent_row(above, scene::Samples::kCentres, look_at);
        scene.conventions.origin = origin;
        const Seen seen = see(visibility_of(scene));
        expect_exact(scene, seen);
        const auto [intervals, pairs, balls, field] = seen.decided_by.stages;
        EXPECT_EQ(intervals + balls + field, 0U) << above;
        if (above > 0 && origin == scene::Origin::kFocal) {
          EXPECT_EQ(pairs, 131U) << above;
        }
      }
    }
  }
}

TEST(Visibility, DoesNotDependOnTheRowsOfACall) {
  const Visibility visibility = visibility_of(random_scene(2));
  const Seen one = see(visibility);
  const auto width = static_cast<std::size_t>(visibility.scene().camera->width);
  const std::int64_t height = visibility.scene().camera->height;
  for (std::int64_t j = 0; j < height; j += 5) {
    const std::int64_t end = std::min(j + 5, height);
    Seen rows(width * static_cast<std::size_t>(end - j));
    visibility.nearest(j, end, rows.rows());
    const auto from = one.sphere.begin() + static_cast<std::ptrdiff_t>(width) * j;
    EXPECT_TRUE(std::equal(rows.sphere.begin(), rows.sphere.end(), from));
  }
}

TEST(Visibility, DoesNotDependOnTheTarget) {
  // A sphere that rays leave or miss so near to the eye that only pairs decide where.
  scene::Scene scene = random_scene(3);
  scene.conventions.origin = scene::Origin::kFocal;
  const auto& [x, y, z] = scene.camera->eye;
  scene.spheres.push_back({{x, y + 1, z}, 1 - 0x1p-50});
  const Visibility visibility = visibility_of(scene);
  const Seen best = see(visibility);
  EXPECT_GT(best.decided_by.stages[1], best.sphere.size() / 5);
  int targets = 0;
  for (std::int64_t left = hwy::SupportedTargets() & kernel_targets(); left != 0;
       left &= left - 1, ++targets) {
    SCOPED_TRACE(hwy::TargetName(left & -left));
    hwy::SetSupportedTargetsForTest(left & -left);
    const Seen seen = see(visibility);
    hwy::SetSupportedTargetsForTest(0);
    EXPECT_EQ(seen.sphere, best.sphere);
    expect_exact(visibility.scene(), seen);
  }
  EXPECT_GT(targets, 1);
}

TEST(Visibility, ClassesAreExact) {
  for (const unsigned seed : {1U, 2U, 4U}) expect_exact_classes(random_scene(seed), 1);
}

/// With intervals and culling, the nearest sphere is often behind others.
TEST(Visibility, FollowsTheRootsThatCount) {
  int differing = 0;
  for (const scene::ValidRoots& valid :
       {scene::ValidRoots{4, kInfinity, {}, {}, {}},
        {0, 9, scene::Ends::kOpen, {}, {}},
        {2, 30, {}, scene::TUnit::kRadius, {}},
        {-kInfinity, kInfinity, {}, {}, {}},
        {-kInfinity, kInfinity, {}, {}, scene::Culling::kFrontFaces},
        {0, kInfinity, {}, {}, scene::Culling::kFrontFaces}}) {
    for (const unsigned seed : {1U, 4U}) {
      scene::Scene scene = random_scene(seed);
      const std::vector<std::int32_t> usual = see(visibility_of(scene)).sphere;
      scene.conventions.valid = valid;
      const Seen seen = see(visibility_of(scene));
      EXPECT_GT(expect_exact(scene, seen), 50);
      differing += seen.sphere != usual ? 1 : 0;
      expect_exact_classes(scene, 7);
    }
  }
  EXPECT_GE(differing, 7);
}

TEST(Visibility, SeesSpheresBehindTheEyeIfLinesAreIntersected) {
  for (const scene::Origin origin : {scene::Origin::kPixel, scene::Origin::kFocal}) {
    scene::Scene scene = tangent_row(0, scene::Samples::kCentres, {0, 0, -1});
    const scene::Camera& camera = *scene.camera;
    const auto& [x, y, z] = camera.eye;
    const auto& [u, v, w] = camera.look_at;
    scene.conventions.origin = origin;
    scene.spheres = {{{x + 3 * (x - u), y + 3 * (y - v), z + 3 * (z - w)}, 1}};
    EXPECT_EQ(expect_exact(scene, see(visibility_of(scene))), 0);
    scene.conventions.valid.t_min = -kInfinity;
    EXPECT_GT(expect_exact(scene, see(visibility_of(scene))), 0);
    expect_exact_classes(scene, 1);
  }
}

TEST(Visibility, RefusesArraysAndRowsThatDoNotFit) {
  const Visibility visibility = visibility_of(random_scene(1));
  std::vector<std::int32_t> sphere(5);
  EXPECT_THROW(visibility.nearest(0, 1, {sphere, {}, {}, {}, {}}), std::invalid_argument);
  EXPECT_THROW(visibility.nearest(0, 1000, {}), std::invalid_argument);
  EXPECT_THROW(visibility.nearest(-1, 1, {}), std::invalid_argument);
  Seen seen(pixels_of(visibility.scene()));
  SeenRows rows = seen.rows();
  rows.point_y = {};
  const std::int64_t height = visibility.scene().camera->height;
  EXPECT_THROW(visibility.nearest(0, height, rows), std::invalid_argument);
}

}  // namespace
}  // namespace raycheck::reference
