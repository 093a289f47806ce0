#include "tools/grade/judging/item_trial.h"

#include <algorithm>
#include <string>
#include <utility>

namespace raycheck::tools {
namespace {

using properties::ShownPicture;
using properties::Verdict;

/// So many failing cases of an item of functions are kept to find the mistake that explains them.
constexpr std::size_t kKeptCases = 8;

/// After so many cases of an item on which a program fails altogether, or does not end in time, the
/// others are not asked.
constexpr int kMostFailures = 8;
constexpr int kMostSilentCases = 3;

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

/// Whether no hit is found where there are some, as where whatever is asked is answered by a miss.
bool never_hits(const Verdict& verdict) {
  const auto& hits = verdict.tally(properties::Quantity::kClass)
                         .answered[static_cast<std::size_t>(properties::Expected::kHit)];
  return hits.asked > 0 && hits.right == 0;
}

/// Whether of most pixels that show a sphere it is told which.
bool tells_spheres(const ShownPicture& picture) {
  const auto& image = picture.image;
  const auto spheres =
      std::count_if(image.begin(), image.end(), [](const auto& one) { return one.has_value(); });
  const auto untold =
      std::count(image.begin(), image.end(), std::optional(properties::kSomeSphere));
  return 2 * untold <= spheres;
}

}  // namespace

ItemTrial try_item(const ItemTask& task, const ItemCases& cases, const ItemExaminee& who,
                   const std::function<ItemReason()>& reason_to_stop, ItemGrade grade) {
  ItemTrial trial;
  Verdict all;
  int failed_altogether = 0, silent = 0;
  bool is_untold = false;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (ItemReason reason = reason_to_stop(); reason.kind != ItemReason::Kind::kNone) {
      grade.state = ItemState::kNotJudged;
      grade.reason = std::move(reason);
      trial.grade = std::move(grade);
      trial.failed.clear();
      return trial;
    }
    std::optional<ItemCase> item_case = cases[k];
    if (!item_case) continue;
    CaseOutcome outcome = try_case(task.laws, item_case->the_case, who.examinee());
    all.merge(std::move(outcome.verdict));
    if (!outcome.answers) continue;
    std::optional<ShownPicture> picture;
    // It was just drawn, and is not again; what does not end is not waited for twice.
    const bool is_silent = outcome.failure == FailureKind::kTimeUp;
    if (who.pictures && !is_silent)
      picture = properties::shown_picture(item_case->the_case.scene, who.candidate);
    if (picture) trial.pictures.push_back(*picture);
    if (outcome.broken == nullptr && outcome.unanswered.kind == ItemReason::Kind::kOtherColours) {
      if (!tells_spheres(*picture)) {
        is_untold = true;
        continue;
      }
      outcome.unanswered = {};
    }
    ++grade.cases;
    grade.comparisons += outcome.compared;
    if (outcome.holds()) {
      ++grade.held;
      continue;
    }
    if (grade.reason.kind == ItemReason::Kind::kNone) grade.reason = outcome.unanswered;
    if (outcome.broken == nullptr) continue;
    const bool failed = outcome.discrepancy->wrong == properties::Wrong::kFailed;
    if (who.pictures || trial.failed.size() < kKeptCases) {
      trial.failed.push_back({std::move(*item_case), outcome.broken, *outcome.discrepancy,
                              outcome.failure, std::move(picture)});
    }
    failed_altogether += failed ? 1 : 0;
    silent += is_silent ? 1 : 0;
    if (failed_altogether == kMostFailures || silent == kMostSilentCases) {
      grade.cases += cases.size() - k - 1;
      while (++k < cases.size()) {
        if (auto next = cases[k]) trial.not_asked.push_back(std::move(next->the_case.scene));
      }
      break;
    }
  }
  if (grade.cases == 0 && is_untold) {
    // Nobody can say that it is wrong, or right.
    grade.points = 0;
    grade.state = ItemState::kNotAsked;
    grade.reason = {.kind = ItemReason::Kind::kOtherColours};
    trial.grade = std::move(grade);
    return trial;
  }
  if (grade.cases == 0) grade.reason = {.kind = ItemReason::Kind::kNothingToCompare};
  if (const auto quantity = never_right(all); quantity && all.holds()) {
    grade.held = 0;
    grade.reason = {.kind = ItemReason::Kind::kNeverRight,
                    .quantity = std::string(info(*quantity).name)};
  }
  // What is given besides is not earned by misses alone.
  if (grade.bonus && never_hits(all)) grade.held = 0;
  grade.state =
      grade.cases > 0 && grade.held == grade.cases ? ItemState::kHolds : ItemState::kFails;
  trial.grade = std::move(grade);
  return trial;
}

}  // namespace raycheck::tools
