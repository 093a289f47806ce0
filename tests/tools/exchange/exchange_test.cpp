// `raycheck generate | a program | raycheck verify`

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

const std::string kPython =
    "PYTHONPATH=tools/external/sdk/adapters python3 tests/candidates/answers.py";
const std::string kVerify = "'" RAYCHECK_BINARY "' verify ";

Outcome piped(const std::string& generate, const std::string& program,
              const std::string& verify = "--format json") {
  return run("generate " + generate + " | " + program + " | " + kVerify + verify);
}

TEST(Questions, are_answered_rightly) {
  const Outcome outcome = piped("--family distance@3 --cases 100", kPython);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["cases"], 100);
  EXPECT_GT(report["answers"], 100);
  EXPECT_EQ(report["quantities"][0]["name"], "class");
  EXPECT_EQ(report["quantities"][0]["cases"], report["answers"]);
}

TEST(Questions, are_the_same_for_a_seed_and_read_back) {
  const std::string once = run("generate --family tangency@4 --cases 5 --seed 7").out;
  EXPECT_EQ(run("generate --family tangency@4 --cases 5 --seed 7").out, once);
  EXPECT_NE(run("generate --family tangency@4 --cases 5 --seed 8").out, once);
  EXPECT_EQ(once.rfind("tangency@4:7:0:0 ", 0), 0u) << once;
}

TEST(Questions, answered_wrongly_are_discrepancies) {
  const Outcome outcome = piped("--family tangency@2 --cases 50", kPython + " all-hits");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["worst"][0]["wrong"], "false hit");
  EXPECT_EQ(report["worst"][0]["id"].get<std::string>().rfind("tangency@2:", 0), 0u);
}

TEST(Questions, of_a_case_are_answered_all_of_them) {
  const Outcome outcome = piped("--family distance@3 --cases 3", kPython + " | head -n 2");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("not answered"), std::string::npos);
}

TEST(Questions, of_whole_cases_are_missed_where_it_is_said_how_many_there_were) {
  const std::string early = kPython + " | grep -v distance@3:2:";
  EXPECT_EQ(piped("--family distance@3 --cases 3", early).exit_code, 0);
  const Outcome outcome = piped("--family distance@3 --cases 3", early, "--cases 3");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("1 of 3 cases are not answered"), std::string::npos) << outcome.out;
}

TEST(Questions, take_no_other_lines) {
  const auto refused = [](const std::string& line, const std::string& why) {
    const Outcome outcome = piped("--family rays --cases 1", "echo '" + line + "'", "");
    EXPECT_EQ(outcome.exit_code, 2) << line;
    EXPECT_NE(outcome.err.find("line 1: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
  };
  refused("hello", "is no id");
  refused("rays:1:0:0", "an answer is");
  refused("rays:1:0:0 1 2", "an answer is");
  refused("rays:1:0:0 1 2 3 x", "'x' is not a number");
  refused("rays:1:0:99 miss", "there is no such question");
  refused("rays:1:a:0 miss", "'a' is not a whole number");
  refused("nowhere:1:0:0 miss", "nowhere");
  refused("cameras:1:0:0 miss", "have cameras");
  const Outcome none = run("generate --family cameras");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("family cameras: its cases have cameras"), std::string::npos);
  EXPECT_EQ(run("generate --family nowhere").exit_code, 2);
}

}  // namespace
}  // namespace raycheck::tests
