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

/// The items that a class in floats loses by the lecture's rubric, changed: of functions and of
/// renderers, careful ones and those whose lecture's formula cancels.
struct Lost {
  Names functions, cancelling_functions, renderer, cancelling_renderer;
};
Lost lost(const std::vector<std::pair<std::string, std::string>>& changes) {
  const Grading grading;
  std::vector<std::string> folders;
  for (const std::string file : {"single_rays.cpp", "single_rt.cpp"}) {
    for (const char* mistake : {"none", "cancelling"}) {
      folders.push_back(grading.submit_built(file + "-" + mistake, file, mistake));
    }
  }
  grading.grade(grading.lecture7_with(changes), folders);
  const auto lost_by = [&](const std::string& name) {
    const json result = grading.result(name);
    Names names;
    int held = 0;
    for (const json& one : result["items"]) {
      held += one["state"] == "holds" ? 1 : 0;
      if (one["state"] != "holds" && one["state"] != "not asked") names.push_back(one["name"]);
    }
    EXPECT_GE(held, 9) << result.dump(2);
    return names;
  };
  return {lost_by("single_rays.cpp-none"), lost_by("single_rays.cpp-cancelling"),
          lost_by("single_rt.cpp-none"), lost_by("single_rt.cpp-cancelling")};
}

const Names kRobustness = {"robustness"};

TEST(Floats, lose_robustness_alone_where_doubles_are_asked_for) {
  const Lost items = lost({});
  EXPECT_EQ(items.functions, kRobustness);
  EXPECT_EQ(items.cancelling_functions, kRobustness);
  EXPECT_EQ(items.renderer, Names{});
  EXPECT_EQ(items.cancelling_renderer, kRobustness);
}

TEST(Floats, lose_what_cancels_alone_where_precision_is_single) {
  const Lost items =
      lost({{"seconds = 60", "precision = \"single\"\nseconds = 60"}, {"ulp = 1e11", "ulp = 256"}});
  EXPECT_EQ(items.functions, Names{});
  EXPECT_EQ(items.cancelling_functions, kRobustness);
  EXPECT_EQ(items.renderer, Names{});
  EXPECT_EQ(items.cancelling_renderer, kRobustness);
}

TEST(Floats, keep_to_bounds_in_their_own_units) {
  const Grading grading;
  const auto score = [&](const std::string& precision) {
    const std::string rubric = grading.write(
        "bounds/" + precision + ".toml",
        "precision = \"" + precision + "\"\n" + kFormsOfBuilt +
            "[[item]]\nname = \"where\"\npoints = 1\n[item.functions]\nlaws = [\"parameter\", "
            "\"hit-point\"]\nsources = [\"course\"]\ncases = 40\nrays = \"given\"\n");
    grading.grade(rubric, {grading.submit_built(precision + "/in", "single_rays.cpp", "none")});
    return grading.result("in")["score"].get<double>();
  };
  EXPECT_EQ(score("double"), 0);
  EXPECT_EQ(score("single"), 1);
}

}  // namespace
}  // namespace raycheck::tests
