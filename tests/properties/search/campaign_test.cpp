#include "properties/search/campaign.h"

#include "properties/candidates/fast_candidate.h"
#include "tests/campaigns.h"
#include "tests/properties/one_ray.h"
#include "tests/testing.h"

namespace raycheck::properties {
namespace {

const Candidate kGood = fast_candidate(fast::kDirectRays, fast::kCross);
const Candidate kBad = fast_candidate(fast::kDirectRays, fast::kQuadratic);

/// Answers that are wrong in the same way agree with each other, but none of their hits is right.
TEST(Campaign, ReportsTooFewRightIfAnswersAreWrongInTheSameWay) {
  const Candidate misses = that_misses([](const auto&) { return true; });
  for (const char* law : {"scaling", "axes"}) {
    for (const char* source : {"rays", "inside@16"}) {
      const CampaignOptions some = options_of(100, {source});
      const CampaignResult result = run_campaign(*find_law(law), misses, some);
      EXPECT_EQ(result.finding(), Finding::kTooFewJudged) << law << ", " << source;
      const std::pair hits(Quantity::kClass, Expected::kHit);
      EXPECT_EQ(result.too_few_right(), hits) << law << ", " << source;
      EXPECT_EQ(run_campaign(*find_law(law), kGood, some).finding(), Finding::kHolds) << law;
    }
  }
}

TEST(Campaign, IsUndecidedIfMoreThanOneIn200ComparisonsAre) {
  for (const std::size_t right :
       {2 * kComparisonsOfUndecided - 3, 2 * kComparisonsOfUndecided - 2}) {
    CampaignResult result;
    result.verdict.judged_right(Quantity::kClass, Expected::kHit, right);
    for (std::size_t ray = 0; ray < 2; ++ray) {
      Discrepancy one;
      one.quantity = Quantity::kClass;
      one.place.ray = ray;
      one.excuse = {ExcuseKind::kUndecided, kExcusedChange};
      result.verdict.judged_wrong({one.quantity, Expected::kHit, one.place, Wrong::kMissed},
                                  one.excuse.standing());
      result.verdict.add(one);
    }
    const bool is_few = result.verdict.compared() == 2 * kComparisonsOfUndecided;
    EXPECT_EQ(result.finding(), is_few ? Finding::kHolds : Finding::kUndecided) << right;
  }
}

/// Expects the same verdict, with the same counts.
void expect_same(const CampaignPart& a, const CampaignPart& b) {
  EXPECT_EQ(a.source.name(), b.source.name());
  EXPECT_EQ(a.counts.cases, b.counts.cases);
  EXPECT_EQ(a.verdict.compared(), b.verdict.compared());
  ASSERT_EQ(a.breaks.size(), b.breaks.size());
  for (std::size_t k = 0; k < a.breaks.size(); ++k) {
    EXPECT_EQ(a.breaks[k].replay, b.breaks[k].replay);
    EXPECT_EQ(a.breaks[k].defects, b.breaks[k].defects);
  }
}

TEST(Campaign, PartsDoNotDependOnEachOther) {
  CampaignOptions some = options_of(120, {"rays", "distance", "horizon@2"});
  CampaignOptions separate = options_of(40, {"distance"});
  const auto all = run_campaign(*find_law("class"), kBad, some).parts;
  const auto of_distance = run_campaign(*find_law("class"), kBad, separate).parts;
  ASSERT_EQ(of_distance.size(), 16u);
  ASSERT_EQ(all.size(), 18u);
  EXPECT_EQ(all.front().source.name(), "rays");
  EXPECT_EQ(all.back().source.name(), "horizon@2");
  EXPECT_EQ(all.back().counts.cases, 40);
  for (std::size_t k = 0; k < of_distance.size(); ++k) expect_same(all[k + 1], of_distance[k]);
}

/// Campaigns run in one pass, by units in any order, and call each candidate once for all laws.
TEST(Campaign, OfManyLawsAndCandidatesEqualsSeparateOnes) {
  CampaignOptions some = options_of(5 * kUnitCases, {"rays", "distance@9"});
  std::vector<const Law*> laws;
  for (const char* name : {"class", "nearest-root", "parameter", "hit-point"}) {
    laws.push_back(find_law(name));
  }
  int asked = 0;
  Candidate counted = kGood;
  counted.intersect = [&](auto... of) {
    ++asked;
    return kGood.intersect(of...);
  };
  const std::vector<Candidate> candidates = {counted, kBad};
  Campaigns together({{laws, some}, {laws, some}});
  std::vector<std::vector<CampaignPart>> parts(together.unit_count());
  ASSERT_EQ(parts.size(), 6u);
  for (std::size_t k = parts.size(); k-- > 0;) parts[k] = together.run(k, candidates, {});
  for (std::size_t k = 0; k < parts.size(); ++k) together.take(k, std::move(parts[k]));
  EXPECT_EQ(asked, some.cases);
  bool any_broken = false;
  for (std::size_t candidate = 0; candidate < candidates.size(); ++candidate) {
    for (std::size_t law = 0; law < laws.size(); ++law) {
      const CampaignResult its = together.finished(candidate, law, candidates[candidate]);
      const CampaignResult separate = run_campaign(*laws[law], candidates[candidate], some);
      EXPECT_EQ(its.finding(), separate.finding());
      ASSERT_EQ(its.parts.size(), separate.parts.size());
      for (std::size_t k = 0; k < its.parts.size(); ++k)
        expect_same(its.parts[k], separate.parts[k]);
      ASSERT_EQ(its.failure.has_value(), separate.failure.has_value());
      if (its.failure) {
        EXPECT_EQ(its.failure->replay, separate.failure->replay);
      }
      any_broken = any_broken || its.failure;
      EXPECT_EQ(its.counts.cases < some.cases, its.failure.has_value());
    }
  }
  EXPECT_TRUE(any_broken);
}

/// Units that are stored do not depend on earlier units; others skip laws that are known to be
/// broken.
TEST(Campaign, KeptUnitsDoNotDependOnEarlierOnes) {
  CampaignOptions some = options_of(3 * kUnitCases, {"distance@12"});
  for (const bool are_kept : {true, false}) {
    Campaigns after({{{find_law("class")}, some}}, are_kept),
        separate({{{find_law("class")}, some}}, are_kept);
    ASSERT_TRUE(after.run(0, {&kBad, 1}, {}).front().is_broken());
    const CampaignPart part = after.run(2, {&kBad, 1}, {}).front();
    EXPECT_EQ(part.counts.cases > 0, are_kept);
    if (are_kept) expect_same(part, separate.run(2, {&kBad, 1}, {}).front());
  }
}

/// A case of a source depends only on its number, not on the number of cases. Units of a large
/// campaign are larger, so that there are never many more than kMostUnits.
TEST(Campaign, HasLargerUnitsIfItIsLarger) {
  const auto few = options_of(200, {"rays"}), many = options_of(1'000'000'000, {"rays"});
  Campaigns small({{{find_law("class")}, few}});
  const Campaigns large({{{find_law("class")}, many}});
  EXPECT_EQ(small.unit_count(), 4u);
  EXPECT_GT(large.unit_count(), std::size_t{kMostUnits / 2});
  EXPECT_LE(large.unit_count(), std::size_t{kMostUnits + 1});
  // Its first unit has more cases than the whole small campaign, and begins with the same cases.
  std::vector<scene::Scene> asked[2];
  for (const bool is_large : {false, true}) {
    Candidate seen = kGood;
    seen.intersect = [&](Candidate::Rays rays, Candidate::Spheres spheres, const auto& by) {
      asked[is_large ? 1 : 0].push_back(
          {{}, {rays.begin(), rays.end()}, {spheres.begin(), spheres.end()}, by});
      return kGood.intersect(rays, spheres, by);
    };
    if (is_large) {
      large.run(0, {&seen, 1}, {.interrupted = [&] { return asked[1].size() >= 250; }});
    } else {
      for (std::size_t k = 0; k < 4; ++k) small.run(k, {&seen, 1}, {});
    }
  }
  ASSERT_GE(asked[1].size(), 250u);
  ASSERT_EQ(asked[0].size(), 200u);
  asked[1].resize(200);
  EXPECT_TRUE(asked[0] == asked[1]);
}

/// Each failure has another source or kind; all cases are judged.
TEST(Campaign, KeepsGoingUntilThatManyFailuresDiffer) {
  CampaignOptions some = options_of(2000, {"distance", "tangency", "tangent-ulps"});
  const CampaignResult first = run_campaign(*find_law("class"), kBad, some);
  some.keep_going = 2;
  const CampaignResult two = run_campaign(*find_law("class"), kBad, some);
  some.keep_going = 100;
  const CampaignResult all = run_campaign(*find_law("class"), kBad, some);
  EXPECT_TRUE(first.others.empty());
  EXPECT_EQ(two.others.size(), 1u);
  ASSERT_GT(all.others.size(), 1u);
  ASSERT_LT(all.others.size(), 99u);
  EXPECT_EQ(all.failure->replay, first.failure->replay);
  EXPECT_EQ(all.others[0].replay, two.others[0].replay);
  EXPECT_LT(first.counts.cases, all.counts.cases);
  std::set<std::pair<std::string, std::vector<DefectKind>>> known;
  std::vector<const Failure*> failures = {&*all.failure};
  for (const Failure& other : all.others) failures.push_back(&other);
  for (const Failure* failure : failures) {
    EXPECT_TRUE(run_replay(parse_replay(failure->replay), kBad).failure);
    const auto source = parse_replay(failure->replay).source.source->name;
    EXPECT_TRUE(known.emplace(source, failure->verdict.defects()).second) << failure->replay;
  }
}

/// A candidate that only fails is dropped after some units. If it answers in one of them, it is
/// not.
TEST(Campaign, DropsACandidateThatAnswersNothing) {
  CampaignOptions some = options_of(500);
  for (const std::size_t answered_in : {std::size_t{1}, kUnitsToFail}) {
    Campaigns campaigns({{{find_law("class"), find_law("scaling")}, some}});
    std::size_t unit = 0, asked = 0;
    Candidate fails = kGood;
    fails.intersect = [&](auto... of) {
      ++asked;
      if (unit == answered_in) return kGood.intersect(of...);
      throw std::runtime_error("it says nothing");
    };
    for (; unit < campaigns.unit_count(); ++unit) {
      campaigns.take(unit, campaigns.run(unit, {&fails, 1}, {}));
    }
    EXPECT_EQ(asked >= unit, answered_in < kUnitsToFail) << asked;
    const CampaignResult its = campaigns.finished(0, 0, fails);
    EXPECT_EQ(its.finding(), Finding::kBroken);
    EXPECT_EQ(its.parts.size() == kUnitsToFail, answered_in == kUnitsToFail);
    ASSERT_TRUE(its.failure);
    EXPECT_EQ(its.failure->is_shrunk, answered_in < kUnitsToFail);
    EXPECT_TRUE(telling_cases(its, 12).empty());  // no mistake in answers explains failures
  }
}

/// The failing case is asked again. A time-out may be the machine's; a wrong answer depends on
/// earlier questions.
TEST(Campaign, JudgesAFailureThatIsNotRepeated) {
  for (const bool times_out : {true, false}) {
    bool has_failed = false;
    Candidate once = kGood;
    once.classes_in = {};
    once.intersect = [&](auto... of) {
      std::vector<SphereHits> answers = kGood.intersect(of...);
      const bool fails = !has_failed && !answers.empty() && !answers[0].empty();
      has_failed = has_failed || fails;
      if (fails && times_out) throw CandidateFailed("no reply", {}, true);
      if (fails) answers[0].clear();
      return answers;
    };
    const CampaignResult result = run_campaign(*find_law("class"), once, options_of(100, {"rays"}));
    EXPECT_TRUE(has_failed);
    EXPECT_EQ(result.finding() == Finding::kBroken, !times_out);
    EXPECT_EQ(result.failure.has_value(), !times_out);
    EXPECT_EQ(result.failure && result.failure->is_of_earlier, !times_out);
    EXPECT_EQ(has(result.counts.reason, "answers when it is asked again"), times_out);
  }
}

TEST(Campaign, GoesOnAfterABreak) {
  CampaignOptions far = options_of(1600, {"distance"});
  const CampaignResult result = run_campaign(*find_law("class"), kBad, far);
  ASSERT_EQ(result.parts.size(), 16u);
  int broken = 0, whole = 0;
  for (const CampaignPart& part : result.parts) {
    broken += part.is_broken() ? 1 : 0;
    whole += part.counts.cases == 100 ? 1 : 0;
    EXPECT_EQ(part.is_broken(), !part.verdict.holds());
    if (!part.is_broken()) continue;
    // The replay string finds it again.
    EXPECT_TRUE(run_replay(parse_replay(part.breaks.front().replay), kBad).failure);
  }
  EXPECT_FALSE(result.parts.front().is_broken());
  EXPECT_GT(broken, 1);
  EXPECT_GT(whole, 1);
  EXPECT_EQ(result.finding(), Finding::kBroken);
  ASSERT_TRUE(result.failure);
  EXPECT_EQ(result.failure->replay,
            std::find_if(result.parts.begin(), result.parts.end(),
                         [](const CampaignPart& part) { return part.is_broken(); })
                ->breaks.front()
                .replay);
}

/// The number of cases of each part of a campaign, by its name.
std::map<std::string, std::int64_t> cases_of(const CampaignOptions& asked) {
  std::map<std::string, std::int64_t> cases;
  Law law = *find_law("class");
  law.judge = [](Trial&, Verdict&) {};
  for (const CampaignPart& part : run_campaign(law, kGood, asked).parts) {
    cases[part.source.name()] = part.counts.cases;
  }
  return cases;
}

TEST(Campaign, SharesCasesAmongTheSeveritiesOfEveryLevelUpToItsOwn) {
  std::map<std::string, std::int64_t> before;
  for (const Level level : {Level::kOrdinary, Level::kDemanding, Level::kExtreme}) {
    const CampaignOptions asked = options_of(2400, {}, level);
    std::map<std::string_view, std::int64_t> of_source;
    const auto parts = cases_of(asked);
    for (const auto& [source_name, cases] : parts) {
      const ChosenSource part = chosen_source(source_name);
      EXPECT_LE(part.level(), level) << source_name;
      EXPECT_GE(cases, 1) << source_name;
      of_source[part.source->name] += cases;
    }
    const int share = 2400 / static_cast<int>(of_source.size());
    std::int64_t all = 0;
    for (const auto& [source_name, cases] : of_source) {
      EXPECT_GE(cases, share) << source_name;
      all += cases;
      const CaseSource& source = *find_case_source(source_name);
      if (!source.severities) continue;
      // The highest severity of the level is always there.
      EXPECT_TRUE(
          parts.contains(ChosenSource{&source, source.severities->highest_of(level)}.name()));
    }
    if (level == Level::kOrdinary) {
      EXPECT_EQ(all, 2400);
    }
    for (const auto& [source_name, cases] : before) {
      ASSERT_TRUE(parts.contains(source_name)) << source_name;
      EXPECT_GE(parts.at(source_name), cases) << source_name;
    }
    before = parts;
  }
}

/// Harder cases do not displace the ordinary ones that break a law.
TEST(Campaign, OfALevelBreaksTheLawsThatEasierLevelsBreak) {
  // The candidate is wrong on few cases, of any severity.
  const Candidate rare =
      that_misses([](const auto& sphere) { return sphere.radius > 0.5 && sphere.radius < 0.6; });
  CampaignOptions asked = options_of(500, {}, Level::kOrdinary);
  ASSERT_TRUE(run_campaign(*find_law("class"), rare, asked).failure);
  for (const Level level : {Level::kDemanding, Level::kExtreme}) {
    asked.level = level;
    EXPECT_EQ(run_campaign(*find_law("class"), rare, asked).finding(), Finding::kBroken);
  }
}

TEST(Campaign, AsksEverySourceAtItsHighestSeverityAtLeastOnce) {
  const CampaignOptions one = options_of(1, {}, Level::kDemanding);
  const auto cases = cases_of(one);
  for (const auto& [source_name, count] : cases) EXPECT_EQ(count, 1) << source_name;
  for (const CaseSource& source : case_sources()) {
    const auto severity =
        source.severities ? std::optional(source.severities->highest_of(one.level)) : std::nullopt;
    EXPECT_TRUE(cases.contains(ChosenSource{&source, severity}.name())) << source.name;
  }
}

TEST(Campaign, JudgesNothingOutsideTheStatedDomain) {
  Candidate small = kGood;
  small.largest_length = 0x1p-20;
  CampaignOptions asked = options_of(200, {"rays"});
  const CampaignResult none = run_campaign(*find_law("parameter"), small, asked);
  EXPECT_EQ(none.counts.not_judged, 200);
  EXPECT_EQ(none.verdict.compared(), 0u);
  EXPECT_EQ(none.finding(), Finding::kNotJudged);
  // A promise of exact hit classes holds outside the domain, too.
  small.exact_class = true;
  EXPECT_EQ(run_campaign(*find_law("class"), small, asked).counts.not_judged, 0);
  EXPECT_EQ(run_campaign(*find_law("parameter"), small, asked).counts.not_judged, 200);
}

TEST(Campaign, SkipsCasesThatAreInvalidUnderTheDeclaredConventions) {
  Candidate edges = kGood;
  edges.declared.samples = scene::Samples::kEdges;
  CampaignOptions asked = options_of(200, {"image-size@0"});  // one pixel across, or down
  const CampaignResult result = run_campaign(*find_law("direction"), edges, asked);
  EXPECT_GT(result.counts.not_judged, 0);
  EXPECT_FALSE(result.failure);
}

TEST(Campaign, DoesNotHoldWithTooFewRightAnswers) {
  const Law& law = *find_law("class");
  EXPECT_EQ(run_campaign(law, kGood, options_of(200)).finding(), Finding::kHolds);
  CampaignOptions few = options_of(6, {"rays"});
  const CampaignResult result = run_campaign(law, kGood, few);
  EXPECT_EQ(result.finding(), Finding::kTooFewJudged);
  EXPECT_TRUE(result.too_few_right());
  EXPECT_TRUE(result.verdict.holds());
}

TEST(Campaign, CountsExcusedAnswersAsBreaksIfItIsStrict) {
  CampaignOptions asked = options_of(400, {"tangency@16"});
  const CampaignResult mild = run_campaign(*find_law("class"), kGood, asked);
  ASSERT_GT(mild.verdict.count(Standing::kExcused), 0u);
  EXPECT_NE(mild.finding(), Finding::kBroken);
  asked.strict = true;
  const CampaignResult strict = run_campaign(*find_law("class"), kGood, asked);
  EXPECT_EQ(strict.finding(), Finding::kBroken);
  ASSERT_TRUE(strict.failure);
  const Replay replay = parse_replay(strict.failure->replay);
  EXPECT_FALSE(run_replay(replay, kGood).failure);
  EXPECT_TRUE(run_replay(replay, kGood, {}, true).failure);
}

TEST(Campaign, EndsWhenItIsInterrupted) {
  int answered = 0;
  Candidate counting = kGood;
  counting.intersect = [&](auto... of) {
    ++answered;
    return kGood.intersect(of...);
  };
  RunControl until_ten;
  until_ten.interrupted = [&] { return answered >= 10; };
  const CampaignResult result =
      run_campaign(*find_law("class"), counting, options_of(1000), until_ten);
  // A case that the law has not finished is not counted.
  EXPECT_GE(result.counts.cases, 9);
  EXPECT_LE(result.counts.cases, 10);
  EXPECT_EQ(answered, 10);
  // An interrupt may end the candidate, too, before it is noticed.
  answered = 0;
  counting.classes_in = {};
  counting.intersect = [&](auto... of) {
    if (++answered >= 10) throw CandidateFailed("it was ended");
    return kGood.intersect(of...);
  };
  const CampaignResult ended =
      run_campaign(*find_law("class"), counting, options_of(1000), until_ten);
  EXPECT_EQ(answered, 10);
  EXPECT_NE(ended.finding(), Finding::kBroken);
}

TEST(Replay, NamesThePartThatIsWrong) {
  EXPECT_EQ(parse_replay("class:a/b:distance:00ff").seed, 255u);
  EXPECT_EQ(parse_replay("class:a/b:distance@3:1").source.severity, 3);
  EXPECT_EQ(parse_replay("class:source:a.cpp:distance:1").candidate, "source:a.cpp");
  const auto error_of = [](const std::string& replay) {
    return thrown_by([&] { parse_replay(replay); });
  };
  EXPECT_TRUE(has(error_of(""), "LAW:CANDIDATE:SOURCE:SEED"));
  EXPECT_TRUE(has(error_of("class:a/b:distance"), "'class:a/b:distance'"));
  EXPECT_TRUE(has(error_of("clas:a/b:distance:1"), "law is called 'clas'"));
  EXPECT_TRUE(has(error_of("class:a/b:distance@16:1"), "are 0 to 15"));
  EXPECT_TRUE(has(error_of("class:a/b:dist:1"), "source of cases is called 'dist'"));
  for (const std::string seed : {"", "x1", "1x", "-1", "0x1", "10000000000000000"}) {
    EXPECT_TRUE(has(error_of("class:a/b:distance:" + seed), "hexadecimal seed")) << seed;
  }
}

}  // namespace
}  // namespace raycheck::properties
