// The identities that formulas and proofs rest on, by a solver of real arithmetic.

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "reference/visibility/visibility_bound.h"
#include "tests/library/shell.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;

const fs::path kIdentities = fs::path(RAYCHECK_SOURCE_DIR) / "proofs/identities";

/// A sign or comparison of each file, and the wrong one, with which there is a counterexample.
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

/// The command of a solver, which gives up after so many steps, on any machine the same; empty
/// where there is none.
std::string solver() {
  if (shell("command -v z3").code == 0) return "z3 rlimit=100000000 ";
  if (shell("command -v cvc5").code == 0) return "cvc5 --rlimit-per=10000000 ";
  return {};
}

TEST(Identities, HoldForAllReals) {
  if (solver().empty()) GTEST_SKIP() << "neither z3 nor cvc5 is there to check identities";
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(kIdentities)) {
    EXPECT_EQ(shell(solver() + "'" + entry.path().string() + "'").text, "unsat\n") << entry.path();
    names.insert(entry.path().stem());
  }
  for (const auto& [name, mistake] : kMistakes) EXPECT_TRUE(names.contains(name)) << name;
  EXPECT_EQ(names.size(), kMistakes.size());
  // The constants of the code's, as the identities have them.
  using namespace reference;
  const std::string by_roots = text_of(kIdentities / "filter_by_roots.smt2"),
                    root = text_of(kIdentities / "filter_root.smt2"),
                    miss = text_of(kIdentities / "filter_miss.smt2");
  EXPECT_TRUE(has(by_roots, fmt::format("(* {} B Eb)", kSquareShare)));
  EXPECT_TRUE(has(by_roots, fmt::format("(* {0} (size ch) Ea) (* {0} rc A)", kProductShare)));
  EXPECT_TRUE(has(root, fmt::format("(* {} x x)", kDecidedBeyond)));
  EXPECT_TRUE(has(root, fmt::format("(- qh q) (* {0} x)) (> (- q qh) (* {0} x))", kRootShare)));
  EXPECT_TRUE(has(miss, fmt::format("(/ S {})", kLeastMoment)));
}

TEST(Identities, AreNotFoundOfWrongSigns) {
  if (solver().empty()) GTEST_SKIP() << "neither z3 nor cvc5 is there to check identities";
  const fs::path changed =
      fs::path(testing::TempDir()) / ("raycheck_" + std::to_string(getpid()) + ".smt2");
  int counterexamples = 0;
  for (const auto& [name, mistake] : kMistakes) {
    const auto& [right, wrong] = mistake;
    std::string text = text_of(kIdentities / (name + ".smt2"));
    const std::size_t at = text.find(right);
    ASSERT_NE(at, std::string::npos) << name;
    ASSERT_EQ(text.find(right, at + 1), std::string::npos) << name;
    std::ofstream(changed) << text.replace(at, right.size(), wrong);
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
}  // namespace raycheck::tests
