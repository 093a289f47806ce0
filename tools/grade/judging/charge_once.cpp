#include <algorithm>
#include <map>

#include "tools/grade/judging/item_causes.h"

namespace raycheck::tools {

using properties::Mistake;
using properties::Quantity;

namespace {

/// What costs one item its points.
struct Charge {
  std::string sentence;
  std::optional<properties::Step> step = {};  ///< Where it is made, if it is made at one.
};

std::vector<Charge> charges(const ItemCause& cause) {
  std::vector<Charge> all;
  for (const Mistake* mistake : cause.fault) all.push_back({mistake->sentence, mistake->step});
  for (const std::string& sentence : cause.others) all.push_back({sentence});
  return all;
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
  std::map<std::string, std::size_t> charged;
  for (const bool of_its_step : {true, false}) {
    for (std::size_t k = 0; k < trials.size(); ++k) {
      for (const Charge& one : charges(causes[k])) {
        const bool is_its_step = one.step && step_of(rubric.items[k]) == one.step;
        if (!of_its_step || is_its_step) charged.try_emplace(one.sentence, k);
      }
    }
  }
  for (std::size_t k = 0; k < trials.size(); ++k) {
    ItemGrade& grade = trials[k].grade;
    const std::vector<Charge> its = charges(causes[k]);
    // What is given besides is earned by right answers alone.
    const bool follows = grade.state == ItemState::kFails && !rubric.items[k].bonus &&
                         causes[k].is_all && !its.empty() &&
                         std::all_of(its.begin(), its.end(), [&](const Charge& one) {
                           return charged.at(one.sentence) != k;
                         });
    if (!follows) continue;
    grade.state = ItemState::kFollows;
    grade.reason = {.kind = ItemReason::Kind::kFollows,
                    .item = rubric.items[charged.at(its.front().sentence)].name};
  }
}

}  // namespace raycheck::tools
