#ifndef RAYCHECK_TOOLS_GRADE_JUDGE_H_
#define RAYCHECK_TOOLS_GRADE_JUDGE_H_

#include <chrono>
#include <cstdint>

#include "properties/run_control.h"
#include "tools/external/external_candidate.h"
#include "tools/grade/result.h"
#include "tools/grade/rubric.h"

namespace raycheck::tools {

/// Asks a candidate what the items of a rubric ask, one after the other. The cases follow from the
/// seed; what the candidate declares yields to the rubric's conventions. A case holds where the
/// laws hold and the candidate answers all that raycheck's own methods answer.
class Judge {
 public:
  /// `pictures`: it is asked for pictures, otherwise for functions. `last_failure` is set where
  /// the candidate fails.
  Judge(const Rubric& rubric, properties::Candidate candidate, bool pictures, std::uint64_t seed,
        const properties::RunControl& control, LastFailure last_failure = nullptr);

  /// Domain: items in the order of the rubric, `before` what became of those before it.
  ItemGrade item(std::size_t index, const std::vector<ItemGrade>& before);

 private:
  using Clock = std::chrono::steady_clock;

  /// Why no more is to be asked, if so.
  ItemReason reason_to_stop() const;

  const Rubric& rubric_;
  properties::Candidate candidate_;
  const properties::RunControl& control_;
  LastFailure last_failure_;
  bool pictures_;
  std::uint64_t seed_;
  Clock::time_point end_;
};

/// The item's points for a share of its cases.
double score_of(const Item& item, std::uint64_t held, std::uint64_t cases);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_JUDGE_H_
