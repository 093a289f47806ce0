#include <gtest/gtest.h>

#include <array>

#include "tests/reference/second_opinion.h"

namespace raycheck::reference {
namespace {

using scene::Camera;

/// low + part (high - low)
Number coordinate(double low, double high, std::int64_t index, std::int64_t count,
                  scene::Samples samples) {
  const Number extent = Number(high) - Number(low);
  if (samples == scene::Samples::kEdges) {
    return Number(low) +
           Number(static_cast<int>(index)) * extent / Number(static_cast<int>(count - 1));
  }
  return Number(low) +
         Number(static_cast<int>(2 * index + 1)) * extent / Number(static_cast<int>(2 * count));
}

/// E and P - E of a pixel, end to end from the camera's numbers.
struct PixelLine {
  Vector eye, to_pixel;

  PixelLine(const Camera& camera, const scene::Conventions& conventions, const scene::Pixel& pixel)
      : eye(vector(camera.eye)) {
    const Vector w = eye - vector(camera.look_at);
    const Vector W = Number(1) / CGAL::sqrt(dot(w, w)) * w;
    const Vector u = cross(vector(camera.up), w);
    const Vector U = Number(1) / CGAL::sqrt(dot(u, u)) * u;
    const bool bottom_first = conventions.rows == scene::Rows::kBottomFirst;
    const Number alpha =
        coordinate(camera.left, camera.right, pixel.i, camera.width, conventions.samples);
    const Number beta =
        coordinate(camera.bottom, camera.top, bottom_first ? pixel.j : camera.height - 1 - pixel.j,
                   camera.height, conventions.samples);
    to_pixel = Number(camera.near) * W + alpha * U + beta * cross(W, U);
  }
};

void expect_same_from_cameras(std::uint64_t seed, Sizes sizes, int cases, Counts& counts) {
  Random random(seed);
  for (int k = 0; k < cases && !testing::Test::HasFailure(); ++k) {
    const Camera camera = random_camera(random, sizes);
    const scene::Conventions conventions = random_conventions(random);
    const scene::Pixel pixel = random_pixel(random, camera);
    SCOPED_TRACE(spelled(camera));
    const ExactRay ray(ExactCamera(camera, conventions), pixel);
    const PixelLine line(camera, conventions, pixel);
    const Vector origin =
        conventions.origin == scene::Origin::kPixel ? line.eye + line.to_pixel : line.eye;
    for (int n = 0; n < 2; ++n) {
      const Sphere sphere = random_sphere(random, sizes);
      SCOPED_TRACE(spelled(sphere));
      expect_same_intersections(ray, origin, line.to_pixel, sphere, counts);
    }
  }
}

TEST(SecondOpinion, OnCamerasEndToEnd) {
  const int cases = share_of(6000);
  for (const auto& [seed, sizes] :
       {std::pair(11u, Sizes::kOrdinary), {12u, Sizes::kSmallIntegers}}) {
    Counts counts;
    expect_same_from_cameras(seed, sizes, cases, counts);
    EXPECT_EQ(counts.decisions, 4 * cases);
    EXPECT_GE(counts.hits, cases / 10);
    EXPECT_GE(counts.misses, cases / 4);
    if (sizes == Sizes::kSmallIntegers) continue;
    EXPECT_GE(counts.larger_roots, cases / 20);
    EXPECT_GE(counts.behind, cases / 20);
  }
}

TEST(SecondOpinion, OnCamerasAlongAnAxisWhoseRaysAreTangent) {
  // The centre column looks along -z with rational steps; unit spheres stand beside and on its
  // rays.
  Random random(13);
  Counts counts;
  const int cases = share_of(6000);
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
    const ExactRay ray(ExactCamera(camera, conventions), {1, 1});
    const PixelLine line(camera, conventions, {1, 1});
    const Vector origin =
        conventions.origin == scene::Origin::kPixel ? line.eye + line.to_pixel : line.eye;
    const double radius = static_cast<double>(random.integer(0, 3));
    const Sphere sphere{
        {nudged(eye.x + radius, random.integer(-1, 1)), eye.y, eye.z + random.small_integer(9)},
        radius};
    SCOPED_TRACE(spelled(camera) + spelled(sphere));
    expect_same_intersections(ray, origin, line.to_pixel, sphere, counts);
  }
  EXPECT_EQ(counts.decisions, 2 * cases);
  EXPECT_GE(counts.tangents, cases / 10);
  EXPECT_GE(counts.hits, cases / 20);
  EXPECT_GE(counts.misses, cases / 4);
}

}  // namespace
}  // namespace raycheck::reference
