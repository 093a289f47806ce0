// The roots that count, decided exactly: t_min and t_max in s, radii or lengths, their ends,
// culling.

#include "reference/account/internal/vector_length.h"
#include "reference/account/nearby_valid.h"
#include "reference/exact_ray.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::reference {
namespace {

using namespace scene;

constexpr double kNoEnd = kInfinity, kNearby = 16 * 0x1p-53;

scene::Conventions conventions_of(const scene::ValidRoots& valid, Root root = Root::kNearest) {
  scene::Conventions conventions;
  conventions.root = root;
  conventions.valid = valid;
  return conventions;
}

/// "near", "far", "tangent" or "miss".
std::string met(const ExactRay& ray, const scene::Sphere& sphere, const scene::ValidRoots& valid,
                Root root = Root::kNearest) {
  const Intersection at = ray.intersect(sphere, conventions_of(valid, root));
  EXPECT_TRUE(at == ray.intersect(sphere, conventions_of(valid, root), {Engine::kFieldOnly}));
  if (at.hit_class == HitClass::kMiss) return "miss";
  if (at.hit_class == HitClass::kTangent) return "tangent";
  return at.root == WhichRoot::kSmaller ? "near" : "far";
}

const ExactRay kRayAlongX(scene::Ray{{0, 0, 0}, {1, 0, 0}});
const scene::Sphere kFromTwoToFour{{3, 0, 0}, 1};
const scene::Sphere kRadius3{{}, 3};

TEST(ValidRoots, OfCamerasAreComparedWithLengths) {
  // D is unit, g = (1, 1, -1): s counts lengths; |g| = sqrt(3) is not a double.
  const scene::Camera camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, -1, {}, -1, 1, -1, 1, 2, 2};
  scene::Conventions focal;
  focal.origin = scene::Origin::kFocal;
  const ExactCamera exact(camera, focal);
  const ExactRay ray(exact, {1, 1});
  const scene::Sphere point{{2, 2, -2}, 0};  // at 2 sqrt(3)
  const Intersection at = ray.intersect(point);
  ASSERT_EQ(at.hit_class, HitClass::kTangent);
  const double s = ray.rounded_parameter(point, at);
  EXPECT_EQ(ray.compare_parameter(point, at, nudged(s, -1), TUnit::kAbsolute), 1);
  EXPECT_EQ(ray.compare_parameter(point, at, nudged(s, 1), TUnit::kAbsolute), -1);
  EXPECT_NE(ray.compare_parameter(point, at, s, TUnit::kAbsolute), 0);
  const scene::Sphere around{{0, 0, 0}, 3};  // its far root, computed by square roots, is 3
  EXPECT_EQ(ray.compare_parameter(around, ray.intersect(around), 3, TUnit::kAbsolute), 0);
  EXPECT_EQ(ray.compare_parameter(around, ray.intersect(around), 1, TUnit::kRadius), 0);
  EXPECT_EQ(met(ray, around, {0, 1, Ends::kOpenMax, TUnit::kRadius, {}}), "miss");
  EXPECT_EQ(met(ray, around, {0, 1, Ends::kClosed, TUnit::kRadius, {}}), "far");
}

TEST(ValidRoots, AgreeInEveryStageNearTheEnds) {
  Random random(6);
  int hits = 0;
  for (int k = 0; k < 3000; ++k) {
    const ExactRay ray(random_ray(random, Sizes::kOrdinary));
    const scene::Sphere sphere = random_sphere(random, Sizes::kOrdinary);
    const Intersection usual = ray.intersect(sphere);
    if (usual.hit_class == HitClass::kMiss) continue;
    const double s = ray.rounded_parameter(sphere, usual);
    if (!std::isfinite(s) || s <= 0) continue;
    const double t = nudged(s, random.integer(-1, 1));
    FilterStage highest{};
    const int side =
        ray.compare_parameter(sphere, usual, t, TUnit::kAbsolute, {.highest = &highest});
    EXPECT_EQ(side,
              ray.compare_parameter(sphere, usual, t, TUnit::kAbsolute, {Engine::kFieldOnly}));
    ++hits;
  }
  EXPECT_GE(hits, 200);
}

