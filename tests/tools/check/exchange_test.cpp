// `raycheck generate | a program | raycheck verify`

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

const std::string kPython = "python3 tests/candidates/answers.py";

/// Where verify is told what it is to hold answers against.
Outcome piped_to(const std::string& generate, const std::string& program,
                 const std::string& verify) {
  return run("generate " + generate + " | " + program + " | '" RAYCHECK_BINARY "' verify " +
             verify);
}

/// verify is told what generate was; its report.
json piped(const std::string& generate, const std::string& program, int exit_code,
           const std::string& more = "") {
  const Outcome outcome = piped_to(generate, program, generate + " --format json" + more);
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.out << outcome.err;
  return json::parse(outcome.out);
}

TEST(Questions, are_the_same_for_a_seed_and_read_back) {
  const std::string asked = "generate --family tangency@4 --cases 5 --seed ";
  const std::string once = run(asked + "7").out;
  EXPECT_EQ(run(asked + "7").out, once);
  EXPECT_NE(run(asked + "8").out, once);
  EXPECT_EQ(once.rfind("tangency@4:7:0:0 ", 0), 0u) << once;
}

TEST(Questions, answered_wrongly_are_discrepancies_in_any_order) {
  const std::string shuffled = " | sort -R --random-source=/bin/sh";
  EXPECT_EQ(piped("--family distance@3 --cases 200", kPython + shuffled, 0)["cases"], 200);
  const std::string wrong = kPython + " all-hits", many = "--family tangency@2 --cases 50";
  for (const std::string& format : {many + " --top 1000 --format json", many + " --top 1000"}) {
    EXPECT_EQ(piped_to(many, wrong + shuffled, format).out, piped_to(many, wrong, format).out);
  }
  const json report = piped(many, wrong, 1);
  ASSERT_GT(report["worst"].size(), 5u);
  EXPECT_EQ(report["worst"][0]["wrong"], "false hit");
  for (const json& one : report["worst"]) {
    const std::string id = one["id"], ray = one["ray"].dump();
    EXPECT_EQ(id.rfind("tangency@2:", 0), 0u) << id;
    EXPECT_EQ(id.substr(id.rfind(':') + 1), ray);
  }
}

/// Answers of nine digits, as a program in float prints them: the float that each names is judged.
TEST(Questions, of_floats_are_judged_in_their_own_units) {
  const std::string floats = "--family distance@2 --cases 60 --precision single";
  const std::string in_floats =
      kPython +
      " | python3 -c 'import sys\nfor line in sys.stdin:\n"
      "    id, *w = line.split()\n"
      "    print(id, *(x if x == \"miss\" else \"%.9g\" % float(x) for x in w))'";
  const json report = piped(floats, in_floats, 0);
  EXPECT_EQ(report["precision"], "single");
  for (const json& quantity : report["quantities"]) {
    if (quantity["name"] != "parameter") continue;
    EXPECT_EQ(quantity["unit"], "ulp of float");
    EXPECT_LE(quantity["max"], 0.51);  // computed in doubles, rounded once
    EXPECT_GT(quantity["max"], 0.2);
  }
  // The questions are of floats, and so is what is judged: told otherwise, answers are wrong.
  const std::string doubles = "--family distance@2 --cases 60";
  EXPECT_NE(run("generate " + floats).out, run("generate " + doubles).out);
  EXPECT_EQ(piped_to(floats, in_floats, doubles).exit_code, 1);
  piped(floats, kPython + " all-hits", 1);
}

TEST(Questions, that_floats_cannot_hold_are_not_asked) {
  const std::string wide = "--family scale@190 --cases 10 --precision single";
  EXPECT_EQ(run("generate " + wide).out, "");
  const json report = piped(wide, kPython, 4);  // nothing was judged
  EXPECT_EQ(report["cases_left_out"], 10);
  EXPECT_EQ(report["not_answered"], 0);
}

TEST(HostileAnswers, to_other_questions_do_not_pass) {
  const std::string asked = "--family distance@3 --cases 5";
  const std::string not_asked = "' was not asked: the cases are distance@3:1 to distance@3:5";
  for (const auto& [others, program, why] : {
           // Easier ones, other seeds, more of them.
           std::array<std::string, 3>{"--family distance@1 --cases 5", kPython,
                                      "line 1: 'distance@1:1:0:0" + not_asked},
           {"--family rays --cases 5", kPython, "line 1: 'rays:1:0:0" + not_asked},
           {asked + " --seed 2", kPython, "'distance@3:6:0:0" + not_asked},
           {"--family distance@3 --cases 6", kPython, "'distance@3:6:0:0" + not_asked},
           // An id that is changed, spelt in another way, extra, said again in its case and after
           // it.
           {asked, kPython + " | sed s/3:2:0:0/3:3:0:0/", "it is answered twice"},
           {asked, kPython + " | sed s/@3:2:/@3:02:/", "'distance@3:02:0:0" + not_asked},
           {asked, "(" + kPython + "; echo distance@3:a:0:0 miss)",
            "'distance@3:a:0:0" + not_asked},
           {asked, kPython + " | sed p", "it is answered twice"},
           {asked, "(" + kPython + "; echo distance@3:1:0:0 miss)", "it is answered twice"},
           // What is no answer, and what has no end.
           {asked, "echo hello", "line 1: an answer is"},
           {asked, "echo hello miss", "line 1: 'hello" + not_asked},
           {asked, "echo distance@3:1:0:0", "line 1: an answer is"},
           {asked, "echo distance@3:1:0:0 1 2", "line 1: an answer is"},
           {asked, "echo distance@3:1:0:0 1 2 3 x", "line 1: 'x' is not a number"},
           {asked, "echo distance@3:1:0:99 miss", "line 1: 'distance@3:1:0:99" + not_asked},
           {asked, "echo distance@3:1:a:0 miss", "line 1: 'distance@3:1:a:0" + not_asked},
           {asked, "head -c 1000000 /dev/zero", "line 1: an answer is"},
           {asked, "cat /dev/zero", "standard input has more than 134217728 bytes"},
       }) {
    const Outcome outcome = piped_to(others, program, asked);
    EXPECT_EQ(outcome.exit_code, 2) << others << program << outcome.out;
    EXPECT_TRUE(has(outcome.err, why)) << others << program;
  }
  // Without a word of what was asked nothing is verified.
  EXPECT_TRUE(has(piped_to(asked, kPython, "--cases 5").err, "--family"));
}

TEST(HostileAnswers, that_are_missing_are_named) {
  const std::string asked = "--family distance@3 --cases 30";
  const std::string some = kPython + " | grep -v distance@3:2:";
  const json report = piped(asked, some, 1);
  ASSERT_GT(report["not_answered"], 0);
  EXPECT_EQ(report["missing"][0], "distance@3:2:0:0");
  EXPECT_EQ(report["cases"], 29);
  EXPECT_EQ(report["holds"], false);
  EXPECT_TRUE(has(piped_to(asked, some, asked).out, " not answered: distance@3:2:0:0"));
  const json of_part = piped(asked, kPython + " | grep -v ':0:1 '", 1);
  ASSERT_GT(of_part["not_answered"], 0);
  EXPECT_TRUE(of_part["missing"][0].get<std::string>().ends_with(":0:1"));
  EXPECT_EQ(piped(asked, "true", 1)["missing"].size(), 5u);
}

}  // namespace
}  // namespace raycheck::tests
