// Compares condition numbers with differences of enclosures at changed inputs, with closed forms of
// derivatives and with values computed by hand; those by intervals with those by balls; and those
// of stages with the derivatives of each step.

#include "reference/account/condition.h"

#include "tests/reference/big_float.h"
#include "tests/reference/lecture_formulas.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using namespace scene;

std::array<Big, 3> coordinates_of(const Big3& v) { return {v.x, v.y, v.z}; }

/// The allowed difference of two upper bounds, or of a bound and the exact value.
constexpr double kAgreement = 1.25 * kConditionWidth;

/// Checks a condition number against its exact value.
void expect_condition(double bound, const Big& exact, const std::string& what) {
  if (exact > Big(kLargest)) {
    EXPECT_EQ(bound, kInfinity) << what;
    return;
  }
  EXPECT_TRUE(Big(bound) >= exact * (1 - power_of_two(-50)))
      << what << ": " << bound << " below " << exact.convert_to<double>();
  EXPECT_TRUE(Big(bound) <= exact * (1 + kAgreement) + kNegligibleCondition)
      << what << ": " << bound << " above " << exact.convert_to<double>();
}

/// Checks two bounds of one condition number.
void expect_same_condition(double one, double other, const std::string& what) {
  if (one == other) return;
  EXPECT_LE(std::abs(one - other), kAgreement * other + kNegligibleCondition)
      << what << ": " << one << " and " << other;
}

/// A camera's ray and a sphere.
struct CameraCase {
  Camera camera;
  scene::Conventions conventions;
  scene::Pixel pixel;
  std::vector<Sphere> spheres;  ///< One sphere.

  ExactRay ray() const { return ExactRay(ExactCamera(camera, conventions), pixel); }
  std::string text() const { return spelled(camera) + spelled(spheres[0]); }
  std::vector<double*> inputs() { return inputs_of(camera, spheres); }
};

CameraCase random_case(Random& random, Sizes sizes) {
  CameraCase result;
  result.camera = random_camera(random, sizes);
  result.conventions = random_conventions(random);
  result.pixel = random_pixel(random, result.camera);
  result.spheres = {random_sphere(random, sizes)};
  return result;
}

using Value = std::function<std::vector<Enclosure>(const CameraCase&)>;

double norm_of(const std::vector<Enclosure>& v) {
  double squares = 0;
  for (const Enclosure& x : v) squares += x.upper() * x.upper();
  return std::sqrt(squares);
}

/// sum |dq/dx|_2 |x| / |q|_2 by central differences of doubles that are 2^-21 |x| apart, with
/// values enclosed at 400 bits. The error from higher derivatives is far below kDifferenceError.
double condition_by_differences(const CameraCase& at, const Value& value) {
  double sum = 0;
  CameraCase moved = at;
  for (double* const input : moved.inputs()) {
    const double x = *input;
    if (x == 0) continue;
    const double high = x * (1 + 0x1p-22), low = x * (1 - 0x1p-22);
    *input = high;
    std::vector<Enclosure> difference = value(moved);
    *input = low;
    const std::vector<Enclosure> other = value(moved);
    *input = x;
    for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= other[k];
    sum += norm_of(difference) * std::abs(x / (high - low));
  }
  return sum / norm_of(value(at));
}
constexpr double kDifferenceError = 0x1p-8;
/// Larger condition numbers are not compared, since differences would be too inaccurate.
constexpr double kMostComparedCondition = 0x1p12;

std::vector<Enclosure> listed(const Enclosure3& v) { return {v.x, v.y, v.z}; }
std::vector<Enclosure> listed(const Enclosure& x) { return {x}; }

constexpr int kDifferenceBits = 400;

void expect_close(double condition, const CameraCase& at, const Value& value, const char* what,
                  int& compared) {
  if (condition <= kNegligibleCondition || condition > kMostComparedCondition) return;
  const double differences = condition_by_differences(at, value);
  EXPECT_LE(std::abs(condition - differences), kDifferenceError * differences)
      << what << " of " << at.text();
  ++compared;
}

struct Compared {
  int values = 0, hits = 0;
};

