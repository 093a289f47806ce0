#include "tools/report/plot/plot_axis.h"

#include <gtest/gtest.h>

#include <limits>

namespace raycheck::tools {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLength = 480;

TEST(PlotAxis, GoesByPowersOfTen) {
  const PlotAxis axis = PlotAxis::powers({0.5, 20, 1000}, kLength, false);
  EXPECT_NEAR(axis.place(100) - axis.place(10), axis.place(10) - axis.place(1), 1e-9);
  EXPECT_GT(axis.place(0.5), 0);
  EXPECT_LT(axis.place(1000), kLength);
  EXPECT_TRUE(axis.rows().empty());
  EXPECT_TRUE(axis.cuts().empty());
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
}

TEST(PlotAxis, HasARowOfInfinityAloneWhereNothingElseIs) {
  const PlotAxis axis = PlotAxis::powers({kInfinity, kInfinity}, kLength, true);
  EXPECT_EQ(axis.place(kInfinity), kLength - kRow / 2);
  EXPECT_EQ(axis.rows().size(), 1u);
}

/// Half an ulp beside 1e15 ulp: what lies between would take nearly all of the axis.
TEST(PlotAxis, CutsOutWhereNothingLies) {
  const std::vector<double> errors = {0.5, 1e15, 2e15};
  const PlotAxis whole = PlotAxis::powers(errors, kLength, false);
  const PlotAxis cut = PlotAxis::powers(errors, kLength, true);
  ASSERT_EQ(cut.cuts().size(), 1u);
  EXPECT_LT(cut.place(0.5), cut.cuts()[0] - kCut / 2);
  EXPECT_GT(cut.place(1e15), cut.cuts()[0] + kCut / 2);
  EXPECT_LT(cut.place(2e15), kLength);
  EXPECT_GT(cut.place(2e15) - cut.place(1e15), 5 * (whole.place(2e15) - whole.place(1e15)));
  for (const PlotAxis::Tick& tick : cut.ticks()) {
    EXPECT_FALSE(tick.at > cut.cuts()[0] - kCut / 2 && tick.at < cut.cuts()[0] + kCut / 2)
        << tick.text;
  }
}

TEST(PlotAxis, DoesNotCutWhatIsNarrow) {
  EXPECT_TRUE(PlotAxis::powers({1, 300, 9e4}, kLength, true).cuts().empty());
}

TEST(PlotAxis, NamesPowers) {
  const auto texts = [](const PlotAxis& axis) {
    std::vector<std::string> list;
    for (const PlotAxis::Tick& tick : axis.ticks()) list.push_back(tick.text);
    return list;
  };
  EXPECT_EQ(texts(PlotAxis::powers({1, 1e6}, kLength, false)),
            (std::vector<std::string>{"1", "10", "100", "1000", "10^{4}", "10^{5}", "10^{6}"}));
  EXPECT_EQ(texts(PlotAxis::powers({0.8, 6}, kLength, false)),
            (std::vector<std::string>{"1", "2", "5"}));
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
}

TEST(PlotAxis, TakesOneNumber) {
  EXPECT_EQ(PlotAxis::even({7}, kLength).place(7), 0);
  const PlotAxis axis = PlotAxis::powers({7}, kLength, true);
  EXPECT_NEAR(axis.place(7), kLength / 2, 1e-9);
}

}  // namespace
}  // namespace raycheck::tools
