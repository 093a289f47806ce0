#pragma once

// Which mistakes the items of a submission fail by. Internal to grading.

#include <optional>
#include <string>
#include <vector>

#include "properties/mistakes/fault.h"
#include "properties/mistakes/shape_cause.h"
#include "tools/grade/judging/item_trial.h"
#include "tools/grade/judging/judge.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// What items fail by that is no mistake in a formula; of each kind a submission has one.
enum class OtherCause { kRoundings, kSidesExchanged, kShapeOfScenes };

/// Why an item fails.
struct ItemCause {
  properties::Fault fault = {};         ///< Of its wrong answers. None: not known.
  std::vector<OtherCause> others = {};  ///< What else it fails by.
  /// It has nothing else wrong, and enough is seen to tell.
  bool is_all = false;
};

/// The step that an item is about, that of what its laws judge first; empty: of no one step.
std::optional<properties::Step> step_of(const Item& item);

/// What the wrong pictures of a renderer come of, all items together, and names it in each.
/// Nothing is named that another form of driver files makes where it is not known which one is
/// read; where it was found, one mistake in it may be another in another form, and is worded as
/// both. Domain: a trial for each item of the rubric.
std::vector<ItemCause> causes_of_pictures(const Rubric& rubric, FormKnown form_known,
                                          scene::Dialect dialect, std::vector<ItemTrial>& trials);

/// The same of functions.
std::vector<ItemCause> causes_of_functions(const Rubric& rubric,
                                           const properties::Candidate& candidate,
                                           std::vector<ItemTrial>& trials);

/// On which scenes a renderer makes no picture, where that is known of all items together.
std::optional<properties::ShapeCause> shape_of_failures(const std::vector<ItemTrial>& trials);

/// Lets each mistake, and all else that is known, cost one item alone: of those that
/// fail by it the first that asks about the step where it is made, or else the first. The others
/// that have nothing else wrong follow.
void charge_once(const Rubric& rubric, const std::vector<ItemCause>& causes,
                 std::vector<ItemTrial>& trials);

}  // namespace raycheck::tools
