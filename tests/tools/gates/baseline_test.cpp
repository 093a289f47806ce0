// The ratchet: what is known may stay, what is new fails, what is mended is said.

#include "tools/gates/baseline.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/tools/limited_run.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using tools::Baseline;
using tools::Findings;
using tools::Identity;
using tools::Ratchet;
namespace fs = std::filesystem;

Identity identity(const std::string& law, const std::string& kind = "class: missed") {
  return {law, "rays", kind, "ordinary", "mine; #1 100%"};
}

Findings findings(const std::set<Identity>& found, const std::set<Identity>& asked) {
  Findings all;
  all.found = found;
  for (const Identity& one : asked) all.asked.insert(scope_of(one));
  for (const Identity& one : found) all.asked.insert(scope_of(one));
  all.complete = all.asked;
  return all;
}

TEST(Baseline, IsTheSameReadAgain) {
  const Baseline first = updated({}, findings({identity("class"), identity("root")}, {}));
  const std::string text = baseline_text(first);
  const Baseline again = tools::parse_baseline(text);
  EXPECT_EQ(again.known, first.known);
  EXPECT_EQ(baseline_text(again), text);
  EXPECT_TRUE(tools::parse_baseline("").known.empty());
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(tools::parse_baseline(windows).known, first.known);
}

