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
#include "properties/truth.h"
#include "properties/verdict.h"
#include "tools/external/candidate_spec.h"
#include "tools/external/pictures/driver_form.h"
#include "tools/external/sandbox/launch.h"
#include "tools/external/sandbox/process.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// The candidate with the tolerance of an item.
properties::Candidate tolerated(properties::Candidate candidate, const Tolerance& tolerance);

/// The output of a program or compiler, without the names of raycheck's private folders and
/// non-ASCII characters.
std::string plain_text(const std::string& said);

/// Where a case comes from: a scene of the rubric, or a source of random cases.
struct CaseOrigin {
  std::string scene = {};    ///< Its name in the rubric; empty: a random case.
  std::string source = {};   ///< "course", "distance@3"
  std::uint64_t number = 0;  ///< Of the random case, from 1.
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
  /// In the quantity's unit, for a number; absent: withheld, or a decision.
  std::optional<double> error;
  std::optional<double> condition;                         ///< The condition number, if computed.
  scene::Precision precision = scene::Precision::kDouble;  ///< The format of the unit.
};

/// A picture and what it should show, pixel by pixel, in the order of the case's conventions; if an
/// item judges masks, kSomeSphere stands for every sphere.
struct ComparedPictures {
  properties::ImageAnswer got;
  std::optional<properties::ImageAnswer> exact;  ///< Absent: withheld.
};

/// A submission's answers about one ray of a case, as judged; empty where it was not asked, or did
/// not answer.
struct RayAnswers {
  std::optional<properties::FrameAnswer> frame = {};
  std::optional<scene::Point3> pixel_point = {};
  std::optional<scene::Ray> ray = {};  ///< For a pixel.
  /// The hits of that ray, or of the given one, by the index of the sphere.
  std::optional<std::map<std::size_t, properties::HitAnswer>> hits = {};
};

/// The smallest case found that an item fails on.
struct FailingCase {
  std::string law;  ///< Its name.
  CaseOrigin origin;
  std::optional<std::string> step;  ///< The first step that goes wrong: "direction".
  WrongAnswer answer;
  properties::Case the_case;  ///< No pixels: all of them, for a picture.
  /// For a program that drew a picture of the case; as many pixels as its camera has.
  std::optional<ComparedPictures> pictures = {};
  /// For functions, about the ray at the answer's place, or the first; absent: withheld.
  std::optional<RayAnswers> answers = {};
};

/// The first wrong answer, before the case was shrunk: equal for submissions with equal errors.
struct FirstWrongAnswer {
  CaseOrigin origin;
  WrongAnswer answer;
};

/// A mistake, and how many of an item's wrong answers (or pixels) it makes right. Nothing is
/// counted without answers, or without pictures of the right size.
struct ExplainingMistake {
  std::vector<std::string> sentences;  ///< Several if it is several mistakes at once.
  std::uint64_t wrong = 0, explained = 0;

  std::string sentence() const { return boost::join(sentences, "; and "); }
};

enum class ItemState {
  kHolds,
  kFails,
  kFollows,   ///< Its only mistake costs another item its points.
  kLeftOut,   ///< A prerequisite failed.
  kNotAsked,  ///< Not for this form of submission.
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
    kOfRenderers,       ///< Only renderers are asked for it.
    kNeeds,             ///< Another item lacks points.
    kFollows,           ///< From the mistake of another item.
    kTimeUp,            ///< For all of the submission's questions.
    kInterrupted,       ///< The run was.
    kOtherColours,      ///< A picture's colours do not identify the spheres.
    kUnanswered,        ///< Less is answered than a law requires.
    kNothingToCompare,  ///< There were no cases.
    kNeverRight,        ///< All answers about some quantity are excused, none right.
    kNothingRuns,       ///< Nothing of the submission could be run.
    kCannotBeSaid       ///< No case can be expressed in its form of input.
  };
  Kind kind = Kind::kNone;
  std::string item = {};                ///< The one that it needs; empty: withheld.
  ItemState state = ItemState::kFails;  ///< The outcome of that.
  double seconds = 0;                   ///< The time that it had.
  std::string law = {}, said = {};      ///< Which law was not answered, and why.
  std::string quantity = {};            ///< It had no right answer.
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
  double points = 0;  ///< The maximum; 0 if not asked.
  double score = 0;
  bool bonus = false;
  bool pictures = false;    ///< It was asked for pictures, not for functions.
  std::uint64_t cases = 0;  ///< Those that asked something.
  std::uint64_t held = 0;
  std::uint64_t unsaid = 0;  ///< Further cases, which its form of input cannot express.
  std::uint64_t comparisons = 0;
  std::vector<ExplainingMistake> mistakes;
  std::optional<FailingCase> failing;
  std::optional<FirstWrongAnswer> first_wrong;
};

