#include "tools/grade/judging/judge.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <variant>

#include "properties/cases/random.h"
#include "properties/mistakes/explanation.h"
#include "scene/interruption.h"
#include "tools/grade/judging/item_trial.h"
#include "tools/grade/results/result.h"

namespace raycheck::tools {

using properties::Mistake;
using properties::Quantity;

std::optional<properties::Step> step_of(const Item& item) {
  if (!item.functions) return {};
  switch (item.functions->laws.front()->quantity) {
    case Quantity::kFrame:
      return properties::Step::kFrame;
    case Quantity::kPixelPoint:
      return properties::Step::kPixelPoint;
    case Quantity::kDirection:
    case Quantity::kUnitDefect:
    case Quantity::kRayOrigin:
      return properties::Step::kRay;
    case Quantity::kNearestSphere:
      return properties::Step::kNearest;
    default:
      return properties::Step::kIntersect;
  }
}

namespace {

using properties::Candidate;
using properties::Fault;

/// A cause that is charged to one item.
using Charge = std::variant<const Mistake*, OtherCause>;

std::vector<Charge> charges(const ItemCause& cause) {
  std::vector<Charge> all(cause.fault.begin(), cause.fault.end());
  all.insert(all.end(), cause.others.begin(), cause.others.end());
  return all;
}

/// Whether a mistake is made at the step about which an item asks.
bool is_of_step(const Charge& charge, const Item& item) {
  const auto* const mistake = std::get_if<const Mistake*>(&charge);
  return mistake != nullptr && step_of(item) == (*mistake)->step;
}

/// Charges each known cause to one item only: of the items that fail by it, the first that asks
/// about the step of the mistake, or else the first. Items that fail only by causes charged
/// elsewhere follow.
void charge_once(const Rubric& rubric, const std::vector<ItemCause>& causes,
                 std::vector<ItemTrial>& trials) {
  std::map<Charge, std::size_t> charged;
  for (const bool of_its_step : {true, false}) {
    for (std::size_t k = 0; k < trials.size(); ++k) {
      for (const Charge& one : charges(causes[k])) {
        if (!of_its_step || is_of_step(one, rubric.items[k])) charged.try_emplace(one, k);
      }
    }
  }
  for (std::size_t k = 0; k < trials.size(); ++k) {
    ItemGrade& grade = trials[k].grade;
    const std::vector<Charge> its = charges(causes[k]);
    // Only right answers get bonus points.
    const bool follows =
        grade.state == ItemState::kFails && !rubric.items[k].bonus && causes[k].is_all &&
        !its.empty() &&
        std::ranges::all_of(its, [&](const Charge& one) { return charged.at(one) != k; });
    if (!follows) continue;
    grade.state = ItemState::kFollows;
    grade.reason = {.kind = ItemReason::Kind::kFollows,
                    .item = rubric.items[charged.at(its.front())].name};
  }
}

/// The candidate with its pictures reduced to masks.
Candidate masked(Candidate candidate) {
  candidate.image = [image = candidate.image](const scene::Scene& scene,
                                              const scene::Conventions& conventions) {
    return mask_of(image(scene, conventions));
  };
  return candidate;
}

/// The item's points for a share of its cases.
double score_of(const Item& item, std::uint64_t held, std::uint64_t cases) {
  if (cases == 0) return 0;
  const double share = static_cast<double>(held) / static_cast<double>(cases);
  if (item.credit == Credit::kAll) return held == cases ? item.points : 0;
  if (item.credit == Credit::kShare) return share * item.points;
  double credit = 0;
  for (const CreditStep& step : item.steps) {
    if (share >= step.share) credit = std::max(credit, step.credit);
  }
  return credit * item.points;
}

/// Asks a submission all items in order.
class Judge {
 public:
  Judge(const Rubric& rubric, JudgedSubmission judged, std::uint64_t seed,
        const properties::RunControl& control)
      : rubric_(rubric),
        judged_(std::move(judged)),
        control_(control),
        seed_(seed),
        before_(judged_.spent ? judged_.spent->so_far() : SpentTime::Time{}) {
    Candidate& candidate = judged_.candidate;
    candidate.declared = rubric.conventions.over(candidate.declared);
    // If a submission could declare valid roots or a domain, it could exclude cases of the rubric.
    if (!judged_.is_declared) {
      candidate.declared.valid = rubric.conventions.valid.value_or(scene::ValidRoots{});
      candidate.smallest_length = candidate.smallest_camera_length =
          std::min(candidate.smallest_length, properties::kSmallestJudgedLength);
      candidate.largest_length = candidate.largest_camera_length =
          std::numeric_limits<double>::infinity();
    }
    candidate = judged_in(rubric.precision, std::move(candidate));
  }

