// Compares the hit classes that a method can answer on a box with its answers in the box.

#include "fast/intersect.h"
#include "properties/cases/random.h"
#include "tests/method_names.h"
#include "tests/testing.h"

namespace raycheck::fast {
namespace {

using properties::Random;
using namespace scene;

struct Question {
  Ray ray;
  Sphere sphere;

  std::vector<double*> numbers() {
    auto& [o, d] = ray;
    auto& [c, r] = sphere;
    return {&o.x, &o.y, &o.z, &d.x, &d.y, &d.z, &c.x, &c.y, &c.z, &r};
  }
};

/// A ray that passes a far sphere at about its radius, so that the roundings of differences of
/// squares decide, or starts near the surface of a close sphere.
Question grazing(Random& random) {
  Question made;
  const scene::Vector3 d = random.direction(), off = random.in_cube(1);
  const double far = random.sign() * random.power_of_ten(0, 8);
  made.ray = {{off.x, off.y, off.z}, d};
  const double along = off.x * d.x + off.y * d.y + off.z * d.z;
  const scene::Vector3 across = {off.x - along * d.x, off.y - along * d.y, off.z - along * d.z};
  made.sphere.centre = {far * d.x, far * d.y, far * d.z};
  made.sphere.radius = std::hypot(across.x, across.y, across.z) * random.between(0.9, 1.1);
  if (random.one_in(3)) {  // It starts near the surface.
    made.sphere.centre = {random.sign() * d.x, d.y, 2 * d.z};
    const auto& C = made.sphere.centre;
    made.sphere.radius = std::hypot(C.x - off.x, C.y - off.y, C.z - off.z);
  }
  return made;
}

/// Both ends of a box about a question, in which one number varies or all do.
std::pair<Question, Question> box_about(Question at, Random& random) {
  std::pair<Question, Question> ends = {at, at};
  const auto low = ends.first.numbers(), high = ends.second.numbers();
  const std::int64_t only = random.integer(-10, 9);
  for (std::size_t k = 0; k < low.size(); ++k) {
    if (only >= 0 && k != static_cast<std::size_t>(only)) continue;
    const double half = std::abs(*low[k]) * random.power_of_ten(-17, 0);
    *low[k] -= half;
    *high[k] += half;
  }
  return ends;
}

struct Seen {
  int decided_hits = 0, decided_misses = 0, open = 0, contradicted = 0;
};

/// The number of boxes with only one class by `claims`, and of those in which `answers` has another
/// class.
Seen seen(const IntersectMethod& claims, const IntersectMethod& answers, int boxes) {
  Random random(7);
  Seen all;
  for (int k = 0; k < boxes; ++k) {
    auto [low, high] = box_about(grazing(random), random);
    const scene::HitRule rule = {random.one_in(2) ? scene::Root::kNearest : scene::Root::kSmaller,
                                 random.one_in(2) ? scene::Tangent::kHit : scene::Tangent::kMiss};
    const auto [hit, miss] =
        claims.classes_in({low.ray, high.ray}, {low.sphere, high.sphere}, rule);
    EXPECT_TRUE(hit || miss);
    (hit && miss ? all.open : hit ? all.decided_hits : all.decided_misses) += 1;
    bool contradicted = false;
    for (int sample = 0; sample < 60; ++sample) {
      Question one = low;
      const auto numbers = one.numbers(), least = low.numbers(), greatest = high.numbers();
      for (std::size_t n = 0; n < numbers.size(); ++n) {
        const double any = random.between(*least[n], *greatest[n]);
        *numbers[n] = sample % 3 == 0    ? std::clamp(any, *least[n], *greatest[n])
                      : random.one_in(2) ? *least[n]
                                         : *greatest[n];
      }
      const bool is_hit = answers.intersect_one(one.ray, one.sphere, rule).has_value();
      contradicted |= is_hit ? !hit : !miss;
    }
    all.contradicted += contradicted ? 1 : 0;
  }
  return all;
}

class EachFormula : public testing::TestWithParam<const IntersectMethod*> {};

TEST_P(EachFormula, StaysWithinItsPossibleClasses) {
  const Seen of_own = seen(*GetParam(), *GetParam(), 2000);
  EXPECT_EQ(of_own.contradicted, 0);
  EXPECT_GT(of_own.decided_hits, 80);
  EXPECT_GT(of_own.decided_misses, 80);
  EXPECT_GT(of_own.open, 80);
}

/// The classes of one formula do not cover the rounding errors of another.
TEST_P(EachFormula, HasOtherClassesThanAnotherFormula) {
  const bool in_floats = GetParam()->unit_roundoff > 0x1p-50;
  EXPECT_GT(seen(*GetParam(), in_floats ? kRobust : kSingleLecture, 2000).contradicted, 8);
}

TEST_P(EachFormula, HasOneClassForASingleRay) {
  Random random(3);
  int hits = 0, misses = 0;
  for (int k = 0; k < 5000; ++k) {
    const auto [ray, sphere] = grazing(random);
    const bool answer = GetParam()->intersect_one(ray, sphere, {}).has_value();
    const auto [hit, miss] = GetParam()->classes_in({ray, ray}, {sphere, sphere}, {});
    EXPECT_EQ(hit, answer);
    EXPECT_EQ(miss, !answer);
    (answer ? hits : misses) += 1;
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 500);
}

TEST_P(EachFormula, HasEveryClassOnOverflow) {
  const Ray ray = {{0, 0, 0}, {0, 0, 1}};
  const auto [hit, miss] = GetParam()->classes_in({ray, {{0, 0, 0}, {0, 0, 1e200}}},
                                                  {{{0, 0, 5}, 1}, {{0, 0, 1e200}, 1e200}}, {});
  EXPECT_TRUE(hit && miss);
}

std::vector<const IntersectMethod*> formulas() {
  std::vector<const IntersectMethod*> found;
  for (const IntersectMethod* method : intersect_methods()) {
    if (method->classes_in != nullptr) found.push_back(method);
  }
  return found;
}

TEST(Formulas, AreThoseThatUseNoErrorsOfSumsOrProducts) { EXPECT_EQ(formulas().size(), 6u); }

INSTANTIATE_TEST_SUITE_P(Formulas, EachFormula, testing::ValuesIn(formulas()), test_name);

}  // namespace
}  // namespace raycheck::fast
