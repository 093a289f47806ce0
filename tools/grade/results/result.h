#pragma once

#include <algorithm>
#include <array>
#include <boost/algorithm/string/join.hpp>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "properties/candidate.h"
#include "properties/decision.h"
#include "properties/discrepancy.h"
#include "tools/external/candidate_spec.h"
#include "tools/external/pictures/dry_run.h"
#include "tools/external/sandbox/launch.h"
#include "tools/external/sandbox/process.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// The candidate with its bounds replaced according to the tolerance of an item.
properties::Candidate tolerated(properties::Candidate candidate, const Tolerance& tolerance);

/// The output of a program or compiler, without the names of raycheck's private folders and without
/// non-ASCII characters.
std::string plain_text(const std::string& said);

/// The origin of a case: a scene of the rubric, or a source of random cases.
struct CaseOrigin {
  std::string scene = {};    ///< The scene's name in the rubric; empty for a random case.
  std::string source = {};   ///< "course", "distance@3"
  std::uint64_t number = 0;  ///< The random case's number, from 1.
};

/// A picture and the exact one, pixel by pixel, in the order of the case's conventions. If an item
/// judges only masks, every sphere is kSomeSphere.
struct ComparedPictures {
  properties::ImageAnswer got;
  std::optional<properties::ImageAnswer> exact;  ///< Absent if withheld.
};

/// A submission's answers about one ray of a case, as judged. An answer is absent if the submission
/// was not asked or did not answer.
struct RayAnswers {
  std::optional<properties::FrameAnswer> frame = {};
  std::optional<scene::Point3> pixel_point = {};
  std::optional<scene::Ray> ray = {};  ///< The ray of a pixel.
  /// The hits of this ray, or of the given ray, by sphere index.
  std::optional<std::map<std::size_t, properties::HitAnswer>> hits = {};
};

/// The smallest case found on which an item fails.
struct FailingCase {
  CaseOrigin origin;
  std::optional<std::string> step;  ///< The first step that goes wrong, if known: "direction".
  properties::Discrepancy answer;   ///< The answer, and the law that it breaks.
  /// Whether the exact answer is withheld, with the error and the condition number, which would
  /// reveal it.
  bool is_withheld = false;
  properties::Case the_case;  ///< For pictures, no pixels means all pixels.
  /// Present if the program drew the case; both pictures have the camera's size.
  std::optional<ComparedPictures> pictures = {};
  /// For functions: the answers about the ray at the answer's place, or about the first ray; absent
  /// if withheld.
  std::optional<RayAnswers> answers = {};
};

/// The first wrong answer, before shrinking. Submissions with the same errors have the same first
/// wrong answer.
struct FirstWrongAnswer {
  CaseOrigin origin;
  properties::Discrepancy answer;
};

/// A mistake, the number of wrong answers (or pixels) of an item, and the number that the mistake
/// explains. Both are 0 if there are no answers, or no pictures of the right size.
struct ExplainingMistake {
  std::vector<std::string> sentences;  ///< One sentence for each mistake, if several act together.
  std::uint64_t wrong = 0, explained = 0;

  std::string sentence() const { return boost::join(sentences, "; and "); }
};

enum class ItemState {
  kHolds,
  kFails,
  kFollows,   ///< It fails only because of mistakes that are charged to other items.
  kLeftOut,   ///< A prerequisite failed.
  kNotAsked,  ///< The item does not apply to this form of submission.
  kNotJudged  ///< The time was up, or the run was interrupted.
};
inline constexpr std::array<std::string_view, 6> kItemStateNames = {
    "holds", "fails", "follows", "left out", "not asked", "not judged"};
constexpr std::string_view name(ItemState state) {
  return kItemStateNames[static_cast<std::size_t>(state)];
}

/// Why an item is left out, not asked or not judged, or why it fails without a failing case.
struct ItemReason {
  /// As in kReasons.
  enum class Kind {
    kNone,
    kNotInPictures,
    kOfRenderers,
    kNeeds,
    kFollows,
    kTimeUp,
    kInterrupted,
    kOtherColours,
    kUnanswered,
    kNothingToCompare,
    kNeverRight,
    kNothingRuns,
    kCannotBeSaid
  };
  Kind kind = Kind::kNone;
  std::string item = {};                ///< The item that it needs or follows; empty if withheld.
  ItemState state = ItemState::kFails;  ///< The state of that item.
  double seconds = 0;                   ///< The time limit.
  std::string law = {}, said = {};      ///< The unanswered law, and why it was not answered.
  std::string function = {};            ///< The missing function, "frame()"; or empty.
  std::string quantity = {};            ///< The quantity without a right answer.
};
/// The kinds of reasons: their names in JSON, and their texts, with the members of ItemReason in
/// braces ({is_state}: "is left out", but "fails").
struct ReasonWords {
  std::string_view name, text;
};
inline constexpr std::array<ReasonWords, 13> kReasons = {
    {{"", ""},
     {"not in pictures", "cannot be judged from a picture"},
     {"of renderers", "only for submissions that draw pictures"},
     {"needs", "'{item}' must have all points first, but {is_state}"},
     {"follows", "because of the mistake in '{item}'"},
     {"time is up", "time is up: the limit for all questions together is {seconds} s"},
     {"interrupted", "interrupted"},
     {"other colours", "its colours do not identify the spheres"},
     {"unanswered", "{law}: {said}"},
     {"nothing to compare", "there was nothing to compare"},
     {"never right", "{quantity}: all answers are excused, none is right"},
     {"nothing runs", "the submission could not be judged"},
     {"cannot be said", "its cases cannot be written in the input format of the program"}}};

