// On every source with cameras, the bounds of scene::EyeSpace contain the exact values, and the
// bounds E and E_m of reference/visibility/visibility_kernel.h hold.

#include "scene/plan/eye_space.h"

#include <hwy/targets.h>

#include "properties/cases/case_source.h"
#include "reference/enclosure.h"
#include "reference/error_measure.h"
#include "reference/exact_camera.h"
#include "reference/visibility/visibility_bound.h"
#include "reference/visibility/visibility_formula.h"
#include "scene/plan/plan.h"
#include "tests/properties/laws/pair_discriminant.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

using reference::Enclosure;
using reference::Enclosure3;
using scene::Bounds;
using scene::EyeSpace;

Enclosure exactly(double x) { return Enclosure(x, kBitsOfAnySum); }
template <class Triple>
Enclosure3 exactly3(const Triple& v) {
  return {exactly(v.x), exactly(v.y), exactly(v.z)};
}
/// The power is made of two factors, because it may be outside the range of doubles.
Enclosure power_of_two(int exponent) {
  return exactly(std::ldexp(1.0, exponent / 2)) * exactly(std::ldexp(1.0, exponent - exponent / 2));
}

/// Compares bounds times 2^exponent with the exact value, an enclosure of 256 bits, which may
/// exceed an end by its width.
void expect_holds(const Bounds& bounds, int exponent, const Enclosure& exact) {
  ASSERT_LE(bounds.low, bounds.high);
  const auto at = [exponent](double end) { return exactly(end) * power_of_two(exponent); };
  if (std::isfinite(bounds.low)) {
    EXPECT_GE((exact - at(bounds.low)).certain_sign().value_or(0), 0) << bounds.low;
  }
  if (std::isfinite(bounds.high)) {
    EXPECT_LE((exact - at(bounds.high)).certain_sign().value_or(0), 0) << bounds.high;
  }
}

/// The number of values that have two ends, and the number that have 10 digits.
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
    const Case the_case = ChosenSource{&source}.make(seed);
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
      const Enclosure3 f = exactly3(sphere.centre) - exactly3(camera.eye);
      const Enclosure r = exactly(sphere.radius);
      expect_holds(seen.u, lengths, dot(f, axes.U));
      expect_holds(seen.v, lengths, dot(f, axes.V));
      expect_holds(seen.w, lengths, dot(f, axes.W));
      expect_holds(seen.radius, lengths, r);
      const Enclosure scale = power_of_two(lengths);
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
    compare(source, 400, false);
    const Known known = compare(source, 400, true);
    EXPECT_GT(known.all, 100);
    EXPECT_GT(20 * known.finite, 19 * known.all);
    EXPECT_GT(4 * known.to_ten_digits, 3 * known.all);
  }
}

/// A scene with its spheres moved and resized in 19 ways: more spheres than two vectors of any
/// target hold.
scene::Scene with_more_spheres(scene::Scene scene) {
  const std::vector<scene::Sphere> given = scene.spheres;
  const scene::Point3 eye = scene.camera->eye;
  scene.spheres.clear();
  for (std::size_t k = 0; !given.empty() && k < 19; ++k) {
    scene::Sphere sphere = given[k % given.size()];
    const double share = static_cast<double>(k / given.size()) / 8;
    for (double scene::Point3::*x : {&scene::Point3::x, &scene::Point3::y, &scene::Point3::z}) {
      sphere.centre.*x += share * (k % 3 == 0 ? -1 : 1) * (eye.*x - sphere.centre.*x);
    }
    sphere.radius *= 1 - share / 4;
    scene.spheres.push_back(sphere);
  }
  return scene;
}

TEST(Plan, OfASphereDoesNotDependOnOtherSpheresOnAnyTarget) {
  for (const CaseSource& source : case_sources()) {
    if (!source.has_camera) continue;
    SCOPED_TRACE(source.name);
    int compared = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      scene::Scene scene = with_more_spheres(ChosenSource{&source}.make(seed).scene);
      const auto plan = [&] {
        return plan_scene(scene, scene.conventions, scene::Wanted::kNearest, {.hidden = false})
            .spheres;
      };
      const std::vector<scene::SpherePlan> best = plan();
      for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
        hwy::SetSupportedTargetsForTest(left & -left);
        EXPECT_EQ(plan(), best);
        hwy::SetSupportedTargetsForTest(0);
      }
      // Spheres that do not fill a vector are planned one by one.
      for (std::size_t k = 0; k < best.size(); ++k) {
        std::rotate(scene.spheres.begin(), scene.spheres.begin() + 1, scene.spheres.end());
        EXPECT_EQ(plan().back(), best[k]);
        ++compared;
      }
    }
    EXPECT_GT(compared, 1000);
  }
}

