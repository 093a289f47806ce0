#include "properties/mistakes/answer_explanation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fast/intersect.h"
#include "properties/mistakes/answer_examination.h"

namespace raycheck::properties {
namespace {

/// The mistakes that best explain the answers of a part, from its first step up to another step.
std::vector<const Mistake*> suspects_at(Examination& examination, Step first, Step step,
                                        std::uint64_t& fewest, double tolerance) {
  std::vector<const Mistake*> best;
  for (const Mistake& mistake : mistakes()) {
    if (mistake.step < first || mistake.step > step) continue;
    const std::uint64_t left = examination.contradicted(mistake, first, step, tolerance, fewest);
    if (left > fewest) continue;
    if (left < fewest) best.clear();
    fewest = left;
    const bool is_known =
        !mistake.family.empty() && !best.empty() && best.back()->family == mistake.family;
    if (!is_known) best.push_back(&mistake);
  }
  return best;
}

/// A part of the functions of a candidate: no mistake in another part shows in it.
struct Part {
  Step first, last;
};

/// Of mistakes that explain a step equally well, keeps those that best explain the errors at later
/// steps of the part; all, if none does.
void tell_apart(Examination& examination, Step step, Step last, double tolerance,
                std::vector<const Mistake*>& suspects) {
  for (int at = static_cast<int>(step) + 1; at <= static_cast<int>(last); ++at) {
    const auto later = static_cast<Step>(at);
    std::uint64_t fewest = most_unexplained(examination.errors(later, tolerance));
    std::vector<const Mistake*> best;
    for (const Mistake* mistake : suspects) {
      const auto left = examination.contradicted(*mistake, later, later, tolerance, fewest);
      if (left > fewest) continue;
      if (left < fewest) best.clear();
      fewest = left;
      best.push_back(mistake);
    }
    if (!best.empty()) suspects = std::move(best);
  }
}

/// The mistakes found at the first step of a part that has errors.
struct FoundCause {
  AnswerCause cause;
  std::vector<const Mistake*> mistakes;
  double tolerance = 0;
  bool is_known() const { return !cause.alternatives.empty(); }
};

/// The roundings that explain the answers at a step, if any do.
std::optional<AnswerCause> roundings_at(Examination& examination, Step step, double tolerance) {
  for (const Arithmetic arithmetic : kArithmetics) {
    const DoubtTally tally = examination.tally(step, arithmetic, tolerance);
    if (!tally.tells()) continue;
    return AnswerCause{step,
                       {{imprecision_sentence(arithmetic, tally.radii), tally.wrong, tally.wrong}},
                       arithmetic};
  }
  return {};
}

/// Relative errors of s up to this may be those of a right formula where s is well-conditioned.
constexpr double kNoticed = 0x1p-44;

/// Roots q/a and c/q lose what q = v + d or v - d does, the larger one, too, where q is the one
/// that cancels. Roundings of d^2 leave that root alone.
std::optional<AnswerCause> cancelling_q(Examination& examination) {
  std::uint64_t wrong = 0;
  for (const Comparison& comparison : examination.at(Step::kIntersect)) {
    const auto& [the_case, rays] = *comparison.asked;
    for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
      const Answer &answer = comparison.answers[k], &right = comparison.right[k];
      if (answer.choice != right.choice) return {};
      const double s = right.vectors[0].x;
      if (!right.choice || answer.vectors[0].x == s) continue;
      const scene::Ray& ray = rays[k % rays.size()];
      const auto roots = fast::kCross.roots(ray, the_case.scene.spheres[k / rays.size()]);
      const double v = std::abs(roots.axial_distance);
      const double d = std::sqrt(std::max(0.0, roots.half_chord_sq));
      const double off = std::abs(answer.vectors[0].x - s) / s;
      const double lost = kRoundings * kDoubleRoundoff * (v + d) / std::abs(v - d);
      if (!(off <= std::max(kNoticed, lost))) return {};
      wrong += off > kNoticed && s * norm(ray.direction) > v ? 1 : 0;
    }
  }
  if (wrong < kFewestWrongByRoundings) return {};
  return AnswerCause{
      Step::kIntersect,
      {{"q = b + sgn(b) sqrt(b^2 - ac) has the wrong sign within: it cancels", wrong, wrong}}};
}

FoundCause find_cause(Examination& examination, const Part& part) {
  for (const double tolerance : kAnswerTolerances) {
    for (int at = static_cast<int>(part.first); at <= static_cast<int>(part.last); ++at) {
      const auto step = static_cast<Step>(at);
      const std::uint64_t errors = examination.errors(step, tolerance);
      if (errors == 0) continue;
      std::uint64_t left = most_unexplained(errors);
      FoundCause found = {
          {step, {}}, suspects_at(examination, part.first, step, left, tolerance), tolerance};
      if (found.mistakes.size() > 1) {
        tell_apart(examination, step, part.last, tolerance, found.mistakes);
      }
      const bool all_by_mistake = !found.mistakes.empty() && left == 0;
      if (!all_by_mistake && part.first >= Step::kIntersect) {
        if (auto roundings = roundings_at(examination, step, tolerance)) {
          return {std::move(*roundings), {}, tolerance};
        }
        // If roundings may have caused it, too, the cause is unknown.
        if (examination.tally(step, kArithmetics.back(), tolerance).allows_all()) break;
      }
      for (const Mistake* mistake : found.mistakes) {
        found.cause.alternatives.push_back({mistake->sentence, errors, errors - left, mistake});
      }
      if (!found.mistakes.empty()) return found;
      break;
    }
  }
  if (part.last == Step::kIntersect) {
    if (auto cause = cancelling_q(examination)) {
      return {std::move(*cause), {}, kAnswerTolerances.front()};
    }
  }
  return {};
}

/// Whether the cause of one part's errors also explains those at a step of another part.
bool explains(Examination& examination, const FoundCause& found, Step step) {
  const std::uint64_t errors = examination.errors(step, found.tolerance);
  const std::uint64_t most = most_unexplained(errors);
  if (found.cause.roundings) {
    return examination.tally(step, *found.cause.roundings, found.tolerance).not_allowed == 0;
  }
  return std::any_of(found.mistakes.begin(), found.mistakes.end(), [&](const Mistake* mistake) {
    return errors > 0 &&
           examination.contradicted(*mistake, step, step, found.tolerance, most) <= most;
  });
}

}  // namespace

