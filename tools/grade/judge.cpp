#include "tools/grade/judge.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "properties/cases/random.h"
#include "tools/grade/failure.h"
#include "tools/grade/item_cases.h"
#include "tools/methods/methods.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::Discrepancy;
using properties::Law;
using properties::Trial;
using properties::Truth;
using properties::Verdict;

/// So many failing cases of an item are kept to find the mistake that explains them.
constexpr std::size_t kKeptCases = 8;

/// After so many cases of an item on which a program fails altogether, the others are not asked.
constexpr int kMostFailures = 8;

/// The candidate held to what an item tolerates.
Candidate tolerated(Candidate candidate, const Tolerance& tolerance) {
  if (tolerance.conditioning) {
    candidate.max_error.fill(properties::kModerateCondition * *tolerance.conditioning);
    candidate.max_error_end_to_end.fill({});
    candidate.unit_roundoff = properties::kDoubleRoundoff * *tolerance.conditioning;
  } else if (tolerance.ulp) {
    candidate.unit_roundoff = properties::kDoubleRoundoff * *tolerance.ulp *
                              (properties::kDoubleRoundoff / properties::kExcusedChange);
  }
  return candidate;
}

/// The candidate, of whose pictures only the mask counts: whether a pixel shows a sphere, not
/// which.
Candidate masked(Candidate candidate) {
  candidate.image = [image = candidate.image](const scene::Scene& scene,
                                              const scene::Conventions& conventions) {
    properties::ImageAnswer answer = image(scene, conventions);
    for (auto& sphere : answer) {
      if (sphere) sphere = properties::kSomeSphere;
    }
    return answer;
  };
  return candidate;
}

/// What became of a case.
struct CaseOutcome {
  bool answers = false;  ///< There was something to ask.
  std::uint64_t compared = 0;
  Verdict verdict;        ///< By all laws.
  ItemReason unanswered;  ///< Why less was answered than asked.
  const Law* broken = nullptr;
  std::optional<Discrepancy> discrepancy;
  bool timed_out = false;  ///< No answer came in time.
  bool is_answered() const { return unanswered.kind == ItemReason::Kind::kNone; }
  bool holds() const { return broken == nullptr && is_answered(); }
};

/// Whether an answer may be missing: decisions about the case are excused or undecided, and where
/// one goes the other way there is a hit less to compare.
bool may_miss_answers(Trial& trial) {
  for (const Law& law : properties::laws()) {
    if (!judges_decisions(law) || law.per == properties::Per::kImage) continue;
    const Verdict verdict = apply(law, trial);
    if (verdict.holds() && verdict.discrepancies() > 0) return true;
  }
  return false;
}

CaseOutcome try_case(const std::vector<const Law*>& laws, const Case& the_case,
                     const Examinee& examinee) {
  Candidate own = candidate_of(kDefaultMethods);
  own.declared = examinee.candidate.declared;
  const auto truth =
      std::make_shared<Truth>(the_case, own.declared.over(the_case.scene.conventions));
  Trial trial(the_case, examinee.candidate, examinee.options(truth));
  Trial own_trial(the_case, own, examinee.options(truth));
  CaseOutcome outcome;
  for (const Law* law : laws) {
    Verdict verdict = apply(*law, trial);
    // raycheck's own methods draw no pictures, of which every pixel is compared.
    const std::uint64_t expected = examinee.pictures ? 0 : apply(*law, own_trial).compared();
    outcome.compared += verdict.compared();
    outcome.answers = outcome.answers || verdict.compared() > 0 || expected > 0;
    // Who shows colours of its own does not tell which sphere it sees.
    const bool is_untold =
        examinee.pictures && !examinee.masks_only && the_case.scene.spheres.size() > 1;
    if (!verdict.holds()) {
      if (outcome.broken != nullptr) continue;
      outcome.broken = law;
      outcome.discrepancy = verdict.worst(1).front();
      outcome.timed_out = outcome.discrepancy->wrong == properties::Wrong::kFailed &&
                          examinee.last_failure && *examinee.last_failure == FailureKind::kTimeUp;
    } else if (is_untold && !verdict.reason_left_out().empty()) {
      outcome.unanswered = {.kind = ItemReason::Kind::kOtherColours};
    } else if (verdict.compared() < expected && outcome.is_answered() && !may_miss_answers(trial)) {
      outcome.unanswered = {.kind = ItemReason::Kind::kUnanswered,
                            .law = std::string(law->name),
                            .said = verdict.reason_left_out()};
    }
    outcome.verdict.merge(std::move(verdict));
  }
  return outcome;
}

/// A case that broke a law.
struct Failure {
  ItemCase item_case;
  const Law* broken;
  Discrepancy discrepancy;
  bool timed_out;
};

/// The first failure of an item, and the first cases that failed.
struct Failures {
  std::optional<Failure> first;
  std::vector<Case> cases;
};

/// A quantity of which every answer has an excuse and none is right: excuses alone earn nothing.
std::optional<properties::Quantity> never_right(const Verdict& verdict) {
  for (const auto& [quantity, tally] : verdict.tallies()) {
    properties::Answered all;
    for (const properties::Answered& answers : tally.answered) {
      all.asked += answers.asked;
      all.right += answers.right;
    }
    if (all.asked > 0 && all.right == 0) return quantity;
  }
  return std::nullopt;
}

using ReasonToStop = std::function<ItemReason()>;