/// A pixel and a sphere in scaled lengths, exact except for the axes, which have 512 bits.
struct Exact {
  Enclosure b, disc;
};

/// A double in the kernel's formulas, with or without fused operations.
template <bool kFused>
struct Number {
  double x;
  friend Number operator*(Number a, Number b) { return {a.x * b.x}; }
  friend Number operator+(Number a, Number b) { return {a.x + b.x}; }
  friend Number operator-(Number a, Number b) { return {a.x - b.x}; }
  friend Number mul_add(Number a, Number b, Number c) {
    return kFused ? Number{std::fma(a.x, b.x, c.x)} : a * b + c;
  }
  friend Number mul_sub(Number a, Number b, Number c) { return mul_add(a, b, {-c.x}); }
  friend Number sub_mul(Number a, Number b, Number c) { return mul_add({-a.x}, b, c); }
};

struct Computed {
  double b, disc;
};

template <bool kFused>
Computed computed(const reference::FilteredSphere& sphere, double alpha, double beta, double near) {
  using N = Number<kFused>;
  namespace formula = reference::HWY_NAMESPACE;
  const N x{alpha}, u{sphere.u}, v{sphere.v}, w{sphere.w};
  const auto row = formula::row_terms(N{near}, N{beta}, u, v, w);
  const N b = formula::b_of(x, u, row.b), a = formula::a_of(x, row.a);
  const N disc = sphere.by_moment ? formula::discriminant_by_moment(
                                        formula::moment_of(x, v, w, row), a, N{sphere.radius_sq})
                                  : formula::discriminant(b, a, N{sphere.power});
  return {b.x, disc.x};
}

/// The largest ratios of an error to its bound.
struct Shares {
  double disc = 0, numerator = 0;
  int compared = 0, decided = 0, by_moment = 0;
};

/// A lower bound on |got - exact| / bound.
double share(const Enclosure& got, const Enclosure& exact, double bound) {
  return (abs(got - exact) / exactly(bound)).upper();
}
double share(double got, const Enclosure& exact, double bound) {
  return share(exactly(got), exact, bound);
}

void compare_pairs(const reference::FilteredSphereOf<reference::Pair>& sphere,
                   const reference::PairRays& rays, const Exact& exact, Shares& shares) {
  const auto sum = [](const reference::Pair& x) { return exactly(x.high) + exactly(x.low); };
  const PairRoots got = pair_roots(sphere, rays);
  ++shares.compared;
  shares.disc = std::max(
      shares.disc, share(sum(got.disc), exact.disc, sphere.decided / reference::kDecidedBeyond));
  if (!(got.disc.high > sphere.decided)) return;
  ++shares.decided;
  for (const double sign : {-1.0, 1.0}) {
    shares.numerator = std::max(
        shares.numerator, share(sum(got.b) + exactly(sign) * sum(got.q),
                                exact.b + exactly(sign) * sqrt(exact.disc), sphere.root_margin));
  }
}

