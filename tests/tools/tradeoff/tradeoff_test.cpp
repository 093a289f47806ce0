#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/tools/program.h"
#include "tools/tradeoff/tradeoff_front.h"
#include "tools/tradeoff/tradeoff_page.h"
#include "tools/view/document_json.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

TEST(ParetoFront, IsWhatNothingBeats) {
  using Points = std::vector<std::pair<double, double>>;
  EXPECT_EQ(tools::pareto_front(Points{{3, 1}, {1, 5}, {2, 5}, {2, 3}, {4, 0}, {5, 0}}),
            (std::vector<std::size_t>{1, 3, 0, 4}));
  EXPECT_EQ(tools::pareto_front(Points{{1, 1}, {1, 1}}), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(tools::pareto_front({}).empty());
}

tools::TradeoffReport small_report() {
  tools::TradeoffOptions options;
  options.sources = {"distance", "rays"};
  options.methods = {"quadratic", "cross", "robust"};
  options.cases = 200;
  return run_tradeoff(options);
}

void expect_every_source_and_all_together(const json& chart) {
  ASSERT_EQ(chart["facets"].size(), 3u);
  EXPECT_EQ(chart["facets"][0]["subject"], "distance, rays");
  EXPECT_EQ(chart["facets"][1]["subject"], "distance");
  EXPECT_EQ(chart["facets"][1]["severities"].size(), 17u);
  EXPECT_EQ(chart["facets"][2]["subject"], "rays");
  EXPECT_EQ(chart["facets"][2]["severities"], json::array({"all"}));
  for (const json& facet : chart["facets"]) {
    EXPECT_EQ(facet["stage"], "Intersections");
    EXPECT_EQ(facet["baseline"], "quadratic");
    ASSERT_EQ(facet["series"].size(), 3u);
    EXPECT_EQ(facet["series"][0]["time"]["ratio"], 1);
  }
}

void expect_what_the_report_tells(const json& all, const tools::TradeoffReport& report) {
  ASSERT_EQ(all["quantities"][0]["name"], "parameter");
  for (std::size_t k = 0; k < report.intersections.size(); ++k) {
    const tools::MethodCost& cost = report.intersections[k];
    const json& mine = all["series"][k];
    EXPECT_EQ(mine["name"], cost.method.name());
    const double base = report.intersections[0].batch->median;
    EXPECT_EQ(mine["time"]["ratio"], cost.batch->median / base);
    const json& errors = mine["points"][0]["errors"][0];
    EXPECT_EQ(errors["at"][3], *cost.main()->quantile(0.999));
    EXPECT_EQ(errors["at"][4], *cost.main()->max());
    EXPECT_EQ(mine["points"][0]["defects"], properties::defects(cost.accuracy.inside));
  }
}

/// Of the same cases: none is lost between severities, and none counted twice.
void expect_source_split_by_severity(const json& facet) {
  for (const json& series : facet["series"]) {
    std::uint64_t decisions = 0;
    double largest = 0;
    for (std::size_t k = 1; k < series["points"].size(); ++k) {
      const json& point = series["points"][k];
      if (point.is_null()) continue;
      decisions += point["decisions"].get<std::uint64_t>();
      const json& error = point["errors"][0]["at"][4];
      if (error.is_number()) largest = std::max(largest, error.get<double>());
    }
    EXPECT_EQ(series["points"][0]["decisions"], decisions);
    EXPECT_EQ(series["points"][0]["errors"][0]["at"][4], largest);
  }
  // What severity is: the textbook's errors grow with the distance.
  const json& points = facet["series"][0]["points"];
  EXPECT_GT(points[9]["errors"][0]["at"][0], 1000 * points[2]["errors"][0]["at"][0].get<double>());
}

TEST(TradeoffPage, TellsWhatTheReportTellsOfEverySource) {
  const tools::TradeoffReport report = small_report();
  const json chart = json::parse(document_json(tradeoff_document(report)))["chart"];
  expect_every_source_and_all_together(chart);
  expect_what_the_report_tells(chart["facets"][0], report);
  expect_source_split_by_severity(chart["facets"][1]);
  // The front is of those without defects.
  const json& series = chart["facets"][1]["series"];
  EXPECT_GT(series[0]["points"][0]["defects"], 0);  // the textbook on far spheres
  EXPECT_EQ(series[0]["points"][0]["errors"][0]["front"][3], false);
  EXPECT_EQ(series[2]["points"][0]["errors"][0]["front"][3], true);  // nothing is as accurate
}

/// How many answers of a quantity were compared.
std::uint64_t cases_of(const json& tallies, const std::string& quantity) {
  for (const json& tally : tallies) {
    if (tally["name"] == quantity) return tally["cases"];
  }
  return 0;
}

TEST(TradeoffCommand, reports_error_and_time_of_each_method_that_a_scene_needs) {
  const std::string asked = " --methods quadratic,cross,direct,focal --cases 300";
  const json report = printed_json("tradeoff" + asked, 0);
  ASSERT_EQ(report["rays"].size(), 2u);
  ASSERT_EQ(report["intersections"].size(), 2u);
  bool is_any_on_the_front = false;
  for (const json& method : report["intersections"]) {
    EXPECT_GT(method["call"]["median_ns"].get<double>(), 0);
    EXPECT_GT(method["batch"]["median_ns"].get<double>(), 0);
    EXPECT_GE(cases_of(method["inside"], "class"), 300u);
    EXPECT_GE(cases_of(method["inside"], "parameter"), 50u);
    EXPECT_GE(cases_of(method["inside"], "backward error"), 50u);
    is_any_on_the_front |= method["pareto"].get<bool>();
  }
  EXPECT_TRUE(is_any_on_the_front);
  const json both = printed_json("tradeoff scene/examples/far-sphere.toml" + asked);
  EXPECT_EQ(both["rays"].size(), 2u);
  EXPECT_EQ(both["intersections"].size(), 2u);
  EXPECT_GE(both["pixels"].size(), 1u);
  const json given = printed_json("tradeoff tests/regressions/tangent.toml" + asked);
  EXPECT_EQ(given["rays"].size(), 0u);
  EXPECT_EQ(given["pixels"].size(), 0u);
  EXPECT_EQ(given["intersections"].size(), 2u);
}

}  // namespace
}  // namespace raycheck::tests
