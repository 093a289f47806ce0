#include "tools/grade/grade.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "properties/mistakes/image_explanation.h"
#include "tools/grade/digest.h"
#include "tools/grade/judge.h"
#include "tools/grade/record.h"
#include "tools/grade/redaction.h"
#include "tools/grade/submission.h"
#include "tools/grade/wording.h"
#include "tools/methods/methods.h"
#include "tools/report/output_file.h"
#include "tools/report/version.h"
#include "tools/run/in_order.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using properties::RunControl;

constexpr const char* kRecord = "result.json";

void judge_all(const Rubric& rubric, const properties::Candidate& candidate, bool pictures,
               const RunControl& control, SubmissionGrade& grade,
               LastFailure last_failure = nullptr) {
  Judge judge(rubric, candidate, pictures, grade.seed, control, std::move(last_failure));
  for (std::size_t k = 0; k < rubric.items.size(); ++k) {
    grade.items.push_back(judge.item(k, grade.items));
    const ItemGrade& item = grade.items.back();
    if (!item.bonus) grade.points += item.points;
    grade.score += item.score;
  }
  grade.finished = !control.interrupted();
}

/// Nothing could be asked of it: every item of its form has its points, and none is given.
void refuse(const Rubric& rubric, const Refusal& refusal, SubmissionGrade& grade) {
  grade.refused = {plain_text(refusal.why), plain_text(refusal.said)};
  const bool pictures = grade.program && grade.program->kind == CandidateKind::kRenderer;
  for (const Item& item : rubric.items) {
    ItemGrade none;
    none.name = item.name;
    none.bonus = item.bonus;
    none.pictures = pictures;
    const bool is_asked = (pictures ? item.pictures : item.functions).has_value();
    none.points = is_asked ? item.points : 0;
    none.state = is_asked ? ItemState::kNotJudged : ItemState::kNotAsked;
    none.reason.kind = ItemReason::Kind::kNothingRuns;
    if (!item.bonus) grade.points += none.points;
    grade.items.push_back(std::move(none));
  }
}

/// One run over a class, into its folder of results.
class ClassRun {
 public:
  explicit ClassRun(const GradeOptions& options)
      : options_(options),
        rubric_(load_rubric(options.rubric)),
        layers_(chosen_layers(options.sandbox)),
        submissions_(find_submissions(options.submissions)) {
    for (const Submission& submission : submissions_) {
      std::error_code error;
      fs::create_directories(folder_of(submission), error);
      if (error) {
        throw std::invalid_argument(fmt::format("out {}: {}", options.out, error.message()));
      }
    }
  }

  ClassGrade grade(const RunControl& control) {
    ClassGrade result;
    struct MaybeReused {
      SubmissionGrade grade;
      bool reused = false;
    };
    in_order<MaybeReused>(
        static_cast<std::int64_t>(submissions_.size()), control,
        [&](std::int64_t k) {
          const Submission& submission = submissions_[static_cast<std::size_t>(k)];
          MaybeReused graded;
          graded.grade = new_grade(submission);
          if (std::optional<SubmissionGrade> known = record_of(submission, graded.grade.key)) {
            graded = {std::move(*known), true};
          } else {
            grade_one(submission, control, graded.grade);
          }
          write(submission, graded.grade);
          return graded;
        },
        [&](MaybeReused& graded) {
          result.reused += graded.reused ? 1 : 0;
          result.submissions.push_back(std::move(graded.grade));
          control.progress(
              fmt::format("{} of {} graded", result.submissions.size(), submissions_.size()));
        });
    result.rubric = rubric_;
    result.out = options_.out;
    result.interrupted = control.interrupted();
    const fs::path out(options_.out);
    for (const ClassView& file : class_files()) {
      OutputFile("out", out / file.name).write(file.render(result));
    }
    return result;
  }

 private:
  fs::path folder_of(const Submission& submission) const {
    return fs::path(options_.out) / submission.name;
  }

  SubmissionGrade new_grade(const Submission& submission) const {
    SubmissionGrade grade;
    grade.name = submission.name;
    grade.seed = options_.secret ? secret_seed(*options_.secret, submission.name) : options_.seed;
    grade.key = digest({std::string(kVersion), std::string(kRecordShape), rubric_.digest,
                        digest(submission), std::to_string(grade.seed), layers_.text()});
    grade.isolation = layers_;
    return grade;
  }