void compare(const Case& the_case, Shares& shares, Shares& in_pairs, Shares& in_pairs_mutated) {
  const scene::Camera& camera = *the_case.scene.camera;
  const scene::ScenePlan plan =
      scene::plan_scene(the_case.scene, the_case.scene.conventions, scene::Wanted::kNearest);
  const auto& [plane, lengths] = plan.eye.scaling();
  std::vector<scene::Bounds> alpha, beta;
  for (const scene::Pixel& pixel : the_case.pixels) {
    alpha.push_back(plan.eye.alpha(static_cast<double>(pixel.i)));
    beta.push_back(plan.eye.beta(static_cast<double>(pixel.j)));
  }
  const double near = reference::middle(plan.eye.near());
  const auto sizes = reference::plane_sizes(alpha, beta, plan.eye.near());
  const reference::ExactCamera exact(camera, the_case.scene.conventions);
  const auto axes = exact.frame(512);
  const reference::PairView pairs(exact);
  for (std::size_t k = 0; k < plan.spheres.size(); ++k) {
    const auto sphere = reference::filtered(plan.spheres[k], k, sizes);
    const scene::Sphere& given = the_case.scene.spheres[k];
    const auto sphere_in_pairs = pairs.sphere(given, k);
    const bool has_pairs = plan.eye.scaling() == scene::Scaling{} && !sphere_in_pairs.exact;
    if (sphere.exact && !has_pairs) continue;
    const Enclosure unit = power_of_two(-lengths);
    const Enclosure3 T = exactly3(given.centre) - exactly3(camera.eye);
    const Enclosure3 f{T.x * unit, T.y * unit, T.z * unit};
    const Enclosure r = exactly(given.radius) * unit;
    const Enclosure u = dot(f, axes.U), v = dot(f, axes.V), w = dot(f, axes.W);
    const Enclosure c = dot(f, f) - r * r;
    for (std::size_t at = 0; at < the_case.pixels.size(); ++at) {
      const Enclosure3 position = exact.plane_position(the_case.pixels[at]);
      const Enclosure on_plane = power_of_two(-plane);
      const Enclosure x = position.x * on_plane, y = position.y * on_plane,
                      n = position.z * on_plane;
      const Enclosure b = n * w + y * v + x * u;
      const Enclosure disc = b * b - c * (n * n + x * x + y * y);
      const double E = sphere.decided / reference::kDecidedBeyond;
      // If a ray passes too far away for a useful bound, it must only miss.
      const Enclosure S_sq = r * r * exactly(sizes.A);
      const bool passes_far = (disc + exactly(3) * S_sq).certain_sign() == -1;
      if (has_pairs && !passes_far) {
        const auto [i, j] = the_case.pixels[at];
        reference::PairRays rays = pairs.rays({}, i, j);
        compare_pairs(sphere_in_pairs, rays, {b, disc}, in_pairs);
        rays.step.low = 0;
        compare_pairs(sphere_in_pairs, rays, {b, disc}, in_pairs_mutated);
      }
      if (sphere.exact) continue;
      for (const bool fused : {true, false}) {
        const auto compute = fused ? computed<true> : computed<false>;
        const Computed got =
            compute(sphere, reference::middle(alpha[at]), reference::middle(beta[at]), near);
        ++shares.compared;
        shares.by_moment += sphere.by_moment ? 1 : 0;
        if (sphere.by_moment && passes_far) {
          EXPECT_LT(got.disc, -2 * sphere.radius_sq * sizes.A);
          continue;
        }
        shares.disc = std::max(shares.disc, share(got.disc, disc, E));
        if (!(got.disc > sphere.decided)) continue;
        ++shares.decided;
        for (const double sign : {-1.0, 1.0}) {
          const double m = got.b + sign * std::sqrt(got.disc);
          shares.numerator = std::max(shares.numerator,
                                      share(m, b + exactly(sign) * sqrt(disc), sphere.root_margin));
        }
      }
    }
  }
}

TEST(VisibilityBound, HoldsOnEverySourceOfCameras) {
  int by_moment = 0, pairs_compared = 0;
  Shares in_pairs_mutated;
  double most_in_pairs = 0;
  for (const CaseSource& source : case_sources()) {
    if (!source.has_camera) continue;
    SCOPED_TRACE(source.name);
    Shares shares, in_pairs;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      // Every second seed is tried without fused operations.
      hwy::SetSupportedTargetsForTest(seed % 2 == 0 ? 0 : HWY_SSE4);
      compare(ChosenSource{&source}.make(seed), shares, in_pairs, in_pairs_mutated);
    }
    hwy::SetSupportedTargetsForTest(0);
    EXPECT_LE(shares.disc, 1);
    EXPECT_LE(shares.numerator, 1);
    // The bound holds for all pixels and spheres at once, but is not much too large.
    EXPECT_GT(shares.disc, 0x1p-6);
    EXPECT_GT(shares.compared, 200);
    EXPECT_LE(in_pairs.disc, 1);
    EXPECT_LE(in_pairs.numerator, 1);
    pairs_compared += in_pairs.compared;
    most_in_pairs = std::max(most_in_pairs, in_pairs.disc);
    by_moment += shares.by_moment;
    RecordProperty(std::string(source.name) + "-disc", std::to_string(shares.disc));
    RecordProperty(std::string(source.name) + "-numerator", std::to_string(shares.numerator));
  }
  EXPECT_GT(by_moment, 1000);
  EXPECT_GT(pairs_compared, 1000);
  EXPECT_GT(most_in_pairs, 0x1p-10);
  EXPECT_GT(in_pairs_mutated.disc, 1);
  RecordProperty("disc-in-pairs", std::to_string(most_in_pairs));
}

}  // namespace
}  // namespace raycheck::properties
