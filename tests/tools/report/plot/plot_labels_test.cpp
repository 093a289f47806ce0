#include "tools/report/plot/plot_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace raycheck::tools {
namespace {

constexpr PlotBox kFrame = {0, 0, 800, 500};

TEST(SpreadApart, LeavesWhatIsApartWhereItIs) {
  const std::vector<double> wanted = {400, 20, 100};
  EXPECT_EQ(spread_apart(wanted, 16, 0, 500), wanted);
}

TEST(SpreadApart, MovesNeighboursByTheSame) {
  EXPECT_EQ(spread_apart({100, 100, 100}, 16, 0, 500), (std::vector<double>{84, 100, 116}));
  // Two pairs that meet when they are pushed apart become four.
  EXPECT_EQ(spread_apart({100, 100, 110, 110}, 16, 0, 500),
            (std::vector<double>{81, 97, 113, 129}));
}

TEST(SpreadApart, StaysWithinTheEdges) {
  EXPECT_EQ(spread_apart({0, 1, 2}, 16, 0, 500), (std::vector<double>{0, 16, 32}));
  EXPECT_EQ(spread_apart({500, 499, 3}, 16, 0, 500), (std::vector<double>{500, 484, 3}));
}

TEST(SpreadApart, NarrowsTheGapWhereThereIsNoRoom) {
  EXPECT_EQ(spread_apart({5, 5, 5, 5, 5}, 16, 0, 40), (std::vector<double>{0, 10, 20, 30, 40}));
  EXPECT_TRUE(spread_apart({}, 16, 0, 40).empty());
}

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
      if (other != k) {
        EXPECT_FALSE(box.overlaps(names[other].box))
            << points[k].name << " on the name " << points[other].name;
      }
    }
  }
}

TEST(NamesBeside, AreRightOfALonePoint) {
  const auto names = names_beside({{300, 200, "cross"}}, marks_of({{300, 200, ""}}), kFrame);
  EXPECT_FALSE(names[0].needs_leader);
  EXPECT_FALSE(names[0].ends_here);
  EXPECT_EQ(names[0].box.left, 311);
  EXPECT_EQ(names[0].box.bottom + kLine / 2, 200);
}

TEST(NamesBeside, TurnAwayFromEdges) {
  expect_readable({{795, 250, "right"}, {3, 497, "corner"}, {400, 2, "below"}});
}

/// As on stress families, where a dozen methods of one speed have one error.
TEST(NamesBeside, OfACrowdOverlapNothing) {
  std::vector<NamedPoint> points;
  for (const char* name : {"quadratic", "lecture", "stable-quadratic", "kahan", "perpendicular",
                           "cross", "boost-math", "gsl", "glm", "vecgeom", "reference-intervals"}) {
    const auto k = static_cast<double>(points.size());
    points.push_back({100 + 4 * k, 300 + 3 * std::sin(k), name});
  }
  expect_readable(points);
}

TEST(NamesBeside, HaveLeadersWhereAnotherPointIsAsNear) {
  const std::vector<NamedPoint> points = {{100, 100, "a"}, {101, 100, "b"}, {400, 100, "c"}};
  const auto names = names_beside(points, marks_of(points), kFrame);
  EXPECT_TRUE(names[0].needs_leader);
  EXPECT_TRUE(names[1].needs_leader);
  EXPECT_FALSE(names[2].needs_leader);
}

TEST(NamesBeside, AreStillPlacedWhereTheFrameHasNoRoom) {
  const std::vector<NamedPoint> points = {{5, 5, "a name far too long for this frame"}};
  EXPECT_EQ(names_beside(points, {}, {0, 0, 10, 10}).size(), 1u);
}

}  // namespace
}  // namespace raycheck::tools
