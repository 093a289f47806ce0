#include "properties/mistakes/answer_explanation.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "fast/intersect.h"
#include "properties/case.h"
#include "properties/mistakes/mistake_list.h"
#include "properties/trial.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

using scene::Vector3;

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
  bool class_alone = false;  ///< That a ray hits is all that is known of a hit.
};

/// What a candidate answered to a case at a step, what is right, and what other right formulas
/// make of it.
struct Comparison {
  const AskedCase* asked;
  StepAnswers answers, right;
  std::vector<StepAnswers> also_right;
};

bool agree(const Vector3& a, const Vector3& b, double tolerance) {
  double size = 0;
  for (const double x : {a.x, a.y, a.z, b.x, b.y, b.z}) {
    if (std::isfinite(x)) size = std::max(size, std::abs(x));
  }
  const auto same = [allowed = tolerance * size](double x, double y) {
    return (std::isnan(x) && std::isnan(y)) || x == y || std::abs(x - y) <= allowed;
  };
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

bool agree(const Answer& a, const Answer& b, double tolerance) {
  return a.choice == b.choice &&
         std::equal(a.vectors.begin(), a.vectors.end(), b.vectors.begin(),
                    [tolerance](auto& x, auto& y) { return agree(x, y, tolerance); });
}

StepAnswers hit_answers(const AskedCase& asked, const Trial& trial) {
  const auto found = trial.intersect(asked.rays, asked.the_case.scene.spheres, trial.conventions());
  StepAnswers answers;
  for (const SphereHits& hits : found) {
    const std::size_t first = answers.size();
    answers.resize(first + asked.rays.size());
    for (const auto& [ray, hit] : hits) {
      answers[first + ray] = {0, {Vector3{}, Vector3{}}};
      if (asked.class_alone) continue;
      answers[first + ray].vectors = {Vector3{hit.parameter, 0, 0}, vector(hit.point)};
    }
  }
  return answers;
}

/// Empty where the candidate lacks the function.
std::optional<StepAnswers> ask(Step step, const AskedCase& asked, const Candidate& candidate) {
  Trial trial(asked.the_case, candidate);
  const scene::Scene& scene = asked.the_case.scene;
  StepAnswers answers;
  switch (step) {
    case Step::kFrame: {
      if (!scene.camera || !candidate.frame) return {};
      const auto& [U, V, W] = trial.frame();
      return StepAnswers{{{}, {vector(U), vector(V), vector(W)}}};
    }
    case Step::kPixelPoint:
      if (!scene.camera || !candidate.pixel_points) return {};
      for (const scene::Point3& P : trial.pixel_points()) answers.push_back({{}, {vector(P)}});
      return answers;
    case Step::kRay:
      if (!scene.camera || !trial.has_rays()) return {};
      for (const auto& [origin, direction] : trial.rays()) {
        answers.push_back({{}, {vector(origin), direction}});
      }
      return answers;
    case Step::kIntersect:
      if (!candidate.intersect) return {};
      return hit_answers(asked, trial);
    case Step::kNearest:
      break;
  }
  if (!candidate.nearest) return {};
  for (const auto& sphere : trial.rank(asked.rays, scene.spheres)) {
    answers.push_back({sphere, {}});
  }
  return answers;
}

/// The same; also empty where the candidate refuses or fails.
std::optional<StepAnswers> try_to_ask(Step step, const AskedCase& asked,
                                      const Candidate& candidate) {
  scene::poll();
  try {
    return ask(step, asked, candidate);
  } catch (const std::runtime_error&) {
    return {};
  } catch (const std::invalid_argument&) {
    return {};
  }
}

/// Floats have fewer digits than an answer whose relative error is at most this.
constexpr double kPrecise = 0x1p-36;

/// Whether an answer is neither as expected nor right in another way.
bool is_different(const Comparison& comparison, std::size_t k, const StepAnswers& expected,
                  double tolerance) {
  const auto is_like = [&](const StepAnswers& other) {
    return agree(comparison.answers[k], other[k], tolerance);
  };
  if (is_like(expected)) return false;
  return is_like(comparison.right) ||
         std::none_of(comparison.also_right.begin(), comparison.also_right.end(), is_like);
}

/// How many answers differ from those expected, except those that are right in another way.
std::uint64_t count_different(const Comparison& comparison, const StepAnswers& expected,
                              double tolerance) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
    count += is_different(comparison, k, expected, tolerance) ? 1 : 0;
  }
  return count;
}

