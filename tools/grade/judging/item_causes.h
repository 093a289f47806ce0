#pragma once

// The mistakes by which the items of a submission fail. Internal to grading.

#include <optional>
#include <string>
#include <vector>

#include "properties/mistakes/fault.h"
#include "tools/grade/judging/item_trial.h"
#include "tools/grade/judging/judge.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// What items fail by that is no mistake in a formula; of each kind a submission has one.
enum class OtherCause { kRoundings, kSidesExchanged, kShapeOfScenes };

/// Why an item fails.
struct ItemCause {
  properties::Fault fault = {};         ///< Of its wrong answers. Empty: unknown.
  std::vector<OtherCause> others = {};  ///< What else it fails by.
  /// Nothing else is wrong with it, and enough is seen to say so.
  bool is_all = false;
};

/// The step that an item is about, which its laws judge first; empty if it is about several.
std::optional<properties::Step> step_of(const Item& item);

/// Finds the causes of a renderer's wrong pictures, over all items together, and names them in
/// each. If it is unknown which form of driver files is read, nothing is named that another form
/// explains; if it was found by trial, a mistake that is another one in another form is worded as
/// both. Domain: a trial for each item of the rubric.
std::vector<ItemCause> causes_of_pictures(const Rubric& rubric, FormKnown form_known,
                                          scene::Dialect dialect, std::vector<ItemTrial>& trials);

/// The same for functions.
std::vector<ItemCause> causes_of_functions(const Rubric& rubric,
                                           const properties::Candidate& candidate,
                                           std::vector<ItemTrial>& trials);

/// Lets each mistake, and all else that is known, cost one item alone: of those that
/// fail by it the first that asks about the step where it is made, or else the first. The others
/// that have nothing else wrong follow.
void charge_once(const Rubric& rubric, const std::vector<ItemCause>& causes,
                 std::vector<ItemTrial>& trials);

}  // namespace raycheck::tools
