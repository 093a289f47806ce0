#include "tools/stress/stress_page.h"

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "tests/tools/program.h"
#include "tools/view/document_json.h"
#include "tools/view/page/page.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

tools::StressOptions few() {
  tools::StressOptions options;
  options.families = {"distance", "up"};
  options.methods = {"quadratic", "robust", "rays/direct"};
  options.cases = 20;
  options.severities = {{0, 4}};
  return options;
}

TEST(StressPage, HasACurveOfEveryMethodOnEveryFamily) {
  const tools::StressReport report = run_stress(few());
  const json chart = json::parse(document_json(stress_document(report)))["chart"];
  ASSERT_EQ(chart["facets"].size(), 3u);  // distance asks nothing of methods that make rays
  EXPECT_EQ(chart["facets"][0]["subject"], "distance");
  EXPECT_EQ(chart["facets"][2]["stage"], "Rays");
  const tools::StressCurve& textbook = report.families[0].curves[0];
  const json& mine = chart["facets"][0]["series"][0];
  EXPECT_EQ(mine["name"], "quadratic");
  EXPECT_TRUE(mine["time"].is_null());
  ASSERT_EQ(mine["points"].size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const json& errors = mine["points"][k]["errors"][0];
    EXPECT_EQ(errors["at"][0], *textbook.tally(k)->median());
    EXPECT_EQ(errors["at"][3], *textbook.tally(k)->quantile(0.999));
    EXPECT_EQ(chart["facets"][0]["condition"][0][3][k],
              *textbook.tally(k)->condition_quantile(0.999));
    EXPECT_EQ(mine["points"][k]["defects"], properties::defects(textbook.results[k].inside));
  }
}

/// So that a method looks the same in every picture and no two look alike.
TEST(StressPage, NumbersMethodsByTheirPlaceAmongAll) {
  tools::StressOptions options = few();
  options.others = {
      {.stage = properties::Stage::kIntersection,
       .other = std::make_shared<const tools::OtherMethod>(tools::OtherMethod{
           .name = "</script><b>", .isolated_by = "", .bounds_of = "", .candidate = [] {
             return tools::candidate_of(tools::kDefaultMethods);
           }})}};
  const tools::ViewDocument document = stress_document(run_stress(options));
  const auto& series = document.chart->facets[0].series;
  ASSERT_EQ(series.size(), 3u);
  EXPECT_EQ(series[0].number, 0u);
  EXPECT_EQ(series[1].number, 12u);
  EXPECT_EQ(series[2].number, tools::all_intersect_methods().size());
  EXPECT_EQ(page(document).find("</script><b>"), std::string::npos);
}

TEST(StressPage, IsOneFileOfTheCommand) {
  const std::string path = temporary_file("stress.html", "");
  const Outcome result =
      run("stress --family distance --method cross --cases 20 --severity 0..3 --view " + path);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(contents(path).find("<title>Error against severity: distance</title>"),
            std::string::npos);
  EXPECT_EQ(run("stress --view /proc/none/page.html").exit_code, 2);
}

}  // namespace
}  // namespace raycheck::tests
