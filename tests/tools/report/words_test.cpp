#include "tools/report/words.h"

#include "tests/testing.h"

namespace raycheck::tools {
namespace {

using properties::Discrepancy, properties::Quantity, properties::Wrong;

constexpr double kBeyondAnyBound = std::numeric_limits<double>::infinity();

TEST(Words, OfAnExplanationCountTheAnswersThatItExplains) {
  EXPECT_EQ(explained_text("rows are upside down", 90, 90, "pixels"),
            "rows are upside down; this explains all 90 wrong pixels examined");
  EXPECT_EQ(explained_text("T = L - C", 11, 12, "answers"),
            "T = L - C; this explains 11 of 12 wrong answers examined");
  EXPECT_EQ(explained_text("T = L - C", 1, 1, "answers"),
            "T = L - C; this explains the only wrong answer examined");
}

TEST(Words, OfAFailureSayThatThereIsNoAnswer) {
  Discrepancy failed;
  failed.quantity = Quantity::kRefusal;
  failed.wrong = Wrong::kFailed;
  failed.what = "intersect: it exited with 3";
  EXPECT_EQ(discrepancy_head(failed), "no answer: intersect: it exited with 3");
  failed.place = {2, {}, 0};
  failed.failed = {properties::Blame::kQuestion, 1, {}};
  EXPECT_EQ(discrepancy_head(failed), "no answer, ray 2, sphere 0: intersect: it exited with 3");
}

TEST(Words, OfFiniteAnswersNameNoInfiniteError) {
  Discrepancy axes;
  axes.quantity = Quantity::kOrthonormality;
  axes.error = kBeyondAnyBound;
  axes.got = {1, 0, 0, 0, 1, 0, 0, 0, -1};
  EXPECT_EQ(wrongness_text(axes), "not right-handed");
  axes.got[0] = kBeyondAnyBound;
  EXPECT_EQ(wrongness_text(axes), "NaN or infinite");
}

TEST(Words, OfRelatedAnswersNameTheLawAndTheExpectedAnswer) {
  Discrepancy related;
  related.law = "scaling";
  related.quantity = Quantity::kInvariance;
  related.what = "lengths scaled by 2^3";
  related.symbol = "s";
  related.got = {1};
  related.exact = {2};
  related.error = 7;
  related.condition = 1e-12;
  const std::string text = discrepancy_text(related, false);
  EXPECT_TRUE(text.starts_with("scaling, ray 0, lengths scaled by 2^3: off by 7")) << text;
  EXPECT_TRUE(has(text, "  expected s = 2"));
  EXPECT_TRUE(has(text, "  condition number below 1e-09\n"));
  related.symbol.clear();  // the numbers are answers, beside the exact ones
  EXPECT_TRUE(has(discrepancy_text(related, false), "  exact 2"));
}

TEST(Words, OfABrokenLawCallOnlyAShrunkCaseShrunk) {
  EXPECT_TRUE(has(broken_law_text("", "", "", "", "", true), "the shrunk case, as a scene"));
  EXPECT_TRUE(has(broken_law_text("", "", "", "", "", false), "the failing case, as a scene"));
}

}  // namespace
}  // namespace raycheck::tools
