#include "properties/mistakes/answer_explanation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "fast/intersect.h"
#include "properties/mistakes/answer_examination.h"
#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

/// A part of the functions of a candidate: no mistake in another part shows in it.
struct Part {
  Step first, last;
};

/// Of some mistakes those that best explain the answers at some steps, of one family the first;
/// `fewest`: how many answers they may contradict at most, then how many they do.
std::vector<const Mistake*> best_of(Examination& examination,
                                    const std::vector<const Mistake*>& suspects, Part steps,
                                    double tolerance, std::uint64_t& fewest) {
  std::vector<const Mistake*> best;
  for (const Mistake* mistake : suspects) {
    const std::uint64_t left =
        examination.contradicted(*mistake, steps.first, steps.last, tolerance, fewest);
    if (left > fewest) continue;
    if (left < fewest) best.clear();
    fewest = left;
    const bool is_known =
        !mistake->family.empty() && !best.empty() && best.back()->family == mistake->family;
    if (!is_known) best.push_back(mistake);
  }
  return best;
}

/// Of mistakes that explain a step equally well, keeps those that best explain the errors at later
/// steps of the part; all, if none does.
void tell_apart(Examination& examination, Step step, Step last, double tolerance,
                std::vector<const Mistake*>& suspects) {
  for (int at = static_cast<int>(step) + 1; at <= static_cast<int>(last); ++at) {
    const auto later = static_cast<Step>(at);
    std::uint64_t fewest = most_unexplained(examination.errors(later, tolerance));
    auto best = best_of(examination, suspects, {later, later}, tolerance, fewest);
    if (!best.empty()) suspects = std::move(best);
  }
}

/// Of mistakes that nothing tells apart those that pictures show are the likelier: the rest is
/// dropped, unless there is no other.
void keep_told(std::vector<const Mistake*>& suspects) {
  const auto is_told = [](const Mistake* one) { return one->is_told_by_pictures; };
  if (std::none_of(suspects.begin(), suspects.end(), is_told)) return;
  std::erase_if(suspects, std::not_fn(is_told));
}

/// Who promises floats is not told that it computes in them, but what is lost there.
std::string sentence_of(const Examination& examination, Arithmetic arithmetic, double radii) {
  if (!examination.is_single()) return imprecision_sentence(arithmetic, radii);
  return "in floats " + imprecision_sentence(Arithmetic::kDifference, radii);
}

/// The roundings that explain the answers at a step, if any do.
std::optional<AnswerCause> roundings_at(Examination& examination, Step step, double tolerance) {
  for (const Arithmetic arithmetic : kArithmetics) {
    const DoubtTally tally = examination.tally(step, arithmetic, tolerance);
    if (!tally.tells()) continue;
    // Whose right answers have more digits than floats does not compute in them.
    if (arithmetic != Arithmetic::kDifference && 2 * tally.precise > tally.hits) continue;
    // Who promises floats makes no mistake by computing in them.
    if (arithmetic == Arithmetic::kSingle && examination.is_single()) continue;
    return AnswerCause{
        step,
        {{sentence_of(examination, arithmetic, tally.radii), tally.wrong, tally.wrong}},
        arithmetic,
        tolerance};
  }
  return {};
}

/// Relative errors of s above so many roundings of the candidate's format are looked at.
constexpr double kNoticed = 512;

/// Errors of s that tell of one formula.
struct SmallErrors {
  std::uint64_t wrong = 0;
  double radii = 0;  ///< The least distance of one.
};
/// The errors at kIntersect that tell of a formula. Empty if it does not allow some class or error,
/// or if too few tell of it.
template <class AllowsClass, class Allows, class IsTelling>
std::optional<SmallErrors> small_errors(Examination& examination, const AllowsClass& allows_class,
                                        const Allows& allows, const IsTelling& is_telling) {
  SmallErrors found;
  for (const Comparison& comparison : examination.at(Step::kIntersect)) {
    const AskedCase& asked = *comparison.asked;
    if (asked.class_alone) return {};
    for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
      const Answer &answer = comparison.answers[k], &right = comparison.right[k];
      const scene::Ray& ray = asked.rays[k % asked.rays.size()];
      const scene::Sphere& sphere = asked.the_case.scene.spheres[k / asked.rays.size()];
      if (answer.choice != right.choice) {
        const auto given = answer.choice ? std::optional(answer.vectors[0].x) : std::nullopt;
        if (!allows_class(asked, ray, sphere, given)) return {};
        continue;
      }
      if (!right.choice) continue;
      const double s = answer.vectors[0].x, exact = right.vectors[0].x;
      const double off = std::abs(s - exact) / exact;
      if (off <= kNoticed * examination.roundoff()) continue;
      if (!allows(asked, ray, sphere, s, off)) return {};
      if (!is_telling(asked, ray, sphere, s)) continue;
      const double radii = norm(sphere.centre - ray.origin) / sphere.radius;
      found.radii = found.wrong == 0 ? radii : std::min(found.radii, radii);
      ++found.wrong;
    }
  }
  if (found.wrong < kFewestWrongByRoundings) return {};
  return found;
}

AnswerCause small_cause(std::string sentence, const SmallErrors& errors) {
  return {Step::kIntersect,
          {{std::move(sentence), errors.wrong, errors.wrong}},
          {},
          kAnswerTolerances.front()};
}

