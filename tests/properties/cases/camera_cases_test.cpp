// The dials of the families of cameras.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "tests/properties/cases/dial.h"

namespace raycheck::properties {
namespace {

using reference::ExactRay;
using scene::Camera;
using scene::Sphere;
using Sets = DialRow::Sets;

const Camera& camera_of(const Case& the_case) { return *the_case.scene.camera; }

std::vector<Measured> far_camera(const Case& the_case) {
  return {{norm(lift(camera_of(the_case).eye))}};
}

/// The longest of |E|, |A| and |near|.
std::vector<Measured> camera_scale(const Case& the_case) {
  const Camera& camera = camera_of(the_case);
  Enclosure longest = norm(lift(camera.eye));
  for (const Enclosure& x : {norm(lift(camera.look_at)), abs(lift(camera.near))}) {
    if ((x - longest).certain_sign().value_or(0) > 0) longest = x;
  }
  return {{longest, 0x1p-1074}};
}

/// The sine of the angle between up and the view.
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

/// |C - P| and r of each sphere, P the exact point of the first pixel.
struct PixelMeeting {
  Enclosure to_centre;
  Enclosure axial;
  Enclosure radius;
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

const DialRow kCameraRows[] = {
    {"far-camera", Sets::kPower, 0.5 * kBelow, 2 * kAbove, 15, far_camera},
    {"camera-scale", Sets::kEither, 0x1p-3, 0x1p6, 1074, camera_scale},
    // An angle whose tangent is at most 0.9 has a sine of 0.66.
    {"up", Sets::kInverse, 0.37, 0.9, 15, up},
    {"field-of-view", Sets::kEither, 0.5 * kBelow, 2 * kAbove, 15, field_of_view},
    {"image-size", Sets::kPower, 1, 1, 30, image_size},
    {"near-plane", Sets::kInverse, 0.4, 0.9, 15, near_plane},
};

class CameraFamily : public testing::TestWithParam<DialRow> {};
TEST_P(CameraFamily, SetsWhatItsDialSays) { expect_dial(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Families, CameraFamily, testing::ValuesIn(kCameraRows), test_name);

TEST(CameraFamily, OfImageSizesReachesTheMostPixelsAndEveryCorner) {
  const CaseSource& source = *find_case_source("image-size");
  std::array<int, 4> corners = {};
  int square = 0;
  int elsewhere = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Case the_case = source.make(source.dial->highest, seed);
    const Camera& camera = camera_of(the_case);
    ASSERT_EQ(camera.width, scene::kMostPixelsAcross);
    square += camera.height == camera.width ? 1 : 0;
    for (const auto& [i, j] : the_case.pixels) {
      const bool is_corner =
          (i == 0 || i == camera.width - 1) && (j == 0 || j == camera.height - 1);
      ++(is_corner ? corners[(i == 0 ? 0u : 2u) + (j == 0 ? 0u : 1u)] : elsewhere);
    }
  }
  for (const int count : corners) EXPECT_GT(count, 50);
  EXPECT_GT(square, 100);
  EXPECT_GT(elsewhere, 100);
}

TEST(CameraFamily, OfNearPlanesStartsOnEverySideOfTheSurface) {
  expect_every_side("near-plane", {0, 7, 13}, [](const Case& the_case, Sides& sides) {
    ASSERT_EQ(the_case.scene.conventions.origin, scene::Origin::kPixel);
    for (const PixelMeeting& m : meetings(the_case)) sides.count(m.to_centre, m.axial, m.radius);
  });
}

}  // namespace
}  // namespace raycheck::properties
