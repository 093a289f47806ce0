#pragma once

// What grading finds out, as data; views (views.h) make words of it.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/candidate.h"
#include "properties/truth.h"
#include "properties/verdict.h"
#include "tools/external/candidate_spec.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/external/sandbox/launch.h"
#include "tools/external/sandbox/process.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// The candidate held to what an item tolerates.
properties::Candidate tolerated(properties::Candidate candidate, const Tolerance& tolerance);

/// What someone's program or compiler said, without the names of raycheck's private folders and
/// without what is not ASCII.
std::string plain_text(const std::string& said);

/// Where a case comes from: a scene of the rubric, or a source of random cases.
struct CaseOrigin {
  std::string scene = {};    ///< As the rubric calls it; empty: a random case.
  std::string source = {};   ///< "course", "distance@3"
  std::uint64_t number = 0;  ///< Of a random case, from 1.
};

/// An answer that breaks a law.
struct WrongAnswer {
  properties::Quantity quantity = properties::Quantity::kFrame;
  properties::Place place;
  std::string part;  ///< "U", "scaled by 2^40"; of a failure what the candidate said.
  properties::Wrong wrong = properties::Wrong::kNot;
  std::string symbol;                        ///< Of the numbers: "s", "Q"; or empty.
  std::vector<double> got;                   ///< Empty: a miss, or no number.
  std::optional<std::vector<double>> exact;  ///< As for got; absent: withheld.
  /// In the quantity's unit, of a number that is off; absent: withheld, or right or wrong.
  std::optional<double> error;
  std::optional<double> condition;  ///< The condition number, where it was worked out.
  scene::Precision precision = scene::Precision::kDouble;  ///< What the unit is of.
};

/// A picture and what it is to show, pixel by pixel, in the order of the case's conventions; of an
/// item that judges masks kSomeSphere stands for every sphere.
struct ComparedPictures {
  properties::ImageAnswer got;
  std::optional<properties::ImageAnswer> exact;  ///< Absent: withheld.
};

/// What a submission answered about one ray of a case, as it was judged; of what it was not asked,
/// or did not answer, nothing.
struct RayAnswers {
  std::optional<properties::FrameAnswer> frame = {};
  std::optional<scene::Point3> pixel_point = {};
  std::optional<scene::Ray> ray = {};  ///< Of a pixel.
  /// Of that ray or the given one with each sphere that it is said to meet, by the sphere's index.
  std::optional<std::map<std::size_t, properties::HitAnswer>> hits = {};
};

/// The smallest case found that an item fails on.
struct FailingCase {
  std::string law;  ///< Its name.
  CaseOrigin origin;
  std::optional<std::string> step;  ///< The first step that goes wrong: "direction".
  WrongAnswer answer;
  properties::Case the_case;  ///< No pixels: of a picture, all of them.
  /// Of a program that drew a picture of the case; as many pixels as its camera has.
  std::optional<ComparedPictures> pictures = {};
  /// Of functions, about the ray of the answer's place, or the first; absent: withheld.
  std::optional<RayAnswers> answers = {};
};

/// The first wrong answer, before the case was made smaller: the same for submissions that go wrong
/// alike.
struct FirstWrongAnswer {
  CaseOrigin origin;
  WrongAnswer answer;
};

/// A mistake, and how many of an item's wrong answers (or pixels) it makes right. Nothing is
/// counted without answers, or without pictures of the right size.
struct ExplainingMistake {
  std::string sentence;
  std::uint64_t wrong = 0, explained = 0;
  /// Where it is several mistakes at once, the sentence of each.
  std::vector<std::string> parts = {};

  std::vector<std::string> each() const {
    return parts.empty() ? std::vector<std::string>{sentence} : parts;
  }
};

/// What became of an item.
enum class ItemState {
  kHolds,
  kFails,
  kFollows,   ///< It fails by a mistake alone that costs another item its points.
  kLeftOut,   ///< A prerequisite failed.
  kNotAsked,  ///< Not of this form of submission.
  kNotJudged  ///< Time was up, or it was interrupted.
};
inline constexpr std::array<std::string_view, 6> kItemStateNames = {
    "holds", "fails", "follows", "left out", "not asked", "not judged"};
constexpr std::string_view name(ItemState state) {
  return kItemStateNames[static_cast<std::size_t>(state)];
}

/// Why an item is left out, not asked, not judged, or fails without a case.
struct ItemReason {
  enum class Kind {
    kNone,
    kNotInPictures,     ///< A picture does not show it.
    kOfRenderers,       ///< It is asked of renderers only.
    kNeeds,             ///< Another item, which has not all points.
    kFollows,           ///< From the mistake of another item.
    kTimeUp,            ///< For all that the submission is asked.
    kInterrupted,       ///< The run was.
    kOtherColours,      ///< A picture's colours do not tell which sphere is seen.
    kUnanswered,        ///< Less is answered than a law asks.
    kNothingToCompare,  ///< There were no cases.
    kNeverRight,        ///< Every answer about some quantity has an excuse, and none is right.
    kNothingRuns        ///< Nothing of the submission could be run.
  };
  Kind kind = Kind::kNone;
  std::string item = {};                ///< The one that it needs; empty: withheld.
  ItemState state = ItemState::kFails;  ///< What became of that.
  double seconds = 0;                   ///< That it had.
  std::string law = {}, said = {};      ///< Which law was not answered, and why.
  std::string quantity = {};            ///< Of which no answer was right.
};
inline constexpr std::array<std::string_view, 12> kReasonNames = {
    "",           "not in pictures",    "of renderers", "needs",
    "follows",    "time is up",         "interrupted",  "other colours",
    "unanswered", "nothing to compare", "never right",  "nothing runs"};

