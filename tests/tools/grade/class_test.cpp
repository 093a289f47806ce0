// Hand-ins as a class gives them (tests/submissions/class), graded by the rubric of the
// seventh lecture as they are: each has the score and the sentences that its table says.

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

/// A hand-in, as the class's table has it.
struct HandIn {
  std::string name;
  std::string language;
  bool is_right = false;
  double score = 0;
  std::vector<std::string> sentences;  ///< Of the items that fail, each once, in order.
};

void PrintTo(const HandIn& hand_in, std::ostream* to) { *to << hand_in.name; }

/// Those of the table, which is read by Python, that take long to grade or do not.
std::vector<HandIn> hand_ins(bool are_long) {
  const Outcome read = run_python(
      "-c \"import json, sys, tomllib; "
      "json.dump(tomllib.load(open(sys.argv[1], 'rb')), sys.stdout)\" "
      "tests/submissions/class/class.toml");
  std::vector<HandIn> all;
  const json table = json::parse(read.out);
  for (const json& one : table["hand_in"]) {
    if (one.value("long", false) != are_long) continue;
    all.push_back({one["name"], one["language"], one["faults"].empty(), one["score"], one["says"]});
  }
  return all;
}

class EachHandIn : public testing::TestWithParam<HandIn> {};

TEST_P(EachHandIn, HasItsScoreAndItsSentences) {
  const HandIn& hand_in = GetParam();
  if (hand_in.language == "Java" && !is_installed("javac")) GTEST_SKIP() << "Java is not installed";
  if (hand_in.language == "JavaScript" && !is_installed("node"))
    GTEST_SKIP() << "Node is not installed";
  const Grading grading;
  const Outcome outcome = grading.grade(
      kLecture7, {std::string(RAYCHECK_SOURCE_DIR) + "/tests/submissions/class/" + hand_in.name});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = grading.result(hand_in.name);
  EXPECT_NEAR(result["score"].get<double>(), hand_in.score, 0.005) << outcome.out;
  if (hand_in.is_right) {
    EXPECT_GE(result["score"], result["points"]);
  }
  std::vector<std::string> said;
  for (const json& item : result["items"]) {
    if (item["state"] != "fails") continue;
    for (const json& mistake : item["mistakes"]) {
      const std::string sentence = mistake["sentence"];
      if (std::find(said.begin(), said.end(), sentence) == said.end()) said.push_back(sentence);
    }
  }
  EXPECT_EQ(said, hand_in.sentences) << outcome.out;
}

const auto kName = [](const auto& the_test) { return the_test.param.name; };
INSTANTIATE_TEST_SUITE_P(Class, EachHandIn, testing::ValuesIn(hand_ins(false)), kName);
INSTANTIATE_TEST_SUITE_P(LongClass, EachHandIn, testing::ValuesIn(hand_ins(true)), kName);

}  // namespace
}  // namespace raycheck::tests
