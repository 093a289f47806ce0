#pragma once

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tests/caught/exact_candidate.h"
#include "tests/degenerate/degenerate.h"
#include "tests/standard.h"

namespace raycheck::degenerate {

/// The result of a law for a degenerate candidate at one severity of a source.
enum class Judgement {
  kBroken,    ///< The law is broken within the cases tried.
  kRight,     ///< Every answer that was compared is right, so the degenerate answer is right here.
  kNotAsked,  ///< Nothing was compared.
  kExcused,   ///< Some answers are wrong, and all of these are excused.
};

struct Judged {
  const Degenerate* degenerate;
  const properties::Law* law;
  properties::ChosenSource where;
  Judgement judgement = Judgement::kExcused;
  properties::Verdict verdict = {};  ///< The verdict on all cases together.
};

/// The degenerate candidates, and the right one from which they are made.
class DegenerateRoom {
 public:
  DegenerateRoom();
  const properties::Candidate& right() const { return right_; }
  std::span<const Degenerate> all() const { return all_; }

  /// Judges each candidate by each of its laws that suits the place. All get the same cases, until
  /// the law is broken or kManyExcused decisions are excused.
  std::vector<Judged> judge(const properties::ChosenSource& place, int cases) const;
  /// Judges the right candidate by every law, within caught::kRoundedDomain.
  std::vector<Judged> judge_right(const properties::ChosenSource& place, int cases) const;

 private:
  std::vector<Judged> judge(std::span<const Degenerate> all, const properties::ChosenSource& place,
                            int cases) const;

  std::shared_ptr<caught::Sights::Pixels> looked_at_;
  properties::Candidate right_;
  std::vector<Degenerate> all_;
};

/// Within this many cases, degenerate candidates must break a law or be excused.
inline constexpr int kDegenerateCases = 200;
/// After this many excused decisions without a defect, a candidate is not judged further, because a
/// search for nearby inputs takes a thousand times as long as a decision.
inline constexpr std::ptrdiff_t kManyExcused = 8;

/// A reason why wrong answers of degenerate candidates are rightly excused.
struct WhyExcused {
  struct Severities {
    std::string_view source;
    int from, to;
  } where;
  std::vector<std::string_view> laws;
  std::vector<std::string_view> candidates;  ///< If empty, any candidate.
  std::string_view reason;

  bool is_about(const Judged& judged) const;
};
std::span<const WhyExcused> why_excused();

}  // namespace raycheck::degenerate
