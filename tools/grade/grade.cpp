#include "tools/grade/grade.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "properties/mistakes/shown_picture.h"
#include "scene/interruption.h"
#include "tools/grade/intake/prepare.h"
#include "tools/grade/judging/judge.h"
#include "tools/grade/store/store.h"
#include "tools/implementations/built_in.h"
#include "tools/report/output_file.h"
#include "tools/run/threads.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using properties::RunControl;

constexpr const char* kResultsFile = "results.json";  ///< For a course's system.
constexpr const char* kSceneEnding = ".toml";

class Stopwatch {
 public:
  /// Seconds since the last call, to the millisecond.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - std::exchange(last_, now);
    return std::round(passed.count() * 1000) / 1000;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Takes the grades of all items, and adds up their points.
void take(std::vector<ItemGrade> items, SubmissionGrade& grade) {
  grade.items = std::move(items);
  for (const ItemGrade& item : grade.items) {
    grade.score += item.score;
    (item.bonus ? grade.bonus : grade.points) += item.bonus ? item.score : item.points;
  }
}

void judge_all(const Rubric& rubric, JudgedSubmission judged, const RunControl& control,
               SubmissionGrade& grade) {
  take(judge(rubric, std::move(judged), grade.seed, control), grade);
  grade.finished = !control.interrupted();
}

/// Records that the submission could not be run: no item is judged, and the rubric's `unjudged`
/// gives the score.
void refuse(const Rubric& rubric, const Refusal& refusal, SubmissionGrade& grade) {
  grade.refused = {plain_text(refusal.why), plain_text(refusal.said)};
  std::vector<ItemGrade> items;
  for (const Item& item : rubric.items) {
    items.push_back(unjudged(item, grade.found.is_renderer()));
    items.back().reason.kind = ItemReason::Kind::kNothingRuns;
  }
  take(std::move(items), grade);
  grade.score = rubric.unjudged * grade.points;
}

/// Takes the findings, and their notes on the build and on the dry run.
void take(const Preparation& found, SubmissionGrade& grade) {
  grade.found = found;
  for (const std::string& note : found.notes) grade.notes.push_back(plain_text(note));
  if (!found.dry_run) return;
  for (const std::string& note : found.dry_run->notes) grade.notes.push_back(plain_text(note));
}

/// Adds the note that pictures show nothing. If the submission has points, it draws scenes other
/// than the dry run's, and there is no note.
void note_that_nothing_shows(SubmissionGrade& grade) {
  const std::optional<DryRun>& dry = grade.found.dry_run;
  if (!dry || dry->shows_nothing.empty()) return;
  const bool has_points =
      std::ranges::any_of(grade.items, [](const ItemGrade& item) { return item.score > 0; });
  if (!has_points) grade.notes.push_back(plain_text(dry->shows_nothing));
}

std::vector<std::string_view> names_of_class_files() {
  std::vector<std::string_view> names;
  for (const ClassView& file : kClassFiles) names.push_back(file.name);
  names.push_back(kStoreFolder);
  names.push_back(kOwnFilesList);
  return names;
}

/// All possible names of the files for a student.
std::vector<std::string> names_for_student(const Rubric& rubric) {
  std::vector<std::string> names = {kReportFile, kFiguresFile};
  for (const Item& item : rubric.items) {
    for (const std::string& ending : {std::string(kSceneEnding), rubric.driver.form.ending()}) {
      names.push_back(file_name(item.name) + ending);
    }
  }
  return names;
}

/// The files for a student by name: pages, and the failing cases as TOML and as driver files.
std::map<std::string, std::string> files_for_student(const StudentGrade& shown) {
  std::map<std::string, std::string> files;
  for (std::size_t k = 0; k < shown.items.size(); ++k) {
    const auto& failing = shown.submission.items[k].failing;
    if (!failing) continue;
    const std::string name = file_name(shown.items[k]->name);
    files[name + kSceneEnding] = scene_text(*failing);
    const Preparation& found = shown.submission.found;
    const std::string driver = driver_file_text(*failing, found);
    if (!driver.empty()) files[name + found.driver().ending()] = driver;
  }
  files[kReportFile] = report_page(shown);
  if (has_figures(shown)) files[kFiguresFile] = figures_page(shown);
  return files;
}

/// Grades a class once, into its folder of results.
class ClassRun {
 public:
  explicit ClassRun(const GradeOptions& options)
      : options_(options),
        rubric_(load_rubric(options.rubric, options.dialect)),
        here_(chosen_layers(options.sandbox)),
        submissions_(find_submissions(options.submissions, names_of_class_files())) {
    if (!options.out.empty()) {
      require_disjoint(options_.out, submissions_);
      own_.emplace(options_.out);
      require_place();
      for (const Submission& submission : submissions_) {
        make_folder("out", fs::path(options_.out) / submission.name);
      }
      if (!options.for_student) store_.emplace(options_.out);
    }
    test_environment(rubric_, here_.layers);
  }

