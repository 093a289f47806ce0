// The bounds of scene::EyeSpace hold the exact values, on every source of cameras.

#include "scene/plan/eye_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "properties/cases/case_source.h"
#include "reference/enclosure.h"
#include "reference/error_measure.h"
#include "reference/exact_camera.h"
#include "scene/plan/plan.h"
#include "tests/numbers.h"

namespace raycheck::properties {
namespace {

using reference::Enclosure;
using reference::Enclosure3;
using scene::Bounds;
using scene::EyeSpace;

/// Bounds times 2^exponent against the exact value, which an enclosure of 256 bits stands for: it
/// may lie across an end by its own width.
void expect_holds(const Bounds& bounds, int exponent, const Enclosure& exact) {
  ASSERT_LE(bounds.low, bounds.high);
  const auto at = [exponent](double end) {
    return Enclosure(end, kBitsOfAnySum) * Enclosure(std::ldexp(1.0, exponent), kBitsOfAnySum);
  };
  if (std::isfinite(bounds.low)) {
    EXPECT_GE((exact - at(bounds.low)).certain_sign().value_or(0), 0) << bounds.low;
  }
  if (std::isfinite(bounds.high)) {
    EXPECT_LE((exact - at(bounds.high)).certain_sign().value_or(0), 0) << bounds.high;
  }
}

/// How often both ends are known, and how often to 10 digits.
struct Known {
  int all = 0, finite = 0, to_ten_digits = 0;

  void count(const Bounds& bounds) {
    ++all;
    finite += std::isfinite(bounds.low) && std::isfinite(bounds.high) ? 1 : 0;
    const double size = std::max(std::abs(bounds.low), std::abs(bounds.high));
    to_ten_digits += bounds.high - bounds.low <= 1e-10 * size ? 1 : 0;
  }
};

Known compare(const CaseSource& source, std::uint64_t cases, bool as_planned) {
  Known known;
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const Case the_case = any_case(source, seed);
    const scene::Camera& camera = *the_case.scene.camera;
    const scene::Conventions& conventions = the_case.scene.conventions;
    const EyeSpace eye =
        as_planned ? scene::plan_scene(the_case.scene, conventions, scene::Wanted::kClass).eye
                   : EyeSpace(camera, conventions, {}, true);
    const reference::ExactCamera exact(camera, conventions);
    const auto axes = exact.frame(256);
    const auto& [plane, lengths] = eye.scaling();
    for (const scene::Sphere& sphere : the_case.scene.spheres) {
      const scene::EyeSphere seen = eye.sphere(sphere);
      const Enclosure3 f =
          Enclosure3{Enclosure(sphere.centre.x, kBitsOfAnySum),
                     Enclosure(sphere.centre.y, kBitsOfAnySum),
                     Enclosure(sphere.centre.z, kBitsOfAnySum)} -
          Enclosure3{Enclosure(camera.eye.x, kBitsOfAnySum), Enclosure(camera.eye.y, kBitsOfAnySum),
                     Enclosure(camera.eye.z, kBitsOfAnySum)};
      const Enclosure r(sphere.radius, kBitsOfAnySum);
      expect_holds(seen.u, lengths, dot(f, axes.U));
      expect_holds(seen.v, lengths, dot(f, axes.V));
      expect_holds(seen.w, lengths, dot(f, axes.W));
      expect_holds(seen.radius, lengths, r);
      const Enclosure scale(std::ldexp(1.0, lengths), kBitsOfAnySum);
      expect_holds(seen.distance_sq, lengths, dot(f, f) / scale);
      expect_holds(seen.power, lengths, (dot(f, f) - r * r) / scale);
      known.count(seen.distance_sq);
    }
    for (const scene::Pixel& pixel : the_case.pixels) {
      const Enclosure3 position = exact.plane_position(pixel);
      const Bounds alpha = eye.alpha(static_cast<double>(pixel.i));
      const Bounds beta = eye.beta(static_cast<double>(pixel.j));
      expect_holds(alpha, plane, position.x);
      expect_holds(beta, plane, position.y);
      expect_holds(eye.near(), plane, position.z);
      const Bounds column = eye.column(alpha), row = eye.row(beta);
      EXPECT_TRUE(column.contains(static_cast<double>(pixel.i)));
      EXPECT_TRUE(row.contains(static_cast<double>(pixel.j)));
    }
  }
  return known;
}

TEST(EyeSpace, BoundsTheExactValues) {
  for (const CaseSource& source : case_sources()) {
    if (!source.has_camera) continue;
    SCOPED_TRACE(source.name);
    Known known;
    for (const bool as_planned : {true, false}) {
      const Known these = compare(source, 400, as_planned);
      if (as_planned) known = these;
    }
    EXPECT_GT(known.all, 100);
    EXPECT_GT(20 * known.finite, 19 * known.all);
    EXPECT_GT(4 * known.to_ten_digits, 3 * known.all);
  }
}

}  // namespace
}  // namespace raycheck::properties
