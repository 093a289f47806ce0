#pragma once

#include <array>
#include <boost/algorithm/string/join.hpp>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "properties/candidate.h"
#include "properties/decision.h"
#include "properties/truth.h"
#include "tools/external/candidate_spec.h"
#include "tools/external/pictures/driver_form.h"
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

/// An answer that breaks a law.
struct WrongAnswer {
  properties::Quantity quantity = properties::Quantity::kFrame;
  properties::Place place;
  std::string part;  ///< "U", "scaled by 2^40"; for a failure, its message.
  properties::Wrong wrong = properties::Wrong::kNot;
  std::string symbol;       ///< The symbol of the numbers, "s" or "Q"; may be empty.
  std::vector<double> got;  ///< Empty for a miss, or if the answer has no numbers.
  std::optional<std::vector<double>> exact;  ///< Like `got`; absent if withheld.
  /// In the quantity's unit; absent if withheld, and for decisions.
  std::optional<double> error;
  std::optional<double> condition;  ///< The condition number; absent if not computed.
  scene::Precision precision = scene::Precision::kDouble;  ///< The format of the unit.
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
  std::string law;  ///< The name of the law.
  CaseOrigin origin;
  std::optional<std::string> step;  ///< The first step that goes wrong, if known: "direction".
  WrongAnswer answer;
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
  WrongAnswer answer;
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
  enum class Kind {
    kNone,
    kNotInPictures,     ///< The item cannot be judged from a picture.
    kOfRenderers,       ///< The item applies only to renderers.
    kNeeds,             ///< An item that it needs does not have all points.
    kFollows,           ///< It fails because of the mistake of another item.
    kTimeUp,            ///< The limit for all questions of the submission was reached.
    kInterrupted,       ///< The run was interrupted.
    kOtherColours,      ///< A picture's colours do not identify the spheres.
    kUnanswered,        ///< The candidate lacks a function, or its hits cannot be compared.
    kNothingToCompare,  ///< There were no cases.
    kNeverRight,        ///< All answers about a quantity are excused; none is right.
    kNothingRuns,       ///< The submission could not be run.
    kCannotBeSaid       ///< No case can be written in its input format.
  };
  Kind kind = Kind::kNone;
  std::string item = {};                ///< The item that it needs or follows; empty if withheld.
  ItemState state = ItemState::kFails;  ///< The state of that item.
  double seconds = 0;                   ///< The time limit.
  std::string law = {}, said = {};      ///< The unanswered law, and why it was not answered.
  std::string function = {};            ///< The missing function, "frame()"; or empty.
  std::string quantity = {};            ///< The quantity without a right answer.
};
inline constexpr std::array<std::string_view, 13> kReasonNames = {"",
                                                                  "not in pictures",
                                                                  "of renderers",
                                                                  "needs",
                                                                  "follows",
                                                                  "time is up",
                                                                  "interrupted",
                                                                  "other colours",
                                                                  "unanswered",
                                                                  "nothing to compare",
                                                                  "never right",
                                                                  "nothing runs",
                                                                  "cannot be said"};

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

struct SubmissionGrade {
  std::string name;
  std::optional<CandidateSpec> program;  ///< The program as it was run; absent if there is none.
  /// The shell command that built the submission in a copy of its folder; empty if nothing had to
  /// be built, or if raycheck compiled it.
  std::string build_words = {};
  std::string adapter = {};  ///< The name of its form's adapter; or empty.
  DriverForm driver = {};    ///< For a renderer: the form of its driver files.
  /// Remarks on the dry run and the build, a sentence each.
  std::vector<std::string> notes = {};
  std::vector<OpaqueFile> opaque_files = {};  ///< Files that instructors should look at.
  Layers isolation;
  std::optional<Refusal> refused;
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

/// The total times of the submissions that this run graded.
struct GradingTimes {
  double build_seconds = 0, judge_seconds = 0;
  std::uint64_t stored_builds = 0;  ///< The number of submissions whose build was in the store.
};

struct ClassGrade {
  Rubric rubric;
  std::string out;  ///< The folder of results; empty if nothing is written.
  std::vector<SubmissionGrade> submissions;  ///< In the given order, as far as reached.
  std::optional<LayersHere> isolation = {};  ///< Absent if no submission was run.
  /// The number of submissions not graded for a reason that is not their fault; the next run tries
  /// them again.
  std::uint64_t not_graded = 0;
  bool interrupted = false;
  std::optional<GradingTimes> times = {};  ///< Absent if no submission was run.
};

using Submissions = std::vector<const SubmissionGrade*>;

/// The submissions that could be judged, or could not, in the order of the class.
Submissions submissions_that(const ClassGrade& graded, bool are_judged);

/// The middle value, or the mean of the two middle values; empty if there are none.
std::optional<double> median(std::vector<double> values);

struct ItemStatistics {
  const Item* item = nullptr;
  std::size_t asked = 0;  ///< The number of judged submissions that were asked.
  std::size_t failing = 0;
  std::size_t left_out = 0;  ///< Left out, or not judged because the time was up.
};
/// The statistics of each item, in the order of the rubric.
/// Domain: grades of `graded.rubric`, which outlives the result.
std::vector<ItemStatistics> item_statistics(const ClassGrade& graded);

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
  std::string title;               ///< The rubric's title.
  SubmissionGrade submission;      ///< Contains only visible items, and no seed.
  std::vector<const Item*> items;  ///< The rubric's item for each item of the submission.
  std::size_t unlisted = 0;  ///< The number of items that count in the score but are not shown.
};

/// Domain: `grade` has all items of the rubric, which outlives the result.
StudentGrade student_grade(const Rubric& rubric, const SubmissionGrade& grade, HiddenBy hidden_by);

}  // namespace raycheck::tools
