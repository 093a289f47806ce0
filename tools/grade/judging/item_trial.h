#pragma once

// One item: its cases asked and judged, and the smallest that fails; its points follow once all
// items are known. Internal to grading.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "properties/mistakes/picture_causes.h"
#include "properties/trial.h"
#include "tools/external/external_candidate.h"
#include "tools/grade/judging/item_cases.h"

namespace raycheck::tools {

/// The candidate for an item, in the item's own units, and how strictly it is judged.
struct Examinee {
  properties::Candidate candidate;  ///< Of its pictures only what the item asks for counts.
  properties::Candidate unmasked;   ///< The same, with its pictures as they are.
  Tolerance tolerance;
  bool pictures = false;
  bool masks_only = false;             ///< Whether a pixel shows a sphere, not which.
  LastFailure last_failure = nullptr;  ///< For other people's candidates.

  properties::TrialOptions options() const { return {.max_error = tolerance.ulp}; }
};

/// A picture of which only the mask counts: whether a pixel shows a sphere, not which.
inline properties::ImageAnswer mask_of(properties::ImageAnswer image) {
  for (auto& sphere : image) {
    if (sphere) sphere = properties::kSomeSphere;
  }
  return image;
}

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

/// Tries the cases of an item, until there is a reason to stop.
ItemTrial try_item(const ItemTask& task, const ItemCases& cases, const Examinee& who,
                   const std::function<ItemReason()>& reason_to_stop, ItemGrade grade);

/// The numbers of a discrepancy, without its law.
WrongAnswer wrong_answer(const properties::Discrepancy& discrepancy);

/// The simplest case found that fails as `first` does: by the same law, in the same quantity and
/// way, with the same message if the candidate failed entirely, and, for a renderer whose mistakes
/// are known (`fault`), with a picture that they make. Timeouts are not shrunk, since every case
/// tried might take as long.
properties::Case simplest(const FailedCase& first, const Examinee& who,
                          const properties::Fault& fault, const std::function<bool()>& is_late);

/// The report on a case, `first` being how it first failed; empty if it does not break the law any
/// more.
std::optional<FailingCase> failing_case(const properties::Case& the_case, const FailedCase& first,
                                        const Examinee& examinee);

}  // namespace raycheck::tools
