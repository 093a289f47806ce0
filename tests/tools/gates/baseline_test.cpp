// Baselines: known discrepancies may stay, new ones fail, and those that no longer occur are
// reported.

#include "tools/gates/baseline.h"

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using tools::Baseline;
using tools::Findings;
using tools::Identity;

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

TEST(Baseline, SurvivesWritingAndReading) {
  const Baseline first = updated({}, findings({identity("class"), identity("root")}, {}));
  const std::string text = baseline_text(first);
  const Baseline again = tools::parse_baseline(text);
  EXPECT_EQ(again.known, first.known);
  EXPECT_EQ(baseline_text(again), text);
  EXPECT_TRUE(tools::parse_baseline("").known.empty());
  Identity all_bytes = identity("class");
  for (int byte = 0; byte < 256; ++byte) all_bytes.source += static_cast<char>(byte);
  all_bytes.candidate = "\xC3\xA4 \xE2\x80\xAE \xED\xA0\x80 \xF0\x9F\x8E\xB2%41; \r\n";
  const std::string spelled = baseline_text(updated({}, findings({all_bytes}, {})));
  EXPECT_EQ(tools::parse_baseline(spelled).known, std::set{all_bytes});
  EXPECT_TRUE(has(spelled, "; \xC3\xA4 %E2%80%AE %ED%A0%80 \xF0\x9F\x8E\xB2%2541%3B %0D%0A\n"));
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(tools::parse_baseline(windows).known, first.known);
}

TEST(Baseline, ErrorsNameTheLine) {
  const std::string fields = "a; b; c; d; ", no_byte = ": expected % and two hexadecimal";
  for (const auto& [text, why] : std::vector<std::pair<std::string, std::string>>{
           {"# raycheck baseline 2\nclass; rays\n", "line 2: it is not of the form"},
           {fields + "\n", "line 1: field 5 is empty"},
           {fields + "%4\n", "line 1: '%4'" + no_byte},
           {fields + "%\n", "line 1: '%'" + no_byte},
           {fields + "%4g\n", "line 1: '%4g'" + no_byte},
           {fields + "%+1\n", "line 1: '%+1'" + no_byte},
           {"# raycheck baseline 1: discrepancies\n", "line 1: the file has an older"},
           {"<<<<<<< HEAD\n", "a merge conflict of git"}}) {
    EXPECT_TRUE(has(thrown_by([&text = text] { tools::parse_baseline(text); }), why));
  }
}

/// BaselineOfARun tests the known, new and mended discrepancies of runs.
TEST(Baseline, KeepsUnjudgedEntriesAndReportsOtherKindsAsNew) {
  const Identity a = identity("class"), b = identity("root");
  const Baseline baseline = updated({}, findings({a}, {}));
  EXPECT_TRUE(compare(baseline, findings({}, {b})).mended.empty());
  EXPECT_EQ(compare(baseline, findings({}, {b})).unasked, std::vector{a});
  EXPECT_TRUE(compare(baseline, findings({}, {a})).unasked.empty());
  EXPECT_EQ(updated(baseline, findings({}, {b})).known, baseline.known);
  EXPECT_TRUE(updated(baseline, findings({}, {a})).known.empty());
  EXPECT_TRUE(compare(baseline, findings({identity("class", "class: false hit")}, {a})).fails());
}