  void grade_one(const Submission& submission, const RunControl& control,
                 SubmissionGrade& grade) const {
    try {
      const RunnableSubmission runnable = prepare(submission, rubric_, layers_);
      grade.program = runnable.program;
      const auto last_failure = std::make_shared<std::optional<FailureKind>>();
      judge_all(rubric_, external_candidate(runnable.external, last_failure),
                runnable.program.kind == CandidateKind::kRenderer, control, grade, last_failure);
    } catch (const SubmissionError& error) {
      grade.program = error.program();
      refuse(rubric_, error.refusal(), grade);
      grade.finished = !control.interrupted();
    } catch (const std::exception& error) {
      // Of this machine, not of the submission: it is graded again by the next run.
      grade.items.clear();
      grade.score = grade.points = 0;
      refuse(rubric_, {fmt::format("raycheck could not grade it: {}", error.what()), ""}, grade);
    }
  }

  /// The grade that an earlier run finished, where it depended on the same as `key`.
  std::optional<SubmissionGrade> record_of(const Submission& submission,
                                           const std::string& key) const {
    std::ifstream file(folder_of(submission) / kRecord, std::ios::binary);
    if (!file) return {};
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    try {
      SubmissionGrade grade = read_record(text);
      grade.name = submission.name;
      grade.isolation = layers_;  // the key says so
      if (grade.finished && grade.key == key) return grade;
    } catch (const std::exception&) {
      // no record, then
    }
    return {};
  }

  void write(const Submission& submission, const SubmissionGrade& grade) const {
    const fs::path folder = folder_of(submission);
    const auto put = [&](const std::string& name, const std::string& text) {
      OutputFile("out", folder / name).write(text);
    };
    // Those of an earlier grade.
    for (const auto& entry : fs::directory_iterator(folder)) {
      const fs::path ending = entry.path().extension();
      const bool is_old =
          ending == ".toml" || ending == ".txt" || entry.path().filename() == "results.json";
      if (is_old) fs::remove(entry.path());
    }
    const StudentGrade shown = student_grade(rubric_, grade, HiddenBy::kUs);
    for (std::size_t k = 0; k < shown.items.size(); ++k) {
      const auto& failing = shown.submission.items[k].failing;
      if (!failing) continue;
      const std::string name = file_name(shown.items[k]->name);
      put(name + ".toml", scene_text(*failing));
      const std::string driver = driver_file_text(*failing, rubric_.dialect);
      if (!driver.empty()) put(name + ".txt", driver);
    }
    put("report.html", student_page(shown));
    if (const ResultsFormat* results = options_.results) {
      put("results.json", results->render(student_grade(rubric_, grade, results->hidden_by)));
    }
    put(kRecord, record_text(grade));
  }

  const GradeOptions& options_;
  Rubric rubric_;
  Layers layers_;
  std::vector<Submission> submissions_;
};

}  // namespace

ClassGrade grade(const GradeOptions& options, const RunControl& control) {
  return ClassRun(options).grade(control);
}

std::vector<SubmissionGrade> try_rubric(const Rubric& rubric, std::uint64_t seed,
                                        const RunControl& control) {
  const auto asks = [&](const auto& task) {
    return std::any_of(rubric.items.begin(), rubric.items.end(),
                       [&](const Item& item) { return (item.*task).has_value(); });
  };
  std::vector<SubmissionGrade> grades;
  const auto try_on = [&](const char* name, const properties::Candidate& candidate, bool pictures) {
    SubmissionGrade grade;
    grade.name = name;
    grade.seed = seed;
    judge_all(rubric, candidate, pictures, control, grade);
    grades.push_back(std::move(grade));
  };
  if (asks(&Item::functions)) try_on("functions", candidate_of(kDefaultMethods), false);
  if (asks(&Item::pictures)) {
    properties::Candidate renderer;
    renderer.name = "pictures";
    renderer.excused_image_change = rubric.image_change;
    renderer.image = properties::exact_image;
    try_on("pictures", renderer, true);
  }
  return grades;
}

}  // namespace raycheck::tools