void expect_differences(const CameraCase& at, Compared& counts) {
  const ExactRay ray = at.ray();
  const Sphere& sphere = at.spheres[0];
  const auto compare = [&](double condition, const char* what, auto value) {
    expect_close(
        condition, at,
        [&](const CameraCase& moved) {
          return listed(value(moved.ray().enclose(kDifferenceBits), moved.spheres[0]));
        },
        what, counts.values);
  };
  compare(condition_of_pixel_point(ray), "P",
          [](const auto& r, const auto&) { return r.pixel_point(); });
  compare(condition_of_direction(ray), "D",
          [](const auto& r, const auto&) { return r.direction(); });
  compare(condition_of_axial_distance(ray, sphere), "v",
          [](const auto& r, const auto& s) { return r.axial_distance(s); });
  compare(condition_of_half_chord_sq(ray, sphere), "d^2",
          [](const auto& r, const auto& s) { return r.half_chord_sq(s); });
  const Intersection met = ray.intersect(sphere);
  if (met.hit_class != HitClass::kHit) return;
  ++counts.hits;
  compare(condition_of_parameter(ray, sphere, met), "s",
          [&](const auto& r, const auto& s) { return r.parameter(s, met); });
  compare(condition_of_point(ray, sphere, met), "Q",
          [&](const auto& r, const auto& s) { return r.point(s, met); });
}

TEST(CameraCondition, AgreesWithSmallDifferences) {
  Random random(1);
  Compared of_cameras;
  for (int k = 0; k < 40; ++k) {
    const CameraCase at = random_case(random, Sizes::kOrdinary);
    expect_differences(at, of_cameras);
    double worst = 0;
    for (const auto axis : {&EnclosedFrame::U, &EnclosedFrame::V, &EnclosedFrame::W}) {
      worst = std::max(worst, condition_by_differences(at, [axis](const CameraCase& moved) {
                         const ExactCamera other(moved.camera, moved.conventions);
                         return listed(other.frame(kDifferenceBits).*axis);
                       }));
    }
    if (worst >= kMostComparedCondition) continue;
    const double frame = condition_of_frame(ExactCamera(at.camera, at.conventions));
    EXPECT_LE(std::abs(frame - worst), kDifferenceError * worst);
  }
  EXPECT_GE(of_cameras.hits, 5);
  EXPECT_GE(of_cameras.values, 150);
}

/// Every condition number of a ray and a sphere.
std::vector<double> all_conditions(const ExactRay& ray, const Sphere& sphere) {
  std::vector<double> result = {condition_of_direction(ray),
                                condition_of_axial_distance(ray, sphere),
                                condition_of_half_chord_sq(ray, sphere)};
  if (ray.source().camera) result.push_back(condition_of_pixel_point(ray));
  const Intersection at = ray.intersect(sphere);
  if (at.hit_class != HitClass::kMiss) {
    result.push_back(condition_of_parameter(ray, sphere, at));
    result.push_back(condition_of_point(ray, sphere, at));
  }
  const RayStageConditions of_ray = stage_conditions(ray);
  const SphereStageConditions of_sphere = stage_conditions(ray, sphere, at);
  result.push_back(of_ray.direction);
  result.push_back(of_sphere.axial_distance);
  result.push_back(of_sphere.half_chord_sq);
  for (const auto& one : {of_ray.pixel_point, of_sphere.root, of_sphere.point}) {
    if (one) result.push_back(*one);
  }
  return result;
}

/// Makes lengths so large that squares overflow. Intervals then decide nothing, and balls are used.
void enlarge(const std::vector<double*>& lengths) {
  for (double* const x : lengths) *x = std::ldexp(*x, 700);
}

/// The number of finite condition numbers that agreed.
int compare(const std::vector<double>& ordinary, const std::vector<double>& enlarged,
            const std::string& what) {
  EXPECT_EQ(ordinary.size(), enlarged.size()) << what;
  int finite = 0;
  for (std::size_t k = 0; k < enlarged.size(); ++k) {
    expect_same_condition(ordinary[k], enlarged[k], std::to_string(k) + " of " + what);
    if (std::isfinite(enlarged[k])) ++finite;
  }
  return finite;
}

