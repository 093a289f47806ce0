// SARIF, as GitHub's code scanning reads it.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/tools/gates/sarif_schema.h"
#include "tools/gates/gate_views.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;
using tools::Gate;
using tools::GateOutcome;

/// A gate of so many failures, each at a line of its own.
Gate gate_at_lines(std::size_t failures, const std::string& text, const std::string& file) {
  Gate gate;
  gate.command = "check";
  for (std::size_t k = 0; k < failures; ++k) {
    const tools::Identity one = {"class", "rays", "refusal: failed", std::to_string(k), "mine"};
    const properties::CodeLine line = {file, static_cast<std::int64_t>(k + 1), 3, text};
    gate.checks.push_back({"mine",
                           "class/" + std::to_string(k),
                           GateOutcome::kFailed,
                           text,
                           text,
                           {one},
                           {{one, text + "\n", line}}});
  }
  tools::complete(gate, false);
  return gate;
}

TEST(Sarif, HasWhatGitHubAsksForOfEachLine) {
  const json log = json::parse(sarif(gate_at_lines(3, "why", "src/my tracer.cpp")));
  EXPECT_EQ(defect_of_log(log), "");
  const json& results = log["runs"][0]["results"];
  ASSERT_EQ(results.size(), 3u);
  std::set<std::string> fingerprints;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const json& place = results[k]["locations"][0]["physicalLocation"];
    EXPECT_EQ(place["artifactLocation"]["uri"], "src/my%20tracer.cpp");
    EXPECT_EQ(place["artifactLocation"]["uriBaseId"], "%SRCROOT%");
    EXPECT_EQ(place["region"]["startLine"], k + 1);
    fingerprints.insert(results[k]["partialFingerprints"]["primaryLocationLineHash"]);
  }
  EXPECT_EQ(fingerprints.size(), 3u);
}

TEST(Sarif, IsHeldToASchemaThatSeesWhatIsMissingOrOther) {
  const json right = json::parse(sarif(gate_at_lines(2, "why", "tracer.cpp")));
  ASSERT_EQ(defect_of_log(right), "");
  const std::string result = "/runs/0/results/0";
  for (const char* const key :
       {"/version", "/runs", "/runs/0/tool", "/runs/0/tool/driver/name", "/runs/0/results",
        "/runs/0/tool/driver/rules", "/runs/0/tool/driver/rules/0/id",
        "/runs/0/tool/driver/rules/0/shortDescription/text",
        "/runs/0/tool/driver/rules/0/help/text", "/runs/0/results/0/ruleId",
        "/runs/0/results/0/message/text", "/runs/0/results/0/locations",
        "/runs/0/results/0/locations/0/physicalLocation/artifactLocation/uri",
        "/runs/0/results/0/locations/0/physicalLocation/region/startLine",
        "/runs/0/results/0/partialFingerprints/primaryLocationLineHash"}) {
    json without = right;
    const json::json_pointer pointer{std::string(key)};
    without[pointer.parent_pointer()].erase(pointer.back());
    EXPECT_NE(defect_of_log(without), "") << key;
  }
  const std::vector<std::pair<std::string, json>> others = {
      {"/version", "2.0.0"},
      {result + "/ruleId", 1},
      {result + "/ruleId", "another"},
      {result + "/ruleIndex", 7},
      {result + "/message/text", ""},
      {result + "/locations", json::array()},
      {result + "/locations/0/physicalLocation/region/startLine", 0},
      {result + "/locations/0/physicalLocation/region/startLine", "1"},
      {result + "/locations/0/physicalLocation/artifactLocation/uri", "a b"},
      {result + "/locations/0/physicalLocation/artifactLocation/uri", "/root.cpp"},
      {result + "/more", "than is known"}};
  for (const auto& [key, value] : others) {
    json other = right;
    other[json::json_pointer(key)] = value;
    EXPECT_NE(defect_of_log(other), "") << key << " " << value;
  }
}

TEST(Sarif, KnowsALineAgainWhereItHasMoved) {
  const auto fingerprint = [](std::int64_t line, const std::string& text) {
    Gate gate = gate_at_lines(1, "why", "tracer.cpp");
    gate.checks[0].failed[0].line = {"tracer.cpp", line, 3, text};
    return json::parse(sarif(gate))["runs"][0]["results"][0]["partialFingerprints"];
  };
  EXPECT_EQ(fingerprint(3, "x / y"), fingerprint(30, "x / y"));
  EXPECT_NE(fingerprint(3, "x / y"), fingerprint(3, "x / z"));
}

TEST(Sarif, HasALineOnceHoweverManyChecksFailThere) {
  Gate gate = gate_at_lines(9, "why", "tracer.cpp");
  for (std::size_t k = 0; k < 9; ++k) gate.checks[k].failed[0].line->line = 7;
  const json results = json::parse(sarif(gate))["runs"][0]["results"];
  ASSERT_EQ(results.size(), 1u);
  EXPECT_NE(results[0]["message"]["text"].get<std::string>().find(
                "fails there: class/0, class/1, class/2, class/3, class/4 and 4 more"),
            std::string::npos)
      << results[0];
}

TEST(Sarif, LeavesOutWhatIsKnownAndSaysWhatHasNoLine) {
  Gate gate = gate_at_lines(4, "why", "tracer.cpp");
  gate.ratchet.emplace();
  gate.ratchet->known = gate.checks[0].defects;
  gate.checks[1].failed[0].line.reset();
  gate.checks[2].failed.clear();
  EXPECT_EQ(json::parse(sarif(gate))["runs"][0]["results"].size(), 1u);
  const std::vector<std::string> warnings = sarif_warnings(gate);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].find("2 of 3 defects not in the SARIF log: 1 wrong answer, which no one "
                             "line makes; 1 failure at no line"),
            0u)
      << warnings[0];
  EXPECT_TRUE(sarif_warnings(gate_at_lines(2, "why", "tracer.cpp")).empty());
}

TEST(HostileSarif, HasNoMoreResultsThanGitHubTakesAndSaysSo) {
  const Gate gate = gate_at_lines(25'001, "why", "tracer.cpp");
  const json log = json::parse(sarif(gate));
  EXPECT_EQ(log["runs"][0]["results"].size(), 25'000u);
  ASSERT_EQ(sarif_warnings(gate).size(), 1u);
  EXPECT_EQ(sarif_warnings(gate)[0], "the SARIF log has the first 25000 of 25001 lines");
}

TEST(HostileSarif, KeepsTextsOfOthersInTheirStrings) {
  const std::string hostile =
      "\"}],\"x\":[{\n::error::mine\n##[error]mine\x1b[31m\x01\xff \u202e</script>";
  const std::string text = sarif(gate_at_lines(1, hostile, "\"a\n%41\xff: b.cpp"));
  EXPECT_EQ(defect_of_log(json::parse(text)), "") << text;
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace raycheck::tests