/// Which of a asked's answers, by sphere and ray or by ray, miss a sphere that none meets.
std::vector<bool> dropped(Step step, const Comparison& comparison) {
  const std::size_t count = comparison.asked->rays.size();
  const auto sphere_of = [&](const Answer& answer, std::size_t k) -> std::optional<std::size_t> {
    if (!answer.choice) return {};
    return step == Step::kNearest ? *answer.choice : k / count;
  };
  std::set<std::size_t> met;
  for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
    if (const auto sphere = sphere_of(comparison.answers[k], k)) met.insert(*sphere);
  }
  std::vector<bool> found(comparison.answers.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto sphere = sphere_of(comparison.right[k], k);
    found[k] = sphere && !comparison.answers[k].choice && !met.contains(*sphere);
  }
  return found;
}

/// Whether another root counts than if every root >= 0 did, as in the code of classic mistakes.
bool ends_matter(const AskedCase& asked) {
  const scene::Conventions& conventions = asked.the_case.scene.conventions;
  if (conventions.valid.is_usual()) return false;
  Case given{asked.the_case.scene, {}};
  given.scene.camera.reset();
  given.scene.rays = asked.rays;
  if (!scene::defects(given.scene).empty()) return true;
  scene::Conventions usual = conventions;
  usual.valid = {};
  Truth own(given, conventions), others(given, usual);
  for (std::size_t ray = 0; ray < asked.rays.size(); ++ray) {
    for (std::size_t sphere = 0; sphere < given.scene.spheres.size(); ++sphere) {
      if (!(own.intersection(ray, sphere) == others.intersection(ray, sphere))) return true;
    }
  }
  return false;
}

/// A candidate's answers to cases; each step is computed on demand.
class Examination {
 public:
  Examination(std::span<const Case> cases, const Candidate& candidate)
      : candidate_(candidate), others_(other_right_candidates(candidate)) {
    for (const Case& the_case : cases) {
      auto rounded = rounded_case(the_case, candidate.input_format()).the_case;
      if (!rounded || !is_inside_domain(candidate, rounded->scene)) continue;
      asked_.push_back({*std::move(rounded), {}, candidate.returns == Returns::kClass});
      AskedCase& asked = asked_.back();
      scene::Conventions& conventions = asked.the_case.scene.conventions;
      conventions = candidate.declared.over(conventions);
      asked.rays = Trial(asked.the_case, right_).rays();
      for (scene::Ray& ray : asked.rays) ray = rounded_ray(ray, candidate.input_format());
      if (ends_matter(asked)) asked_.pop_back();
    }
  }

  const std::vector<Comparison>& at(Step step) {
    auto& known = comparisons_[static_cast<std::size_t>(step)];
    if (known) return *known;
    known.emplace();
    for (const AskedCase& asked : asked_) {
      std::optional<StepAnswers> answers = try_to_ask(step, asked, candidate_);
      if (!answers) continue;
      Comparison comparison = {&asked, std::move(*answers), ask(step, asked, right_).value(), {}};
      if (count_different(comparison, comparison.right, kAnswerTolerances.front()) > 0) {
        comparison.also_right = ask_others(step, asked);
      }
      known->push_back(std::move(comparison));
    }
    return *known;
  }

  bool is_single() const { return candidate_.precision == scene::Precision::kSingle; }
  double roundoff() const { return scene::unit_roundoff(candidate_.precision); }

  std::uint64_t errors(Step step, double tolerance) {
    std::uint64_t count = 0;
    for (const Comparison& comparison : at(step))
      count += count_different(comparison, comparison.right, tolerance);
    return count;
  }

