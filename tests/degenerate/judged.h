#pragma once

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tests/caught/exact_candidate.h"
#include "tests/degenerate/degenerate.h"
#include "tests/standard.h"

namespace raycheck::degenerate {

/// What a law made of a degenerate candidate at one severity of a source.
enum class Judgement {
  kBroken,    ///< Within the cases tried.
  kRight,     ///< Every answer that it compared is the right one: degenerate is right here.
  kNotAsked,  ///< It compared nothing.
  kExcused,   ///< Answers are wrong, all of them excused.
};

struct Judged {
  const Degenerate* degenerate;
  const properties::Law* law;
  properties::ChosenSource where;
  Judgement judgement = Judgement::kExcused;
  properties::Verdict verdict = {};  ///< All cases together.
};

/// The degenerate candidates, and the right one that they are made of.
class DegenerateRoom {
 public:
  DegenerateRoom();
  const properties::Candidate& right() const { return right_; }
  std::span<const Degenerate> all() const { return all_; }

  /// Each with each of its laws that suits the place, on the same cases until it is broken, or
  /// excused kManyExcused decisions.
  std::vector<Judged> judge(const properties::ChosenSource& place, int cases) const;
  /// The right one with every law, within caught::kRoundedDomain.
  std::vector<Judged> judge_right(const properties::ChosenSource& place, int cases) const;

 private:
  std::vector<Judged> judge(std::span<const Degenerate> all, const properties::ChosenSource& place,
                            int cases) const;

  std::shared_ptr<caught::Sights::Pixels> looked_at_;
  properties::Candidate right_;
  std::vector<Degenerate> all_;
};

/// So many cases break what is degenerate, or excuse it.
inline constexpr int kDegenerateCases = 200;
/// Who is excused so many wrong decisions, and of none convicted, is asked no further: a search for
/// inputs close by takes a thousand times as long as a decision.
inline constexpr std::ptrdiff_t kManyExcused = 8;

/// Why wrong answers of degenerate candidates are excused somewhere, rightly.
struct WhyExcused {
  struct Severities {
    std::string_view source;
    int from, to;
  } where;
  std::vector<std::string_view> laws;
  std::vector<std::string_view> candidates;  ///< Empty: any.
  std::string_view reason;

  bool is_about(const Judged& judged) const;
};
std::span<const WhyExcused> why_excused();

}  // namespace raycheck::degenerate