TEST(ValidRoots, MayBeSceneLengthsAlongTheRay) {
  // Roots at 1, 1.5 and 2 scene lengths; s is 2^-10 times the length.
  const ExactRay ray(scene::Ray{{0, 0, 0}, {1024, 0, 0}});
  const scene::Sphere sphere{{1.5, 0, 0}, 0.5};
  const auto from = [](double t, Ends ends) {
    return scene::ValidRoots{t, kNoEnd, ends, TUnit::kLength, {}};
  };
  EXPECT_EQ(met(ray, sphere, from(1, Ends::kClosed)), "near");
  EXPECT_EQ(met(ray, sphere, from(1, Ends::kOpen)), "far");
  EXPECT_EQ(met(ray, sphere, from(nudged(2, 1), Ends::kClosed)), "miss");
  // |direction| = sqrt(3) is not a double. The sphere begins at the length 10 sqrt(3).
  const ExactRay slanted(scene::Ray{{0, 0, 0}, {1, 1, 1}});
  const scene::Sphere point{{10, 10, 10}, 0};
  const double s = 10 * std::sqrt(3.0);
  EXPECT_EQ(met(slanted, point, from(nudged(s, -1), Ends::kOpen)), "tangent");
  EXPECT_EQ(met(slanted, point, from(nudged(s, 1), Ends::kOpen)), "miss");
  EXPECT_TRUE(is_outside(from(1e-3, Ends::kOpen), ray, sphere, 0x1p-20));
  EXPECT_FALSE(is_outside(from(1e-3, Ends::kOpen), ray, sphere, 0x1p-10));
  EXPECT_TRUE(is_outside(from(1, Ends::kOpen), ray, sphere, 0x1p-10));
  EXPECT_FALSE(is_outside(from(1, Ends::kClosed), ray, sphere, 0x1p-10));
}

TEST(ValidRoots, OfLinesLieBehindTheOriginToo) {
  const scene::ValidRoots line{-kInfinity, kNoEnd, Ends::kClosed, {}, {}};
  EXPECT_EQ(met(kRayAlongX, {{-3, 0, 0}, 1}, line), "near");
  EXPECT_EQ(met(kRayAlongX, {{0, 0, 0}, 1}, line), "near");
  EXPECT_EQ(met(kRayAlongX, {{-3, 1, 0}, 1}, line), "tangent");
  EXPECT_EQ(met(kRayAlongX, {{-3, 2, 0}, 1}, line), "miss");
  EXPECT_FALSE(is_outside(line, kRayAlongX, kFromTwoToFour, -1e300));
}

Nearby nearby(const std::optional<double>& answer, const scene::ValidRoots& valid) {
  return right_nearby(kRayAlongX, kFromTwoToFour, {.relative_change = kNearby, .valid = valid},
                      answer)
      .found;
}

TEST(RefutedNearby, IsAnAnswerThatNoInputsCloseByMakeRight) {
  const scene::ValidRoots from_one{1, kNoEnd, {}, {}, {}};
  EXPECT_EQ(nearby({}, from_one), Nearby::kRefuted);                  // a miss, where 2 counts
  EXPECT_EQ(nearby(4, from_one), Nearby::kRefuted);                   // the far root
  EXPECT_EQ(nearby(2, {5, kNoEnd, {}, {}, {}}), Nearby::kRefuted);    // nothing counts
  EXPECT_EQ(nearby(2, {2.5, kNoEnd, {}, {}, {}}), Nearby::kRefuted);  // the culled near one
}

/// Tangents far from any end are excused as if every root >= 0 counted.
TEST(RefutedNearby, LeavesTangentsFarFromAnyEndToTheSearchForWitnesses) {
  const scene::Sphere touched{{3, 1, 0}, 1};
  const auto missed = [&](const scene::ValidRoots& valid) {
    return right_nearby(kRayAlongX, touched, {.relative_change = kNearby, .valid = valid}, {})
        .found;
  };
  for (const TUnit unit : {TUnit::kAbsolute, TUnit::kRadius, TUnit::kLength}) {
    EXPECT_EQ(missed({1e-3, kNoEnd, Ends::kOpen, unit, {}}), Nearby::kWitness);
    EXPECT_EQ(missed({0, 3, Ends::kOpen, unit, {}}), Nearby::kUndecided);  // it is the end
  }
  EXPECT_EQ(missed({1e-3, kNoEnd, Ends::kOpen, {}, Culling::kBackFaces}), Nearby::kWitness);
  EXPECT_EQ(missed({1e-3, kNoEnd, Ends::kOpen, {}, Culling::kFrontFaces}), Nearby::kUndecided);
}