/// Merges two branches that fix different discrepancies by the installed git.
TEST(Baseline, MergesByGitWhenTwoBranchesMendDifferentThings) {
  const Identity a = identity("class"), b = identity("root"), c = identity("hit-point");
  const Baseline before = updated({}, findings({a, b, c}, {}));
  const fs::path folder = temporary_folder("merged");
  const auto git = [&](const std::string& arguments) {
    return run_bash(
               "GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null git -c user.name=a -c "
               "user.email=a@example.org -C " +
               folder.string() + " " + arguments)
        .exit_code;
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

/// One candidate's discrepancies: known, then of another kind, then mended.
class BaselineOfARun : public testing::Test {
 protected:
  std::string known() const { return folder_ + "/known"; }

  /// Judges the candidate; the command must end in this way.
  Outcome gate(const std::string& ending, const std::string& options, int exit_code) const {
    std::string text = contents(RAYCHECK_SOURCE_DIR "/tests/candidates/float_quadratic.cpp");
    text.resize(text.find("RAYCHECK_CANDIDATE("));
    const std::string source =
        write(std::to_string(std::hash<std::string>()(ending)) + ".cpp", text + R"(
static std::optional<Hit> mine(const Ray& ray, const Sphere& sphere, const Conventions& asked) {
  const auto hit = intersect(ray, sphere, asked);
  )" + ending + R"(
}
RAYCHECK_CANDIDATE(.name = "mine", .intersect = mine, .precision = Precision::single)
)");
    fs::copy_file(compiled(source).substr(std::string("library:").size()), folder_ + "/mine.so",
                  fs::copy_options::overwrite_existing);
    return run("properties --filter class --cases 60 --source rays --candidate library:" + folder_ +
                   "/mine.so --baseline " + known() + " " + options,
               exit_code);
  }

  /// Judges the candidate on a scene.
  Outcome check(const std::string& scene, const std::string& candidate, const std::string& options,
                int exit_code) const {
    return run("check '" + scene + "' --candidate '" + candidate + "' --baseline " + known() + " " +
                   options,
               exit_code);
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + "/" + name) << text;
    return folder_ + "/" + name;
  }

  const std::string folder_ = temporary_folder("baseline");
};

TEST_F(BaselineOfARun, CallsACandidateWithoutANameByItsFile) {
  const std::string source = write("never.cpp", R"(#include <raycheck/candidate.hpp>
using namespace raycheck;
static std::optional<Hit> never(const Ray&, const Sphere&, const Conventions&) { return {}; }
RAYCHECK_CANDIDATE(.intersect = never)
)");
  run("properties --filter class --cases 60 --source rays --candidate source:" + source +
          " --baseline " + known() + " --update-baseline",
      0);
  EXPECT_TRUE(has(contents(known()), "\nclass; rays; class: missed; ordinary; never.cpp\n"));
}

TEST_F(BaselineOfARun, PassesOnlyKnownDiscrepancies) {
  const std::string misses = "return {};", right = "return hit;";
  const std::string hits = "return hit ? hit : Hit{1, {}};";
  const Outcome none = gate(misses, "", 2);
  EXPECT_TRUE(has(none.err, "--update-baseline creates it"));
  gate(misses, "--update-baseline", 0);
  const std::string first = contents(known());
  EXPECT_TRUE(has(first, "\n# class; rays\nclass; rays; class: missed; ordinary; mine\n"));
  const Outcome known_alone = gate(misses, "--strict-baseline --format junit", 0);
  expect_parts(known_alone.out, {"failures=\"0\"", "<skipped type=\"known\""});
  gate(misses, "--update-baseline", 0);
  EXPECT_EQ(contents(known()), first);

  const Outcome swapped = gate(hits, "", 1);
  EXPECT_TRUE(has(swapped.out,
                  ": 0 known, 1 new, 0 fixed\n  new: class on rays, ordinary (class: "
                  "false hit), mine"));

  const Outcome mended = gate(right, "", 0);
  EXPECT_TRUE(has(mended.out, ": 0 known, 0 new, 1 fixed (--update-baseline)"));
  gate(right, "--strict-baseline", 1);
  gate(right, "--update-baseline --strict-baseline", 0);
  EXPECT_EQ(contents(known()),
            "# raycheck baseline 2: discrepancies that are known, see docs/ci.md\n"
            "# class; rays\n");
  gate(misses, "", 1);
}

TEST_F(BaselineOfARun, IdentifiesCandidatesAndScenesHoweverTheyAreTyped) {
  const std::string by_python = "renderer:python3 ", mirrored = " upside-down {scene} {image}";
  const std::string renderer = by_python + "tests/candidates/rt.py" + mirrored;
  const std::string scene = "scene/examples/probe.toml";
  check(scene, renderer, "", 2);
  check(scene, renderer, "--update-baseline", 0);
  EXPECT_TRUE(has(contents(known()), "; python3 rt.py upside-down {scene} {image}\n"));
  for (const std::string folder : {".", RAYCHECK_SOURCE_DIR, "tests/.."}) {
    check(folder + "/" + scene, by_python + folder + "/tests/candidates/rt.py" + mirrored, "", 0);
  }
  // Two candidates with the same name are identified as the user typed them.
  const std::string twice =
      renderer + "' --candidate '" + by_python + "./tests/candidates/rt.py" + mirrored;
  check(scene, twice, "", 1);
}

TEST_F(BaselineOfARun, AcceptsPathsOfAnyBytes) {
  const std::string folder = folder_ + "/\n\x1b[31m\xff; #%41";
  fs::create_directories(folder);
  fs::copy_file(fs::path(RAYCHECK_SOURCE_DIR) / "scene/examples/probe.toml",
                folder + "/probe.toml");
  const std::string renderer =
      "renderer:python3 tests/candidates/rt.py upside-down {scene} {image}";
  check(folder + "/probe.toml", renderer, "--update-baseline", 0);
  check(folder + "/probe.toml", renderer, "", 0);
}

TEST_F(BaselineOfARun, AcceptsUndecidedAndJunitReportsThem) {
  // The ray begins on the rounded sphere: a hit there is right for only one radius.
  const std::string scene =
      write("scene.toml", "[conventions]\nroot = \"smaller\"\n" +
                              sphere_text("0, 0.6, 0.7", "0.9219544457292888") +
                              ray_text("0, 0, 0", "1, 0, 0"));
  const std::string mine =
      "command:python3 " +
      write("mine.py",
            "import raycheck_candidate as rc\n"
            "rc.run('mine', intersect=lambda ray, sphere, asked: (0.0, (0.0, 0.0, 0.0)))\n");
  EXPECT_EQ(run("check '" + scene + "' --candidate '" + mine + "'").exit_code, 4);
  write("known", "");
  const Outcome unknown = check(scene, mine, "--format junit", 4);
  expect_parts(unknown.out,
               {"errors=\"1\"", "<error type=\"inconclusive\" message=\"1 answer undecided\">"});
  EXPECT_FALSE(has(unknown.out, "nothing was judged"));
  check(scene, mine, "--update-baseline", 0);
  EXPECT_TRUE(has(contents(known()), "; class: false hit, undecided; sphere 0; mine\n"));
  const Outcome known = check(scene, mine, "--format junit", 0);
  EXPECT_TRUE(has(known.out, "<skipped type=\"known\" message=\"1 answer undecided\">"));
  // With --strict it is a defect, which the baseline has only as undecided.
  check(scene, mine, "--strict", 1);
}

}  // namespace
}  // namespace raycheck::tests