/// An item of which nothing is asked yet.
ItemGrade unjudged(const Item& item, bool pictures);

/// A file of a submission that cannot be understood by reading it.
struct OpaqueFile {
  std::string name;
  std::string kind;  ///< "picture"
  std::uintmax_t bytes = 0;
};

struct SubmissionGrade {
  std::string name;
  std::optional<CandidateSpec> program;  ///< As it was run; absent if none was found.
  /// The shell command that built it, in a copy of its folder; empty: nothing had to be built, or
  /// raycheck compiled it.
  std::string build_words = {};
  DriverForm driver = {};  ///< For a renderer: how its driver files are written.
  /// Remarks on the dry run and the build, a sentence each.
  std::vector<std::string> notes = {};
  std::vector<OpaqueFile> opaque_files = {};  ///< For instructors to look at.
  Layers isolation;
  std::optional<Refusal> refused;
  /// To make it run, and to ask everything in the rubric.
  double build_seconds = 0, judge_seconds = 0;
  bool build_is_stored = false;  ///< The build of an earlier run, or of equal files, was used.
  std::uint64_t seed = 0;
  bool finished = false;
  double points = 0;  ///< Of the items asked, without bonus.
  double score = 0;
  double bonus = 0;  ///< Of the score, what comes on top of the points.
  std::vector<ItemGrade> items;
};

/// How many of the cases its form of input cannot express, as a sentence; empty: none.
std::string unsaid_text(const SubmissionGrade& grade);

/// Otherwise its points mean nothing: nothing of it ran.
inline bool could_be_judged(const SubmissionGrade& grade) { return !grade.refused; }

/// The total times of a run for the submissions that it graded itself.
struct GradingTimes {
  double build_seconds = 0, judge_seconds = 0;
  std::uint64_t stored_builds = 0;  ///< Submissions whose build was in the store.
};

struct ClassGrade {
  Rubric rubric;
  std::string out;                           ///< Where the results are; empty: nowhere.
  std::vector<SubmissionGrade> submissions;  ///< In the given order, as far as reached.
  std::optional<LayersHere> isolation = {};  ///< Absent: none was run.
  std::uint64_t not_graded = 0;              ///< For outside causes, which may be gone next time.
  bool interrupted = false;
  std::optional<GradingTimes> times = {};  ///< Absent: nothing was run.
};

using Submissions = std::vector<const SubmissionGrade*>;

/// Those that could be judged, or those that could not, in the order of the class.
Submissions submissions_that(const ClassGrade& graded, bool are_judged);

/// The middle value, or the mean of the two in the middle; empty if there is none.
std::optional<double> median(std::vector<double> values);

struct ItemStatistics {
  const Item* item = nullptr;
  std::size_t asked = 0;  ///< Of the submissions that could be judged.
  std::size_t failing = 0;
  std::size_t left_out = 0;  ///< Or not judged, as time was up.
};
/// In the order of the rubric. Domain: grades of `graded.rubric`, which outlives the result.
std::vector<ItemStatistics> item_statistics(const ClassGrade& graded);

/// A mistake, and who makes it.
struct MistakeStatistics {
  std::string sentence;
  Submissions students;  ///< Those with an item whose wrong answers it explains.
  int items = 0;         ///< Theirs that it explains.
  bool costs = false;    ///< Some of these their points.
  /// The failing case that it explains with the fewest spheres, then pixels; null if there is none.
  const ItemGrade* smallest = nullptr;
  const SubmissionGrade* whose = nullptr;  ///< Whose smallest case it is; null likewise.
};
/// Most students first.
std::vector<MistakeStatistics> mistake_statistics(std::span<const SubmissionGrade> graded);

/// Who hides items that students may not see yet, or ever.
enum class HiddenBy {
  kUs,          ///< Only visible items are included.
  kOtherSystem  ///< All are included; hidden ones with their outcome, but no cases.
};

/// The part of a grade that a student may see: what is withheld is not in it, so that no view can
/// reveal it.
struct StudentGrade {
  std::string rubric;              ///< The name of its file.
  std::string dialect;             ///< What overrode its [driver]; or empty.
  std::string title;               ///< Of the rubric.
  SubmissionGrade submission;      ///< With visible items only; without the seed.
  std::vector<const Item*> items;  ///< The rubric's, one for each of these.
  std::size_t unlisted = 0;        ///< Items in the score that are not among them.
};

/// Domain: as many items graded as the rubric has, which outlives the result.
StudentGrade student_grade(const Rubric& rubric, const SubmissionGrade& grade, HiddenBy hidden_by);

}  // namespace raycheck::tools