  std::vector<ItemGrade> judge() {
    std::vector<ItemTrial> trials;
    for (std::size_t k = 0; k < rubric_.items.size(); ++k) trials.push_back(try_item_at(k));
    std::vector<ItemCause> causes(trials.size());
    try {
      // If answers depend on earlier questions, they say nothing about formulas.
      if (!name_kept_state(trials)) {
        causes = judged_.pictures
                     ? causes_of_pictures(rubric_, judged_.form_known, *judged_.format, trials)
                     : causes_of_functions(rubric_, judged_.candidate, trials);
      }
    } catch (const scene::Interrupted&) {
      // The causes stay unknown.
    }
    charge_once(rubric_, causes, trials);
    std::vector<ItemGrade> grades;
    for (std::size_t k = 0; k < trials.size(); ++k) {
      leave_out_what_needs_others(rubric_.items[k], grades, trials[k].grade);
      ItemGrade& grade = trials[k].grade;
      if (grade.state == ItemState::kFails) {
        grade.score = score_of(rubric_.items[k], grade.held, grade.cases);
        show_failure(k, causes[k].fault, trials[k]);
      } else if (grade.state == ItemState::kHolds || grade.state == ItemState::kFollows) {
        grade.score = score_of(rubric_.items[k], grade.cases, grade.cases);
      }
      grades.push_back(std::move(grade));
    }
    return grades;
  }

 private:
  /// The reason to stop asking, if there is one.
  ItemReason reason_to_stop() const {
    if (control_.interrupted()) return {.kind = ItemReason::Kind::kInterrupted};
    if (!judged_.spent || judged_.spent->seconds_since(before_) < rubric_.seconds) return {};
    return {.kind = ItemReason::Kind::kTimeUp, .seconds = rubric_.seconds};
  }

  const std::optional<ItemTask>& task_of(const Item& item) const {
    return judged_.pictures ? item.pictures : item.functions;
  }

  GradedCandidate candidate_for(const Item& item) const {
    const ItemTask& task = *task_of(item);
    GradedCandidate graded;
    graded.unmasked = tolerated(judged_.candidate, item.tolerance);
    graded.unmasked.excused_image_change =
        task.image_change.value_or(graded.unmasked.excused_image_change);
    graded.candidate = task.masks_only ? masked(graded.unmasked) : graded.unmasked;
    if (!task.judges_depth) graded.candidate.depths = {};
    graded.tolerance = item.tolerance;
    graded.pictures = judged_.pictures;
    graded.masks_only = task.masks_only;
    graded.last_failure = judged_.last_failure;
    return graded;
  }

  ItemTrial try_item_at(std::size_t index) {
    using Kind = ItemReason::Kind;
    const Item& item = rubric_.items[index];
    ItemTrial trial;
    ItemGrade& grade = trial.grade = unjudged(item, judged_.pictures);
    const auto& task = task_of(item);
    if (!task) {
      grade.reason.kind = judged_.pictures ? Kind::kNotInPictures : Kind::kOfRenderers;
      return trial;
    }
    properties::Random seeds(seed_);
    for (std::size_t k = 0; k < index; ++k) seeds.bits();
    const GradedCandidate graded = candidate_for(item);
    const ItemCases cases(*task, judged_.pictures, seeds.bits(), graded.candidate.declared,
                          graded.candidate.input_format());
    try {
      return try_item(
          *task, cases, graded, [this] { return reason_to_stop(); }, grade);
    } catch (const scene::Interrupted&) {
      grade.reason.kind = Kind::kInterrupted;
      return trial;
    }
  }

