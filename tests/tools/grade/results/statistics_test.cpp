#include "tests/testing.h"
#include "tools/grade/results/result.h"

namespace raycheck::tests {
namespace {

TEST(MistakeStatistics, CountAMistakeOnceBesideAnother) {
  const auto student = [](const std::vector<tools::ExplainingMistake>& mistakes) {
    tools::SubmissionGrade grade;
    grade.finished = true;
    for (const tools::ExplainingMistake& one : mistakes) {
      tools::ItemGrade item;
      item.state = tools::ItemState::kFails;
      item.mistakes = {one};
      grade.items.push_back(item);
    }
    return grade;
  };
  tools::ClassGrade graded;
  graded.submissions = {student({{{"a"}, 1, 1}, {{"a", "b"}, 2, 2}}),
                        student({{{"b"}, 1, 1}, {{"b", "c"}, 1, 1}}), student({{{"b"}, 3, 3}})};
  const auto statistics = tools::mistake_statistics(graded.submissions);
  ASSERT_EQ(statistics.size(), 3u);
  EXPECT_EQ(statistics[0].sentence, "b");
  EXPECT_EQ(statistics[0].students.size(), 3u);
  EXPECT_EQ(statistics[1].sentence, "a");
  EXPECT_EQ(statistics[1].students.size(), 1u);
  EXPECT_EQ(statistics[2].sentence, "c");
  EXPECT_EQ(statistics[0].items, 4);
  EXPECT_EQ(statistics[1].items, 2);
}

}  // namespace
}  // namespace raycheck::tests
