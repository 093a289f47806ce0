#include "tools/grade/grade.h"

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
#include "tools/grade/results/record.h"
#include "tools/grade/store/store.h"
#include "tools/implementations/built_in.h"
#include "tools/report/version.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using properties::RunControl;

constexpr const char* kResultsFile = "results.json";  ///< For a course's system.
constexpr const char* kSceneEnding = ".toml";
constexpr const char* kDriverEnding = ".txt";

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

void judge_all(const Rubric& rubric, JudgedSubmission judged, const RunControl& control,
               SubmissionGrade& grade) {
  grade.items = judge(rubric, std::move(judged), grade.seed, control);
  for (const ItemGrade& item : grade.items) {
    grade.score += item.score;
    (item.bonus ? grade.bonus : grade.points) += item.bonus ? item.score : item.points;
  }
  grade.finished = !control.interrupted();
}

/// Records that the submission could not be run: no item is judged, and the rubric's `unjudged`
/// gives the score.
void refuse(const Rubric& rubric, const Refusal& refusal, SubmissionGrade& grade) {
  grade.refused = {plain_text(refusal.why), plain_text(refusal.said)};
  const bool pictures = grade.program && grade.program->kind == CandidateKind::kRenderer;
  for (const Item& item : rubric.items) {
    ItemGrade none = unjudged(item, pictures);
    none.reason.kind = ItemReason::Kind::kNothingRuns;
    if (!item.bonus) grade.points += none.points;
    grade.items.push_back(std::move(none));
  }
  grade.score = rubric.unjudged * grade.points;
}

void take_what_was_found(const Preparation& found, SubmissionGrade& grade) {
  grade.program = found.program;
  grade.build_words = found.build_words;
  grade.adapter = found.adapter;
  grade.opaque_files = found.opaque_files;
  grade.notes = found.all_notes();
  if (found.dry_run) grade.driver = found.dry_run->driver;
}

/// Adds the note that pictures show nothing. If the submission has points, it draws scenes other
/// than the dry run's, and there is no note.
void note_that_nothing_shows(const std::optional<DryRun>& dry, SubmissionGrade& grade) {
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
    for (const char* ending : {kSceneEnding, kDriverEnding}) {
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
    const std::string driver = driver_file_text(*failing, shown.submission.driver);
    if (!driver.empty()) files[name + kDriverEnding] = driver;
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
        layers_(here_.layers),
        submissions_(find_submissions(options.submissions, names_of_class_files())) {
    if (!options.out.empty()) {
      require_disjoint(options_.out, submissions_);
      own_.emplace(options_.out);
      require_place();
      for (const Submission& submission : submissions_) own_->make_folder(submission.name);
      if (!options.for_student) store_.emplace(options_.out);
    }
    test_environment(rubric_, layers_);
  }

  ClassGrade grade(const RunControl& control, Units* units) {
    ClassGrade result;
    if (units != nullptr) grade_shard(control, *units);
    if (units != nullptr && !units->are_all()) {
      result.interrupted = control.interrupted();
      return result;
    }
    std::vector<Graded> all = done_for_each<Graded>(
        submissions_, control,
        [&](const Submission& one, bool alone) { return graded(one, control, alone); });
    for (Graded& one : all) {
      add_times(one.grade, result.times);
      if (!one.outside.empty()) ++result.not_graded;
      result.submissions.push_back(std::move(one.grade));
    }
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
    const auto all = done_for_each<Graded>(mine, control, [&](const Submission& one, bool alone) {
      return graded(one, control, alone);
    });
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k].grade.finished && all[k].outside.empty()) units.write(open[k], all[k].grade.name);
    }
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

  static void add_times(const SubmissionGrade& grade, std::optional<GradingTimes>& times) {
    if (!times) times.emplace();
    times->build_seconds += grade.build_seconds;
    times->judge_seconds += grade.judge_seconds;
    times->stored_builds += grade.build_is_stored ? 1 : 0;
  }

  struct Graded {
    SubmissionGrade grade;
    std::string outside = {};  ///< Why the environment failed, so that there is no grade; or empty.
  };

  Graded graded(const Submission& submission, const RunControl& control, bool alone) {
    Graded one;
    one.grade.name = submission.name;
    one.grade.seed =
        options_.secret ? secret_seed(*options_.secret, submission.name) : options_.seed;
    one.grade.isolation = layers_;
    try {
      one.outside = grade_one(submission, control, alone, one.grade);
    } catch (const std::logic_error& error) {
      const auto* const ours = dynamic_cast<const properties::InternalError*>(&error);
      throw properties::InternalError(fmt::format("{}: {}", submission.name, error.what()),
                                      ours != nullptr ? ours->the_case : std::nullopt);
    }
    if (own_) write(submission, one.grade);
    return one;
  }

  /// How raycheck knows the form that a renderer reads, after a dry run if there was one.
  static FormKnown form_known(const DriverRule& rule, const std::optional<DryRun>& dry) {
    const bool is_given = !dry || !rule.tries_others ||
                          (rule.is_asked_for && dry->shows_a_sphere() && dry->driver == rule.form);
    if (is_given) return FormKnown::kGiven;
    return dry->shows_a_sphere() ? FormKnown::kFound : FormKnown::kNot;
  }

  /// Grades a submission. If there is no grade for a reason that is not its fault, returns that
  /// reason; otherwise an empty text.
  std::string grade_one(const Submission& submission, const RunControl& given, bool alone,
                        SubmissionGrade& grade) {
    Stopwatch watch;
    const auto surroundings = std::make_shared<Surroundings>(alone);
    const RunControl control = until_blamed(given, *surroundings);
    const SubmissionGrade before = grade;
    try {
      const RunnableSubmission runnable = prepare(submission, rubric_, {layers_, surroundings},
                                                  control, store_ ? &*store_ : nullptr);
      grade.build_seconds = watch.lap();
      grade.build_is_stored = runnable.build_is_stored;
      take_what_was_found(runnable.found, grade);
      const auto last_failure = std::make_shared<std::optional<FailureKind>>();
      const auto& dry = runnable.found.dry_run;
      judge_all(rubric_,
                {external_candidate(runnable.external, last_failure),
                 runnable.found.program->kind == CandidateKind::kRenderer,
                 form_known(rubric_.driver, dry), dry ? dry->driver.dialect : scene::Dialect::kB,
                 last_failure, !runnable.found.adapter.empty(), runnable.external.program.spent},
                control, grade);
      note_that_nothing_shows(dry, grade);
      if (std::string note = inexpressible_text(grade); !note.empty()) grade.notes.push_back(note);
      grade.judge_seconds = watch.lap();
    } catch (const SubmissionError& error) {
      grade.build_seconds = watch.lap();
      take_what_was_found(error.found(), grade);
      refuse(rubric_, error.refusal(), grade);
      grade.finished = !control.interrupted();
    } catch (const scene::Interrupted&) {
      // The next run grades it.
      refuse(rubric_, {"raycheck was interrupted before the first question", ""}, grade);
    } catch (const std::logic_error&) {  // raycheck's own
      throw;
    } catch (const std::exception& error) {
      surroundings->blame(error.what());
    }
    // If the submission is not at fault, the next run grades it again.
    const std::string cause = surroundings->cause();
    if (!cause.empty()) {
      grade = before;
      refuse(rubric_, outside_refusal(cause), grade);
    }
    return cause;
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
  Layers layers_;
  std::vector<Submission> submissions_;
  std::optional<OwnFiles> own_;  ///< Absent if no results are written.
  std::optional<Store> store_;   ///< Absent if there is no `out`, and for students.
};

}  // namespace