  /// How many answers up to a step are not as a mistake makes them; any number above `most` if
  /// there are more.
  std::uint64_t contradicted(const Mistake& mistake, Step first, Step last, double tolerance,
                             std::uint64_t most) {
    std::uint64_t count = 0;
    for (auto step = static_cast<int>(last); step >= static_cast<int>(first); --step) {
      for (const Comparison& comparison : at(static_cast<Step>(step))) {
        if (count > most) return count;
        const auto made = try_to_ask(static_cast<Step>(step), *comparison.asked, mistake.candidate);
        count += count_different(comparison, made ? *made : comparison.right, tolerance);
      }
    }
    return count;
  }

  /// How well the roundings of a formula agree with the answers at kIntersect or kNearest.
  DoubtTally tally(Step step, Arithmetic arithmetic, double tolerance) {
    DoubtTally all;
    for (const Comparison& comparison : at(step)) {
      const auto& [the_case, rays, class_alone] = *comparison.asked;
      const scene::Conventions& conventions = the_case.scene.conventions;
      const std::vector<bool> is_dropped = dropped(step, comparison);
      for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
        const Answer& answer = comparison.answers[k];
        const bool is_wrong = is_different(comparison, k, comparison.right, tolerance);
        if (step == Step::kNearest) {
          const PossibleSight sight = possible_sight(arithmetic, rays[k], the_case.scene.spheres,
                                                     conventions, answer.choice);
          all.add(is_wrong, is_dropped[k], sight.allows, sight.is_doubtful, sight.radii);
          continue;
        }
        const PossibleHit hit = possible_hit(arithmetic, rays[k % rays.size()],
                                             the_case.scene.spheres[k / rays.size()], conventions);
        const bool is_wide = hit.is_possible && hit.most - hit.least > tolerance * hit.most;
        const auto s = answer.choice ? std::optional(answer.vectors[0].x) : std::nullopt;
        // Roundings of d^2 move Q along the ray.
        const bool is_on_ray =
            !s || agree(answer.vectors[1], vector(hit_at(rays[k % rays.size()], *s).point), 1e-3);
        all.add(is_wrong, is_dropped[k], is_on_ray && hit.allows(s), hit.is_doubtful() || is_wide,
                hit.radii);
        if (is_wrong || !s || class_alone) continue;
        const double exact = comparison.right[k].vectors[0].x;
        ++all.hits;
        all.precise += std::abs(*s - exact) <= kPrecise * exact ? 1 : 0;
      }
    }
    return all;
  }

 private:
  std::vector<StepAnswers> ask_others(Step step, AskedCase asked) const {
    std::vector<StepAnswers> answers;
    scene::Conventions& conventions = asked.the_case.scene.conventions;
    const auto add = [&](const Candidate& other) {
      if (!(other.declared.over(conventions) == conventions)) return;
      if (auto its = try_to_ask(step, asked, other)) answers.push_back(std::move(*its));
    };
    for (const Candidate& other : others_) add(other);
    if (conventions.tangent == scene::Tangent::kEither && step >= Step::kIntersect) {
      conventions.tangent = scene::Tangent::kMiss;
      add(right_);
    }
    return answers;
  }

  const Candidate& candidate_;
  const Candidate right_ = right_candidate();
  const std::vector<Candidate> others_;
  std::vector<AskedCase> asked_;
  std::array<std::optional<std::vector<Comparison>>, kStepCount> comparisons_;
};

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

/// The roundings that explain the answers at a step, if any do.
std::optional<AnswerCause> roundings_at(Examination& examination, Step step, double tolerance) {
  for (const Arithmetic arithmetic : kArithmetics) {
    const DoubtTally tally = examination.tally(step, arithmetic, tolerance);
    if (!tally.tells()) continue;
    // Whose right answers have more digits than floats does not compute in them.
    if (arithmetic != Arithmetic::kDifference && 2 * tally.precise > tally.hits) continue;
    return AnswerCause{step,
                       {{imprecision_sentence(arithmetic, tally.radii), tally.wrong, tally.wrong}},
                       arithmetic,
                       tolerance};
  }
  return {};
}

