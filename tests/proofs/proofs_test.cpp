// Proves the bounds on which decisions rely, by Gappa, for the code's formulas; calling a formula
// records its script. Proves the identities on which formulas and proofs rely, by a solver for real
// arithmetic.

#include <fmt/core.h>
#include <unistd.h>

#include "proofs/bounds.h"
#include "reference/visibility/visibility_bound.h"
#include "tests/library/shell.h"

namespace raycheck::proofs {
namespace {

using namespace tests;
namespace fs = std::filesystem;

const fs::path kScripts = fs::path(RAYCHECK_SOURCE_DIR) / "proofs";

bool has_gappa() { return shell("command -v gappa").code == 0; }

/// A path for this process only, since tests run in parallel.
fs::path own_path(const std::string& name) {
  return fs::path(testing::TempDir()) / ("raycheck_" + std::to_string(getpid()) + name);
}

/// Gappa's output for a script; empty if the script is proved. (Gappa gives up by itself.)
std::string complaint(const std::string& script, const std::string& options = "") {
  const fs::path file = own_path(".gappa");
  std::ofstream(file) << script;
  const Ended ended = shell("gappa " + options + " '" + file.string() + "'");
  fs::remove(file);
  return ended.code == 0 ? ended.text : ended.text + "not proved";
}

/// A bound's script, after a comment that names the bound and the formula's file.
std::string commented(const Bound& bound) {
  return "# " + std::string(bound.what) + ": " + std::string(bound.where) + "\n" +
         bound.script(bound.value, {}).text();
}

TEST(Bounds, AreProvedForTheFormulas) {
  std::set<std::string> names;
  for (const Bound& bound : bounds()) {
    const fs::path file = kScripts / (std::string(bound.name) + ".gappa");
    names.insert(file.filename());
    const std::string script = commented(bound);
    EXPECT_EQ(contents(file), script) << bound.name;
    if (has_gappa()) {
      EXPECT_EQ(complaint(script), "") << bound.name;
    }
  }
  for (const auto& entry : fs::directory_iterator(kScripts)) {
    if (entry.path().extension() != ".gappa") continue;
    EXPECT_TRUE(names.contains(entry.path().filename()))
        << entry.path() << " does not belong to a bound";
  }
  if (!has_gappa()) GTEST_SKIP() << "gappa is not installed";
}

/// Whether Gappa reads the script but cannot prove it.
bool is_refused(const std::string& script, const std::string& options) {
  const std::string said = complaint(script, options);
  EXPECT_EQ(said.find("syntax"), std::string::npos) << said << " in " << script;
  return said.find("some properties were not satisfied") != std::string::npos ||
         said.find("no contradiction was found") != std::string::npos;
}

/// Replaces each operation of each formula, and halves each constant. Gappa may not split intervals
/// if the right formula needs no splits, since it would spend a second on each wrong formula.
TEST(LongBounds, AreNotProvedForMutatedFormulas) {
  if (!has_gappa()) GTEST_SKIP() << "gappa is not installed";
  int mutants = 0;
  for (const Bound& bound : bounds()) {
    const Script script = bound.script(bound.value, {});
    const std::string whole = "-Eno-auto-dichotomy";
    const std::string options = complaint(script.text(), whole).empty() ? whole : "";
    EXPECT_TRUE(is_refused(bound.script(bound.value / 2, {}).text(), options))
        << bound.name << " halved";
    for (const std::size_t operation : script.operations()) {
      const std::string mutant = bound.script(bound.value, Mutation{operation}).text();
      ASSERT_NE(mutant, script.text()) << bound.name;
      EXPECT_TRUE(is_refused(mutant, options)) << bound.name << " with " << mutant;
      ++mutants;
    }
  }
  EXPECT_GE(mutants, 100);
}

TEST(Bounds, AreNearObservedErrors) {
  for (const Bound& bound : bounds()) {
    const double observed = bound.observed(2000);
    EXPECT_LE(observed, bound.value) << bound.name;
    EXPECT_GE(observed, bound.value / 8) << bound.name;
  }
}

/// Coq checks the proofs that Gappa writes for it. Its library has rounding to doubles, but not
/// Gappa's relative operators, nor its rule for negated doubles.
TEST(LongCoq, ChecksProofsOfDoubleDoubles) {
  if (!has_gappa() || shell("command -v coqc").code != 0) {
    GTEST_SKIP() << "gappa or coq is not installed";
  }
  const fs::path folder = own_path("_coq");
  fs::create_directories(folder);
  const std::string folder_first = "cd '" + folder.string() + "' && ";
  for (const std::string name :
       {"double-double-product", "double-double-quotient", "double-double-root"}) {
    const std::string script = (kScripts / (name + ".gappa")).string();
    const Ended ended =
        shell(folder_first + "gappa -Bcoq '" + script + "' > proof.v && coqc -q proof.v");
    EXPECT_EQ(ended.code, 0) << ended.text;
    EXPECT_TRUE(fs::exists(folder / "proof.vo")) << name;
    fs::remove(folder / "proof.vo");
  }
  fs::remove_all(folder);
}

/// Writes the files with which the first test compares. Run it after a change of a formula.
TEST(Bounds, DISABLED_WriteTheirScripts) {
  for (const Bound& bound : bounds()) {
    std::ofstream(kScripts / (std::string(bound.name) + ".gappa")) << commented(bound);
  }
}

const fs::path kIdentities = fs::path(RAYCHECK_SOURCE_DIR) / "proofs/identities";

/// A sign, number or comparison in each file, and a wrong one, for which there is a counterexample.
const std::map<std::string, std::pair<std::string, std::string>> kMistakes = {
    {"filter_by_moment", {"(* 4 S e1)", "(* 3 S e1)"}},
    {"filter_by_roots", {"(* 2.2 B Eb)", "(* 1.1 B Eb)"}},
    {"filter_miss", {"(/ S 8)", "S"}},
    {"filter_root", {"(* 0.51 x)) (>", "(* 0.5 x)) (>"}},
    {"hit_point", {"(- (dot Tx Ty Tz Tx Ty Tz) (* v v))", "(+ (dot Tx Ty Tz Tx Ty Tz) (* v v))"}},
    {"lagrange", {"(- (* a r r) (dot mx", "(+ (* a r r) (dot mx"}},
    {"newton_slope", {"(* 4 (- (* b b)", "(* 4 (+ (* b b)"}},
    {"newton_step", {"(- (* a (- s0 s)", "(+ (* a (- s0 s)"}},
    {"pixel_distance", {"(- (dot Ux Uy Uz Ux Uy Uz) 1)", "(+ (dot Ux Uy Uz Ux Uy Uz) 1)"}},
    {"roots_by_q", {"(* a smaller) (- b h)) (= (+", "(* a smaller) (+ b h)) (= (+"}},
    {"second_axis", {"(- (* px Wy) (* py Wx))", "(+ (* px Wy) (* py Wx))"}},
    {"signs_of_roots", {"(< b 0)) (< larger 0)", "(< b 0)) (> larger 0)"}},
    {"third_axis", {"(- (* Wy Uz) (* Wz Uy))", "(+ (* Wy Uz) (* Wz Uy))"}},
};

/// The command of a solver with a limit on steps, which is the same on every machine; empty if no
/// solver is installed.
std::string solver() {
  if (shell("command -v z3").code == 0) return "z3 rlimit=100000000 ";
  if (shell("command -v cvc5").code == 0) return "cvc5 --rlimit-per=10000000 ";
  return {};
}

TEST(Identities, HoldForAllReals) {
  if (solver().empty()) GTEST_SKIP() << "neither z3 nor cvc5 is installed";
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(kIdentities)) {
    EXPECT_EQ(shell(solver() + "'" + entry.path().string() + "'").text, "unsat\n") << entry.path();
    names.insert(entry.path().stem());
  }
  for (const auto& [name, mistake] : kMistakes) EXPECT_TRUE(names.contains(name)) << name;
  EXPECT_EQ(names.size(), kMistakes.size());
  // The identities use these constants of the code.
  using namespace reference;
  const std::string by_roots = contents(kIdentities / "filter_by_roots.smt2"),
                    root = contents(kIdentities / "filter_root.smt2"),
                    miss = contents(kIdentities / "filter_miss.smt2");
  EXPECT_TRUE(has(by_roots, fmt::format("(* {} B Eb)", kSquareShare)));
  EXPECT_TRUE(has(by_roots, fmt::format("(* {0} (size ch) Ea) (* {0} rc A)", kProductShare)));
  EXPECT_TRUE(has(root, fmt::format("(* {} x x)", kDecidedBeyond)));
  EXPECT_TRUE(has(root, fmt::format("(- qh q) (* {0} x)) (> (- q qh) (* {0} x))", kRootShare)));
  EXPECT_TRUE(has(miss, fmt::format("(/ S {})", kLeastMoment)));
}

TEST(Identities, FailWithWrongSigns) {
  if (solver().empty()) GTEST_SKIP() << "neither z3 nor cvc5 is installed";
  const fs::path changed = own_path(".smt2");
  int counterexamples = 0;
  for (const auto& [name, mistake] : kMistakes) {
    const auto& [right, wrong] = mistake;
    const std::string text = contents(kIdentities / (name + ".smt2"));
    ASSERT_EQ(text.find(right), text.rfind(right)) << name;
    std::ofstream(changed) << replaced(text, right, wrong);
    const std::string found = shell(solver() + "'" + changed.string() + "'").text;
    EXPECT_TRUE(found == "sat\n" || found == "unknown\n") << name << ": " << found;
    counterexamples += found == "sat\n" ? 1 : 0;
  }
  fs::remove(changed);
  if (solver().starts_with("z3")) {
    EXPECT_EQ(counterexamples, static_cast<int>(kMistakes.size()));
  }
}

}  // namespace
}  // namespace raycheck::proofs
