// Laws under t_min, t_max and culling: code that follows them exactly passes; code that treats the
// ends wrongly fails.

#include "properties/search/campaign.h"
#include "tests/properties/one_ray.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

using Change = std::function<void(scene::Conventions&)>;

/// A candidate with the exact answers, correctly rounded, under conventions that a mistake changes.
Candidate follower(const Change& mistake = [](scene::Conventions&) {}) {
  Candidate candidate;
  candidate.name = "follower";
  candidate.refuses = false;
  candidate.intersect = [mistake](Candidate::Rays rays, Candidate::Spheres spheres,
                                  scene::Conventions by) {
    mistake(by);
    std::vector<SphereHits> all(spheres.size());
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      for (std::size_t ray = 0; ray < rays.size(); ++ray) {
        const reference::ExactRay exact(rays[ray]);
        const auto at = exact.intersect(spheres[k], by);
        if (!reference::counts_as_hit(at.hit_class, by.tangent)) continue;
        all[k].push_back(
            {ray, {exact.rounded_parameter(spheres[k], at), exact.rounded_point(spheres[k], at)}});
      }
    }
    return all;
  };
  return candidate;
}

/// A ray along x from 0 with roots at 2 and 4 of a sphere of radius 1, and other rays and spheres.
Case a_case(const scene::ValidRoots& valid) {
  Case one;
  one.scene.rays = {{{0, 0, 0}, {1, 0, 0}}, {{2.5, 0, 0}, {1, 0, 0}}, {{0, 0.5, 0}, {1, 0, 0}}};
  one.scene.spheres = {{{3, 0, 0}, 1}, {{9, 0, 0}, 2}};
  one.scene.conventions.valid = valid;
  return one;
}

Verdict verdict(std::string_view law, const Candidate& candidate, const scene::ValidRoots& valid) {
  return judge(law, a_case(valid), candidate);
}

constexpr double kNoEnd = kInfinity;

TEST(ValidRootsLaws, HoldWhereTheyAreFollowed) {
  for (const auto ends :
       {scene::Ends::kClosed, scene::Ends::kOpenMax, scene::Ends::kOpenMin, scene::Ends::kOpen}) {
    for (const auto unit : {scene::TUnit::kAbsolute, scene::TUnit::kRadius}) {
      for (const auto culling :
           {scene::Culling::kNone, scene::Culling::kBackFaces, scene::Culling::kFrontFaces}) {
        for (const char* law :
             {"class", "nearest-root", "parameter", "hit-point", "scaling", "axes"}) {
          const Verdict found = verdict(law, follower(), {2, 7, ends, unit, culling});
          EXPECT_EQ(found.discrepancies(), 0u) << law;
        }
      }
    }
  }
}

TEST(ValidRootsLaws, FindWrongEndsAndReportDefectsFarFromThem) {
  using C = scene::Conventions;
  const Change keep = [](C&) {}, ignore = [](C&c) { c.valid = {}; },
               open_min = [](C&c) { c.valid.ends = scene::Ends::kOpenMin; },
               open_max = [](C&c) { c.valid.ends = scene::Ends::kOpenMax; },
               absolute = [](C&c) { c.valid.unit = scene::TUnit::kAbsolute; };
  // The near root is 2 on the first ray and 7 on the second sphere. At an end, a wrong answer is
  // not a defect.
  const scene::ValidRoots closed{2, 7, scene::Ends::kClosed, {}, {}};
  const scene::ValidRoots open{2, 7, scene::Ends::kOpen, {}, {}};
  struct Row {
    const char* what;
    scene::ValidRoots valid;
    const Change& mistake;
    bool is_wrong, is_defect;
  };
  for (const auto& [what, valid, mistake, is_wrong, is_defect] : std::vector<Row>{
           {"closed, open below", closed, open_min, true, false},
           {"closed, open above", closed, open_max, true, false},
           {"open, closed above", open, open_min, true, true},
           {"open, closed below", open, open_max, true, true},
           {"open, followed", open, keep, false, false},
           {"t_min ignored", {3, kNoEnd, {}, {}, {}}, ignore, true, true},
           {"t_max ignored", {0, 1, {}, {}, {}}, ignore, true, true},
           {"front faces", {0, kNoEnd, {}, {}, scene::Culling::kFrontFaces}, ignore, true, true},
           {"back faces", {0, kNoEnd, {}, {}, scene::Culling::kBackFaces}, ignore, true, true},
           {"in radii", {4, kNoEnd, {}, scene::TUnit::kRadius, {}}, absolute, true, true}}) {
    std::uint64_t wrong = 0, defects = 0;
    for (const char* law : {"class", "nearest-root"}) {
      const Verdict found = verdict(law, follower(mistake), valid);
      wrong += found.discrepancies();
      defects += found.count(Standing::kDefect);
    }
    EXPECT_EQ(wrong > 0, is_wrong) << what;
    EXPECT_EQ(defects > 0, is_defect) << what;
  }
}

/// The law that reports a defect; empty if there is none.
std::string law_of_defect(const scene::ValidRoots& valid, const Change& mistake) {
  for (const char* law : {"class", "nearest-root"}) {
    const Verdict found = verdict(law, follower(mistake), valid);
    if (found.count(Standing::kDefect) == 0) continue;
    const Discrepancy worst = found.worst(1).front();
    EXPECT_TRUE(worst.excluded_by == valid) << law;
    return law;
  }
  return "";
}