/// Small errors of s, where the answers' classes are right: those above this share of s count, in
/// roundings of the candidate's format.
constexpr double kNoticed = 512;

/// What all such errors at kIntersect are within, and what some go beyond.
struct SmallErrors {
  std::uint64_t wrong = 0;  ///< Beyond what `stable` allows.
  double radii = 0;         ///< The least distance of one of these.
};
/// Empty where one answer has another class than the right one, or is not as `allows` says.
template <class Allows, class IsTelling>
std::optional<SmallErrors> small_errors(Examination& examination, const Allows& allows,
                                        const IsTelling& is_telling) {
  SmallErrors found;
  for (const Comparison& comparison : examination.at(Step::kIntersect)) {
    const AskedCase& asked = *comparison.asked;
    if (asked.class_alone) return {};
    for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
      const Answer &answer = comparison.answers[k], &right = comparison.right[k];
      if (answer.choice != right.choice) return {};
      if (!right.choice) continue;
      const double s = answer.vectors[0].x, exact = right.vectors[0].x;
      const double off = std::abs(s - exact) / exact;
      if (off <= kNoticed * examination.roundoff()) continue;
      const scene::Ray& ray = asked.rays[k % asked.rays.size()];
      const scene::Sphere& sphere = asked.the_case.scene.spheres[k / asked.rays.size()];
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
/// that cancels. Roundings of d^2 leave that root alone.
std::optional<AnswerCause> cancelling_q(Examination& examination) {
  const auto found = small_errors(
      examination,
      [&](const AskedCase&, const scene::Ray& ray, const scene::Sphere& sphere, double,
          double off) {
        const auto roots = fast::kCross.roots(ray, sphere);
        const double v = std::abs(roots.axial_distance);
        const double d = std::sqrt(std::max(0.0, roots.half_chord_sq));
        const double lost = kRoundings * examination.roundoff() * (v + d) / std::abs(v - d);
        return off <= lost;
      },
      [](const AskedCase&, const scene::Ray& ray, const scene::Sphere& sphere, double s) {
        return s * norm(ray.direction) > std::abs(fast::kCross.roots(ray, sphere).axial_distance);
      });
  if (!found) return {};
  return small_cause("q = b + sgn(b) sqrt(b^2 - ac) has the wrong sign within: it cancels", *found);
}

/// d^2 as a difference that cancels, where that moves no class yet: s loses digits that r^2 - |T x
/// D|^2 keeps.
std::optional<AnswerCause> cancelling_difference(Examination& examination) {
  const bool is_single = examination.is_single();
  const auto within = [](Arithmetic arithmetic) {
    return [arithmetic](const AskedCase& asked, const scene::Ray& ray, const scene::Sphere& sphere,
                        double s, auto...) {
      return possible_hit(arithmetic, ray, sphere, asked.the_case.scene.conventions).allows(s);
    };
  };
  const auto stable = within(is_single ? Arithmetic::kSingle : Arithmetic::kProduct);
  const auto found = small_errors(
      examination, within(is_single ? Arithmetic::kSingleDifference : Arithmetic::kDifference),
      [&](const auto&... of) { return !stable(of...); });
  if (!found) return {};
  return small_cause(imprecision_sentence(Arithmetic::kDifference, found->radii), *found);
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
        if (mistake.step >= part.first && mistake.step <= step) suspects.push_back(&mistake);
      }
      suspects = best_of(examination, suspects, {part.first, step}, tolerance, left);
      if (suspects.size() > 1) tell_apart(examination, step, part.last, tolerance, suspects);
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

}  // namespace

std::vector<AnswerCause> answer_causes(std::span<const Case> cases, const Candidate& candidate) {
  Examination examination(cases, candidate);
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

std::vector<Explanation> explanations(const std::vector<AnswerCause>& causes) {
  std::vector<Explanation> all;
  for (const AnswerCause& cause : causes) {
    all.insert(all.end(), cause.alternatives.begin(), cause.alternatives.end());
  }
  return all;
}

}  // namespace raycheck::properties
