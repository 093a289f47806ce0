#include "tools/grade/results/statistics.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace raycheck::tools {
namespace {

/// By spheres, then pixels.
std::pair<std::size_t, std::int64_t> size_of(const FailingCase& failing) {
  const scene::Scene& scene = failing.the_case.scene;
  return {scene.spheres.size(), scene.camera ? scene.camera->width * scene.camera->height : 0};
}

/// Counts a student's item that a mistake explains.
void add(const std::string& sentence, const ItemGrade& item, const SubmissionGrade& grade,
         std::vector<MistakeStatistics>& all) {
  auto known = std::find_if(all.begin(), all.end(), [&](const MistakeStatistics& other) {
    return other.sentence == sentence;
  });
  if (known == all.end()) known = all.insert(all.end(), MistakeStatistics{sentence, {}});
  if (known->students.empty() || known->students.back() != &grade) {
    known->students.push_back(&grade);
  }
  const bool is_smaller =
      item.failing &&
      (known->smallest == nullptr || size_of(*item.failing) < size_of(*known->smallest->failing));
  if (!is_smaller) return;
  known->smallest = &item;
  known->whose = &grade;
}

}  // namespace

Submissions submissions_that(const ClassGrade& graded, bool are_judged) {
  Submissions found;
  for (const SubmissionGrade& grade : graded.submissions) {
    if (could_be_judged(grade) == are_judged) found.push_back(&grade);
  }
  return found;
}

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

std::vector<ItemStatistics> item_statistics(const ClassGrade& graded) {
  std::vector<ItemStatistics> all;
  for (std::size_t k = 0; k < graded.rubric.items.size(); ++k) {
    ItemStatistics one;
    one.item = &graded.rubric.items[k];
    for (const SubmissionGrade* grade : submissions_that(graded, true)) {
      const ItemGrade& item = grade->items[k];
      if (item.state == ItemState::kNotAsked) continue;
      ++one.asked;
      one.failing += item.state == ItemState::kFails ? 1 : 0;
      one.left_out +=
          item.state == ItemState::kLeftOut || item.state == ItemState::kNotJudged ? 1 : 0;
    }
    all.push_back(one);
  }
  return all;
}

std::vector<MistakeStatistics> mistake_statistics(const ClassGrade& graded) {
  std::vector<MistakeStatistics> all;
  for (const SubmissionGrade& grade : graded.submissions) {
    for (const ItemGrade& item : grade.items) {
      for (const ExplainingMistake& mistake : item.mistakes) {
        for (const std::string& sentence : mistake.each()) add(sentence, item, grade, all);
      }
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.students.size() > b.students.size();
  });
  return all;
}

}  // namespace raycheck::tools