std::vector<AnswerCause> answer_causes(std::span<const Case> cases, const Candidate& candidate) {
  Examination examination(cases, candidate);
  std::vector<FoundCause> findings = {find_cause(examination, {Step::kFrame, Step::kRay})};
  for (const Step step : {Step::kIntersect, Step::kNearest}) {
    const bool is_known =
        std::any_of(findings.begin(), findings.end(),
                    [&](const FoundCause& found) { return explains(examination, found, step); });
    if (is_known) continue;
    // Where hits have no errors they rule out mistakes that would change them.
    const bool hits_are_right =
        step == Step::kNearest &&
        examination.errors(Step::kIntersect, kAnswerTolerances.front()) == 0;
    findings.push_back(find_cause(examination, {hits_are_right ? Step::kIntersect : step, step}));
    // If nothing explains the hits, nearest spheres that follow from them say nothing.
    if (step == Step::kIntersect && !findings.back().is_known() &&
        examination.errors(step, kAnswerTolerances.front()) > 0) {
      break;
    }
  }
  std::vector<AnswerCause> causes;
  for (const FoundCause& found : findings) {
    if (found.is_known()) causes.push_back(found.cause);
  }
  return causes;
}

std::vector<Explanation> explanations(const std::vector<AnswerCause>& causes) {
  std::vector<Explanation> all;
  for (const AnswerCause& cause : causes) {
    all.insert(all.end(), cause.alternatives.begin(), cause.alternatives.end());
  }
  return all;
}

}  // namespace raycheck::properties
