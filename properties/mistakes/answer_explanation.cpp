#include "properties/mistakes/answer_explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "properties/candidates/fast_candidate.h"
#include "properties/mistakes/mistake_list.h"
#include "properties/trial.h"

namespace raycheck::properties {
namespace {

using scene::Vector3;

/// Any step's answer: which sphere, or whether one, and what vectors there are.
struct Answer {
  std::optional<std::size_t> choice;
  std::array<Vector3, 3> vectors;
};
using Answers = std::vector<Answer>;

template <class Triple>
Vector3 vector(const Triple& v) {
  return {v.x, v.y, v.z};
}

template <class Change>
double size_of(const Vector3& v, const Change& change) {
  return std::max({change(v.x), change(v.y), change(v.z)});
}

bool agree(const Vector3& a, const Vector3& b, double tolerance) {
  const auto finite = [](double x) { return std::isfinite(x) ? std::abs(x) : 0; };
  const double allowed = tolerance * std::max(size_of(a, finite), size_of(b, finite));
  const auto same = [allowed](double x, double y) {
    return (std::isnan(x) && std::isnan(y)) || x == y || std::abs(x - y) <= allowed;
  };
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

bool agree(const Answer& a, const Answer& b, double tolerance) {
  return a.choice == b.choice &&
         std::equal(a.vectors.begin(), a.vectors.end(), b.vectors.begin(),
                    [tolerance](auto& x, auto& y) { return agree(x, y, tolerance); });
}

/// A case under the conventions by which the candidate is judged, and its right rays.
struct Question {
  Case the_case;
  std::vector<scene::Ray> rays;
};

Answers hit_answers(const Question& question, const Trial& trial) {
  const auto found =
      trial.intersect(question.rays, question.the_case.scene.spheres, trial.conventions());
  Answers answers;
  for (const SphereHits& hits : found) {
    const std::size_t first = answers.size();
    answers.resize(first + question.rays.size());
    for (const auto& [ray, hit] : hits) {
      answers[first + ray] = {0, {Vector3{hit.parameter, 0, 0}, vector(hit.point)}};
    }
  }
  return answers;
}

/// Empty where the candidate has no such function.
std::optional<Answers> ask(Step step, const Question& question, const Candidate& candidate) {
  Trial trial(question.the_case, candidate);
  const scene::Scene& scene = question.the_case.scene;
  Answers answers;
  switch (step) {
    case Step::kFrame: {
      if (!scene.camera || !candidate.frame) return {};
      const auto& [U, V, W] = trial.frame();
      return Answers{{{}, {vector(U), vector(V), vector(W)}}};
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
      return hit_answers(question, trial);
    case Step::kNearest:
      break;
  }
  if (!candidate.nearest) return {};
  for (const auto& sphere : trial.rank(question.rays, scene.spheres)) {
    answers.push_back({sphere, {}});
  }
  return answers;
}

/// The same; empty too where the candidate refuses or fails.
std::optional<Answers> try_to_ask(Step step, const Question& question, const Candidate& candidate) {
  try {
    return ask(step, question, candidate);
  } catch (const std::runtime_error&) {
    return {};
  } catch (const std::invalid_argument&) {
    return {};
  }
}

/// What a candidate answered to a question at a step, what is right, and what other right formulas
/// make of it.
struct Comparison {
  const Question* question;
  Answers answers, right;
  std::vector<Answers> also_right;
};

/// The answers that differ from those expected, but for those that are right in another way.
std::uint64_t count_different(const Comparison& comparison, const Answers& expected,
                              double tolerance) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
    const Answer& answer = comparison.answers[k];
    const auto is_like = [&](const Answers& other) { return agree(answer, other[k], tolerance); };
    if (is_like(expected)) continue;
    if (!is_like(comparison.right) &&
        std::any_of(comparison.also_right.begin(), comparison.also_right.end(), is_like)) {
      continue;
    }
    ++count;
  }
  return count;
}

/// The methods of fast/ beside direct/cross, but for those that are less precise than a candidate.
std::vector<Candidate> other_right_candidates(const Candidate& candidate) {
  std::vector<Candidate> others;
  const double coarsest = std::max(candidate.unit_roundoff, kDoubleRoundoff);
  const auto add = [&](const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect) {
    Candidate other = fast_candidate(rays, intersect);
    if (other.unit_roundoff <= coarsest) others.push_back(std::move(other));
  };
  for (const auto* rays : fast::pixel_ray_methods()) {
    if (rays != &fast::kDirectRays) add(*rays, fast::kCross);
  }
  for (const auto* intersect : fast::intersect_methods()) {
    if (intersect != &fast::kCross) add(fast::kDirectRays, *intersect);
  }
  return others;
}

/// A candidate's answers to cases, each step's worked out when first asked for.
class Examination {
 public:
  Examination(std::span<const Case> cases, const Candidate& candidate)
      : candidate_(candidate), others_(other_right_candidates(candidate)) {
    for (const Case& the_case : cases) {
      if (!is_inside_domain(candidate, the_case.scene)) continue;
      questions_.push_back({the_case, {}});
      Question& question = questions_.back();
      scene::Conventions& conventions = question.the_case.scene.conventions;
      conventions = candidate.declared.over(conventions);
      question.rays = Trial(question.the_case, right_).rays();
    }
  }

