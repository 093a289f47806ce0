#pragma once

// Compares a candidate's answers with the right ones, step by step, and finds out from them which
// formula loses digits. Internal to answer_explanation.

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

/// The answer at one step: which sphere, or whether a sphere is hit, and the vectors.
struct Answer {
  std::optional<std::size_t> choice;
  std::array<Vector3, 3> vectors;
};
using StepAnswers = std::vector<Answer>;

/// A case under the conventions that the candidate is judged by, and its correct rays.
struct AskedCase {
  Case the_case;
  std::vector<Ray> rays;
  Returns returns = Returns::kHit;  ///< The values that are returned for a hit.
  bool picks = false;               ///< Whether hits are asked by pixels, not by these rays.
};

/// A candidate's answers to a case at a step, the right answers, and the answers of other right
/// formulas.
struct Comparison {
  const AskedCase* asked;
  StepAnswers answers, right;
  std::vector<StepAnswers> also_right;
};

/// Whether a case is left out under the candidate's conventions, because roots are so near to t_min
/// or t_max that mistakes, which are computed in doubles, would choose wrong roots.
bool is_left_out(const Case& the_case, const Candidate& candidate);

/// The treatment of answers that are NaN or infinite although the right ones are finite.
enum class NotNumbers { kWrong, kLeftOut };

/// A candidate's answers to cases; each step is computed on demand.
class Examination {
 public:
  Examination(std::span<const Case> cases, const Candidate& candidate,
              NotNumbers not_numbers = NotNumbers::kWrong);

  const std::vector<Comparison>& at(Step step);

  const Candidate& candidate() const { return candidate_; }
  bool is_single() const { return candidate_.precision == Precision::kSingle; }
  /// Whether at most half of the cases are left out by is_left_out().
  bool is_of_most() const { return left_out_ <= asked_.size(); }
  double roundoff() const { return scene::unit_roundoff(candidate_.precision); }
  /// Whether a few roundings of the input can cause this error of s. Then the error says nothing
  /// about the formula.
  bool is_of_input(const Ray& ray, const Sphere& sphere, double error) const;

  std::uint64_t errors(Step step, double tolerance);
  /// The number of answers at a step that are NaN or infinite although the right ones are finite.
  std::uint64_t not_numbers(Step step);

  /// The number of wrong answers at a step that contain numbers, not only a hit class or a choice,
  /// and differ from the answers of `other`.
  std::uint64_t wrong_numbers(Step step, double tolerance, const Candidate* other = nullptr);

  /// Whether no answer at a step is NaN or infinite although the right one is finite; ignores
  /// answers that are left out.
  bool are_numbers(Step step) {
    return not_numbers_ == NotNumbers::kLeftOut || not_numbers(step) == 0;
  }

  /// The number of answers at these steps that differ from the answers of `made`. Once the count
  /// exceeds `most`, counting may stop.
  std::uint64_t contradicted(const Candidate& made, Step first, Step last, double tolerance,
                             std::uint64_t most);
  /// Whether `made` gives any wrong answer at these steps.
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

// Which formula loses digits (lost_digits.cpp); each is empty if the cause is not found.
/// The roundings that explain the wrong answers at kIntersect or kNearest.
std::optional<AnswerCause> roundings_at(Examination& examination, Step step, double tolerance);
/// The cause of the errors of hits that are right up to kAnswerTolerances.
std::optional<AnswerCause> lost_digits(Examination& examination);
/// The cause of the errors of directions that are right up to kAnswerTolerances.
std::optional<AnswerCause> lost_digits_of_rays(Examination& examination);

}  // namespace raycheck::properties