TEST(ConditionArithmetics, AgreeForGivenRaysAndRaysOfCameras) {
  for (const Sizes sizes : {Sizes::kSmallIntegers, Sizes::kOrdinary}) {
    Random random(2);
    int given = 0, of_cameras = 0;
    for (int k = 0; k < 200; ++k) {
      scene::Ray ray = random_ray(random, sizes);
      Sphere sphere = random_sphere(random, sizes);
      const std::string of_given = spelled(ray) + spelled(sphere);
      const std::vector<double> ordinary = all_conditions(ExactRay(ray), sphere);
      auto& [origin, direction] = ray;
      enlarge({&origin.x, &origin.y, &origin.z, &direction.x, &direction.y, &direction.z,
               &sphere.centre.x, &sphere.centre.y, &sphere.centre.z, &sphere.radius});
      given += compare(ordinary, all_conditions(ExactRay(ray), sphere), of_given);
      if (k % 3 != 0) continue;
      const CameraCase at = random_case(random, sizes);
      CameraCase enlarged = at;
      enlarge(enlarged.inputs());
      const auto conditions = [](const CameraCase& one) {
        std::vector<double> all = all_conditions(one.ray(), one.spheres[0]);
        all.push_back(condition_of_frame(ExactCamera(one.camera, one.conventions)));
        return all;
      };
      of_cameras += compare(conditions(at), conditions(enlarged), at.text());
    }
    EXPECT_GE(given, 1000);
    EXPECT_GE(of_cameras, 300);
  }
}

TEST(CameraCondition, OfTheFrameGrowsAsUpNearsTheViewDirection) {
  // w = (1 - 1, 0, 10) and u = up x w = (10 angle, up_z w_x - up_x w_z, ...): changes of E_x and
  // A_x move w_x by 1 each, so that U turns by 1 / (10 angle) with each.
  for (const double angle : {0x1p-10, 0x1p-20, 0x1p-30}) {
    const Camera camera{{1, 0, 10}, {1, 0, 0}, {0, angle, 1}, -1, {}, -1, 1, -1, 1, 3, 3};
    expect_condition(condition_of_frame(ExactCamera(camera, {})), Big(2) / (10 * Big(angle)),
                     "the frame");
  }
}

TEST(Condition, IsInfiniteAtATangent) {
  const ExactRay ray(scene::Ray{{-5, 1, 0}, {1, 0, 0}});
  EXPECT_EQ(condition_of_parameter(ray, kUnit, kTangent), kInfinity);
  EXPECT_EQ(condition_of_point(ray, kUnit, kTangent), kInfinity);
  EXPECT_EQ(condition_of_half_chord_sq(ray, kUnit), kInfinity);
  EXPECT_LT(condition_of_axial_distance(ray, kUnit), 3);
}

