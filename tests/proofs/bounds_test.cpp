// The bounds that decisions stand on, proved by Gappa of the formulas themselves: each script is
// what a formula writes down when it is called.

#include "proofs/bounds.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "tests/library/shell.h"

namespace raycheck::proofs {
namespace {

namespace fs = std::filesystem;

const fs::path kScripts = fs::path(RAYCHECK_SOURCE_DIR) / "proofs";

bool has_gappa() { return tests::shell("command -v gappa").code == 0; }

/// A place of this process: tests run side by side.
fs::path own_path(const std::string& name) {
  return fs::path(testing::TempDir()) / ("raycheck_" + std::to_string(getpid()) + name);
}

/// What Gappa, which gives up by itself, says of a script: nothing where it is proved.
std::string complaint(const std::string& script, const std::string& options = "") {
  const fs::path file = own_path(".gappa");
  std::ofstream(file) << script;
  const tests::Ended ended = tests::shell("gappa " + options + " '" + file.string() + "'");
  fs::remove(file);
  return ended.code == 0 ? ended.text : ended.text + "not proved";
}

/// The script, under a comment that says what it is about.
std::string commented(const Bound& bound) {
  return "# " + std::string(bound.what) + ": " + std::string(bound.where) + "\n" +
         bound.script(bound.value, {}).text();
}

TEST(Bounds, AreProvedOfTheFormulasAsTheyAre) {
  std::set<std::string> names;
  for (const Bound& bound : bounds()) {
    const fs::path file = kScripts / (std::string(bound.name) + ".gappa");
    names.insert(file.filename());
    const std::string script = commented(bound);
    EXPECT_EQ(tests::text_of(file), script) << bound.name;
    if (has_gappa()) {
      EXPECT_EQ(complaint(script), "") << bound.name;
    }
  }
  for (const auto& entry : fs::directory_iterator(kScripts)) {
    if (entry.path().extension() != ".gappa") continue;
    EXPECT_TRUE(names.contains(entry.path().filename())) << entry.path() << " is of no bound";
  }
  if (!has_gappa()) GTEST_SKIP() << "there is no gappa to prove bounds by";
}

/// Whether Gappa reads the script and does not find it proved.
bool is_refused(const std::string& script, const std::string& options) {
  const std::string said = complaint(script, options);
  EXPECT_EQ(said.find("syntax"), std::string::npos) << said << " in " << script;
  return said.find("some properties were not satisfied") != std::string::npos ||
         said.find("no contradiction was found") != std::string::npos;
}

/// Each operation of each formula done otherwise, and each constant halved. Gappa splits no
/// intervals where it need not to prove the formula: what is wrong it would split for a second
/// each.
TEST(LongBounds, AreRefusedOfMutatedFormulas) {
  if (!has_gappa()) GTEST_SKIP() << "there is no gappa to refuse anything";
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

TEST(Bounds, AreNotIdle) {
  for (const Bound& bound : bounds()) {
    const double observed = bound.observed(2000);
    EXPECT_LE(observed, bound.value) << bound.name;
    EXPECT_GE(observed, bound.value / 8) << bound.name;
  }
}

/// Coq checks the proofs that Gappa writes for it. Its library has rounding to doubles, and not
/// Gappa's relative operators, nor its rule for negated doubles.
TEST(LongCoq, ChecksProofsOfDoubleDoubles) {
  if (!has_gappa() || tests::shell("command -v coqc").code != 0) {
    GTEST_SKIP() << "there is no gappa, or no coq, to check proofs by";
  }
  const fs::path folder = own_path("_coq");
  fs::create_directories(folder);
  const std::string folder_first = "cd '" + folder.string() + "' && ";
  for (const std::string name :
       {"double-double-product", "double-double-quotient", "double-double-root"}) {
    const std::string script = (kScripts / (name + ".gappa")).string();
    const tests::Ended ended =
        tests::shell(folder_first + "gappa -Bcoq '" + script + "' > proof.v && coqc -q proof.v");
    EXPECT_EQ(ended.code, 0) << ended.text;
    EXPECT_TRUE(fs::exists(folder / "proof.vo")) << name;
    fs::remove(folder / "proof.vo");
  }
  fs::remove_all(folder);
}

/// The file that the first test compares with, for who changes a formula.
TEST(Bounds, DISABLED_WriteTheirScripts) {
  for (const Bound& bound : bounds()) {
    std::ofstream(kScripts / (std::string(bound.name) + ".gappa")) << commented(bound);
  }
}

}  // namespace
}  // namespace raycheck::proofs
