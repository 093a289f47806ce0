// Hand-ins as a class gives them (tests/submissions/class and fresh), graded by the rubric of the
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

/// A hand-in, as its folder's table has it.
struct HandIn {
  std::string folder;  ///< "class/amelie"
  bool is_right = false;
  double score = 0;
  std::vector<std::string> sentences;  ///< Of the items that fail, each once, in order.
};

void PrintTo(const HandIn& hand_in, std::ostream* to) { *to << hand_in.folder; }

/// The tables, read by Python, which has a reader of TOML.
std::vector<HandIn> hand_ins() {
  std::vector<HandIn> all;
  for (const std::string folder : {"class", "fresh"}) {
    const Outcome read = run_python(
        "-c \"import json, sys, tomllib; "
        "json.dump(tomllib.load(open(sys.argv[1], 'rb')), sys.stdout)\" "
        "tests/submissions/" +
        folder + "/" + folder + ".toml");
    const json table = json::parse(read.out);
    for (const json& one : table["hand_in"]) {
      all.push_back({folder + "/" + one["name"].get<std::string>(), one["faults"].empty(),
                     one["score"], one["says"]});
    }
  }
  return all;
}

class EachHandIn : public testing::TestWithParam<HandIn> {};

TEST_P(EachHandIn, HasItsScoreAndItsSentences) {
  const HandIn& hand_in = GetParam();
  const Grading grading;
  const Outcome outcome = grading.grade(
      kLecture7, {std::string(RAYCHECK_SOURCE_DIR) + "/tests/submissions/" + hand_in.folder});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string name = hand_in.folder.substr(hand_in.folder.find('/') + 1);
  const json result = grading.result(name);
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

INSTANTIATE_TEST_SUITE_P(Class, EachHandIn, testing::ValuesIn(hand_ins()),
                         [](const auto& the_test) {
                           std::string name = the_test.param.folder;
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

}  // namespace
}  // namespace raycheck::tests
