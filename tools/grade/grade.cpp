#include "tools/grade/grade.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "properties/mistakes/image_explanation.h"
#include "tools/grade/digest.h"
#include "tools/grade/judge.h"
#include "tools/grade/pages.h"
#include "tools/grade/words.h"
#include "tools/methods/methods.h"
#include "tools/report/output_file.h"
#include "tools/report/version.h"
#include "tools/run/in_order.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using properties::RunControl;
using RecordJson = nlohmann::json;

constexpr const char* kRecord = "result.json";

void judge_all(const Rubric& rubric, const properties::Candidate& candidate, bool pictures,
               const RunControl& control, SubmissionGrade& grade) {
  Judge judge(rubric, candidate, pictures, grade.seed, control);
  for (std::size_t k = 0; k < rubric.items.size(); ++k) {
    grade.items.push_back(judge.item(k, grade.items));
    const ItemGrade& item = grade.items.back();
    if (!item.bonus) grade.points += item.points;
    grade.score += item.score;
  }
  grade.finished = !control.interrupted();
}

bool is_renderer(const std::string& form) { return form.starts_with("renderer:"); }

/// Nothing could be asked of it: every item of its form has its points, and none is given.
void refuse(const Rubric& rubric, const std::string& why, SubmissionGrade& grade) {
  grade.refused = plain_text(why);
  for (const Item& item : rubric.items) {
    ItemGrade none;
    none.name = item.name;
    none.bonus = item.bonus;
    const bool is_asked = (is_renderer(grade.form) ? item.pictures : item.functions).has_value();
    none.points = is_asked ? item.points : 0;
    none.state = is_asked ? kNotJudged : kNotAsked;
    none.reason = "nothing could be asked";
    if (!item.bonus) grade.points += none.points;
    grade.items.push_back(std::move(none));
  }
}

class Class {
 public:
  explicit Class(const GradeOptions& options)
      : options_(options),
        rubric_(load_rubric(options.rubric)),
        layers_(chosen_layers(options.sandbox)),
        submissions_(find_submissions(options.submissions)) {
    for (const Submission& submission : submissions_) {
      std::error_code error;
      fs::create_directories(folder_of(submission), error);
      if (error) {
        throw std::invalid_argument(fmt::format("--out {}: {}", options.out, error.message()));
      }
    }
  }

  ClassGrade grade(const RunControl& control) {
    ClassGrade result;
    struct Graded {
      SubmissionGrade grade;
      bool reused = false;
    };
    in_order<Graded>(
        static_cast<std::int64_t>(submissions_.size()), control,
        [&](std::int64_t k) {
          const Submission& submission = submissions_[static_cast<std::size_t>(k)];
          Graded graded;
          graded.grade = new_grade(submission);
          if (std::optional<SubmissionGrade> known = record_of(submission, graded.grade.key)) {
            graded = {std::move(*known), true};
          } else {
            grade_one(submission, control, graded.grade);
          }
          write(submission, graded.grade);
          return graded;
        },
        [&](Graded& graded) {
          result.reused += graded.reused ? 1 : 0;
          result.submissions.push_back(std::move(graded.grade));
          control.progress(
              fmt::format("{} of {} graded", result.submissions.size(), submissions_.size()));
        });
    result.rubric = rubric_;
    result.out = options_.out;
    result.interrupted = control.interrupted();
    const fs::path out(options_.out);
    OutputFile("--out", out / kClassTable).write(class_csv(result));
    OutputFile("--out", out / kClassPage).write(class_page(result));
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
    grade.key = digest({std::string(kVersion), rubric_.digest, digest(submission),
                        std::to_string(grade.seed), layers_.text()});
    grade.kept_by = layers_.text();
    return grade;
  }

  void grade_one(const Submission& submission, const RunControl& control,
                 SubmissionGrade& grade) const {
    try {
      const Prepared prepared = prepare(submission, rubric_, layers_);
      grade.form = prepared.form;
      judge_all(rubric_, external_candidate(prepared.external), is_renderer(grade.form), control,
                grade);
    } catch (const Refused& refused) {
      grade.form = refused.form();
      refuse(rubric_, refused.what(), grade);
      grade.finished = !control.interrupted();
    } catch (const std::exception& error) {
      // Of this machine, not of the submission: it is graded again by the next run.
      grade.items.clear();
      grade.score = grade.points = 0;
      refuse(rubric_, fmt::format("raycheck could not grade it: {}", error.what()), grade);
    }
  }

  /// What an earlier run finished.
  std::optional<SubmissionGrade> record_of(const Submission& submission,
                                           const std::string& key) const {
    std::ifstream file(folder_of(submission) / kRecord, std::ios::binary);
    if (!file) return {};
    try {
      auto grade = RecordJson::parse(file).get<SubmissionGrade>();
      grade.name = submission.name;
      if (grade.finished && grade.key == key) return grade;
    } catch (const RecordJson::exception&) {
      // no record, then
    }
    return {};
  }

  void write(const Submission& submission, const SubmissionGrade& grade) const {
    const fs::path folder = folder_of(submission);
    const auto put = [&](const std::string& name, const std::string& text) {
      OutputFile("--out", folder / name).write(text);
    };
    // Those of an earlier grade.
    for (const auto& entry : fs::directory_iterator(folder)) {
      const fs::path ending = entry.path().extension();
      const bool is_old =
          ending == ".toml" || ending == ".txt" || entry.path().filename() == "results.json";
      if (is_old) fs::remove(entry.path());
    }
    for (std::size_t k = 0; k < grade.items.size(); ++k) {
      const Item& item = rubric_.items[k];
      if (item.visibility != Visibility::kVisible) continue;
      for (const FailingCase& failing : thinned(rubric_, item, grade.items[k]).failing) {
        put(file_name(item.name) + ".toml", failing.scene);
        if (!failing.driver.empty()) put(file_name(item.name) + ".txt", failing.driver);
      }
    }
    put("report.html", student_page(rubric_, grade));
    if (options_.results_for == ResultsFor::kGradescope) {
      put("results.json", gradescope_results(rubric_, grade));
    } else if (options_.results_for == ResultsFor::kPrairieLearn) {
      put("results.json", prairielearn_results(rubric_, grade));
    }
    // Names of files and folders may be no UTF-8.
    put(kRecord,
        RecordJson(grade).dump(2, ' ', false, RecordJson::error_handler_t::replace) + "\n");
  }

  const GradeOptions& options_;
  Rubric rubric_;
  Layers layers_;
  std::vector<Submission> submissions_;
};

}  // namespace

ClassGrade grade(const GradeOptions& options, const RunControl& control) {
  return Class(options).grade(control);
}

std::vector<SubmissionGrade> try_rubric(const Rubric& rubric, std::uint64_t seed,
                                        const RunControl& control) {
  const auto asks = [&](const auto& questions) {
    return std::any_of(rubric.items.begin(), rubric.items.end(),
                       [&](const Item& item) { return (item.*questions).has_value(); });
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
