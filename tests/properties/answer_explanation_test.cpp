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

std::vector<std::string> sentences_for(const Candidate& candidate,
                                       const std::vector<Case>& cases = fixed_cases()) {
  std::vector<std::string> sentences;
  for (const Explanation& explanation : explanations(cases, candidate)) {
    EXPECT_GT(explanation.errors, 0u);
    EXPECT_LE(explanation.explained, explanation.errors);
    EXPECT_GE(static_cast<double>(explanation.explained),
              kExplainedShare * static_cast<double>(explanation.errors));
    sentences.push_back(explanation.sentence);
  }
  return sentences;
}

using Sentences = std::vector<std::string>;

TEST(Mistakes, HaveSentencesOfTheirOwn) {
  std::set<std::string> sentences;
  for (const Mistake& mistake : mistakes()) EXPECT_TRUE(sentences.insert(mistake.sentence).second);
  EXPECT_GE(sentences.size(), 60u);
}

class EachMistake : public testing::TestWithParam<std::size_t> {
 protected:
  const Mistake& mistake() const { return mistakes()[GetParam()]; }
};

TEST_P(EachMistake, IsExplainedByItsOwnSentenceAlone) {
  EXPECT_EQ(sentences_for(mistake().candidate), Sentences{mistake().sentence});
}

/// Without the functions before: the mistake shows only in what follows from it.
TEST_P(EachMistake, IsAmongTheExplanationsOfItsRays) {
  if (mistake().stage >= Stage::kIntersect) GTEST_SKIP() << "its rays are right";
  Candidate candidate = mistake().candidate;
  candidate.frame = nullptr;
  candidate.pixel_points = nullptr;
  const auto sentences = sentences_for(candidate);
  EXPECT_TRUE(std::count(sentences.begin(), sentences.end(), mistake().sentence))
      << mistake().sentence << ": " << testing::PrintToString(sentences);
}

TEST_P(EachMistake, IsAmongTheExplanationsOfTheNearestSpheres) {
  if (mistake().stage < Stage::kIntersect) GTEST_SKIP() << "asked about right rays";
  Candidate candidate;
  candidate.nearest = mistake().candidate.nearest;
  const auto& sentence = mistake().sentence;
  if (sentence.starts_with("Q = ") || sentence.starts_with("s is a length")) {
    GTEST_SKIP() << "the nearest sphere stays the nearest";
  }
  const auto sentences = sentences_for(candidate);
  EXPECT_TRUE(std::count(sentences.begin(), sentences.end(), sentence))
      << sentence << ": " << testing::PrintToString(sentences);
}

INSTANTIATE_TEST_SUITE_P(Classic, EachMistake,
                         testing::Range(std::size_t{0}, mistakes().size()));

TEST(AnswerExplanation, OfARightCandidateIsNone) {
  for (const auto* rays : fast::pixel_ray_methods()) {
    for (const auto* intersect : fast::intersect_methods()) {
      if (rays != &fast::kDirectRays && intersect != &fast::kCross) continue;
      const Candidate candidate = fast_candidate(*rays, *intersect);
      EXPECT_EQ(sentences_for(candidate), Sentences()) << candidate.name;
    }
  }
}

}  // namespace
}  // namespace raycheck::properties
