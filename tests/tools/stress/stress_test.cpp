#include "tools/stress/stress.h"

#include "tests/tools/external/judged.h"
#include "tools/implementations/built_in.h"
#include "tools/tradeoff/tradeoff.h"
#include "tools/view/document.h"
#include "tools/view/page/page.h"

namespace raycheck::tests {
namespace {

const std::string kFew = " --cases 60 --severity 0..9 ";

TEST(StressCommand, reports_the_severity_at_which_the_textbook_first_fails) {
  const json report = printed_json("stress --family distance --method quadratic,cross" + kFew, 1);
  const json& methods = report["families"][0]["methods"];
  ASSERT_EQ(methods.size(), 2u);
  EXPECT_EQ(methods[0]["name"], "quadratic");
  EXPECT_GT(methods[0]["first_failing"].get<int>(), 0);
  EXPECT_NEAR(methods[0]["slope"].get<double>(), 1, 0.2);  // as the distance over the radius
  expect_values(methods[1], {{"name", "cross"}, {"first_failing", nullptr}});
  EXPECT_EQ(methods[0]["severities"].size(), 10u);
}

TEST(StressCommand, and_tradeoff_print_tables_with_equal_rows) {
  const std::string stress = "stress --family distance --method cross" + kFew;
  const std::string tradeoff = "tradeoff --methods quadratic,robust,direct --cases 100";
  for (const auto& [command, rows] : {std::pair(stress, 18u), {tradeoff, 7u}}) {
    std::vector<std::string> table;  // the last one
    std::size_t found = 0;
    for (const std::string& line : lines_of(run(command + " --format markdown").out)) {
      if (!line.starts_with('|')) {
        table.clear();
        continue;
      }
      table.push_back(line);
      ++found;
      EXPECT_EQ(std::count(line.begin(), line.end(), '|'),
                std::count(table[0].begin(), table[0].end(), '|'))
          << line;
    }
    EXPECT_EQ(found, rows);
  }
}

TEST(StressCommand, proves_its_discrepancies) {
  const std::string path = temporary_file("stress.certificates", "");
  const std::string asked = "stress --family distance,up --method quadratic,rays/lecture";
  EXPECT_EQ(run(asked + " --certificates " + path + kFew).exit_code, 1);
  EXPECT_GT(lines_of(contents(path)).size(), 20u);
  run_python("tools/verify_certificates.py " + path, 0);
}

TEST(StressCommand, has_a_page_with_a_curve_for_every_method_and_family) {
  tools::StressOptions options;
  options.families = {"distance", "up"};
  options.implementations = tools::find_methods({"quadratic", "robust", "rays/direct"});
  options.cases = 20;
  options.severities = {{0, 4}};
  options.implementations.push_back(
      {.name = "</script><b>", .stages = {properties::Stage::kIntersection}, .make = [] {
         return tools::candidate_of(tools::kDefaultMethods);
       }});
  const tools::StressReport report = run_stress(options);
  const tools::ViewDocument document = stress_document(report);
  EXPECT_FALSE(has(page(document), "</script><b>"));
  const json chart = json::parse(document_json(document))["chart"];
  ASSERT_EQ(chart["facets"].size(), 3u);  // distance does not test methods that make rays
  expect_values(chart["facets"], {{"0/subject", "distance"}, {"2/stage", "Rays"}});
  const tools::StressCurve& textbook = report.families[0].curves[0];
  const json& mine = chart["facets"][0]["series"][0];
  expect_values(mine, {{"name", "quadratic"}, {"time", nullptr}});
  ASSERT_EQ(mine["points"].size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const json& errors = mine["points"][k]["errors"][0];
    EXPECT_EQ(errors["at"][0], *textbook.tally(k).median());
    EXPECT_EQ(errors["at"][3], *textbook.tally(k).quantile(0.999));
    EXPECT_EQ(chart["facets"][0]["condition"][0][3][k],
              *textbook.tally(k).condition_quantile(0.999));
    EXPECT_EQ(mine["points"][k]["defects"], properties::defects(textbook.results[k].inside));
  }
  // Methods are numbered among all methods, so that each looks the same in every picture.
  const auto& series = document.chart->facets[0].series;
  ASSERT_EQ(series.size(), 3u);
  EXPECT_EQ(series[0].number, 0u);
  EXPECT_EQ(series[1].number, 12u);
}

TEST(StressCommand, and_tradeoff_write_their_pages) {
  for (const auto& [command, title] :
       {std::pair("stress --severity 0..3 --family distance --method cross",
                  "Error against severity: distance"),
        {"tradeoff --family rays --method quadratic,cross", "Error against run time: rays"}}) {
    const std::string path = temporary_file("page.html", "");
    const Outcome result = run(command + (" --cases 20 --view " + path), 0);
    EXPECT_NE(contents(path).find(std::string("<title>") + title), std::string::npos) << command;
    EXPECT_LT(contents(path).size(), 300'000u);  // without what draws in three dimensions
  }
}

/// Every source has the first severity, and one of them the last.
TEST(StressCommand, accepts_severities_that_one_family_reaches) {
  const std::string asked = "stress --family distance,scale --method cross --cases 1 --severity ";
  run(asked + "0..20", 0);
  expect_refused(asked + "16..20", "severity 16..20: the severities of distance are 0..15");
}

TEST(WorstCommand, finds_an_input_that_check_accepts) {
  const std::string path = temporary_file("worst.toml", "");
  const Outcome result =
      run("worst --method intersect/quadratic --family distance --by rho --cases 200 --steps 400 "
          "--save " +
              path,
          1);
  expect_parts(result.out, {"unstable", "0x1"});
  EXPECT_EQ(run("check " + path + " --intersect quadratic").exit_code, 1);
}

TEST(ParetoFront, HasThePointsThatNoOtherBeats) {
  using Points = std::vector<std::pair<double, double>>;
  EXPECT_EQ(tools::pareto_front(Points{{3, 1}, {1, 5}, {2, 5}, {2, 3}, {4, 0}, {5, 0}}),
            (std::vector<std::size_t>{1, 3, 0, 4}));
  EXPECT_EQ(tools::pareto_front(Points{{1, 1}, {1, 1}}), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(tools::pareto_front({}).empty());
}

tools::TradeoffReport small_report() {
  tools::TradeoffOptions options;
  options.sources = {properties::chosen_source("distance"), properties::chosen_source("rays")};
  options.implementations = tools::find_methods({"quadratic", "cross", "robust"});
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
    expect_values(facet, {{"stage", "Intersections"}, {"baseline", "quadratic"}});
    ASSERT_EQ(facet["series"].size(), 3u);
    EXPECT_EQ(facet["series"][0]["time"]["ratio"], 1);
  }
}

void expect_what_the_report_tells(const json& all, const tools::TradeoffReport& report) {
  ASSERT_EQ(all["quantities"][0]["name"], "parameter");
  for (std::size_t k = 0; k < report.intersections.size(); ++k) {
    const tools::MethodCost& cost = report.intersections[k];
    const json& mine = all["series"][k];
    EXPECT_EQ(mine["name"], cost.candidate.name);
    const double base = report.intersections[0].batch->median;
    EXPECT_EQ(mine["time"]["ratio"], cost.batch->median / base);
    const json& errors = mine["points"][0]["errors"][0];
    EXPECT_EQ(errors["at"][3], *cost.accuracy.inside.tally(cost.quantity()).quantile(0.999));
    EXPECT_EQ(errors["at"][4], *cost.accuracy.inside.tally(cost.quantity()).max());
    EXPECT_EQ(mine["points"][0]["defects"], properties::defects(cost.accuracy.inside));
  }
}

/// Expects that the severities together have the cases of the whole source: none is lost, and none
/// is counted twice.
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
  // Severity has its meaning: the textbook's errors grow with the distance.
  const json& points = facet["series"][0]["points"];
  EXPECT_GT(points[9]["errors"][0]["at"][0], 1000 * points[2]["errors"][0]["at"][0].get<double>());
}

TEST(TradeoffPage, HasTheNumbersOfTheReportForEverySource) {
  const tools::TradeoffReport report = small_report();
  const json chart = json::parse(document_json(tradeoff_document(report)))["chart"];
  expect_every_source_and_all_together(chart);
  expect_what_the_report_tells(chart["facets"][0], report);
  expect_source_split_by_severity(chart["facets"][1]);
  // Only methods without defects are on the front.
  const json& series = chart["facets"][1]["series"];
  EXPECT_GT(series[0]["points"][0]["defects"], 0);  // the textbook on far spheres
  EXPECT_EQ(series[0]["points"][0]["errors"][0]["front"][3], false);
  EXPECT_EQ(series[2]["points"][0]["errors"][0]["front"][3], true);  // nothing is as accurate
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
    EXPECT_GE(quantity_of(method["inside"], "class")["cases"], 300u);
    EXPECT_GE(quantity_of(method["inside"], "parameter")["cases"], 50u);
    EXPECT_GE(quantity_of(method["inside"], "backward error")["cases"], 50u);
    is_any_on_the_front |= method["pareto"].get<bool>();
  }
  EXPECT_TRUE(is_any_on_the_front);
  const json both = printed_json("tradeoff scene/examples/far-sphere.toml" + asked);
  EXPECT_EQ(both["rays"].size(), 2u);
  EXPECT_EQ(both["intersections"].size(), 2u);
  const json given = printed_json("tradeoff tests/regressions/tangent.toml" + asked);
  EXPECT_EQ(given["rays"].size(), 0u);
  EXPECT_EQ(given["intersections"].size(), 2u);
}

}  // namespace
}  // namespace raycheck::tests