/// Roots q/a and c/q lose what q = v + d or v - d does, the larger one, too, where q is the one
/// that cancels. Roundings of d^2 leave that root alone from inside a sphere.
std::optional<AnswerCause> cancelling_q(Examination& examination) {
  const auto found = small_errors(
      examination, [](const auto&...) { return false; },
      [&](const AskedCase&, const scene::Ray& ray, const scene::Sphere& sphere, double,
          double off) {
        const auto roots = fast::kCross.roots(ray, sphere);
        const double v = std::abs(roots.axial_distance);
        const double d = std::sqrt(std::max(0.0, roots.half_chord_sq));
        const double lost = kRoundings * examination.roundoff() * (v + d) / std::abs(v - d);
        return off <= lost;
      },
      [](const AskedCase&, const scene::Ray& ray, const scene::Sphere& sphere, double s) {
        const auto roots = fast::kCross.roots(ray, sphere);
        return roots.smaller < 0 && s * norm(ray.direction) > std::abs(roots.axial_distance);
      });
  if (!found) return {};
  return small_cause("q = b + sgn(b) sqrt(b^2 - ac) has the wrong sign within: it cancels", *found);
}

/// d^2 as a difference that cancels: s loses digits that r^2 - |T x D|^2 keeps, also where so much
/// is in doubt that wrong classes say nothing.
std::optional<AnswerCause> cancelling_difference(Examination& examination) {
  const bool is_single = examination.is_single();
  const auto within = [](Arithmetic arithmetic) {
    return [arithmetic](const AskedCase& asked, const scene::Ray& ray, const scene::Sphere& sphere,
                        std::optional<double> s, auto...) {
      return possible_hit(arithmetic, ray, sphere, asked.the_case.scene.conventions).allows(s);
    };
  };
  const auto stable = within(is_single ? Arithmetic::kSingle : Arithmetic::kProduct);
  const Arithmetic difference = is_single ? Arithmetic::kSingleDifference : Arithmetic::kDifference;
  const auto cancels = within(difference);
  const auto found = small_errors(examination, cancels, cancels,
                                  [&](const auto&... of) { return !stable(of...); });
  if (!found) return {};
  AnswerCause cause =
      small_cause(sentence_of(examination, Arithmetic::kDifference, found->radii), *found);
  cause.roundings = difference;
  return cause;
}

/// At the first step of a part that has errors.
AnswerCause find_cause(Examination& examination, const Part& part) {
  for (const double tolerance : kAnswerTolerances) {
    for (int at = static_cast<int>(part.first); at <= static_cast<int>(part.last); ++at) {
      const auto step = static_cast<Step>(at);
      const std::uint64_t errors = examination.errors(step, tolerance);
      if (errors == 0) continue;
      std::uint64_t left = most_unexplained(errors);
      std::vector<const Mistake*> suspects;
      for (const Mistake& mistake : mistakes()) {
        if (mistake.step < part.first || mistake.step > step) continue;
        if (!mistake.is_told_by_answers) continue;
        if (mistake.needs_other_directions && examination.is_of_unit_directions()) continue;
        suspects.push_back(&mistake);
      }
      suspects = best_of(examination, suspects, {part.first, step}, tolerance, left);
      if (suspects.size() > 1) tell_apart(examination, step, part.last, tolerance, suspects);
      keep_told(suspects);
      const bool all_by_mistake = !suspects.empty() && left == 0;
      if (!all_by_mistake && part.first >= Step::kIntersect) {
        if (const auto found = roundings_at(examination, step, tolerance)) return *found;
        // If roundings may have caused it, too, the cause is unknown.
        if (examination.tally(step, kArithmetics.back(), tolerance).allows_all()) break;
      }
      if (suspects.empty()) break;
      AnswerCause found = {step, {}, {}, tolerance};
      for (const Mistake* mistake : suspects) {
        found.alternatives.push_back({mistake->sentence, errors, errors - left, mistake});
      }
      return found;
    }
  }
  if (part.last == Step::kIntersect) {
    if (auto cause = cancelling_q(examination)) return *std::move(cause);
    if (auto cause = cancelling_difference(examination)) return *std::move(cause);
  }
  return {};
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
           return examination.contradicted(*one.mistake, step, step, tolerance, most) <= most;
         });
}

std::vector<AnswerCause> causes_in(Examination& examination) {
  std::vector<AnswerCause> findings = {find_cause(examination, {Step::kFrame, Step::kRay})};
  for (const Step step : {Step::kIntersect, Step::kNearest}) {
    const bool is_known =
        std::any_of(findings.begin(), findings.end(),
                    [&](const AnswerCause& found) { return explains(examination, found, step); });
    if (is_known) continue;
    // Where hits have no errors they rule out mistakes that would change them.
    const bool hits_are_right =
        step == Step::kNearest &&
        examination.errors(Step::kIntersect, kAnswerTolerances.front()) == 0;
    findings.push_back(find_cause(examination, {hits_are_right ? Step::kIntersect : step, step}));
    // If nothing explains the hits, nearest spheres that follow from them say nothing.
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
    // A separate defect, which no other cause has to explain.
    Examination rest(cases, candidate, NotNumbers::kLeftOut);
    found = causes_in(rest);
    found.push_back({step, {{"not a number, or infinite", count, count}}});
    break;
  }
  return found;
}

std::vector<Explanation> explanations(const std::vector<AnswerCause>& causes) {
  std::vector<Explanation> all;
  for (const AnswerCause& cause : causes) {
    all.insert(all.end(), cause.alternatives.begin(), cause.alternatives.end());
  }
  return all;
}

}  // namespace raycheck::properties