  /// Leaves an item out if an item that it needs does not have all points.
  static void leave_out_what_needs_others(const Item& item, const std::vector<ItemGrade>& before,
                                          ItemGrade& grade) {
    if (grade.state == ItemState::kNotAsked) return;
    for (const std::string& needed : item.needs) {
      const auto found = std::ranges::find_if(
          before, [&](const ItemGrade& other) { return other.name == needed; });
      if (found->state == ItemState::kNotAsked || found->score >= found->points) continue;
      grade = unjudged(item, grade.pictures);
      grade.state = ItemState::kLeftOut;
      grade.reason = {.kind = ItemReason::Kind::kNeeds, .item = needed, .state = found->state};
      return;
    }
  }

  /// If a fresh process answers the first failure of an item rightly, names kept state as the
  /// item's mistake.
  bool name_kept_state(std::vector<ItemTrial>& trials) const {
    bool is_kept = false;
    for (std::size_t k = 0; k < trials.size(); ++k) {
      if (trials[k].failed.empty()) continue;
      const FailedCase& first = trials[k].failed.front();
      if (!keeps_state(first, candidate_for(rubric_.items[k]))) continue;
      trials[k].grade.mistakes = {{{std::string(properties::kKeepsState)}}};
      trials[k].grade.first_wrong = {first.item_case.origin, first.discrepancy};
      trials[k].failed.clear();
      is_kept = true;
    }
    return is_kept;
  }

  /// Shrinks an item's first failure, and stores the smallest case.
  void show_failure(std::size_t index, const Fault& fault, ItemTrial& trial) {
    if (trial.failed.empty()) return;
    const FailedCase& first = trial.failed.front();
    const GradedCandidate graded = candidate_for(rubric_.items[index]);
    trial.grade.first_wrong = {first.item_case.origin, first.discrepancy};
    const auto is_late = [this] { return reason_to_stop().kind != ItemReason::Kind::kNone; };
    try {
      const properties::Case smallest = simplest(first, graded, fault, is_late);
      trial.grade.failing = failing_case(smallest, first, graded);
    } catch (const scene::Interrupted&) {
      trial.grade.failing.reset();
    }
  }

  const Rubric& rubric_;
  JudgedSubmission judged_;
  const properties::RunControl& control_;
  std::uint64_t seed_;
  SpentTime::Time before_;
};

}  // namespace

std::vector<ItemGrade> judge(const Rubric& rubric, JudgedSubmission judged, std::uint64_t seed,
                             const properties::RunControl& control) {
  using scene::Rows, scene::Samples;
  const auto declared = rubric.conventions;
  std::vector<properties::DeclaredConventions> all = {declared};
  if (rubric.rows_either) {
    all.assign(2, declared);
    all[0].rows = Rows::kBottomFirst;
    all[1].rows = Rows::kTopFirst;
  }
  if (rubric.samples_either) {
    const auto of_rows = std::exchange(all, {});
    const bool is_any = rubric.any_sample && judged.pictures;
    for (const Samples samples : {Samples::kEdges, Samples::kCentres, Samples::kCorners}) {
      if (is_any && samples != Samples::kCentres) continue;
      for (const properties::DeclaredConventions& one : of_rows) {
        all.push_back(one);
        all.back().samples = samples;
      }
    }
  }
  if (all.size() == 1) return Judge(rubric, std::move(judged), seed, control).judge();
  std::vector<ItemGrade> best;
  const auto lost = [](const std::vector<ItemGrade>& grades) {
    return std::accumulate(grades.begin(), grades.end(), 0.0, [](double sum, const ItemGrade& one) {
      return sum + one.points - one.score;
    });
  };
  for (const properties::DeclaredConventions& conventions : all) {
    Rubric either = rubric;
    either.conventions = conventions;
    std::vector<ItemGrade> grades = Judge(either, judged, seed, control).judge();
    if (best.empty() || lost(grades) < lost(best)) best = std::move(grades);
    if (lost(best) == 0) break;
  }
  return best;
}

}  // namespace raycheck::tools