  ClassGrade grade(const RunControl& control, Units* units) {
    ClassGrade result;
    if (units != nullptr) grade_shard(control, *units);
    if (units != nullptr && !units->are_all()) {
      result.interrupted = control.interrupted();
      return result;
    }
    result.submissions = graded(submissions_, control);
    result.rubric = rubric_;
    result.out = options_.out;
    result.isolation = here_;
    result.interrupted = control.interrupted();
    if (!store_) return result;
    for (const ClassView& file : kClassFiles) own_->write(file.name, file.render(result));
    return result;
  }

 private:
  /// Grades the submissions of a shard whose units are missing, and writes the units.
  void grade_shard(const RunControl& control, Units& units) {
    std::vector<std::int64_t> open;
    std::vector<Submission> mine;
    for (const std::int64_t unit : units.open(static_cast<std::int64_t>(submissions_.size()))) {
      if (units.read(unit)) continue;
      open.push_back(unit);
      mine.push_back(submissions_[static_cast<std::size_t>(unit)]);
    }
    const std::vector<SubmissionGrade> all = graded(mine, control);
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k].finished && all[k].outside.empty()) units.write(open[k], all[k].name);
    }
  }

  /// Grades submissions; the results are in order. If a failure is not the submission's fault, it
  /// is graded again at the end, with no other submission running.
  std::vector<SubmissionGrade> graded(const std::vector<Submission>& submissions,
                                      const RunControl& control) {
    std::vector<SubmissionGrade> all;
    in_order<SubmissionGrade>(
        static_cast<std::int64_t>(submissions.size()), control,
        [&](std::int64_t k) {
          return graded(submissions[static_cast<std::size_t>(k)], control, false);
        },
        [&](SubmissionGrade& one) {
          const std::string state =
              fmt::format("{} of {} done", all.size() + 1, submissions.size());
          control.progress(state);
          control.done(state + ": " + one.name);
          all.push_back(std::move(one));
        },
        // All results are kept in any case, so that none need wait for a slow build.
        std::max<std::size_t>(1, submissions.size()));
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k].outside.empty() || control.interrupted()) continue;
      const std::string again =
          submissions[k].name + ": repeated, with no other submission running";
      control.progress(again);
      all[k] = graded(submissions[k], control, true);
      control.done(again);
    }
    return all;
  }

  /// Checks before grading that no file that raycheck did not write has the name of a result.
  void require_place() const {
    std::vector<std::string> names = names_for_student(rubric_);
    if (!options_.for_student) {
      for (const ClassView& file : kClassFiles) own_->require_own(file.name);
      names.emplace_back(kRecordFile);
    }
    if (options_.results != nullptr) names.emplace_back(kResultsFile);
    for (const Submission& submission : submissions_) {
      for (const std::string& name : names) own_->require_own(fs::path(submission.name) / name);
    }
  }

  SubmissionGrade graded(const Submission& submission, const RunControl& control, bool alone) {
    SubmissionGrade grade;
    grade.name = submission.name;
    grade.seed = options_.secret ? secret_seed(*options_.secret, submission.name) : options_.seed;
    grade.isolation = here_.layers;
    try {
      grade_one(submission, control, alone, grade);
    } catch (const std::logic_error& error) {
      const auto* const ours = dynamic_cast<const properties::InternalError*>(&error);
      throw properties::InternalError(fmt::format("{}: {}", submission.name, error.what()),
                                      ours != nullptr ? ours->the_case : std::nullopt);
    }
    if (own_) write(submission, grade);
    return grade;
  }

  /// How raycheck knows the form that a renderer reads, after a dry run if there was one.
  static FormKnown form_known(const DriverRule& rule, const std::optional<DryRun>& dry) {
    const bool is_given = !dry || !rule.tries_others ||
                          (rule.is_asked_for && dry->shows_a_sphere() && dry->driver == rule.form);
    if (is_given) return FormKnown::kGiven;
    return dry->shows_a_sphere() ? FormKnown::kFound : FormKnown::kNot;
  }

  /// Asks a submission that runs all items.
  void ask(const RunnableSubmission& runnable, const RunControl& control, SubmissionGrade& grade) {
    const auto last_failure = std::make_shared<std::optional<FailureKind>>();
    const auto& dry = grade.found.dry_run;
    judge_all(rubric_,
              {external_candidate(runnable.external, last_failure), grade.found.is_renderer(),
               form_known(rubric_.driver, dry), grade.found.driver().format, last_failure,
               !grade.found.adapter.empty() || !runnable.external.declares.empty(),
               runnable.external.program.spent},
              control, grade);
    note_that_nothing_shows(grade);
    if (std::string note = inexpressible_text(grade); !note.empty()) grade.notes.push_back(note);
  }

  void grade_one(const Submission& submission, const RunControl& given, bool alone,
                 SubmissionGrade& grade) {
    Stopwatch watch;
    const auto surroundings = std::make_shared<Surroundings>(alone);
    RunControl control = given;
    control.interrupted = [&] { return given.interrupted() || !surroundings->cause().empty(); };
    const SubmissionGrade before = grade;
    try {
      RunOptions options = run_options(rubric_, here_.layers);
      options.surroundings = surroundings;
      const RunnableSubmission runnable =
          prepare(submission, rubric_, std::move(options), control, store_ ? &*store_ : nullptr);
      grade.build_seconds = watch.lap();
      grade.build_is_stored = runnable.build_is_stored;
      take(runnable.found, grade);
      if (!options_.probe) ask(runnable, control, grade);
      grade.judge_seconds = watch.lap();
    } catch (const SubmissionError& error) {
      grade.build_seconds = watch.lap();
      take(error.found, grade);
      refuse(rubric_, error.refusal, grade);
      grade.finished = !control.interrupted();
    } catch (const scene::Interrupted&) {
      if (options_.probe) throw;
      // The next run grades it.
      refuse(rubric_, {"raycheck was interrupted before the first question", ""}, grade);
    } catch (const std::logic_error&) {  // raycheck's own
      throw;
    } catch (const std::exception& error) {
      surroundings->blame(error.what());
    }
    // If the submission is not at fault, the next run grades it again.
    if (const std::string cause = surroundings->cause(); !cause.empty()) {
      grade = before;
      grade.outside = cause;
      refuse(rubric_, {"for a reason outside the submission: " + cause, ""}, grade);
    }
  }

  void write(const Submission& submission, const SubmissionGrade& grade) {
    auto files = files_for_student(student_grade(rubric_, grade, HiddenBy::kUs));
    if (const ResultsFormat* results = options_.results) {
      files[kResultsFile] = results->render(student_grade(rubric_, grade, results->hidden_by));
    }
    if (!options_.for_student) files[kRecordFile] = json_text(record_json(grade));
    own_->replace(submission.name, files);
  }

  const GradeOptions& options_;
  Rubric rubric_;
  LayersHere here_;
  std::vector<Submission> submissions_;
  std::optional<OwnFiles> own_;  ///< Absent if no results are written.
  std::optional<Store> store_;   ///< Absent if there is no `out`, and for students.
};

}  // namespace

ClassGrade grade(const GradeOptions& options, const RunControl& control, Units* units) {
  return ClassRun(options).grade(control, units);
}

ClassGrade try_rubric(const GradeOptions& options, const RunControl& control) {
  ClassGrade tried;
  tried.rubric = load_rubric(options.rubric, options.dialect);
  const auto try_on = [&](const auto& task, const properties::Candidate& candidate, bool pictures) {
    const bool is_asked = std::ranges::any_of(
        tried.rubric.items, [&](const Item& item) { return (item.*task).has_value(); });
    if (!is_asked) return;
    SubmissionGrade& grade = tried.submissions.emplace_back();
    grade.name = pictures ? "pictures" : "functions";
    grade.seed = options.seed;
    judge_all(tried.rubric, {candidate, pictures}, control, grade);
  };
  try_on(&Item::functions, candidate_of(kDefaultMethods), false);
  properties::Candidate renderer;
  renderer.name = "pictures";
  renderer.excused_image_change = tried.rubric.image_change;
  renderer.any_sample = tried.rubric.any_sample;
  renderer.image = properties::exact_image;
  try_on(&Item::pictures, renderer, true);
  tried.interrupted = control.interrupted();
  return tried;
}

}  // namespace raycheck::tools