/// Tries the cases of an item, until there is a reason to stop.
Failures try_cases(const std::vector<const Law*>& laws, const ItemCases& cases,
                   const Examinee& examinee, const ReasonToStop& reason_to_stop, ItemGrade& grade) {
  Failures failures;
  Verdict all;
  int failed_altogether = 0;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (ItemReason reason = reason_to_stop(); reason.kind != ItemReason::Kind::kNone) {
      grade.state = ItemState::kNotJudged;
      grade.reason = std::move(reason);
      return {};
    }
    std::optional<ItemCase> item_case = cases[k];
    if (!item_case) continue;
    CaseOutcome outcome = try_case(laws, item_case->the_case, examinee);
    all.merge(std::move(outcome.verdict));
    if (!outcome.answers) continue;
    ++grade.cases;
    grade.comparisons += outcome.compared;
    if (outcome.holds()) {
      ++grade.held;
      continue;
    }
    if (grade.reason.kind == ItemReason::Kind::kNone) grade.reason = outcome.unanswered;
    if (outcome.broken == nullptr) continue;
    if (failures.cases.size() < kKeptCases) failures.cases.push_back(item_case->the_case);
    if (!failures.first) {
      failures.first =
          Failure{std::move(*item_case), outcome.broken, *outcome.discrepancy, outcome.timed_out};
    }
    if (outcome.discrepancy->wrong == properties::Wrong::kFailed &&
        ++failed_altogether == kMostFailures) {
      grade.cases += cases.size() - k - 1;
      break;
    }
  }
  if (grade.cases == 0) grade.reason = {.kind = ItemReason::Kind::kNothingToCompare};
  if (const auto quantity = never_right(all); quantity && all.holds()) {
    grade.held = 0;
    grade.reason = {.kind = ItemReason::Kind::kNeverRight,
                    .quantity = std::string(info(*quantity).name)};
  }
  grade.state =
      grade.cases > 0 && grade.held == grade.cases ? ItemState::kHolds : ItemState::kFails;
  return failures;
}

}  // namespace

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

Judge::Judge(const Rubric& rubric, Candidate candidate, bool pictures, std::uint64_t seed,
             const properties::RunControl& control, LastFailure last_failure)
    : rubric_(rubric),
      candidate_(std::move(candidate)),
      control_(control),
      last_failure_(std::move(last_failure)),
      pictures_(pictures),
      seed_(seed),
      end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                              std::chrono::duration<double>(rubric.seconds))) {
  candidate_.declared = rubric.conventions.over(candidate_.declared);
  // A domain that a submission states for itself would excuse it from what the rubric asks.
  candidate_.smallest_length = std::min(candidate_.smallest_length, kSmallestJudgedLength);
  candidate_.largest_length = std::numeric_limits<double>::infinity();
}

ItemReason Judge::reason_to_stop() const {
  if (control_.interrupted()) return {.kind = ItemReason::Kind::kInterrupted};
  if (Clock::now() <= end_) return {};
  return {.kind = ItemReason::Kind::kTimeUp, .seconds = rubric_.seconds};
}

ItemGrade Judge::item(std::size_t index, const std::vector<ItemGrade>& before) {
  using Kind = ItemReason::Kind;
  const Item& item = rubric_.items[index];
  ItemGrade grade;
  grade.name = item.name;
  grade.bonus = item.bonus;
  grade.pictures = pictures_;
  const auto& task = pictures_ ? item.pictures : item.functions;
  if (!task) {
    grade.state = ItemState::kNotAsked;
    grade.reason.kind = pictures_ ? Kind::kNotInPictures : Kind::kOfRenderers;
    return grade;
  }
  grade.points = item.points;
  for (const std::string& needed : item.needs) {
    const auto found = std::find_if(before.begin(), before.end(),
                                    [&](const ItemGrade& other) { return other.name == needed; });
    if (found->state == ItemState::kNotAsked || found->score >= found->points) continue;
    grade.state = ItemState::kLeftOut;
    grade.reason = {.kind = Kind::kNeeds, .item = needed, .state = found->state};
    return grade;
  }
  // A mistake is looked for in the pictures themselves: which sphere a pixel shows tells more of it
  // than whether it shows one.
  Candidate unmasked = tolerated(candidate_, item.tolerance);
  unmasked.excused_image_change = task->image_change.value_or(unmasked.excused_image_change);
  const Candidate candidate = task->masks_only ? masked(unmasked) : unmasked;
  const Examinee examinee{candidate, item.tolerance, pictures_, task->masks_only, last_failure_};
  properties::Random seeds(seed_);
  for (std::size_t k = 0; k < index; ++k) seeds.bits();
  const ItemCases cases(*task, pictures_, seeds.bits(), candidate.declared);
  const auto stop = [this] { return reason_to_stop(); };
  const Failures failures = try_cases(task->laws, cases, examinee, stop, grade);
  if (grade.state == ItemState::kNotJudged) return grade;
  grade.score = score_of(item, grade.held, grade.cases);
  if (!failures.first) return grade;
  const auto& [item_case, broken, discrepancy, timed_out] = *failures.first;
  grade.first_wrong = {item_case.origin, wrong_answer(discrepancy)};
  grade.mistakes = explaining_mistakes(failures.cases, unmasked, pictures_);
  const auto is_late = [this] { return reason_to_stop().kind != ItemReason::Kind::kNone; };
  const Case smallest = timed_out
                            ? item_case.the_case
                            : simplest(item_case.the_case, *broken, discrepancy, examinee, is_late);
  grade.failing = failing_case(smallest, item_case.origin, *broken, discrepancy, examinee);
  return grade;
}

}  // namespace raycheck::tools