struct ItemGrade {
  std::string name;
  ItemState state = ItemState::kNotJudged;
  ItemReason reason;
  double points = 0;  ///< To be had; 0 where it is not asked.
  double score = 0;
  bool bonus = false;
  bool pictures = false;    ///< It was asked for pictures, otherwise for functions.
  std::uint64_t cases = 0;  ///< Of which something was asked.
  std::uint64_t held = 0;
  std::uint64_t comparisons = 0;
  std::vector<ExplainingMistake> mistakes;
  std::optional<FailingCase> failing;
  std::optional<FirstWrongAnswer> first_wrong;
};

/// A file of a submission that cannot be seen through by reading it.
struct OpaqueFile {
  std::string name;
  std::string kind;  ///< "picture"
  std::uintmax_t bytes = 0;
};

/// What a grade depends on besides its seed and how the submission was isolated: digests, to tell
/// what has changed since.
struct GradeInputs {
  std::string raycheck;                      ///< Its version, and that of records.
  std::string submission;                    ///< Its files.
  std::string rubric;                        ///< What it says beside its items.
  std::map<std::string, std::string> items;  ///< By name: what each asks, with its scenes.
};

struct SubmissionGrade {
  std::string name;
  std::string key;  ///< Of all that the grade depends on.
  GradeInputs inputs;
  std::optional<CandidateSpec> program;  ///< As it was run; absent where none was found.
  /// The shell words that built it, in a copy of its folder; empty: nothing was to build, or
  /// raycheck compiled it.
  std::string build_words = {};
  DriverForm driver = {};  ///< Of a renderer: how its driver files are written.
  /// What the dry run found out, and what is worth knowing of how it was built, a sentence each.
  std::vector<std::string> notes = {};
  std::vector<OpaqueFile> opaque_files = {};  ///< For instructors to look at.
  Layers isolation;
  std::optional<Refusal> refused;
  /// To make it run, and to ask it all that the rubric asks.
  double build_seconds = 0, judge_seconds = 0;
  bool build_is_stored =
      false;  ///< What was built by an earlier run, or of equal files, was taken.
  std::uint64_t seed = 0;
  bool finished = false;
  double points = 0;  ///< Of items that are asked, bonus aside.
  double score = 0;
  double bonus = 0;  ///< Of the score, what comes on top of the points.
  std::vector<ItemGrade> items;
};

/// Otherwise its points say nothing: nothing of it ran.
inline bool could_be_judged(const SubmissionGrade& grade) { return !grade.refused; }

/// What a run took for the submissions that it graded itself, added up.
struct GradingTimes {
  double build_seconds = 0, judge_seconds = 0;
  std::uint64_t stored_builds = 0;  ///< Submissions that were not built, but taken from the store.
};

/// What differs between two gradings of a submission.
enum class ChangeCause {
  kSubmission,  ///< Its files.
  kItems,       ///< Items of the rubric.
  kRubric,      ///< What the rubric says beside its items.
  kSeed,
  kRaycheck,  ///< Its version.
  kIsolation
};
inline constexpr std::array<std::string_view, 6> kChangeCauseNames = {
    "submission", "items", "rubric", "seed", "raycheck", "isolation"};
constexpr std::string_view name(ChangeCause cause) {
  return kChangeCauseNames[static_cast<std::size_t>(cause)];
}

/// Points before and now. Absent: it could not be judged, or the item was not there.
struct ScoreChange {
  std::string name;
  std::optional<double> before, now;
};

/// A submission whose points changed.
struct SubmissionChange {
  ScoreChange score;
  std::vector<ScoreChange> items;         ///< Those whose points changed.
  std::vector<ChangeCause> causes;        ///< Empty: it answers otherwise when it is asked again.
  std::vector<std::string> rubric_items;  ///< Those that the rubric changed, added or left out.
};

/// A class beside an earlier grading.
struct ClassChanges {
  std::string against;                       ///< The folder of that.
  std::uint64_t compared = 0, new_ones = 0;  ///< Submissions with a grade there, and without.
  std::vector<SubmissionChange> changed;
};

/// A class, graded.
struct ClassGrade {
  Rubric rubric;
  std::string out;                           ///< Where the results are; empty: nowhere.
  std::vector<SubmissionGrade> submissions;  ///< In the order given; those that were reached.
  std::optional<LayersHere> isolation = {};  ///< Absent: none was run.
  std::uint64_t reused = 0;                  ///< Of those, graded by an earlier run.
  std::uint64_t not_graded = 0;  ///< For causes outside them, which may have gone next time.
  bool interrupted = false;
  std::optional<GradingTimes> times = {};    ///< Absent: nothing was run.
  std::optional<ClassChanges> changes = {};  ///< Where an earlier grading is given.
};

}  // namespace raycheck::tools
