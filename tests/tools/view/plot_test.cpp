#include <gtest/gtest.h>

#include <filesystem>

#include "tests/has.h"
#include "tests/numbers.h"
#include "tests/tools/program.h"
#include "tools/view/chart/chart.h"

namespace raycheck::tests {
namespace {

using tools::ChartFacet;
using tools::ChartPoint;

/// A point all of whose errors are one, or that has none.
ChartPoint point_of(std::optional<double> error, std::uint64_t defects = 0) {
  ChartPoint point{.errors = {{}}, .decisions = 1, .wrong = defects, .defects = defects};
  point.errors[0].at.fill(error);
  return point;
}

ChartFacet facet_of(const std::string& name, std::vector<std::optional<ChartPoint>> points) {
  ChartFacet facet{.subject = "it's",
                   .stage = "Intersections",
                   .severities = {"0", "1", "2", "3"},
                   .quantities = {properties::Quantity::kParameter}};
  facet.series = {{.name = name, .points = std::move(points)}};
  return facet;
}

TEST(Plot, HasItsTextsInQuotesAndRowsForZeroAndInfinity) {
  const ChartFacet facet = facet_of(
      "cross'; system 'x", {point_of(0), point_of(1, 1), std::nullopt, point_of(kInfinity)});
  const std::string script = tools::gnuplot_script({facet}, "a.svg");
  for (const char* part : {"title 'cross''; system ''x'", "set title 'Intersections on it''s'",
                           "set ytics add ('0' ", "set ytics add ('infinite' ", "\n\n"}) {
    EXPECT_TRUE(has(script, part)) << part;
  }
}

TEST(Plot, IsDrawnOfAnyNumbers) {
  if (!is_installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  std::vector<ChartFacet> facets = {
      facet_of("wide", {point_of(5e-324), point_of(1.7e308), point_of(0), point_of(kInfinity)}),
      facet_of("nothing", {std::nullopt, point_of(std::nullopt), point_of(0), std::nullopt}),
      facet_of("one", {point_of(1), std::nullopt, std::nullopt, std::nullopt}),
      facet_of("timed", {})};
  facets.back().baseline = "cross";
  facets.back().series[0].time = {.ratio = 2, .low = 1, .high = 3};
  facets.back().series[0].whole = point_of(3);
  for (const char* name : {"plot.svg", "plot.png", "plot.pdf"}) {
    const std::string path = temporary_file(name, "");
    draw(facets, path);
    EXPECT_GT(std::filesystem::file_size(path), 1000u) << name;
  }
}

}  // namespace
}  // namespace raycheck::tests
