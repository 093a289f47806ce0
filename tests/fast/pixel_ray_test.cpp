#include "fast/pixel_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "properties/cases/case_source.h"
#include "properties/quantity.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"

namespace raycheck::fast {
namespace {

using scene::Camera;
using scene::Conventions;
using scene::Pixel;
using scene::Point3;
using scene::UnitVector3;

const Camera kFirst = {{8, 8, 100}, {8, 8, 54}, {0, 1, 0}, -30, {}, -30, 30, -20, 20, 2, 2};
Point3 point(const Vectors& vectors, std::size_t k) {
  return {vectors.x.at(k), vectors.y.at(k), vectors.z.at(k)};
}

UnitVector3 direction(const Rays& rays, std::size_t k) {
  return {rays.direction.x.at(k), rays.direction.y.at(k), rays.direction.z.at(k)};
}

TEST(PixelRay, TakesBatchesOfAnySize) {
  Camera camera = kFirst;
  camera.width = camera.height = 200;
  std::vector<Pixel> many;
  for (std::int64_t k = 0; k < 1000; ++k) many.push_back({k % 200, k / 200});
  for (const PixelRayMethod* method : pixel_ray_methods()) {
    Rays rays;
    method->focal_rays(camera, {}, many, rays);
    ASSERT_EQ(rays.size(), 1000u);
    Rays alone;
    for (const std::size_t k :
         {std::size_t{0}, std::size_t{31}, std::size_t{64}, std::size_t{127}, std::size_t{999}}) {
      method->focal_rays(camera, {}, std::span(&many[k], 1), alone);
      ASSERT_EQ(alone.size(), 1u);
      EXPECT_EQ(direction(alone, 0), direction(rays, k)) << method->name;
    }
    // An answer does not depend on which pixels are asked for before it.
    const std::vector<Pixel> scattered = {{7, 1},  {8, 2},  {10, 2}, {9, 2},
                                          {63, 2}, {64, 2}, {65, 2}};
    method->focal_rays(camera, {}, scattered, alone);
    for (std::size_t k = 0; k < scattered.size(); ++k) {
      const auto in_order = static_cast<std::size_t>(scattered[k].j * 200 + scattered[k].i);
      EXPECT_EQ(direction(alone, k), direction(rays, in_order)) << method->name;
    }
    method->focal_rays(camera, {}, {}, rays);  // a batch in use shrinks
    EXPECT_EQ(rays.size(), 0u);
    EXPECT_EQ(rays.direction.size(), 0u);
  }
}

TEST(PixelRay, RefusesByTheNameOfTheField) {
  Camera camera = kFirst;
  camera.right = camera.left;
  const std::vector<Pixel> pixels = {{0, 0}};
  for (const PixelRayMethod* method : pixel_ray_methods()) {
    Rays rays;
    try {
      method->focal_rays(camera, {}, pixels, rays);
      ADD_FAILURE() << method->name;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("camera.right"), std::string::npos) << error.what();
    }
  }
  camera = kFirst;
  camera.width = 1;  // i/(w-1) is 0/0 on the edges, and well defined at the centres
  Rays rays;
  EXPECT_THROW(kDirectRays.focal_rays(camera, {}, pixels, rays), std::invalid_argument);
  Conventions centres;
  centres.samples = scene::Samples::kCentres;
  EXPECT_NO_THROW(kDirectRays.focal_rays(camera, centres, pixels, rays));
}

/// Calls visit(scene, exact ray, pixel) for pixels of random cameras, whose images are wide enough
/// for every step of `incremental`.
template <class Visit>
void for_each_pixel(std::initializer_list<const char*> sources, Visit visit) {
  for (const char* source : sources) {
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      auto the_case = properties::chosen_source(source).make(seed);
      scene::Scene& scene = the_case.scene;
      if (seed % 2 == 1) {
        constexpr std::int64_t kWider = 100;
        scene.camera->width *= kWider;
        for (Pixel& pixel : the_case.pixels) {
          pixel.i = pixel.i * kWider + static_cast<std::int64_t>(seed) % kWider;
        }
      }
      const reference::ExactCamera camera(*scene.camera, scene.conventions);
      for (const Pixel& pixel : the_case.pixels) {
        visit(scene, reference::ExactRay(camera, pixel), pixel);
      }
    }
  }
}

/// Holds a method to its bounds, as they stand while the condition numbers are moderate.
void expect_within_bounds(const PixelRayMethod& method,
                          std::initializer_list<const char*> sources) {
  SCOPED_TRACE(method.name);
  int points_judged = 0;
  int directions_judged = 0;
  for_each_pixel(
      sources, [&](const scene::Scene& scene, const reference::ExactRay& exact, Pixel pixel) {
        const std::span<const Pixel> pixels(&pixel, 1);
        if (method.pixel_points != nullptr &&
            reference::condition_of_pixel_point(exact) <= properties::kModerateCondition) {
          ++points_judged;
          Vectors points;
          method.pixel_points(*scene.camera, scene.conventions, pixels, points);
          EXPECT_LE(reference::relative_error(point(points, 0), exact.pixel_point()),
                    method.max_point_ulp);
        }
        if (reference::condition_of_direction(exact) > properties::kModerateCondition) return;
        ++directions_judged;
        Rays rays;
        method.focal_rays(*scene.camera, scene.conventions, pixels, rays);
        EXPECT_LE(reference::angle_error(direction(rays, 0), exact.direction()),
                  method.max_direction_ulp);
        EXPECT_LE(reference::unit_defect(direction(rays, 0)), method.max_unit_defect_ulp);
      });
  EXPECT_GT(directions_judged, 400 * static_cast<int>(sources.size()));
  if (method.pixel_points != nullptr) {
    EXPECT_GT(points_judged, 500 * static_cast<int>(sources.size()));
  }
}

TEST(PixelRay, IsWithinItsBoundsOnRandomCameras) {
  for (const PixelRayMethod* method : {&kDirectRays, &kFocalRays, &kIncrementalRays}) {
    expect_within_bounds(*method, {"cameras", "plain-cameras", "far-camera", "up"});
  }
}

TEST(PixelRay, OfSinglePrecisionIsWithinItsBoundsNearTheOrigin) {
  expect_within_bounds(kSingleRays, {"cameras", "plain-cameras"});
}

TEST(PixelRay, OfTheLectureIsWithinItsBoundsFromPlainEyes) {
  expect_within_bounds(kLectureRays, {"plain-cameras"});
}

}  // namespace
}  // namespace raycheck::fast