/// For lines, tangents behind the origin are treated like tangents ahead, and a clear miss is not
/// excused.
TEST(RefutedNearby, ReversesLinesBehindTheirOrigin) {
  const auto missed = [](const scene::Sphere& sphere, const scene::ValidRoots& valid) {
    return right_nearby(kRayAlongX, sphere, {.relative_change = kNearby, .valid = valid}, {}).found;
  };
  const scene::ValidRoots line{-kInfinity, kNoEnd, {}, {}, {}};
  EXPECT_EQ(missed({{-3, 1, 0}, 1}, line), Nearby::kWitness);
  EXPECT_EQ(missed({{-3, 0.5, 0}, 1}, line), Nearby::kRefuted);
  EXPECT_EQ(missed({{-3, 1, 0}, 1}, {-kInfinity, -3, {}, {}, {}}), Nearby::kUndecided);
}

TEST(RefutedNearby, LeavesRootsAtAnEndUndecided) {
  for (const double t : {nudged(2, -2), 2.0, nudged(2, 2)}) {
    EXPECT_EQ(nearby({}, {t, kNoEnd, {}, {}, {}}), Nearby::kUndecided) << t;
    EXPECT_EQ(nearby(nudged(2, 2), {t, kNoEnd, {}, {}, {}}), Nearby::kUndecided) << t;
    EXPECT_EQ(nearby({}, {0, t, {}, {}, {}}), Nearby::kUndecided) << t;
  }
  EXPECT_EQ(nearby(2, {2 + 0x1p-40, kNoEnd, {}, {}, {}}), Nearby::kRefuted);
}

TEST(RefutedNearby, IsAnAnswerOutsideTheIntervalEvenCloseToItsEnd) {
  for (const double t : {2.0, nudged(2, 1)}) {
    EXPECT_EQ(nearby(2, {t, kNoEnd, Ends::kOpen, {}, {}}), Nearby::kRefuted) << t;
    EXPECT_EQ(nearby(nudged(2, 2), {t, kNoEnd, Ends::kOpen, {}, {}}), Nearby::kUndecided) << t;
  }
  EXPECT_EQ(nearby(2, {2, kNoEnd, Ends::kClosed, {}, {}}), Nearby::kUndecided);
  EXPECT_EQ(nearby(2, {0, 2, Ends::kOpenMax, {}, {}}), Nearby::kRefuted);
  EXPECT_EQ(nearby(2, {0, 2, Ends::kOpenMin, {}, {}}), Nearby::kUndecided);
}

/// The product of t and the radius is exact: 0.1 * 3 is not a double.
TEST(RefutedNearby, ComparesRadiiByTheirExactProduct) {
  const double rounded = 0.1 * 3;  // above the product
  ASSERT_GT(std::fma(-0.1, 3, rounded), 0);
  for (const Ends ends : {Ends::kClosed, Ends::kOpen}) {
    const scene::ValidRoots from{0.1, kNoEnd, ends, TUnit::kRadius, {}};
    const scene::ValidRoots to{0, 0.1, ends, TUnit::kRadius, {}};
    EXPECT_FALSE(is_outside(from, kRayAlongX, kRadius3, rounded));
    EXPECT_TRUE(is_outside(from, kRayAlongX, kRadius3, nudged(rounded, -1)));
    EXPECT_TRUE(is_outside(to, kRayAlongX, kRadius3, rounded));
    EXPECT_FALSE(is_outside(to, kRayAlongX, kRadius3, nudged(rounded, -1)));
    // If the product is a double, the end decides.
    const scene::ValidRoots half{0.5, kNoEnd, ends, TUnit::kRadius, {}};
    EXPECT_EQ(is_outside(half, kRayAlongX, kRadius3, 1.5), ends == Ends::kOpen);
  }
  const scene::ValidRoots wide{0, 0x1p1000, Ends::kClosed, TUnit::kRadius, {}};
  EXPECT_FALSE(is_outside(wide, kRayAlongX, {{}, 0x1p1000}, 0x1p1023));
  EXPECT_TRUE(
      is_outside({0x1p-1000, 1, Ends::kClosed, TUnit::kRadius, {}}, kRayAlongX, {{}, 0x1p-60}, 0));
}

/// If no end matters, witnesses are searched for, as for one sphere.
TEST(RefutedNearby, LeavesTheFirstHitToTheSearchForWitnesses) {
  const std::vector<scene::Sphere> touched = {{{3, 1, 0}, 1}, {{-9, 0, 0}, 1}};
  const auto claim = [&](FirstMet::What what, double t_min) {
    const Neighbourhood around{.relative_change = kNearby,
                               .valid = {t_min, kNoEnd, Ends::kOpen, {}, {}}};
    return right_nearby(kRayAlongX, touched, around, FirstMet{what}).found;
  };
  EXPECT_EQ(claim(FirstMet::What::kNothing, 1e-3), Nearby::kWitness);
  EXPECT_EQ(claim(FirstMet::What::kSomething, 1e-3), Nearby::kWitness);
  EXPECT_EQ(claim(FirstMet::What::kNothing, 3), Nearby::kUndecided);
}