/// An answer outside the interval by which it is judged is a defect without further proof. So >=
/// for > is a defect exactly at the end.
TEST(ValidRootsLaws, ReportAnswersOutsideTheIntervalAsDefects) {
  const auto closed = [](scene::Conventions& c) { c.valid.ends = scene::Ends::kClosed; };
  // The near root of the first ray is 2, the far one 4; 7 and 11 of the second sphere.
  EXPECT_EQ(law_of_defect({2, 7, scene::Ends::kOpenMin, {}, {}}, closed), "nearest-root");
  EXPECT_EQ(law_of_defect({5, 7, scene::Ends::kOpenMax, {}, {}}, closed), "class");
  // 3.5 radii of the second sphere.
  EXPECT_EQ(law_of_defect({3, 3.5, scene::Ends::kOpenMax, scene::TUnit::kRadius, {}}, closed),
            "class");
  EXPECT_EQ(law_of_defect({2, 7, scene::Ends::kOpen, {}, {}}, [](auto&) {}), "");
}

/// s is 1/3. That is slightly above the nearest double, which is the best answer.
TEST(ValidRootsLaws, LetTheExactRootBeRoundedToAnOpenEnd) {
  Case one = one_ray({{0, 0, 0}, {3, 0, 0}}, {{2, 0, 0}, 1});
  one.scene.conventions.valid = {1.0 / 3, kNoEnd, scene::Ends::kOpen, {}, {}};
  const auto defects = [&](double s) {
    const Candidate candidate = that_answers(HitAnswer{s, {3 * s, 0, 0}});
    EXPECT_EQ(judge("class", one, candidate).discrepancies(), 0u);
    return judge("nearest-root", one, candidate).count(Standing::kDefect);
  };
  EXPECT_EQ(defects(1.0 / 3), 0u);
  EXPECT_EQ(defects(std::nextafter(1.0 / 3, 0)), 1u);
  EXPECT_EQ(defects(std::nextafter(1.0 / 3, 1)), 0u);
}

TEST(ValidRootsLaws, ScaleAbsoluteEndsWithTheScene) {
  const scene::ValidRoots absolute{2.5, 7, scene::Ends::kClosed, {}, {}};
  EXPECT_GT(verdict("scaling", follower(), absolute).compared(), 0u);
  // A candidate that does not scale the ends is wrong.
  EXPECT_GT(
      verdict("scaling", follower([](auto& c) { c.valid.t_min = 2.5; }), absolute).discrepancies(),
      0u);
  Candidate own = follower();
  own.declared.valid = absolute;
  const Verdict left_out = verdict("scaling", own, {});
  EXPECT_EQ(left_out.compared(), 0u);
  EXPECT_TRUE(has(left_out.reason_left_out(), "does not scale"));
  const Verdict grown = verdict("growing-radius", follower(), {1, kNoEnd, {}, {}, {}});
  EXPECT_EQ(grown.compared(), 0u);
  EXPECT_TRUE(has(grown.reason_left_out(), "t_min"));
}

TEST(ValidRootsLaws, HoldWithTheEndsOfASegmentExchanged) {
  const auto found = [](const Candidate& candidate) {
    CampaignOptions options;
    options.cases = 200;
    return run_campaign(*find_law("exchange"), candidate, options);
  };
  EXPECT_EQ(found(follower()).finding(), Finding::kHolds);
  EXPECT_GT(found(follower()).verdict.compared(), 300u);
  Candidate one = follower([](auto& c) { c.valid.culling = scene::Culling::kBackFaces; });
  one.declared.valid = {.t_max = 1};
  const CampaignResult broken = found(one);
  ASSERT_TRUE(broken.failure);
  EXPECT_TRUE(has(broken.failure->verdict.worst(1).front().what, "segment exchanged"));
  one = follower();
  one.declared.valid = scene::ValidRoots{.t_min = 0.25};
  EXPECT_TRUE(has(found(one).counts.reason, "roots other than those of rays or segments"));
  one.declared.valid = scene::ValidRoots{};
  EXPECT_EQ(found(one).finding(), Finding::kHolds);
  EXPECT_GT(found(one).verdict.compared(), 100u);
  one.interface.directions = contract::Directions::kUnit;
  EXPECT_TRUE(has(found(one).counts.reason, "not unit"));
}

TEST(ValidRootsLaws, HoldOnRandomCasesWithAnEpsilon) {
  Candidate declares = follower();
  declares.declared.valid = scene::ValidRoots{1e-3, kNoEnd, scene::Ends::kOpen, {}, {}};
  Candidate ignores = follower([](auto& c) { c.valid = {}; });
  ignores.declared.valid = declares.declared.valid;
  CampaignOptions options;
  options.cases = 200;
  for (const char* law : {"class", "nearest-root", "parameter"}) {
    EXPECT_EQ(run_campaign(*find_law(law), declares, options).finding(), Finding::kHolds) << law;
  }
  EXPECT_EQ(run_campaign(*find_law("class"), ignores, options).finding(), Finding::kBroken);
}

}  // namespace
}  // namespace raycheck::properties
