#include <algorithm>
#include <map>
#include <variant>

#include "tools/grade/judging/item_causes.h"

namespace raycheck::tools {

using properties::Mistake;
using properties::Quantity;

namespace {

/// The reason why one item loses its points.
using Charge = std::variant<const Mistake*, OtherCause>;

std::vector<Charge> charges(const ItemCause& cause) {
  std::vector<Charge> all(cause.fault.begin(), cause.fault.end());
  all.insert(all.end(), cause.others.begin(), cause.others.end());
  return all;
}

/// Whether a mistake is made at the step that an item asks about.
bool is_of_step(const Charge& charge, const Item& item) {
  const auto* const mistake = std::get_if<const Mistake*>(&charge);
  return mistake != nullptr && step_of(item) == (*mistake)->step;
}

}  // namespace

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
    // Bonus points are earned by right answers only.
    const bool follows = grade.state == ItemState::kFails && !rubric.items[k].bonus &&
                         causes[k].is_all && !its.empty() &&
                         std::all_of(its.begin(), its.end(),
                                     [&](const Charge& one) { return charged.at(one) != k; });
    if (!follows) continue;
    grade.state = ItemState::kFollows;
    grade.reason = {.kind = ItemReason::Kind::kFollows,
                    .item = rubric.items[charged.at(its.front())].name};
  }
}

}  // namespace raycheck::tools
