#include "tools/grade/results/result.h"

#include <fmt/core.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <filesystem>
#include <utility>

#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {

properties::Candidate tolerated(properties::Candidate candidate, const Tolerance& tolerance) {
  const double unit = scene::unit_roundoff(candidate.precision);
  if (tolerance.conditioning) {
    candidate.max_error.fill(properties::kModerateCondition * *tolerance.conditioning);
    candidate.max_error_end_to_end.fill({});
    candidate.unit_roundoff = unit * *tolerance.conditioning;
  } else if (tolerance.ulp) {
    candidate.unit_roundoff = unit * *tolerance.ulp / properties::kExcusedRoundoffs;
  }
  return candidate;
}

ItemGrade unjudged(const Item& item, bool pictures) {
  ItemGrade grade;
  const bool is_asked = (pictures ? item.pictures : item.functions).has_value();
  grade.name = item.name;
  grade.state = is_asked ? ItemState::kNotJudged : ItemState::kNotAsked;
  grade.points = is_asked ? item.points : 0;
  grade.bonus = item.bonus;
  grade.pictures = pictures;
  return grade;
}

std::string plain_text(const std::string& said) {
  // Compilers print typographic quotes.
  std::string text = without_private_folders(said);
  for (const char* quote : {"\xe2\x80\x98", "\xe2\x80\x99"}) boost::replace_all(text, quote, "'");
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < ' ' && c != '\n' && c != '\t') || byte > '~') c = '?';
  }
  return text;
}

std::string inexpressible_text(const SubmissionGrade& grade) {
  std::uint64_t unsaid = 0, cases = 0;
  for (const ItemGrade& item : grade.items) {
    unsaid += item.unsaid;
    cases += item.cases + item.unsaid;
  }
  if (unsaid == 0) return "";
  return fmt::format(
      "{} of {} cases cannot be written in the input format of the program, and do not count",
      unsaid, cases);
}

namespace {

/// The size of a failing case: its spheres, then its pixels.
std::pair<std::size_t, std::int64_t> size_of(const FailingCase& failing) {
  const scene::Scene& scene = failing.the_case.scene;
  return {scene.spheres.size(), scene.camera ? scene.camera->width * scene.camera->height : 0};
}

/// Counts an item of a submission that a mistake explains.
void add(const std::string& sentence, const ItemGrade& item, const SubmissionGrade& grade,
         std::vector<MistakeStatistics>& all) {
  auto known = std::ranges::find(all, sentence, &MistakeStatistics::sentence);
  if (known == all.end()) known = all.insert(all.end(), MistakeStatistics{sentence, {}});
  if (known->students.empty() || known->students.back() != &grade) {
    known->students.push_back(&grade);
  }
  ++known->items;
  known->costs = known->costs || item.state == ItemState::kFails;
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

std::vector<MistakeStatistics> mistake_statistics(std::span<const SubmissionGrade> graded) {
  std::vector<MistakeStatistics> all;
  for (const SubmissionGrade& grade : graded) {
    for (const ItemGrade& item : grade.items) {
      for (const ExplainingMistake& mistake : item.mistakes) {
        for (const std::string& sentence : mistake.sentences) add(sentence, item, grade, all);
      }
    }
  }
  std::ranges::stable_sort(
      all, [](const auto& a, const auto& b) { return a.students.size() > b.students.size(); });
  return all;
}

namespace {

bool is_visible(const Rubric& rubric, const std::string& item) {
  return std::ranges::any_of(rubric.items, [&](const Item& one) {
    return one.name == item && one.visibility == Visibility::kVisible;
  });
}

void withhold_exact(FailingCase& failing) {
  properties::Discrepancy& answer = failing.answer;
  failing.is_withheld = true;
  answer.exact.clear();
  answer.error = 0;
  answer.condition.reset();
  answer.excuse = {};
  failing.answers.reset();
  if (failing.pictures) failing.pictures->exact.reset();
}

ItemGrade redacted(const Rubric& rubric, const Item& item, ItemGrade grade) {
  if (!is_visible(rubric, grade.reason.item)) grade.reason.item.clear();
  grade.first_wrong.reset();
  const Detail detail = item.visibility == Visibility::kHidden ? Detail::kNothing : item.detail;
  if (detail == Detail::kNothing) {
    grade.failing.reset();
    grade.mistakes.clear();
  } else if (detail == Detail::kActualOnly && grade.failing) {
    withhold_exact(*grade.failing);
  }
  return grade;
}

}  // namespace

StudentGrade student_grade(const Rubric& rubric, const SubmissionGrade& grade, HiddenBy hidden_by) {
  StudentGrade result{std::filesystem::path(rubric.path).filename().string(),
                      rubric.dialect,
                      rubric.depth ? rubric.depth->text() : "",
                      rubric.title,
                      grade,
                      {},
                      0};
  result.submission.seed = 0;
  result.submission.items.clear();
  for (std::size_t k = 0; k < grade.items.size(); ++k) {
    const Item& item = rubric.items[k];
    if (item.visibility != Visibility::kVisible && hidden_by == HiddenBy::kUs) {
      ++result.unlisted;
      continue;
    }
    result.items.push_back(&item);
    result.submission.items.push_back(redacted(rubric, item, grade.items[k]));
  }
  return result;
}

}  // namespace raycheck::tools
