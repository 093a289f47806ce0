#pragma once

// A candidate's answers, step by step, beside what is right. Internal to answer_explanation.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/mistakes/answer_explanation.h"
#include "properties/mistakes/imprecision.h"
#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {

/// The answer at any step: which sphere, or whether one is hit, and any vectors.
struct Answer {
  std::optional<std::size_t> choice;
  std::array<scene::Vector3, 3> vectors;
};
using StepAnswers = std::vector<Answer>;

/// A case under the conventions that the candidate is judged by, and its correct rays.
struct AskedCase {
  Case the_case;
  std::vector<scene::Ray> rays;
  Returns returns = Returns::kHit;  ///< What is known of a hit.
};

/// What a candidate answered to a case at a step, what is right, and what other right formulas
/// make of it.
struct Comparison {
  const AskedCase* asked;
  StepAnswers answers, right;
  std::vector<StepAnswers> also_right;
};

/// Whether a case is left out as the candidate is asked about it: roots are so near to t_min or
/// t_max that mistakes, which are made in doubles, would not count the right ones.
bool is_left_out(const Case& the_case, const Candidate& candidate);

/// What becomes of answers that are no numbers where numbers are right.
enum class NotNumbers { kWrong, kLeftOut };

/// A candidate's answers to cases; each step is computed on demand.
class Examination {
 public:
  Examination(std::span<const Case> cases, const Candidate& candidate,
              NotNumbers not_numbers = NotNumbers::kWrong);

  const std::vector<Comparison>& at(Step step);

  const Candidate& candidate() const { return candidate_; }
  bool is_single() const { return candidate_.precision == scene::Precision::kSingle; }
  /// Whether at most half of the cases are left out for that.
  bool is_of_most() const { return left_out_ <= asked_.size(); }
  double roundoff() const { return scene::unit_roundoff(candidate_.precision); }
  /// Whether a few roundings of the input make such an error of s, which says nothing of a formula.
  bool is_of_input(const scene::Ray& ray, const scene::Sphere& sphere, double error) const;

  std::uint64_t errors(Step step, double tolerance);
  /// How many answers at a step are no numbers where numbers are right.
  std::uint64_t not_numbers(Step step);

  /// How many wrong answers at a step have numbers, which tell more than a class or a choice, and
  /// are not as `other` gives them.
  std::uint64_t wrong_numbers(Step step, double tolerance, const Candidate* other = nullptr);

  /// Whether all answers at a step are numbers where numbers are right, but for those left out.
  bool are_numbers(Step step) {
    return not_numbers_ == NotNumbers::kLeftOut || not_numbers(step) == 0;
  }

  /// How many answers up to a step are not as `made` gives them; any number above `most` if there
  /// are more.
  std::uint64_t contradicted(const Candidate& made, Step first, Step last, double tolerance,
                             std::uint64_t most);
  /// Whether `made` gives any of these answers otherwise than right.
  bool shows(const Candidate& made, Step first, Step last, double tolerance);

  /// How well the roundings of a formula agree with the answers at kIntersect or kNearest.
  DoubtTally tally(Step step, Arithmetic arithmetic, double tolerance);

 private:
  std::vector<StepAnswers> ask_others(Step step, AskedCase asked) const;

  const Candidate& candidate_;
  NotNumbers not_numbers_;
  std::array<std::uint64_t, kStepCount> not_number_counts_{};
  const Candidate right_ = right_candidate();
  const std::vector<Candidate> others_;
  std::vector<AskedCase> asked_;
  std::size_t left_out_ = 0;
  std::array<std::optional<std::vector<Comparison>>, kStepCount> comparisons_;
};

}  // namespace raycheck::properties