TEST(Baseline, NamesTheLineThatIsWrong) {
  const auto error_of = [](const std::string& text) -> std::string {
    try {
      tools::parse_baseline(text);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(error_of("# raycheck baseline 1\nclass; rays\n").find("line 2: 2 fields"),
            std::string::npos);
  EXPECT_NE(error_of("a; b; c; d; \n").find("line 1: field 5 is empty"), std::string::npos);
  EXPECT_NE(error_of("a; b; c; d; %41\n").find("line 1: '%41'"), std::string::npos);
  EXPECT_NE(error_of("<<<<<<< HEAD\n").find("git left a conflict"), std::string::npos);
}

TEST(Baseline, FailsForWhatIsNewAlsoWhereAsMuchIsMended) {
  const Identity a = identity("class"), b = identity("root");
  const Baseline baseline = updated({}, findings({a}, {}));
  const Ratchet same = compare(baseline, findings({a}, {a, b}));
  EXPECT_FALSE(same.fails());
  EXPECT_EQ(same.known, std::vector{a});
  const Ratchet swapped = compare(baseline, findings({b}, {a, b}));
  EXPECT_TRUE(swapped.fails());
  EXPECT_EQ(swapped.added, std::vector{b});
  EXPECT_EQ(swapped.mended, std::vector{a});
  Ratchet mended = compare(baseline, findings({}, {a}));
  EXPECT_FALSE(mended.fails());
  mended.strict = true;
  EXPECT_TRUE(mended.fails());
  // What was not asked is not mended, and stays.
  EXPECT_TRUE(compare(baseline, findings({}, {b})).mended.empty());
  EXPECT_EQ(compare(baseline, findings({}, {b})).unasked, std::vector{a});
  EXPECT_TRUE(compare(baseline, findings({}, {a})).unasked.empty());
  EXPECT_EQ(updated(baseline, findings({}, {b})).known, baseline.known);
  EXPECT_TRUE(updated(baseline, findings({}, {a})).known.empty());
  // Another way of being wrong at the same place is new.
  EXPECT_TRUE(compare(baseline, findings({identity("class", "class: false hit")}, {a})).fails());
}

/// Two branches that mend different laws, merged by git as it is installed.
TEST(Baseline, OfTwoBranchesThatMendDifferentThingsIsMergedByGit) {
  const Identity a = identity("class"), b = identity("root"), c = identity("hit-point");
  const Baseline before = updated({}, findings({a, b, c}, {}));
  const TestFolder its;
  const fs::path folder = its.path();
  const auto git = [&](const std::string& arguments) {
    return std::system(("GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null git -c "
                        "user.name=a -c user.email=a@example.org -C " +
                        folder.string() + " " + arguments + " > /dev/null 2>&1")
                           .c_str());
  };
  if (git("--version") != 0) GTEST_SKIP() << "git is not installed";
  const auto write = [&](const Baseline& baseline) {
    std::ofstream(folder / "known") << baseline_text(baseline);
  };
  ASSERT_EQ(git("init -b main"), 0);
  write(before);
  ASSERT_EQ(git("add known") + git("commit -m before") + git("checkout -b other"), 0);
  write(updated(before, findings({}, {b})));
  ASSERT_EQ(git("commit -am other") + git("checkout main"), 0);
  write(updated(before, findings({}, {a})));
  ASSERT_EQ(git("commit -am mine"), 0);
  EXPECT_EQ(git("merge other"), 0) << contents(folder / "known");
  const Baseline merged = tools::parse_baseline(contents(folder / "known"));
  EXPECT_EQ(merged.known, std::set{c});
  EXPECT_EQ(baseline_text(merged), contents(folder / "known"));
}

/// The whole way of one candidate: known, otherwise wrong, mended.
class BaselineOfARun : public testing::Test {
 protected:
  BaselineOfARun() {
    fs::copy_file(fs::path(RAYCHECK_SOURCE_DIR) / "tests/candidates/right.py",
                  folder_ + "/right.py");
  }
  std::string known() const { return folder_ + "/known"; }

  /// Asks the candidate, which ends in this way whatever it found.
  Outcome gate(const std::string& ending, const std::string& options) const {
    std::ofstream(folder_ + "/mine.py")
        << "import raycheck_candidate as rc\nimport right\n"
           "def intersect(ray, sphere, asked):\n"
           "    hit = right.intersect(ray, sphere, asked)\n"
        << "    " << ending << "\nrc.run('mine', intersect=intersect)\n";
    return run("properties --filter class --cases 60 --source rays --candidate 'command:python3 " +
               folder_ + "/mine.py' --baseline " + known() + " " + options);
  }

  const TestFolder its_;
  const std::string folder_ = its_.path();
};

TEST_F(BaselineOfARun, LetsPassWhatIsKnownAndNothingElse) {
  const std::string misses = "return None", right = "return hit";
  const std::string hits = "return hit or (1.0, (0.0, 0.0, 0.0))";
  const Outcome none = gate(misses, "");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("--update-baseline makes it"), std::string::npos) << none.err;
  EXPECT_EQ(gate(misses, "--update-baseline").exit_code, 0);
  const std::string first = contents(known());
  EXPECT_NE(first.find("\n# class; rays\nclass; rays; class: missed; ordinary; command:python3 "),
            std::string::npos)
      << first;
  EXPECT_EQ(gate(misses, "--strict-baseline").exit_code, 0);
  EXPECT_EQ(gate(misses, "--update-baseline").exit_code, 0);
  EXPECT_EQ(contents(known()), first);

  const Outcome swapped = gate(hits, "");
  EXPECT_EQ(swapped.exit_code, 1);
  EXPECT_NE(swapped.out.find(": 0 known, 1 new, 0 mended\n  new: class on rays, ordinary, class: "
                             "false hit"),
            std::string::npos)
      << swapped.out;

  const Outcome mended = gate(right, "");
  EXPECT_EQ(mended.exit_code, 0);
  EXPECT_NE(mended.out.find(": 0 known, 0 new, 1 mended (--update-baseline)"), std::string::npos)
      << mended.out;
  EXPECT_EQ(gate(right, "--strict-baseline").exit_code, 1);
  EXPECT_EQ(gate(right, "--update-baseline --strict-baseline").exit_code, 0);
  EXPECT_EQ(contents(known()),
            "# raycheck baseline 1: discrepancies that are known, see docs/ci.md\n"
            "# class; rays\n");
  EXPECT_EQ(gate(misses, "").exit_code, 1);
}

TEST_F(BaselineOfARun, MarksKnownFailuresAsSkippedInJunit) {
  EXPECT_EQ(gate("return None", "--update-baseline").exit_code, 0);
  const Outcome outcome = gate("return None", "--format junit");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("failures=\"0\""), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("<skipped type=\"known\""), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace raycheck::tests
