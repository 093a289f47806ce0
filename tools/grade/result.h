#ifndef RAYCHECK_TOOLS_GRADE_RESULT_H_
#define RAYCHECK_TOOLS_GRADE_RESULT_H_

// What grading finds out, as data; views (views.h) make words of it.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/truth.h"
#include "properties/verdict.h"
#include "tools/external/candidate_spec.h"
#include "tools/external/sandbox/process.h"

namespace raycheck::tools {

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
};

/// The smallest case found that an item fails on.
struct FailingCase {
  std::string law;  ///< Its name.
  CaseOrigin origin;
  std::optional<std::string> step;  ///< The first step that goes wrong: "direction".
  WrongAnswer answer;
  properties::Case the_case;  ///< No pixels: of a picture, all of them.
};

/// The first wrong answer, before the case was made smaller: the same for submissions that go wrong
/// alike.
struct FirstWrongAnswer {
  CaseOrigin origin;
  WrongAnswer answer;
};

/// A mistake that makes right so many of an item's wrong answers, or pixels.
struct ExplainingMistake {
  std::string sentence;
  std::uint64_t wrong = 0, explained = 0;
};

/// What became of an item.
enum class ItemState {
  kHolds,
  kFails,
  kLeftOut,   ///< A prerequisite failed.
  kNotAsked,  ///< Not of this form of submission.
  kNotJudged  ///< Time was up, or it was interrupted.
};
inline constexpr std::array<std::string_view, 5> kItemStateNames = {"holds", "fails", "left out",
                                                                    "not asked", "not judged"};
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
    kTimeUp,            ///< For all that the submission is asked.
    kInterrupted,       ///< The run was.
    kOtherColours,      ///< A picture's colours are not those of the driver file.
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
inline constexpr std::array<std::string_view, 11> kReasonNames = {"",
                                                                  "not in pictures",
                                                                  "of renderers",
                                                                  "needs",
                                                                  "time is up",
                                                                  "interrupted",
                                                                  "other colours",
                                                                  "unanswered",
                                                                  "nothing to compare",
                                                                  "never right",
                                                                  "nothing runs"};

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

/// Why nothing of a submission could be run.
struct Refusal {
  std::string why;   ///< One line.
  std::string said;  ///< What a compiler said of it, or empty.
};

struct SubmissionGrade {
  std::string name;
  std::string key;                       ///< Of all that the grade depends on.
  std::optional<CandidateSpec> program;  ///< As it was run; absent where none was found.
  Layers isolation;
  std::optional<Refusal> refused;
  std::uint64_t seed = 0;
  bool finished = false;
  double points = 0;  ///< Of items that are asked, bonus aside.
  double score = 0;
  std::vector<ItemGrade> items;
};

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_RESULT_H_
