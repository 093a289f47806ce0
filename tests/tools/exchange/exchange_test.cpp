// `raycheck generate | a program | raycheck verify`

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

const std::string kPython = "python3 tests/candidates/answers.py";
const std::string kVerify = "'" RAYCHECK_BINARY "' verify ";

/// verify is told what generate was, and more.
Outcome piped(const std::string& generate, const std::string& program,
              const std::string& more = "--format json") {
  return run("generate " + generate + " | " + program + " | " + kVerify + generate + " " + more);
}

/// The same, where it is told something else.
Outcome piped_to_others(const std::string& generate, const std::string& program,
                        const std::string& verify) {
  return run("generate " + generate + " | " + program + " | " + kVerify + verify);
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

TEST(Questions, of_whole_cases_are_missed) {
  const std::string early = kPython + " | grep -v distance@3:2:";
  const Outcome outcome = piped("--family distance@3 --cases 3", early, "");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("1 of 3 cases are not answered: distance@3:2\n"), std::string::npos)
      << outcome.out;
}

TEST(Questions, are_answered_in_any_order) {
  const std::string shuffled = " | sort -R --random-source=/bin/sh";
  const Outcome outcome = piped("--family distance@3 --cases 200", kPython + shuffled);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["cases"], 200);
  const std::string wrong = kPython + " all-hits", many = "--family tangency@2 --cases 50";
  for (const std::string format : {"--top 1000 --format json", "--top 1000"}) {
    EXPECT_EQ(piped(many, wrong + shuffled, format).out, piped(many, wrong, format).out);
  }
  const json report = json::parse(piped(many, wrong).out);
  ASSERT_GT(report["worst"].size(), 5u);
  for (const json& one : report["worst"]) {
    const std::string id = one["id"], ray = one["ray"].dump();
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
  const Outcome good = piped(floats, in_floats);
  EXPECT_EQ(good.exit_code, 0) << good.out << good.err;
  const json report = json::parse(good.out);
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
  EXPECT_EQ(piped_to_others(floats, in_floats, doubles).exit_code, 1);
  const Outcome bad = piped(floats, kPython + " all-hits");
  EXPECT_EQ(bad.exit_code, 1) << bad.out;
}

TEST(Questions, that_floats_cannot_hold_are_not_asked) {
  const std::string wide = "--family scale@190 --cases 10 --precision single";
  const Outcome outcome = piped(wide, kPython);
  EXPECT_EQ(run("generate " + wide).out, "");
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["cases_left_out"], 10);
  EXPECT_EQ(report["cases_missing"], json::array());
  EXPECT_EQ(outcome.exit_code, 4) << outcome.out << outcome.err;  // nothing was judged
}

TEST(HostileAnswers, to_other_questions_do_not_pass) {
  const auto fails = [](const std::string& asked, const std::string& program,
                        const std::string& verify, int code, const std::string& why) {
    const Outcome outcome = piped_to_others(asked, program, verify);
    EXPECT_EQ(outcome.exit_code, code) << outcome.out << outcome.err;
    EXPECT_NE((outcome.out + outcome.err).find(why), std::string::npos)
        << outcome.out << outcome.err;
  };
  const std::string asked = "--family distance@3 --cases 5";
  const std::string not_asked = "' was not asked: the cases are distance@3:1 to distance@3:5";
  // Easier ones, other seeds, more of them, and fewer.
  fails("--family distance@1 --cases 5", kPython, asked, 2,
        "line 1: 'distance@1:1:0:0" + not_asked);
  fails("--family rays --cases 5", kPython, asked, 2, "line 1: 'rays:1:0:0" + not_asked);
  fails("--family distance@3 --cases 5 --seed 2", kPython, asked, 2,
        "'distance@3:6:0:0" + not_asked);
  fails("--family distance@3 --cases 6", kPython, asked, 2, "'distance@3:6:0:0" + not_asked);
  fails("--family distance@3 --cases 4", kPython, asked, 1,
        "1 of 5 cases are not answered: distance@3:5\n");
  // An id that is changed, spelt in another way, extra, said again in its case and after it.
  fails(asked, kPython + " | sed s/3:2:0:0/3:3:0:0/", asked, 2, "it is answered twice");
  fails(asked, kPython + " | sed s/@3:2:/@3:02:/", asked, 2, "'distance@3:02:0:0" + not_asked);
  fails(asked, "(" + kPython + "; echo distance@3:a:0:0 miss)", asked, 2,
        "'distance@3:a:0:0" + not_asked);
  fails(asked, kPython + " | sed p", asked, 2, "it is answered twice");
  fails(asked, "(" + kPython + "; echo distance@3:1:0:0 miss)", asked, 2, "it is answered twice");
  // Without a word of what was asked nothing is verified.
  fails(asked, kPython, "--cases 5", 2, "--family");
}

TEST(HostileAnswers, that_are_missing_are_named) {
  const std::string some = kPython + " | grep -v distance@3:2:";
  const Outcome outcome = piped("--family distance@3 --cases 30", some);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["cases_missing"], json::array({"distance@3:2"}));
  EXPECT_EQ(report["holds"], false);
  const Outcome part = piped("--family distance@3 --cases 30", kPython + " | grep -v ':0:1 '");
  EXPECT_EQ(part.exit_code, 1) << part.err;
  const json of_part = json::parse(part.out);
  EXPECT_EQ(of_part["cases_missing"], json::array());
  ASSERT_GT(of_part["questions_missing"], 0);
  EXPECT_TRUE(of_part["questions_named"][0].get<std::string>().ends_with(":0:1"));
  const Outcome none = piped("--family distance@3 --cases 30", "true");
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_EQ(json::parse(none.out)["cases_missing"].size(), 5u);
}

TEST(HostileAnswers, that_go_on_without_end_are_refused) {
  const Outcome line = piped("--family rays --cases 1", "head -c 1000000 /dev/zero", "");
  EXPECT_EQ(line.exit_code, 2);
  EXPECT_NE(line.err.find("line 1: is longer than 65536 bytes"), std::string::npos) << line.err;
}

TEST(Questions, take_no_other_lines) {
  const auto refused = [](const std::string& line, const std::string& why) {
    const Outcome outcome = piped_to_others("--family rays --cases 1", "echo '" + line + "'",
                                            "--family rays --cases 1");
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
  refused("nowhere:1:0:0 miss", "'nowhere:1:0:0' was not asked");
  refused("cameras:1:0:0 miss", "'cameras:1:0:0' was not asked");
  const Outcome none = run("generate --family cameras");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("family cameras: its cases have cameras"), std::string::npos);
  EXPECT_EQ(run("generate --family nowhere").exit_code, 2);
}

}  // namespace
}  // namespace raycheck::tests
