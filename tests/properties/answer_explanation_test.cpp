#include "properties/answer_explanation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/case_source.h"
#include "properties/fast_candidate.h"
#include "properties/mistakes.h"

namespace raycheck::properties {
namespace {

std::vector<Case> cases_of(std::initializer_list<const char*> sources, std::uint64_t count) {
  std::vector<Case> cases;
  for (const char* name : sources) {
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
      cases.push_back(find_case_source(name)->make(0, seed));
    }
  }
  return cases;
}

const std::vector<Case>& fixed_cases() {
  static const std::vector<Case> kCases =
      cases_of({"cameras", "plain-cameras", "crowds", "rays", "ties", "inside"}, 40);
  return kCases;
}

Candidate candidate_of(std::string_view sentence) {
  const Mistake* mistake = find_mistake(sentence);
  if (mistake == nullptr) throw std::invalid_argument(std::string(sentence));
  return mistake->candidate;
}

using Sentences = std::vector<std::string>;

Sentences sentences_for(const Candidate& candidate,
                        const std::vector<Case>& cases = fixed_cases()) {
  Sentences sentences;
  for (const Explanation& explanation : explanations(cases, candidate)) {
    EXPECT_GT(explanation.errors, 0u);
    EXPECT_LE(explanation.explained, explanation.errors);
    EXPECT_GE(static_cast<double>(explanation.explained),
              kExplainedShare * static_cast<double>(explanation.errors));
    sentences.push_back(explanation.sentence);
  }
  return sentences;
}

TEST(Mistakes, HaveSentencesOfTheirOwn) {
  std::set<std::string> sentences;
  for (const Mistake& mistake : mistakes()) EXPECT_TRUE(sentences.insert(mistake.sentence).second);
  EXPECT_GE(sentences.size(), 60u);
}

/// The indices of the mistakes that are made on the way to a ray, or after it.
std::vector<std::size_t> indices(bool on_the_way) {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < mistakes().size(); ++k) {
    if ((mistakes()[k].stage < Stage::kIntersect) == on_the_way) result.push_back(k);
  }
  return result;
}

void expect_among(const Sentences& sentences, const std::string& sentence) {
  EXPECT_TRUE(std::count(sentences.begin(), sentences.end(), sentence))
      << sentence << ": " << testing::PrintToString(sentences);
}

class EachMistake : public testing::TestWithParam<std::size_t> {
 protected:
  const Mistake& mistake() const { return mistakes()[GetParam()]; }
};

TEST_P(EachMistake, IsExplainedByItsOwnSentenceAlone) {
  EXPECT_EQ(sentences_for(mistake().candidate), Sentences{mistake().sentence});
}

INSTANTIATE_TEST_SUITE_P(Classic, EachMistake, testing::Range(std::size_t{0}, mistakes().size()));

using EachMistakeInRays = EachMistake;

TEST_P(EachMistakeInRays, IsAmongTheExplanationsOfRaysAlone) {
  Candidate candidate;
  candidate.pixel_rays = mistake().candidate.pixel_rays;
  candidate.focal_rays = mistake().candidate.focal_rays;
  expect_among(sentences_for(candidate), mistake().sentence);
}

INSTANTIATE_TEST_SUITE_P(Classic, EachMistakeInRays, testing::ValuesIn(indices(true)));

using EachMistakeInHits = EachMistake;

TEST_P(EachMistakeInHits, IsAmongTheExplanationsOfNearestSpheresAlone) {
  Candidate candidate;
  candidate.nearest = mistake().candidate.nearest;
  const std::string& sentence = mistake().sentence;
  const bool keeps_nearest = sentence.starts_with("Q = ") || sentence.starts_with("s is a length");
  if (keeps_nearest) {
    EXPECT_EQ(sentences_for(candidate), Sentences());
  } else {
    expect_among(sentences_for(candidate), sentence);
  }
}

INSTANTIATE_TEST_SUITE_P(Classic, EachMistakeInHits, testing::ValuesIn(indices(false)));

TEST(AnswerExplanation, OfARightCandidateIsNone) {
  for (const auto* rays : fast::pixel_ray_methods()) {
    for (const auto* intersect : fast::intersect_methods()) {
      if (rays != &fast::kDirectRays && intersect != &fast::kCross) continue;
      const Candidate candidate = fast_candidate(*rays, *intersect);
      EXPECT_EQ(sentences_for(candidate), Sentences()) << candidate.name;
    }
  }
}

TEST(AnswerExplanation, OfARightCandidateOnAnyCaseIsNone) {
  for (const auto* rays : fast::pixel_ray_methods()) {
    for (const auto* intersect : fast::intersect_methods()) {
      if (rays != &fast::kDirectRays && intersect != &fast::kCross) continue;
      const Candidate candidate = fast_candidate(*rays, *intersect);
      for (const CaseSource& source : case_sources()) {
        for (int severity = 0; severity <= (source.dial ? source.dial->highest : 0); ++severity) {
          std::vector<Case> cases;
          for (std::uint64_t seed = 1; seed <= 5; ++seed)
            cases.push_back(source.make(severity, seed));
          EXPECT_EQ(sentences_for(candidate, cases), Sentences())
              << candidate.name << " " << source.name << severity;
        }
      }
    }
  }
}

}  // namespace
}  // namespace raycheck::properties
