// Tests the laws of the plan on every source, with each item of the plan on and off. Plans must
// leave out spheres for every reason.

#include "properties/candidates/fast_candidate.h"
#include "properties/cases/case_text.h"
#include "properties/cases/random.h"
#include "properties/search/campaign.h"
#include "scene/validate.h"
#include "tests/names.h"
#include "tests/properties/laws/certified_candidate.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

using scene::LeftOut;
using scene::PlanItems;

constexpr const char* kPlanLaws[] = {"plan-left-out", "plan-rectangles", "plan-roots",
                                     "visible-sphere"};

/// The number of cases of each source: 200, or RAYCHECK_PLAN_CASES (100,000 every night), but at
/// least one of every severity.
std::uint64_t cases_of(const CaseSource& source) {
  const char* const asked = std::getenv("RAYCHECK_PLAN_CASES");
  const std::uint64_t cases = asked == nullptr ? 200 : std::strtoull(asked, nullptr, 10);
  const int severities = source.severities ? source.severities->highest + 1 : 1;
  return std::max(cases, static_cast<std::uint64_t>(severities));
}

/// A camera whose middle pixel has a given ray. Some spheres fill the image, some are a pixel wide.
/// Empty if the lengths differ too much for doubles.
std::optional<Case> through_a_camera(const Case& of_rays, std::uint64_t seed) {
  Random random(seed);
  const scene::Ray& ray = of_rays.scene.rays.front();
  Case result{of_rays.scene, {}};
  result.scene.rays.clear();
  scene::Camera camera;
  camera.eye = ray.origin;
  camera.look_at = {ray.origin.x + ray.direction.x, ray.origin.y + ray.direction.y,
                    ray.origin.z + ray.direction.z};
  camera.up = random.direction();
  const auto& [x, y, z] = ray.direction;
  const double size = std::hypot(x, y, z);
  camera.near = -size * random.power_of_ten(-2, 0);
  const double half = camera.near * random.power_of_ten(-6, 1);
  camera.left = camera.bottom = half;
  camera.right = camera.top = -half;
  camera.width = 2 * random.integer(1, 8) + 1;
  camera.height = 2 * random.integer(1, 8) + 1;
  result.scene.camera = camera;
  if (random.one_in(2)) result.scene.conventions.origin = scene::Origin::kFocal;
  result.pixels = {{camera.width / 2, camera.height / 2}, {0, 0}};
  if (!scene::defects(result.scene).empty()) return std::nullopt;
  return result;
}

/// Calls body(case) for this number of cases of the source, each with a camera, with all severities
/// equally often.
template <class Body>
void for_each_case(const CaseSource& source, std::uint64_t cases, Body body) {
  const int severities = source.severities ? source.severities->highest + 1 : 1;
  const auto each = static_cast<std::uint64_t>(severities);
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const std::uint64_t severity = cases < each ? seed * each / cases : seed % each;
    std::optional<Case> the_case = source.make(static_cast<int>(severity), seed);
    if (!source.has_camera) the_case = through_a_camera(*the_case, seed);
    if (the_case) body(*the_case);
  }
}

/// The number of comparisons of each law.
using Compared = std::map<std::string_view, std::uint64_t>;

void expect_laws_hold(const Case& the_case, const Candidate& candidate, Compared& compared,
                      std::shared_ptr<Truth> truth = nullptr) {
  Trial trial(the_case, candidate, {.truth = std::move(truth)});
  for (const char* const name : kPlanLaws) {
    const Verdict verdict = apply(*find_law(name), trial);
    EXPECT_EQ(verdict.discrepancies(), 0u)
        << candidate.name << " breaks " << name << "\n"
        << (verdict.discrepancies() > 0 ? verdict.worst(1).front().what : "")
        << scene_text(the_case);
    compared[name] += verdict.compared();
  }
}

class EachSource : public testing::TestWithParam<std::string> {
 protected:
  const CaseSource& source() const { return *find_case_source(GetParam()); }
};

TEST_P(EachSource, KeepsTheLawsOfThePlan) {
  const Candidate certified = certified_candidate();
  const std::uint64_t cases = cases_of(source());
  std::uint64_t seen = 0;
  Compared compared;
  for_each_case(source(), cases, [&](const Case& the_case) {
    ++seen;
    expect_laws_hold(the_case, certified, compared);
  });
  // Cases may be skipped: rays at the end of the range have no camera, and images may be too large
  // for `certified`.
  EXPECT_GE(4 * seen, cases);  // cases that leave the range if they get a camera are skipped
  EXPECT_GE(compared["visible-sphere"], 4 * seen);
  const std::uint64_t of_plans =
      compared["plan-left-out"] + compared["plan-rectangles"] + compared["plan-roots"];
  // From an eye on the sphere, little can be left out.
  EXPECT_GE(of_plans, (source().name == "from-surface" ? 2 : 10) * seen);
  if (source().has_camera) {
    EXPECT_GE(compared["plan-rectangles"], 10 * seen);
    EXPECT_GE(compared["plan-roots"], 2 * seen);
  }
}

INSTANTIATE_TEST_SUITE_P(Sources, EachSource, testing::ValuesIn(raycheck::names_of(case_sources())),
                         by_name);

