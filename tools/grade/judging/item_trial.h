#pragma once

// The cases of one item, asked and judged; its points follow once all items are known. Internal to
// grading.

#include <functional>
#include <optional>
#include <vector>

#include "properties/mistakes/picture_causes.h"
#include "tools/grade/judging/case_trial.h"
#include "tools/grade/judging/item_cases.h"

namespace raycheck::tools {

/// A case that broke a law.
struct FailedCase {
  ItemCase item_case;
  const properties::Law* broken = nullptr;
  properties::Discrepancy discrepancy;
  /// How the candidate failed, if it did.
  std::optional<FailureKind> failure = {};
  /// A renderer's picture of it; empty if there is none. Its sides may be exchanged.
  std::optional<properties::ShownPicture> shown = {};
};

/// The outcome of an item's cases.
struct ItemTrial {
  ItemGrade grade;                 ///< Without a score, and what depends on all items.
  std::vector<FailedCase> failed;  ///< In order; for functions only the first.
  /// A renderer's pictures of all its cases.
  std::vector<properties::ShownPicture> pictures;
  /// The scenes that were not asked about any more.
  std::vector<scene::Scene> not_asked;
};

/// The candidate for an item, in the item's own units.
struct ItemExaminee {
  properties::Candidate candidate;  ///< With the item's tolerance.
  properties::Candidate masked;     ///< The same; of its pictures only the mask may count.
  Tolerance tolerance;
  bool pictures = false;
  bool masks_only = false;
  LastFailure last_failure = nullptr;
  Examinee examinee() const { return {masked, tolerance, pictures, masks_only, last_failure}; }
};

/// Tries the cases of an item, until there is a reason to stop.
ItemTrial try_item(const ItemTask& task, const ItemCases& cases, const ItemExaminee& who,
                   const std::function<ItemReason()>& reason_to_stop, ItemGrade grade);

}  // namespace raycheck::tools
