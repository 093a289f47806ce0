#include "tools/report/plot/plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "tests/has.h"
#include "tests/numbers.h"
#include "tools/report/plot/plot_axis.h"
#include "tools/report/plot/plot_labels.h"
#include "tools/report/plot/plot_series.h"

namespace raycheck::tools {
namespace {

constexpr double kLength = 480;

TEST(PlotAxis, GoesByPowersOfTenWithTicksOfTheirNames) {
  const auto ticks = [](const std::vector<double>& numbers) {
    std::vector<std::string> texts;
    const PlotAxis of_numbers = PlotAxis::powers(numbers, kLength, false);
    for (const auto& tick : of_numbers.ticks()) texts.push_back(tick.text);
    return texts;
  };
  const PlotAxis axis = PlotAxis::powers({0.5, 20, 1000}, kLength, false);
  EXPECT_NEAR(axis.place(100) - axis.place(10), axis.place(10) - axis.place(1), 1e-9);
  EXPECT_GT(axis.place(0.5), 0);
  EXPECT_LT(axis.place(1000), kLength);
  EXPECT_TRUE(axis.rows().empty());
  EXPECT_TRUE(axis.cuts().empty());
  EXPECT_NEAR(PlotAxis::powers({7}, kLength, true).place(7), kLength / 2, 1e-9);
  EXPECT_EQ(ticks({1, 1e6}),
            (std::vector<std::string>{"1", "10", "100", "1000", "10^{4}", "10^{5}", "10^{6}"}));
  EXPECT_EQ(ticks({0.8, 6}), (std::vector<std::string>{"1", "2", "5"}));
}

TEST(PlotAxis, HasRowsForZeroAndInfinityThatNoNumberReaches) {
  const PlotAxis axis = PlotAxis::powers({0, 5e-324, 1.7e308, kInfinity}, kLength, false);
  ASSERT_EQ(axis.rows().size(), 2u);
  EXPECT_EQ(axis.rows()[0].text, "0");
  EXPECT_EQ(axis.rows()[1].text, "infinite");
  EXPECT_EQ(axis.rows()[0].at, axis.place(0));
  EXPECT_EQ(axis.rows()[1].at, axis.place(kInfinity));
  EXPECT_GT(axis.place(5e-324), axis.place(0) + kRow / 2);
  EXPECT_LT(axis.place(1.7e308), axis.place(kInfinity) - kRow / 2);
  const PlotAxis alone = PlotAxis::powers({kInfinity, kInfinity}, kLength, true);
  EXPECT_EQ(alone.place(kInfinity), kLength - kRow / 2);
  EXPECT_EQ(alone.rows().size(), 1u);
}

/// Half an ulp beside 1e15 ulp: what lies between would take nearly all of the axis.
TEST(PlotAxis, CutsOutWhereNothingLies) {
  const std::vector<double> errors = {0.5, 1e15, 2e15};
  const PlotAxis whole = PlotAxis::powers(errors, kLength, false);
  const PlotAxis cut = PlotAxis::powers(errors, kLength, true);
  ASSERT_EQ(cut.cuts().size(), 1u);
  const double low = cut.cuts()[0] - kCut / 2, high = cut.cuts()[0] + kCut / 2;
  EXPECT_LT(cut.place(0.5), low);
  EXPECT_GT(cut.place(1e15), high);
  EXPECT_LT(cut.place(2e15), kLength);
  EXPECT_GT(cut.place(2e15) - cut.place(1e15), 5 * (whole.place(2e15) - whole.place(1e15)));
  for (const auto& tick : cut.ticks()) EXPECT_FALSE(tick.at > low && tick.at < high) << tick.text;
  EXPECT_TRUE(PlotAxis::powers({1, 300, 9e4}, kLength, true).cuts().empty());
}

TEST(PlotAxis, IsEvenWithTicksThatHaveRoom) {
  std::vector<double> severities;
  for (int k = 0; k <= 64; ++k) severities.push_back(k);
  const PlotAxis axis = PlotAxis::even(severities, kLength);
  EXPECT_EQ(axis.place(0), 0);
  EXPECT_EQ(axis.place(64), kLength);
  EXPECT_EQ(axis.place(32), kLength / 2);
  ASSERT_GT(axis.ticks().size(), 4u);
  for (std::size_t k = 1; k < axis.ticks().size(); ++k) {
    EXPECT_GT(axis.ticks()[k].at - axis.ticks()[k - 1].at, 40);
  }
  EXPECT_EQ(PlotAxis::even({7}, kLength).place(7), 0);
}

TEST(SpreadApart, MovesNeighboursByTheSameWithinTheEdges) {
  struct Spread {
    std::vector<double> wanted;
    double most;
    std::vector<double> got;
  };
  for (const auto& [wanted, most, got] :
       std::vector<Spread>{{{400, 20, 100}, 500, {400, 20, 100}},
                           {{100, 100, 100}, 500, {84, 100, 116}},
                           // Two pairs that meet when they are pushed apart become four.
                           {{100, 100, 110, 110}, 500, {81, 97, 113, 129}},
                           {{0, 1, 2}, 500, {0, 16, 32}},
                           {{500, 499, 3}, 500, {500, 484, 3}},
                           // The gap is narrower where there is no room.
                           {{5, 5, 5, 5, 5}, 40, {0, 10, 20, 30, 40}},
                           {{}, 40, {}}}) {
    EXPECT_EQ(spread_apart(wanted, 16, 0, most), got);
  }
}

constexpr PlotBox kFrame = {0, 0, 800, 500};

std::vector<PlotObstacle> marks_of(const std::vector<NamedPoint>& points) {
  std::vector<PlotObstacle> marks;
  for (const NamedPoint& point : points) marks.push_back({{point.x - 9, point.y - 9, 18, 18}});
  return marks;
}

void expect_readable(const std::vector<NamedPoint>& points) {
  const auto marks = marks_of(points);
  const auto names = names_beside(points, marks, kFrame);
  ASSERT_EQ(names.size(), points.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const PlotBox& box = names[k].box;
    EXPECT_TRUE(box.left >= 0 && box.bottom >= 0 && box.left + box.width <= kFrame.width &&
                box.bottom + box.height <= kFrame.height)
        << points[k].name;
    EXPECT_GE(box.width, text_width(points[k].name));
    for (std::size_t other = 0; other < names.size(); ++other) {
      EXPECT_FALSE(box.overlaps(marks[other].box))
          << points[k].name << " on " << points[other].name;
      EXPECT_FALSE(other != k && box.overlaps(names[other].box))
          << points[k].name << " on the name " << points[other].name;
    }
  }
}

TEST(NamesBeside, OverlapNothingAndStayInside) {
  expect_readable({{795, 250, "right"}, {3, 497, "corner"}, {400, 2, "below"}});
  // As on stress families, where a dozen methods of one speed have one error.
  std::vector<NamedPoint> points;
  for (const char* name : {"quadratic", "lecture", "stable-quadratic", "kahan", "perpendicular",
                           "cross", "boost-math", "gsl", "glm", "vecgeom", "reference-intervals"}) {
    const auto k = static_cast<double>(points.size());
    points.push_back({100 + 4 * k, 300 + 3 * std::sin(k), name});
  }
  expect_readable(points);
  // They are still placed where the frame has no room.
  EXPECT_EQ(names_beside({{5, 5, "a name far too long for this frame"}}, {}, {0, 0, 10, 10}).size(),
            1u);
}

TEST(NamesBeside, HaveLeadersWhereAnotherPointIsAsNear) {
  const std::vector<NamedPoint> points = {{100, 100, "a"}, {101, 100, "b"}, {400, 100, "c"}};
  const auto names = names_beside(points, marks_of(points), kFrame);
  EXPECT_TRUE(names[0].needs_leader);
  EXPECT_TRUE(names[1].needs_leader);
  EXPECT_FALSE(names[2].needs_leader);
  EXPECT_FALSE(names[2].ends_here);
  EXPECT_EQ(names[2].box.left, 411);
  EXPECT_EQ(names[2].box.bottom + kLine / 2, 100);
}

PlotFrame frame() {
  return {100, 100, PlotAxis::even({0, 10}, 100), PlotAxis::powers({0.1, 1000}, 100, false)};
}

TEST(PlotSeries, NoTwoLookAlike) {
  std::set<std::string> looks;
  for (std::size_t k = 0; k < kPlotLooks; ++k) {
    const PlotSeries series{"", PlotSeries::Style::kCurve, {{1, 1}}, k};
    const std::string parts = series_parts(series, "$d")[1];  // the colour
    const std::string data = series_data(series, frame());    // the shape
    EXPECT_TRUE(looks.insert(parts + data).second) << k;
  }
}

TEST(PlotSeries, ShowsWhatDecisionsWereAndBreaksWhereThereIsNoError) {
  const auto data = [](PlotStanding standing) {
    return series_data({"", PlotSeries::Style::kCurve, {{0, 1, standing}}, 0}, frame());
  };
  const std::string y = data(PlotStanding::kRight).substr(5, 5);
  EXPECT_EQ(data(PlotStanding::kRight), "0.00 " + y + " 7 " + y + " NaN\n");
  EXPECT_EQ(data(PlotStanding::kExcused), "0.00 " + y + " 6 NaN NaN\n");
  EXPECT_EQ(data(PlotStanding::kDefect), "0.00 " + y + " 6 NaN " + y + "\n");
  const PlotSeries gap{"", PlotSeries::Style::kCurve, {{0, 1}, {5, kNaN}, {10, 1}}, 0};
  EXPECT_TRUE(has(series_data(gap, frame()), "\n\n100.00 "));
}

/// Every method has its name in the picture, whatever is in it, and there is no legend to follow.
TEST(PlotScript, NamesSeriesDirectly) {
  Plot plot;
  plot.title = "it's";
  plot.series = {{"cross'; system 'x", PlotSeries::Style::kCurve, {{0, 1}, {1, kInfinity}}, 0},
                 {"robust_{2}", PlotSeries::Style::kCurve, {{0, 0}, {1, kNaN}}, 1}};
  const std::string script = gnuplot_script({plot}, "a.svg");
  for (const char* part : {"set label 'cross''; system ''x' at ", "set label 'robust_{2}' at ",
                           "unset key", "'infinite'", "set label 'it''s'"}) {
    EXPECT_TRUE(has(script, part));
  }
}

}  // namespace
}  // namespace raycheck::tools