ClassGrade grade(const GradeOptions& options, const RunControl& control, Units* units) {
  return ClassRun(options).grade(control, units);
}

std::vector<SubmissionGrade> try_rubric(const Rubric& rubric, std::uint64_t seed,
                                        const RunControl& control) {
  const auto asks = [&](const auto& task) {
    return std::ranges::any_of(rubric.items,
                               [&](const Item& item) { return (item.*task).has_value(); });
  };
  std::vector<SubmissionGrade> grades;
  const auto try_on = [&](const char* name, const properties::Candidate& candidate, bool pictures) {
    SubmissionGrade grade;
    grade.name = name;
    grade.seed = seed;
    judge_all(rubric, {candidate, pictures}, control, grade);
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

bool TryReport::holds() const {
  const auto item_holds = [](const ItemGrade& item) {
    return item.state == ItemState::kHolds || item.state == ItemState::kNotAsked;
  };
  return std::ranges::all_of(shown, [&](const StudentGrade& one) {
    return could_be_judged(one.submission) && std::ranges::all_of(one.submission.items, item_holds);
  });
}

TryReport try_submission(GradeOptions options, const properties::RunControl& control) {
  options.for_student = true;
  ClassGrade graded = grade(options, control);
  TryReport report;
  report.interrupted = graded.interrupted;
  report.rubric = std::make_shared<const Rubric>(std::move(graded.rubric));
  report.out = options.out;
  for (const SubmissionGrade& grade : graded.submissions) {
    report.shown.push_back(student_grade(*report.rubric, grade, HiddenBy::kUs));
  }
  return report;
}

namespace {

/// The lines that `grade` prints for one submission, then details of the items that fail. `out`:
/// the folder of the results; or empty.
std::string try_text(const StudentGrade& shown, const std::string& out) {
  std::string text = submission_text(shown.items, shown.submission);
  if (shown.unlisted > 0) text += "  " + unlisted_text(shown) + "\n";
  for (std::size_t k = 0; k < shown.items.size(); ++k) {
    const ItemGrade& item = shown.submission.items[k];
    // For items that were not answered, the line above is complete.
    const bool has_more = item.failing || item.reason.kind != ItemReason::Kind::kUnanswered;
    if (item.state != ItemState::kFails || !has_more) continue;
    text += "\n" + shown.items[k]->name + "\n" + indented(item_text(shown, k), "  ");
  }
  if (!out.empty()) {
    const bool has_cases = std::ranges::any_of(
        shown.submission.items, [](const ItemGrade& item) { return item.failing.has_value(); });
    text +=
        fmt::format("\nwrote {}/report.html{}\n", (fs::path(out) / shown.submission.name).string(),
                    has_cases ? ", and the smallest failing cases beside it" : "");
  }
  return text;
}

}  // namespace

std::string try_text(const TryReport& report) {
  std::string text = report.rubric->title + "\n";
  for (std::size_t k = 0; k < report.shown.size(); ++k) {
    text += (k == 0 ? "" : "\n") + try_text(report.shown[k], report.out);
  }
  if (report.interrupted) text += "INTERRUPTED: these are the results so far.\n";
  return text;
}

}  // namespace raycheck::tools
