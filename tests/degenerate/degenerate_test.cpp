#include "tests/caught/places.h"
#include "tests/degenerate/judged.h"
#include "tests/names.h"
#include "tests/testing.h"

namespace raycheck::degenerate {
namespace {

using namespace properties;

const DegenerateRoom& room() {
  static const DegenerateRoom the_room;
  return the_room;
}

std::string described(const Judged& judged) {
  std::string text = judged.degenerate->candidate.name + ", " + std::string(judged.law->name) +
                     ", " + judged.where.name() + ":";
  for (const auto& [quantity, tally] : judged.verdict.tallies()) {
    text += " " + std::string(info(quantity).name) + " compared " + std::to_string(tally.cases) +
            " ill-conditioned " + std::to_string(tally.ill_conditioned);
  }
  for (const Standing standing : {Standing::kUndecided, Standing::kExcused}) {
    text +=
        ", " + std::string(name(standing)) + " " + std::to_string(judged.verdict.count(standing));
  }
  return text;
}

class OnEachSource : public testing::TestWithParam<std::string> {
 protected:
  const CaseSource& source() const { return *find_case_source(GetParam()); }
};

TEST_P(OnEachSource, DegenerateCandidatesBreakTheirLawsAtEverySeverityOrTheReasonIsListed) {
  std::set<const WhyExcused*> used;
  for (const ChosenSource& place : caught::places_of(source())) {
    for (const Judged& judged : room().judge(place, kDegenerateCases)) {
      if (judged.judgement == Judgement::kBroken &&
          judged.degenerate->candidate.name != "refuses-all") {
        const Wrong wrong = judged.verdict.worst(1).front().wrong;
        EXPECT_TRUE(wrong != Wrong::kRefused && wrong != Wrong::kFailed) << described(judged);
      }
      if (judged.judgement != Judgement::kExcused) continue;
      const auto why =
          std::find_if(why_excused().begin(), why_excused().end(),
                       [&](const WhyExcused& reason) { return reason.is_about(judged); });
      EXPECT_NE(why, why_excused().end()) << described(judged);
      if (why != why_excused().end()) used.insert(&*why);
    }
  }
  for (const WhyExcused& reason : why_excused()) {
    if (reason.where.source == source().name) {
      EXPECT_TRUE(used.contains(&reason)) << "not needed: " << reason.reason;
    }
  }
}

TEST_P(OnEachSource, TheRightCandidateBreaksNoLawAtAnySeverity) {
  constexpr int kRightCases = 20;
  for (const ChosenSource& place : caught::places_of(source(), caught::kFewSeverities)) {
    for (const Judged& judged : room().judge_right(place, kRightCases)) {
      EXPECT_NE(judged.judgement, Judgement::kBroken) << described(judged);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Degenerate, OnEachSource, testing::ValuesIn(names_of(case_sources())),
                         by_name);

TEST(DegenerateCandidates, HaveDistinctNames) {
  std::set<std::string> names;
  for (const Degenerate& degenerate : room().all()) names.insert(degenerate.candidate.name);
  EXPECT_EQ(names.size(), room().all().size());
}

TEST(DegenerateCandidates, BreakEveryLaw) {
  std::set<std::string_view> broken;
  for (const Degenerate& degenerate : room().all()) {
    broken.insert(degenerate.broken_by.begin(), degenerate.broken_by.end());
  }
  for (const Law& law : laws()) EXPECT_TRUE(broken.contains(law.name)) << law.name;
}

}  // namespace
}  // namespace raycheck::degenerate