TEST(RefutedNearby, DecidesWhichSphereIsMetFirst) {
  const std::vector<scene::Sphere> spheres = {kFromTwoToFour, {{13, 0, 0}, 1}};
  const auto claim = [&](FirstMet::What what, std::size_t sphere, double t_min) {
    const Neighbourhood around{.relative_change = kNearby, .valid = {t_min, kNoEnd, {}, {}, {}}};
    return right_nearby(kRayAlongX, spheres, around, FirstMet{what, sphere}).found;
  };
  EXPECT_EQ(claim(FirstMet::What::kSphere, 1, 1), Nearby::kRefuted);
  EXPECT_EQ(claim(FirstMet::What::kSphere, 0, 5), Nearby::kRefuted);
  EXPECT_EQ(claim(FirstMet::What::kNothing, 0, 5), Nearby::kRefuted);
  EXPECT_EQ(claim(FirstMet::What::kSomething, 0, 20), Nearby::kRefuted);
  EXPECT_EQ(claim(FirstMet::What::kSphere, 1, 4), Nearby::kUndecided);
}

/// A hit at height 1 - k u is nearly a miss if (1 - k u)(1 + 16 u) > 1 - 16 u, that is, if k < 32.
/// A miss at height 1 + k u, k even, is nearly a hit if (1 + k u)(1 - 16 u) <= 1 + 16 u.
TEST(NearbyAnswer, DecidesNearMissesToTheLastBit) {
  const auto found = [](double height, const std::optional<double>& answer) {
    const ExactRay ray(scene::Ray{{-5, height, 0}, {1, 0, 0}});
    return right_nearby(ray, kUnit, {.relative_change = kNearby}, answer).found;
  };
  for (int k = 1; k <= 80; ++k) {
    if (k == 32) continue;  // only 256 u^2 decides
    const Nearby expected = k < 32 ? Nearby::kWitness : Nearby::kRefuted;
    EXPECT_EQ(found(1 - k * 0x1p-53, std::nullopt), expected) << k;
    if (k % 2 == 0) {
      EXPECT_EQ(found(1 + k * 0x1p-53, 5.0), expected) << k;
    }
  }
  for (const double s : {-1.0, kInfinity, -kInfinity, kNaN}) {
    EXPECT_EQ(found(1, s), Nearby::kRefuted) << "no parameter";
  }
}

constexpr std::size_t kInputs = 7;

Variation random_variation(Random& random, double value, double reach) {
  Variation result{Enclosure(value, kVariationBits), {}};
  for (std::size_t k = 0; k < kInputs; ++k) {
    result.reach.emplace_back(random.between(-reach, reach), kVariationBits);
  }
  result.most = sum_of_sizes(result.reach);
  return result;
}

double at(const Variation& variation, const std::vector<double>& t) {
  double value = variation.value.lower();
  for (std::size_t k = 0; k < t.size(); ++k) value += t[k] * variation.reach[k].lower();
  return value;
}

/// These lengths refute answers that are far from right.
TEST(VectorLength, IsShortestWhereNoOtherPointOfTheBoxIsShorter) {
  Random random(5);
  int certainly_longer = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    const double reach = random.between(0, 0.3);
    const auto any = [&](double low, double most) {
      return random_variation(random, random.between(low, low + 2), most);
    };
    const VectorAndLength both{{any(-1, reach), any(-1, reach), any(-1, 0.2)}, any(0, 0.01)};
    const auto length_at = [&](const std::vector<double>& t) {
      return std::hypot(at(both.vector[0], t), at(both.vector[1], t), at(both.vector[2], t));
    };
    const Shortest least = shortest(both);
    const Variation room = less_share_along(both, least.direction);
    const bool is_longer = (room.value + room.most).certain_sign() == -1;
    certainly_longer += is_longer ? 1 : 0;
    for (int place = 0; place < 50; ++place) {
      std::vector<double> t;
      for (std::size_t k = 0; k < kInputs; ++k) t.push_back(random.between(-1, 1));
      ASSERT_GE(length_at(t), length_at(least.t) - 1e-3);
      ASSERT_TRUE(!is_longer || length_at(t) > at(both.length, t));
    }
  }
  EXPECT_GE(certainly_longer, 300);
}

}  // namespace
}  // namespace raycheck::reference