/// The numbers of spheres that plans left out, and of tests that plans made unnecessary.
struct Savings {
  std::map<LeftOut, int> left_out;
  int smaller_rectangles = 0, no_far_root = 0, no_behind_test = 0, scaled = 0, aligned = 0;
  int spheres = 0, plans = 0;
};

Savings savings_of(const CaseSource& source, std::uint64_t cases) {
  Savings result;
  for_each_case(source, cases, [&](const Case& the_case) {
    const scene::ScenePlan plan =
        scene::plan_scene(the_case.scene, the_case.scene.conventions, scene::Wanted::kNearest);
    const scene::Camera& camera = *the_case.scene.camera;
    ++result.plans;
    result.scaled += plan.eye.scaling() == scene::Scaling{} ? 0 : 1;
    result.aligned += plan.eye.axis_aligned() ? 1 : 0;
    for (const scene::SpherePlan& sphere : plan.spheres) {
      ++result.spheres;
      if (sphere.left_out) {
        ++result.left_out[*sphere.left_out];
        continue;
      }
      result.smaller_rectangles += sphere.pixels.count() < camera.width * camera.height ? 1 : 0;
      result.no_far_root += sphere.origin_inside ? 0 : 1;
      result.no_behind_test += sphere.reaches_behind ? 0 : 1;
    }
  });
  return result;
}

TEST(Plans, LeaveOutSomethingOfEveryKind) {
  const Savings crowds = savings_of(*find_case_source("crowds"), 500);
  EXPECT_EQ(crowds.plans, 500);
  for (const LeftOut why : {LeftOut::kOutsideView, LeftOut::kBehind, LeftOut::kHidden}) {
    EXPECT_GT(20 * crowds.left_out.at(why), crowds.spheres)
        << scene::kLeftOutNames[static_cast<std::size_t>(why)];
  }
  EXPECT_GT(4 * crowds.smaller_rectangles, crowds.spheres);
  EXPECT_GT(4 * crowds.no_far_root, crowds.spheres);
  EXPECT_GT(4 * crowds.no_behind_test, crowds.spheres);
  EXPECT_EQ(crowds.scaled, 0);
  EXPECT_EQ(crowds.aligned, 0);
  const Savings plain = savings_of(*find_case_source("plain-cameras"), 500);
  EXPECT_EQ(plain.aligned, 500);
  EXPECT_GT(plain.left_out.at(LeftOut::kHidden), 20);  // equal spheres
  EXPECT_GT(savings_of(*find_case_source("camera-scale"), 500).scaled, 300);
}

/// Flags of PlanItems, by name.
struct Item {
  const char* name;
  bool PlanItems::*flag;
};
void PrintTo(const Item& item, std::ostream* out) { *out << item.name; }
constexpr Item kItems[] = {{"view", &PlanItems::view},
                           {"behind", &PlanItems::behind},
                           {"hidden", &PlanItems::hidden},
                           {"rectangles", &PlanItems::rectangles},
                           {"constants", &PlanItems::constants},
                           {"far_root", &PlanItems::far_root},
                           {"behind_test", &PlanItems::behind_test},
                           {"scaling", &PlanItems::scaling},
                           {"filter", &PlanItems::filter},
                           {"basis", &PlanItems::basis},
                           {"quantities", &PlanItems::quantities}};

PlanItems items_with(bool others, const Item& item, bool value) {
  PlanItems items;
  for (const Item& other : kItems) items.*other.flag = others;
  items.*item.flag = value;
  return items;
}

class EachItem : public testing::TestWithParam<Item> {
 protected:
  /// Judges cases of every source, for the certified and a fast candidate with these `items`.
  void expect_laws_hold_with(const PlanItems& items) {
    const Candidate certified = certified_candidate(items);
    const Candidate fast = fast_candidate(fast::kDirectRays, fast::kRobust, items);
    Compared by_certified, by_fast;
    for (const CaseSource& source : case_sources()) {
      for_each_case(source, 10, [&](const Case& the_case) {
        const auto truth = std::make_shared<Truth>(the_case, the_case.scene.conventions);
        expect_laws_hold(the_case, certified, by_certified, truth);
        Trial trial(the_case, fast, {.truth = truth});
        const Verdict verdict = apply(*find_law("visible-sphere"), trial);
        EXPECT_TRUE(verdict.holds()) << scene_text(the_case);
        by_fast["visible-sphere"] += verdict.compared();
      });
    }
    EXPECT_GT(by_certified["visible-sphere"], 500u);
    EXPECT_GT(by_fast["visible-sphere"], 500u);
  }
};

TEST_P(EachItem, SwitchedOffKeepsTheLaws) {
  expect_laws_hold_with(items_with(true, GetParam(), false));
}
TEST_P(EachItem, AloneKeepsTheLaws) { expect_laws_hold_with(items_with(false, GetParam(), true)); }

INSTANTIATE_TEST_SUITE_P(Items, EachItem, testing::ValuesIn(kItems),
                         [](const testing::TestParamInfo<Item>& the_test) {
                           return std::string(the_test.param.name);
                         });

TEST(PlanItems, AreAllTried) {
  // PlanItems has one flag per byte: a new item must be added above.
  EXPECT_EQ(std::size(kItems), sizeof(PlanItems));
}

}  // namespace
}  // namespace raycheck::properties