  const std::vector<Comparison>& at(Step step) {
    auto& known = comparisons_[static_cast<std::size_t>(step)];
    if (known) return *known;
    known.emplace();
    for (const Question& question : questions_) {
      std::optional<Answers> answers = try_to_ask(step, question, candidate_);
      if (!answers) continue;
      Comparison comparison = {
          &question, std::move(*answers), ask(step, question, right_).value(), {}};
      if (count_different(comparison, comparison.right, kAnswerTolerances.front()) > 0) {
        comparison.also_right = ask_others(step, question);
      }
      known->push_back(std::move(comparison));
    }
    return *known;
  }

  std::uint64_t errors(Step step, double tolerance) {
    std::uint64_t count = 0;
    for (const Comparison& comparison : at(step))
      count += count_different(comparison, comparison.right, tolerance);
    return count;
  }

  /// The answers up to a step that are not as a mistake makes them; any number above `most` where
  /// they are more.
  std::uint64_t contradicted(const Mistake& mistake, Step first, Step last, double tolerance,
                             std::uint64_t most) {
    std::uint64_t count = 0;
    for (auto step = static_cast<int>(last); step >= static_cast<int>(first); --step) {
      for (const Comparison& comparison : at(static_cast<Step>(step))) {
        if (count > most) return count;
        const auto made =
            try_to_ask(static_cast<Step>(step), *comparison.question, mistake.candidate);
        count += count_different(comparison, made ? *made : comparison.right, tolerance);
      }
    }
    return count;
  }

 private:
  std::vector<Answers> ask_others(Step step, Question question) const {
    std::vector<Answers> answers;
    scene::Conventions& conventions = question.the_case.scene.conventions;
    const auto add = [&](const Candidate& other) {
      if (!(other.declared.over(conventions) == conventions)) return;
      if (auto its = try_to_ask(step, question, other)) answers.push_back(std::move(*its));
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
  std::vector<Question> questions_;
  std::array<std::optional<std::vector<Comparison>>, kStepCount> comparisons_;
};

std::vector<Explanation> explain(Examination& examination, Step step, std::uint64_t errors,
                                 double tolerance) {
  // Hits are asked about right rays: no mistake in these shows in them.
  const Step first = step < Step::kIntersect ? Step::kFrame : Step::kIntersect;
  std::vector<Explanation> best;
  std::uint64_t fewest = most_unexplained(errors);
  for (const Mistake& mistake : mistakes()) {
    if (mistake.step < first || mistake.step > step) continue;
    const std::uint64_t left = examination.contradicted(mistake, first, step, tolerance, fewest);
    if (left > fewest) continue;
    if (left < fewest) best.clear();
    fewest = left;
    best.push_back({mistake.sentence, errors, errors - left});
  }
  return best;
}

}  // namespace

std::vector<Explanation> explanations(std::span<const Case> cases, const Candidate& candidate) {
  Examination examination(cases, candidate);
  for (const double tolerance : kAnswerTolerances) {
    for (const Step step :
         {Step::kFrame, Step::kPixelPoint, Step::kRay, Step::kIntersect, Step::kNearest}) {
      const std::uint64_t errors = examination.errors(step, tolerance);
      if (errors == 0) continue;
      std::vector<Explanation> found = explain(examination, step, errors, tolerance);
      if (!found.empty()) return found;
      break;
    }
  }
  return {};
}

}  // namespace raycheck::properties