TEST(Condition, IsInfiniteIfSmallChangesMoveAValueFromZero) {
  // v = T.D = 0, since its terms cancel.
  const ExactRay ray(scene::Ray{{0, 0, 0}, {1, 1, 0}});
  EXPECT_EQ(condition_of_axial_distance(ray, {{3, -3, 0}, 1}), kInfinity);
  // Q = 0, the world's origin.
  const ExactRay to_origin(scene::Ray{{-1, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(condition_of_point(to_origin, {{2, 0, 0}, 2}, kSmallerHit), kInfinity);
  // s = 2^-1075 from numbers near 1 is out of the range of doubles.
  const ExactRay close(scene::Ray{{-1, 0x1p-537, 0}, {1, 0, 0}});
  EXPECT_EQ(condition_of_parameter(close, {{0, 0, 0}, 1}, kSmallerHit), kInfinity);
}

TEST(Condition, IsZeroIfNoSmallChangeMovesAZero) {
  // For T = (0, 3, 0) and D = (1, 0, 0), relative changes leave v = 0.
  const ExactRay ray(scene::Ray{{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(condition_of_axial_distance(ray, {{0, 3, 0}, 1}), 0);
  // A point on the axis stays there.
  EXPECT_EQ(condition_of_half_chord_sq(ray, {{5, 0, 0}, 0}), 0);
  // The direction (1, 0, 0) keeps its sign and its axis.
  EXPECT_LE(condition_of_direction(ray), kNegligibleCondition);
}

Big3 axis(std::size_t k) { return {Big(k == 0 ? 1 : 0), Big(k == 1 ? 1 : 0), Big(k == 2 ? 1 : 0)}; }

/// sum / size, the condition number; infinite if a condition number is.
Big over(const Big& sum, const Big& size) {
  if (size != 0) return sum / size;
  return sum == 0 ? Big(0) : Big(kInfinity);
}

/// The values of a ray and a sphere, and their derivatives by hand.
struct ByHand {
  ByHand(const Ray& ray, const Sphere& sphere, const Intersection& at)
      : L(big(ray.origin)), d(big(ray.direction)), C(big(sphere.centre)), r(sphere.radius) {
    const Big3 t = C - L;
    const Big length = norm(d);
    const Big3 D = d / length;
    v = dot(t, D);
    const Big3 moment = cross(t, D);
    half_chord_sq = r * r - dot(moment, moment);
    const Big half_chord = half_chord_sq > 0 ? Big(sqrt(half_chord_sq)) : Big(0);
    s = (at.root == WhichRoot::kSmaller ? Big(v - half_chord) : Big(v + half_chord)) / length;
    // s is exactly 0 if the ray starts on the sphere.
    if (dot(t, t) == r * r && (at.root == WhichRoot::kSmaller) == (dot(t, d) > 0)) s = 0;
    q = L + s * d - C;
    for (std::size_t k = 0; k < 3; ++k) {
      const Big size_of_ends = abs(coordinates_of(L)[k]) + abs(coordinates_of(C)[k]);
      const Big size_of_d = abs(coordinates_of(d)[k]);
      const Big T_k = coordinates_of(t)[k];
      const Big D_k = coordinates_of(D)[k];
      const Big by_d = abs(T_k - v * D_k) / length;
      axial_sum += abs(D_k) * size_of_ends + by_d * size_of_d;
      half_sum += 2 * (abs(T_k - v * D_k) * size_of_ends + abs(v) * by_d * size_of_d);
    }
    half_sum += 2 * r * r;
  }

  /// From p(s) = |L + s d - C|^2 - r^2 = 0: ds/dx = -(dp/dx) / (dp/ds).
  Big parameter_condition() const {
    Big sum = 2 * r * r;
    for (std::size_t k = 0; k < 3; ++k) {
      const Big size =
          abs(coordinates_of(L)[k]) + abs(coordinates_of(C)[k]) + abs(s * coordinates_of(d)[k]);
      sum += 2 * abs(coordinates_of(q)[k]) * size;
    }
    return over(sum / abs(2 * dot(q, d)), abs(s));
  }

  /// dQ/dx = dL/dx + s dd/dx + d ds/dx.
  Big point_condition() const {
    const Big slope = 2 * dot(q, d);
    Big sum = norm((2 * r * r / slope) * d);
    for (std::size_t k = 0; k < 3; ++k) {
      const Big by_start = -2 * coordinates_of(q)[k] / slope;
      sum += norm(axis(k) + by_start * d) * abs(coordinates_of(L)[k]);
      sum += norm(by_start * d) * abs(coordinates_of(C)[k]);
      sum += norm(s * axis(k) + (s * by_start) * d) * abs(coordinates_of(d)[k]);
    }
    return over(sum, norm(q + C));
  }

  Big3 L, d, C;
  Big r, v, half_chord_sq, s;
  Big3 q;
  Big axial_sum, half_sum;
};

int compare_with_closed_forms(Sizes sizes, std::uint64_t seed, int cases) {
  Random random(seed);
  int compared = 0;
  for (int k = 0; k < cases; ++k) {
    const Ray ray = random_ray(random, sizes);
    const Sphere sphere = random_sphere(random, sizes);
    const ExactRay exact(ray);
    const Intersection at = exact.intersect(sphere);
    if (at.hit_class == HitClass::kTangent) continue;
    const ByHand by_hand(ray, sphere, at);
    const std::string what = spelled(ray) + spelled(sphere);
    // v or d^2 is not compared if it is 0 except for the rounding of the closed form.
    if (abs(by_hand.v) > by_hand.axial_sum * power_of_two(-5000)) {
      expect_condition(condition_of_axial_distance(exact, sphere),
                       by_hand.axial_sum / abs(by_hand.v), "v of " + what);
    }
    if (abs(by_hand.half_chord_sq) > by_hand.half_sum * power_of_two(-5000)) {
      expect_condition(condition_of_half_chord_sq(exact, sphere),
                       by_hand.half_sum / abs(by_hand.half_chord_sq), "d^2 of " + what);
    }
    if (at.hit_class != HitClass::kHit) continue;
    expect_condition(condition_of_parameter(exact, sphere, at), by_hand.parameter_condition(),
                     "s of " + what);
    expect_condition(condition_of_point(exact, sphere, at), by_hand.point_condition(),
                     "Q of " + what);
    ++compared;
  }
  return compared;
}

TEST(Condition, AgreesWithTheClosedForms) {
  EXPECT_GE(compare_with_closed_forms(Sizes::kOrdinary, 1, 2000), 200);
  EXPECT_GE(compare_with_closed_forms(Sizes::kSmallIntegers, 2, 2000), 200);
  EXPECT_GE(compare_with_closed_forms(Sizes::kAll, 3, 1000), 100);
}

TEST(Condition, GrowsLikeOneOverTheRootOfTheDistanceToATangent) {
  // With y = 1 - e and q = sqrt(1 - y^2): (1/q + y^2/q + 5 + s)/s, s = 5 - q.
  for (const double e : {0x1p-10, 0x1p-20, 0x1p-30, 0x1p-40, 0x1p-53}) {
    const double y = 1 - e;
    const Big q = sqrt(1 - Big(y) * y);
    const ExactRay ray(Ray{{-5, y, 0}, {1, 0, 0}});
    expect_condition(condition_of_parameter(ray, kUnit, kSmallerHit),
                     (1 / q + Big(y) * y / q + 10 - q) / (5 - q), "s near a tangent");
  }
}

TEST(Condition, OfTheParameterIsInfiniteOnTheSurface) {
  const ExactRay ray(Ray{{-1, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(condition_of_parameter(ray, kUnit, kSmallerHit), kInfinity);
  expect_condition(condition_of_parameter(ray, kUnit, kLargerHit), Big(2), "s");
}

Big sum_of_sizes(const Big3& v) { return abs(v.x) + abs(v.y) + abs(v.z); }

void expect_ray_stages(const RayStageConditions& got, const LectureRay& ray, const Big3& E,
                       const Big& n, const std::string& what) {
  const Big point = sum_of_sizes(E) + abs(n) * (1 + sum_of_sizes(ray.W)) +
                    abs(ray.alpha) * (1 + sum_of_sizes(ray.U)) +
                    abs(ray.beta) * (1 + sum_of_sizes(ray.V));
  ASSERT_TRUE(got.pixel_point.has_value());
  if (norm(ray.P) != 0) expect_condition(*got.pixel_point, point / norm(ray.P), "P of " + what);
  // dD/dP_k = (e_k - D_k D)/l, of size sqrt(1 - D_k^2)/l.
  Big direction = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Big D_k = coordinates_of(ray.D)[k];
    const Big rest = 1 - D_k * D_k;
    if (rest <= 0) continue;
    direction +=
        sqrt(rest) / ray.length * (abs(coordinates_of(ray.P)[k]) + abs(coordinates_of(E)[k]));
  }
  expect_condition(got.direction, direction, "D of " + what);
}

void expect_sphere_stages(const SphereStageConditions& got, const Big3& L, const Big3& D,
                          const Sphere& sphere, const Intersection& at, const std::string& what) {
  const LectureHit hit = lecture_hit(L, D, sphere);
  const Big3 T = big(sphere.centre) - L;
  Big axial = 0;
  Big half = 2 * Big(sphere.radius) * sphere.radius;
  for (std::size_t k = 0; k < 3; ++k) {
    const Big T_k = coordinates_of(T)[k];
    const Big D_k = coordinates_of(D)[k];
    const Big across = abs(T_k - hit.v * D_k);
    axial += abs(D_k * T_k) + across * abs(D_k);
    half += 2 * across * (abs(T_k) + abs(hit.v * D_k));
  }
  if (hit.v != 0) expect_condition(got.axial_distance, axial / abs(hit.v), "v of " + what);
  if (hit.d_sq != 0) expect_condition(got.half_chord_sq, half / abs(hit.d_sq), "d^2 of " + what);
  ASSERT_EQ(got.root.has_value(), at.hit_class != HitClass::kMiss);
  ASSERT_EQ(got.point.has_value(), at.hit_class != HitClass::kMiss);
  if (at.hit_class != HitClass::kHit) return;
  const Big s = at.root == WhichRoot::kSmaller ? hit.smaller() : hit.larger();
  const Big root_sum = abs(hit.v) + sqrt(hit.d_sq) / 2;
  // If the ray starts on the sphere, the literal formula is 0 except for rounding.
  if (abs(s) > root_sum * power_of_two(-3000)) {
    expect_condition(*got.root, root_sum / abs(s), "s of " + what);
  } else {
    EXPECT_EQ(*got.root, kInfinity) << what;
  }
  const Big point = sum_of_sizes(L) + abs(s) + abs(s) * sum_of_sizes(D);
  expect_condition(*got.point, point / norm(L + s * D), "Q of " + what);
}

TEST(StageCondition, AgreesWithDerivativesByHand) {
  Random random(1);
  int hits = 0;
  for (const Sizes sizes : {Sizes::kSmallIntegers, Sizes::kOrdinary}) {
    for (int k = 0; k < 150; ++k) {
      scene::Camera camera = random_camera(random, sizes);
      const scene::Conventions conventions = random_conventions(random);
      const scene::Pixel pixel = random_pixel(random, camera);
      const Sphere sphere = random_sphere(random, sizes);
      const ExactRay exact(ExactCamera(camera, conventions), pixel);
      const LectureRay ray = lecture_ray(camera, conventions, pixel);
      const std::string what = spelled(camera) + spelled(sphere);
      // P is not compared if it is 0 except for rounding.
      if (norm(ray.P) < power_of_two(-3000)) continue;
      expect_ray_stages(stage_conditions(exact), ray, big(camera.eye), Big(camera.near), what);
      const Big3 L = conventions.origin == scene::Origin::kPixel ? ray.P : big(camera.eye);
      const Intersection at = exact.intersect(sphere);
      expect_sphere_stages(stage_conditions(exact, sphere, at), L, ray.D, sphere, at, what);
      if (at.hit_class == HitClass::kHit) ++hits;
      const scene::Ray given = random_ray(random, sizes);
      const ExactRay of_given(given);
      EXPECT_FALSE(stage_conditions(of_given).pixel_point.has_value());
      const Intersection there = of_given.intersect(sphere);
      const Big3 d = big(given.direction);
      expect_sphere_stages(stage_conditions(of_given, sphere, there), big(given.origin),
                           d / norm(d), sphere, there, spelled(given) + spelled(sphere));
      if (there.hit_class == HitClass::kHit) ++hits;
    }
  }
  EXPECT_GE(hits, 40);
}

TEST(StageCondition, OfTheRootOfATangentIsThatOfV) {
  const ExactRay ray(scene::Ray{{-5, 1, 0}, {1, 0, 0}});
  const SphereStageConditions got = stage_conditions(ray, kUnit, kTangent);
  expect_condition(got.root.value(), Big(1), "s");
  EXPECT_EQ(got.half_chord_sq, kInfinity);
  // (|L| + s + s |D|)/|Q|, Q = (0, 1, 0).
  expect_condition(got.point.value(), Big(6 + 5 + 5), "Q");
}

/// s = 9: (|T| + d + (2 |T||v| + |T|^2 + r^2)/2d)/|s| = (10 + 1 + (200 + 100 + 1)/2)/9.
TEST(TextbookCondition, AgreesWithTheFormulaByHand) {
  const ExactRay ray(scene::Ray{{-10, 0, 0}, {2, 0, 0}});
  expect_condition(textbook_condition(ray, kUnit, {HitClass::kHit, WhichRoot::kSmaller}),
                   Big(11 + 150.5) / 9, "s");
  expect_condition(textbook_condition(ray, kUnit, {HitClass::kHit, WhichRoot::kLarger}),
                   Big(11 + 150.5) / 11, "s");
  expect_condition(distance_in_radii(ray, kUnit), Big(10), "radii");
  expect_condition(half_chord_share(ray, kUnit), Big(1), "d^2");
  const ExactRay touching(scene::Ray{{-5, 1, 0}, {1, 0, 0}});
  EXPECT_EQ(textbook_condition(touching, kUnit, kTangent), kInfinity);
}

}  // namespace
}  // namespace raycheck::reference