struct ItemGrade {
  std::string name;
  ItemState state = ItemState::kNotJudged;
  ItemReason reason;
  double points = 0;  ///< The maximum score; 0 if the item is not asked.
  double score = 0;
  bool bonus = false;
  bool pictures = false;    ///< Whether it is judged by pictures. If not, by functions.
  std::uint64_t cases = 0;  ///< The number of cases with at least one question.
  std::uint64_t held = 0;
  /// The number of further cases, which cannot be written in its input format.
  std::uint64_t unsaid = 0;
  std::uint64_t comparisons = 0;
  std::vector<ExplainingMistake> mistakes;
  std::optional<FailingCase> failing;
  std::optional<FirstWrongAnswer> first_wrong;
};

/// An item before any question is asked.
ItemGrade unjudged(const Item& item, bool pictures);

/// A file of a submission whose content a human reader cannot judge.
struct OpaqueFile {
  std::string name;
  std::string kind;  ///< "picture"
  std::uintmax_t bytes = 0;
};

/// The findings about a submission while it is prepared, as far as it got.
struct Preparation {
  /// The candidate as for --candidate; absent if no form fits.
  std::optional<CandidateSpec> program = {};
  std::vector<std::string> files = {};  ///< The files at the top, with notebooks' modules.
  std::string adapter = {};             ///< The name of its form's adapter; or empty.
  bool built_automatically = false;     ///< Its form has build = "auto".
  /// The shell command that built it in a copy of its folder; empty: nothing had to be built, or
  /// raycheck compiled it.
  std::string build_words = {};
  std::optional<double> build_seconds = {};  ///< Absent: there is no program to start.
  /// Remarks on the build: "its Makefile failed; built from its sources".
  std::vector<std::string> notes = {};
  std::set<std::string> functions = {};  ///< The functions it implements; empty for a renderer.
  std::optional<DryRun> dry_run = {};    ///< For a renderer.
  std::vector<OpaqueFile> opaque_files = {};

  /// The form of its driver files, for a renderer.
  DriverForm driver() const { return dry_run ? dry_run->driver : DriverForm{}; }
  bool is_renderer() const { return program && program->kind == CandidateKind::kRenderer; }
};

struct SubmissionGrade {
  std::string name;
  Preparation found;
  /// Remarks on the build, the dry run and the cases, a sentence each, as plain text.
  std::vector<std::string> notes = {};
  Layers isolation;
  std::optional<Refusal> refused;
  /// The cause if a failure is not the submission's fault, so that there is no grade; or empty.
  std::string outside = {};
  /// The time for the build and the dry run, and the time for all questions of the rubric.
  double build_seconds = 0, judge_seconds = 0;
  bool build_is_stored = false;  ///< Whether the build came from the store.
  std::uint64_t seed = 0;
  bool finished = false;
  double points = 0;  ///< The maximum score of the items asked, without bonus.
  double score = 0;
  double bonus = 0;  ///< The part of the score that comes from bonus items.
  std::vector<ItemGrade> items;
};

/// A sentence about the cases that cannot be written in the submission's input format; empty if
/// there are none.
std::string inexpressible_text(const SubmissionGrade& grade);

/// Whether the submission ran. If not, its points mean nothing.
inline bool could_be_judged(const SubmissionGrade& grade) { return !grade.refused; }

struct ClassGrade {
  Rubric rubric;
  std::string out;  ///< The folder of results; empty if nothing is written.
  std::vector<SubmissionGrade> submissions;  ///< In the given order, as far as reached.
  std::optional<LayersHere> isolation = {};  ///< Absent if no submission was run.
  bool interrupted = false;

  /// The number of submissions not graded for a reason that is not their fault; the next run tries
  /// them again.
  std::ptrdiff_t not_graded() const {
    return std::ranges::count_if(submissions, [](const auto& one) { return !one.outside.empty(); });
  }
};

using Submissions = std::vector<const SubmissionGrade*>;

/// The submissions that could be judged, or could not, in the order of the class.
Submissions submissions_that(const ClassGrade& graded, bool are_judged);

/// A mistake, and the submissions that have it.
struct MistakeStatistics {
  std::string sentence;
  Submissions students;  ///< The submissions with an item whose wrong answers the mistake explains.
  int items = 0;         ///< The number of these items.
  bool costs = false;    ///< Whether the mistake costs points in one of these items.
  /// The item with the smallest failing case (fewest spheres, then pixels); null if there is none.
  const ItemGrade* smallest = nullptr;
  const SubmissionGrade* whose = nullptr;  ///< The submission of `smallest`, or null.
};
/// The statistics of each mistake, that of the most students first.
std::vector<MistakeStatistics> mistake_statistics(std::span<const SubmissionGrade> graded);

/// The system that hides items which students may not see, now or ever.
enum class HiddenBy {
  kUs,          ///< raycheck: only visible items are included.
  kOtherSystem  ///< The course's system: all items are included, hidden ones without failing cases.
};

/// The part of a grade that a student may see. Withheld parts are not in it, so that no view can
/// reveal them.
struct StudentGrade {
  std::string rubric;              ///< The rubric's file name.
  std::string dialect;             ///< The dialect that replaced the rubric's [driver], or empty.
  std::string depth;               ///< The rubric's depth, for --depth, or empty.
  std::string title;               ///< The rubric's title.
  SubmissionGrade submission;      ///< Contains only visible items, and no seed.
  std::vector<const Item*> items;  ///< The rubric's item for each item of the submission.
  std::size_t unlisted = 0;  ///< The number of items that count in the score but are not shown.
};

/// Domain: `grade` has all items of the rubric, which outlives the result.
StudentGrade student_grade(const Rubric& rubric, const SubmissionGrade& grade, HiddenBy hidden_by);

}  // namespace raycheck::tools
