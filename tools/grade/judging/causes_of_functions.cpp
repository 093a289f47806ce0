#include <algorithm>
#include <cmath>
#include <optional>

#include "properties/mistakes/answer_explanation.h"
#include "properties/mistakes/fault.h"
#include "properties/trial.h"
#include "tools/grade/judging/item_trial.h"

namespace raycheck::tools {
namespace {

using properties::AnswerCause;
using properties::Candidate;
using properties::Case;
using properties::Explanation;
using properties::Trial;

/// The part to which a step belongs: camera, hits, nearest hit. Mistakes affect only answers of the
/// same part.
int part_of(properties::Step step) {
  return step < properties::Step::kIntersect ? 0 : step == properties::Step::kIntersect ? 1 : 2;
}

std::vector<Case> cases_of(const ItemTrial& trial) {
  std::vector<Case> cases;
  for (const FailedCase& one : trial.failed) cases.push_back(one.item_case.the_case);
  return cases;
}

/// The causes; empty if the candidate fails, which the verdict reports.
std::vector<AnswerCause> causes_of(const std::vector<Case>& cases, const Candidate& candidate) {
  return answered([&] { return properties::answer_causes(cases, candidate); })
      .value_or(std::vector<AnswerCause>());
}

/// Whether an alternative of a cause is also an alternative of one of `causes`.
bool is_among(const Explanation& alternative, const AnswerCause& cause,
              const std::vector<AnswerCause>& causes) {
  return std::ranges::any_of(causes, [&](const AnswerCause& other) {
    return other.roundings == cause.roundings &&
           std::ranges::any_of(other.alternatives, [&](const Explanation& one) {
             return cause.roundings || one.sentence == alternative.sentence;
           });
  });
}

/// The cause "roundings" among the causes of all items, or null. It is reported once.
const AnswerCause* roundings_of(const std::vector<AnswerCause>& causes) {
  const auto found = std::ranges::find_if(
      causes, [](const AnswerCause& one) { return one.roundings.has_value(); });
  return found == causes.end() ? nullptr : &*found;
}

bool are_near(const auto& a, const auto& b, double allowed) {
  const auto near = [allowed](double x, double y) {
    return x == y || (std::isnan(x) && std::isnan(y)) || std::abs(x - y) <= allowed;
  };
  return near(a.x, b.x) && near(a.y, b.y) && near(a.z, b.z);
}

/// Whether a direction is degenerate: NaN, or 0 if the code guards the division.
bool is_none(const scene::Vector3& direction) {
  const auto& [x, y, z] = direction;
  return std::isnan(x + y + z) || (x == 0 && y == 0 && z == 0);
}

bool are_alike(const scene::Ray& a, const scene::Ray& b) {
  const auto& [P, D] = a;
  const auto& [Q, E] = b;
  const double size = std::max({std::abs(P.x), std::abs(P.y), std::abs(P.z), 1.0});
  const double allowed = properties::kAnswerTolerances.back();
  return are_near(P, Q, allowed * size) && ((is_none(D) && is_none(E)) || are_near(D, E, allowed));
}

/// Whether a candidate's rays equal those of a mistake, so that nothing else is wrong with them.
/// For degenerate directions of the mistake, the candidate may also fail.
bool makes_rays_by(const properties::Mistake& mistake, const std::vector<Case>& cases,
                   const Candidate& candidate) {
  Candidate mistaken = mistake.candidate;
  mistaken.declared = candidate.declared;
  return std::ranges::all_of(cases, [&](const Case& one) {
    Trial its(one, candidate), made(one, mistaken);
    if (!one.scene.camera || !its.has_rays()) return true;
    const auto its_rays = answered([&] { return its.rays(); });
    const auto made_rays = answered([&] { return made.rays(); });
    if (!made_rays) return false;
    if (!its_rays) {
      return std::all_of(made_rays->begin(), made_rays->end(),
                         [](const scene::Ray& ray) { return is_none(ray.direction); });
    }
    return std::equal(its_rays->begin(), its_rays->end(), made_rays->begin(), made_rays->end(),
                      are_alike);
  });
}

}  // namespace

std::vector<ItemCause> causes_of_functions(const Rubric& rubric, const Candidate& candidate,
                                           std::vector<ItemTrial>& trials) {
  // Bonus items require more than right formulas, so their errors do not rule out an explanation of
  // the other items.
  std::vector<Case> all, ordinary;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    const std::vector<Case> cases = cases_of(trials[k]);
    all.insert(all.end(), cases.begin(), cases.end());
    if (!rubric.items[k].bonus) ordinary.insert(ordinary.end(), cases.begin(), cases.end());
  }
  const std::vector<AnswerCause> of_all = causes_of(all, candidate);
  const std::vector<AnswerCause> of_ordinary = causes_of(ordinary, candidate);
  std::vector<ItemCause> item_causes(trials.size());
  for (std::size_t k = 0; k < trials.size(); ++k) {
    ItemTrial& trial = trials[k];
    const auto step = step_of(rubric.items[k]);
    if (trial.grade.state != ItemState::kFails || trial.failed.empty() || !step) continue;
    const std::vector<Case> cases = cases_of(trial);
    for (const AnswerCause& cause : causes_of(cases, candidate)) {
      const int part = part_of(cause.step);
      if (part > part_of(*step) || (part == 0) != (part_of(*step) == 0)) continue;
      std::vector<Explanation> said;
      for (const Explanation& one : cause.alternatives) {
        if (one.explained == 0) continue;
        if (is_among(one, cause, of_all) || is_among(one, cause, of_ordinary)) {
          said.push_back(one);
        }
      }
      if (const auto* roundings = cause.roundings ? roundings_of(of_all) : nullptr) {
        said = cause.alternatives;
        said.front().sentence = roundings->alternatives.front().sentence;
      }
      if (said.empty()) continue;
      trial.grade.mistakes.push_back(
          {{properties::sentence_of(said)}, said.front().errors, said.front().explained});
      const properties::Fault& fault = said.front().mistakes;
      if (cause.roundings) {
        item_causes[k].others.push_back(OtherCause::kRoundings);
        item_causes[k].is_all = item_causes[k].fault.empty();
      }
      if (fault.empty()) continue;
      item_causes[k].fault.insert(item_causes[k].fault.end(), fault.begin(), fault.end());
      item_causes[k].is_all = item_causes[k].fault.size() == 1 &&
                              said.front().explained == said.front().errors &&
                              (part > 0 || makes_rays_by(*fault.front(), cases, candidate));
    }
  }
  return item_causes;
}

}  // namespace raycheck::tools
