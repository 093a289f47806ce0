// Submissions all in `float`, functions and renderers, where doubles are asked for and where floats
// are fine.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

/// The items that a submission in floats loses by the lecture's rubric, changed.
Names lost(const std::string& file, const std::string& form,
           const std::vector<std::pair<std::string, std::string>>& changes) {
  const Grading grading;
  const std::string rubric = grading.lecture7_with(changes);
  const Outcome outcome = grading.grade(rubric, {grading.submit_built(form, file, form)});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const json result = grading.result(form);
  Names names;
  int held = 0;
  for (const json& one : result["items"]) {
    held += one["state"] == "holds" ? 1 : 0;
    if (one["state"] != "holds" && one["state"] != "not asked") names.push_back(one["name"]);
  }
  EXPECT_GE(held, 9) << result.dump(2);
  return names;
}

TEST(Floats, lose_robustness_alone_where_doubles_are_asked_for) {
  const Names robustness = {"robustness"};
  EXPECT_EQ(lost("single_rays.cpp", "careful", {}), robustness);
  EXPECT_EQ(lost("single_rays.cpp", "lecture", {}), robustness);
  EXPECT_EQ(lost("single_rt.cpp", "careful", {}), Names{});
  EXPECT_EQ(lost("single_rt.cpp", "lecture", {}), robustness);
}

const std::vector<std::pair<std::string, std::string>> kSingle = {
    {"seconds = 60", "precision = \"single\"\nseconds = 60"}, {"ulp = 1e11", "ulp = 256"}};

TEST(Floats, that_are_careful_lose_nothing_where_precision_is_single) {
  EXPECT_EQ(lost("single_rays.cpp", "careful", kSingle), Names{});
  EXPECT_EQ(lost("single_rt.cpp", "careful", kSingle), Names{});
}

TEST(Floats, that_cancel_lose_robustness_where_precision_is_single) {
  EXPECT_EQ(lost("single_rays.cpp", "lecture", kSingle), Names{"robustness"});
}

TEST(Floats, keep_to_bounds_in_their_own_units) {
  const Grading grading;
  const auto score = [&](const std::string& precision, const std::string& form) {
    const std::string rubric = grading.write(
        "bounds/" + precision + ".toml",
        "precision = \"" + precision + "\"\n" + kFormsOfBuilt +
            "[[item]]\nname = \"where\"\npoints = 1\n[item.functions]\nlaws = [\"parameter\", "
            "\"hit-point\"]\nsources = [\"course\"]\ncases = 40\nrays = \"given\"\n");
    const std::string name = precision + "-" + form;
    grading.grade(rubric, {grading.submit_built(name + "/in", "single_rays.cpp", form)}, "out");
    return grading.result("in")["score"].get<double>();
  };
  EXPECT_EQ(score("double", "careful"), 0);
  EXPECT_EQ(score("single", "careful"), 1);
}

TEST(Floats, of_another_precision_have_no_rubric) {
  const Grading grading;
  const std::string item =
      "[[item]]\nname = \"a\"\npoints = 1\nfunctions = { laws = [\"class\"], "
      "sources = [\"rays\"], cases = 1 }\n";
  const auto error = [&](const std::string& text) {
    const Outcome outcome = run("grade " + grading.write("rubric.toml", text + item));
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_TRUE(contains(error("precision = \"half\"\n"), "precision = \"half\": must be one of"));
  const std::string everything = error("precision = \"single\"\n[tolerance]\nulp = 1e10\n");
  EXPECT_TRUE(contains(everything, "tolerance.ulp = 1e10: allows every answer")) << everything;
}

}  // namespace
}  // namespace raycheck::tests
