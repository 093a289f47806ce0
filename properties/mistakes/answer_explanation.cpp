#include "properties/mistakes/answer_explanation.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "properties/mistakes/answer_examination.h"
#include "properties/mistakes/fault.h"

namespace raycheck::properties {
namespace {

/// A part of a candidate's functions. Mistakes in one part do not show in the answers of another.
struct Part {
  Step first, last;
};

/// The mistakes that best explain the answers at some steps, only the first of each group. `fewest`
/// is the number of answers that they may contradict at most, and becomes the number that they
/// contradict.
std::vector<const Mistake*> best_of(Examination& examination,
                                    const std::vector<const Mistake*>& suspects, Part steps,
                                    double tolerance, std::uint64_t& fewest) {
  std::vector<const Mistake*> best;
  for (const Mistake* mistake : suspects) {
    const std::uint64_t left =
        examination.contradicted(mistake->candidate, steps.first, steps.last, tolerance, fewest);
    if (left > fewest) continue;
    if (left < fewest) best.clear();
    fewest = left;
    const bool is_known =
        !mistake->group.empty() && !best.empty() && best.back()->group == mistake->group;
    if (!is_known) best.push_back(mistake);
  }
  return best;
}

/// Of mistakes that explain a step equally well, keeps those that best explain the errors at later
/// steps of the part. Keeps all if no mistake explains these errors.
void tell_apart(Examination& examination, Step step, Step last, double tolerance,
                std::vector<const Mistake*>& suspects) {
  for (int at = static_cast<int>(step) + 1; at <= static_cast<int>(last); ++at) {
    const auto later = static_cast<Step>(at);
    std::uint64_t fewest = most_unexplained(examination.errors(later, tolerance));
    auto best = best_of(examination, suspects, {later, later}, tolerance, fewest);
    if (!best.empty()) suspects = std::move(best);
  }
}

/// The mistakes that a candidate can make, in a part up to a step.
std::vector<const Mistake*> offered(const Candidate& candidate, Part part, Step step) {
  std::vector<const Mistake*> all;
  for (const Mistake& mistake : mistakes()) {
    if (mistake.step < part.first || mistake.step > step) continue;
    if (mistake.is_offered == nullptr || mistake.is_offered(candidate)) all.push_back(&mistake);
  }
  return all;
}

/// Pairs of mistakes are tried only if at least this many answers are wrong. A pair must explain
/// all of them, and each of its mistakes must explain kFewestErrorsOfACause answers with numbers
/// that the other does not explain.
constexpr std::uint64_t kFewestErrorsOfTwo = 12;

/// The pairs that contradict no answer; of pairs that differ only within a group, the first.
std::vector<Fault> pairs_of(Examination& examination, std::vector<const Mistake*> mistakes,
                            Part steps, double tolerance) {
  std::erase_if(mistakes, [&](const Mistake* one) {
    return !examination.shows(one->candidate, steps.first, steps.last, tolerance);
  });
  const auto is_too_much = [&](const Mistake* one) {
    return examination.wrong_numbers(steps.last, tolerance, &one->candidate) >=
           kFewestErrorsOfACause;
  };
  std::set<std::pair<std::string_view, std::string_view>> known;
  std::vector<Fault> found;
  for (std::size_t a = 0; a < mistakes.size(); ++a) {
    for (std::size_t b = a + 1; b < mistakes.size(); ++b) {
      const Fault pair = {mistakes[a], mistakes[b]};
      if (!can_be_together(*pair[0], *pair[1])) continue;
      if (examination.contradicted(candidate_with(pair), steps.first, steps.last, tolerance, 0) > 0)
        continue;
      if (!is_too_much(pair[0]) || !is_too_much(pair[1])) continue;
      if (known.insert({pair[0]->name(), pair[1]->name()}).second) found.push_back(pair);
    }
  }
  return found;
}

std::vector<Fault> each_alone(const std::vector<const Mistake*>& mistakes) {
  std::vector<Fault> faults;
  for (const Mistake* mistake : mistakes) faults.push_back({mistake});
  return faults;
}

AnswerCause cause_of(const std::vector<Fault>& alternatives, AnswerCause cause,
                     std::uint64_t errors, std::uint64_t left) {
  for (const Fault& fault : alternatives) {
    cause.alternatives.push_back({sentence_of(fault), errors, errors - left, fault});
  }
  return cause;
}

/// The tolerance for roundings to floats. A cause is sought for answers that are right up to
/// kAnswerTolerances but off by more than this; a mistake must reproduce them up to this.
constexpr double kOfFloats = 1e-10;

/// The cause "rounded to floats", at the first step of a part that shows it.
std::optional<AnswerCause> rounding_in(Examination& examination, const Part& part) {
  for (int at = static_cast<int>(part.first); at <= static_cast<int>(part.last); ++at) {
    const auto step = static_cast<Step>(at);
    const std::uint64_t errors = examination.errors(step, kOfFloats);
    if (errors < kFewestErrorsOfACause) continue;
    std::vector<const Mistake*> suspects = offered(examination.candidate(), part, step);
    std::erase_if(suspects, [](const Mistake* one) { return !one->is_rounding; });
    std::uint64_t left = most_unexplained(errors);
    suspects = best_of(examination, suspects, {part.first, step}, kOfFloats, left);
    if (suspects.size() > 1) tell_apart(examination, step, part.last, kOfFloats, suspects);
    if (suspects.empty() || suspects.size() > kMostAlternatives) return {};
    return cause_of(each_alone(suspects), {step, {}, {}, kOfFloats}, errors, left);
  }
  return {};
}

/// The cause of the errors at the first step of a part that has any.
AnswerCause find_cause(Examination& examination, const Part& part) {
  AnswerCause too_few;
  for (const double tolerance : kAnswerTolerances) {
    for (int at = static_cast<int>(part.first); at <= static_cast<int>(part.last); ++at) {
      const auto step = static_cast<Step>(at);
      const std::uint64_t errors = examination.errors(step, tolerance);
      if (errors == 0) continue;
      const Part steps = {part.first, step};
      std::uint64_t left = most_unexplained(errors);
      const std::vector<const Mistake*> all = offered(examination.candidate(), part, step);
      std::vector<const Mistake*> suspects = best_of(examination, all, steps, tolerance, left);
      if (suspects.size() > 1) tell_apart(examination, step, part.last, tolerance, suspects);
      AnswerCause cause = {step, {}, {}, tolerance};
      if (errors < kFewestErrorsOfACause && !suspects.empty() &&
          (suspects.size() > 1 || examination.wrong_numbers(step, tolerance) == 0)) {
        cause.alternatives = {{std::string(kTooFewErrors), errors, 0}};
        too_few = cause;
        break;
      }
      const bool all_by_mistake = !suspects.empty() && left == 0;
      if (!all_by_mistake && step >= Step::kIntersect) {
        if (const auto found = roundings_at(examination, step, tolerance)) return *found;
        // If roundings may be the cause, too, the cause is unknown.
        if (examination.tally(step, kArithmetics.back(), tolerance).allows_all()) break;
      }
      if (!all_by_mistake && errors >= kFewestErrorsOfTwo && examination.are_numbers(step) &&
          examination.wrong_numbers(step, tolerance) >= kFewestErrorsOfACause) {
        const std::vector<Fault> pairs = pairs_of(examination, all, steps, tolerance);
        if (pairs.size() > kMostAlternatives) return {};
        if (!pairs.empty()) return cause_of(pairs, cause, errors, 0);
      }
      if (suspects.empty()) break;
      if (suspects.size() > kMostAlternatives) return {};
      return cause_of(each_alone(suspects), cause, errors, left);
    }
  }
  if (part.last != Step::kNearest) {
    if (auto cause = rounding_in(examination, part)) return *std::move(cause);
  }
  if (part.last == Step::kRay) {
    if (auto cause = lost_digits_of_rays(examination)) return *std::move(cause);
  }
  if (part.last == Step::kIntersect && examination.is_of_most()) {
    if (auto cause = lost_digits(examination)) return *std::move(cause);
  }
  return too_few;
}

/// Whether the cause of one part's errors also explains those at a step of another part.
bool explains(Examination& examination, const AnswerCause& found, Step step) {
  const double tolerance = found.tolerance;
  if (found.roundings) {
    return examination.tally(step, *found.roundings, tolerance).not_allowed == 0;
  }
  const std::uint64_t errors = examination.errors(step, tolerance);
  const std::uint64_t most = most_unexplained(errors);
  const auto& all = found.alternatives;
  return errors > 0 && std::any_of(all.begin(), all.end(), [&](const Explanation& one) {
           return !one.mistakes.empty() &&
                  examination.contradicted(candidate_with(one.mistakes), step, step, tolerance,
                                           most) <= most;
         });
}

/// Whether only hits can show mistakes in its rays.
bool only_picks(const Candidate& candidate) {
  return candidate.pick && !candidate.frame && !candidate.pixel_points && !candidate.pixel_rays &&
         !candidate.focal_rays;
}

std::vector<AnswerCause> causes_in(Examination& examination) {
  const Step first_of_hits = only_picks(examination.candidate()) ? Step::kFrame : Step::kIntersect;
  std::vector<AnswerCause> findings = {find_cause(examination, {Step::kFrame, Step::kRay})};
  for (const Step step : {Step::kIntersect, Step::kNearest}) {
    const bool is_known =
        std::any_of(findings.begin(), findings.end(),
                    [&](const AnswerCause& found) { return explains(examination, found, step); });
    if (is_known) continue;
    // Hits without errors rule out mistakes that would change them.
    const bool hits_are_right =
        step == Step::kNearest &&
        examination.errors(Step::kIntersect, kAnswerTolerances.front()) == 0;
    const Step first = step == Step::kIntersect ? first_of_hits : step;
    findings.push_back(find_cause(examination, {hits_are_right ? Step::kIntersect : first, step}));
    // If nothing explains the hits, nearest spheres that follow from these hits prove nothing.
    if (step == Step::kIntersect && findings.back().alternatives.empty() &&
        examination.errors(step, kAnswerTolerances.front()) > 0) {
      break;
    }
  }
  std::erase_if(findings, [](const AnswerCause& found) { return found.alternatives.empty(); });
  return findings;
}

}  // namespace

std::vector<AnswerCause> answer_causes(std::span<const Case> cases, const Candidate& candidate) {
  Examination examination(cases, candidate);
  std::vector<AnswerCause> found = causes_in(examination);
  const bool is_all = std::all_of(found.begin(), found.end(), [](const AnswerCause& cause) {
    const Explanation& one = cause.alternatives.front();
    return one.explained == one.errors;
  });
  if (!found.empty() && is_all) return found;
  for (std::size_t at = 0; at < kStepCount; ++at) {
    const auto step = static_cast<Step>(at);
    const std::uint64_t count = examination.not_numbers(step);
    if (count == 0) continue;
    Examination rest(cases, candidate, NotNumbers::kLeftOut);
    found = causes_in(rest);
    const std::uint64_t others = rest.errors(step, kAnswerTolerances.front());
    found.push_back({step, {{std::string(kNotNumbers), count + others, count}}});
    break;
  }
  return found;
}

std::string sentence_of(const std::vector<Explanation>& alternatives) {
  if (alternatives.size() == 1) return alternatives.front().sentence;
  std::vector<Fault> faults;
  for (const Explanation& one : alternatives) faults.push_back(one.mistakes);
  return sentence_of(faults);
}

std::vector<Explanation> explanations(const std::vector<AnswerCause>& causes) {
  std::vector<Explanation> all;
  for (const AnswerCause& cause : causes) {
    all.push_back(cause.alternatives.front());
    all.back().sentence = sentence_of(cause.alternatives);
  }
  return all;
}

}  // namespace raycheck::properties
