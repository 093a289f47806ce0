#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/mistakes/fault.h"
#include "properties/mistakes/picture_causes.h"
#include "properties/trial.h"
#include "tools/external/external_candidate.h"
#include "tools/grade/judging/judge.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// A case of an item, and its origin.
struct ItemCase {
  properties::Case the_case;
  CaseOrigin origin;
};

/// The numbered cases of an item: its scenes (for pictures varied as the item says), then random
/// cases. All follow from a seed.
class ItemCases {
 public:
  /// `declared`: the conventions under which the submission is judged, in a format that every case
  /// is rounded to.
  ItemCases(const ItemTask& task, bool pictures, std::uint64_t seed,
            const properties::DeclaredConventions& declared, properties::InputFormat format = {});

  std::size_t size() const { return task_.scenes.size() + seeds_.size(); }
  /// Empty if there is nothing to ask, for example because the format cannot represent the case.
  std::optional<ItemCase> operator[](std::size_t k) const;

 private:
  ItemCase of_scene(std::size_t k) const;
  std::optional<ItemCase> of_source(std::size_t k) const;

  const ItemTask& task_;
  bool pictures_;
  const properties::DeclaredConventions& declared_;
  properties::InputFormat format_;
  std::vector<std::uint64_t> scene_seeds_;
  std::vector<std::uint64_t> seeds_;
};

/// The candidate for an item, in the item's own units, and how strictly it is judged.
struct GradedCandidate {
  properties::Candidate candidate;  ///< Its pictures are reduced to what the item judges.
  properties::Candidate unmasked;   ///< The same with unreduced pictures.
  Tolerance tolerance;
  bool pictures = false;
  bool masks_only = false;             ///< Whether a pixel shows a sphere, not which.
  LastFailure last_failure = nullptr;  ///< Null for raycheck's own methods.

  properties::TrialOptions options() const { return {.max_error = tolerance.ulp}; }
};

/// A picture of which only the mask counts: whether a pixel shows a sphere, not which.
inline properties::ImageAnswer mask_of(properties::ImageAnswer image) {
  for (auto& sphere : image) {
    if (sphere && sphere != properties::kUnclear) sphere = properties::kSomeSphere;
  }
  return image;
}

/// A case that broke a law.
struct FailedCase {
  ItemCase item_case;
  const properties::Law* broken = nullptr;
  properties::Discrepancy discrepancy;
  /// The kind of failure, if the candidate failed.
  std::optional<FailureKind> failure = {};
  /// A renderer's picture of the case, if there is one. Its sides may be exchanged.
  std::optional<properties::ShownPicture> shown = {};
};

/// The outcome of an item's cases.
struct ItemTrial {
  ItemGrade grade;                 ///< Without its score and whatever depends on all items.
  std::vector<FailedCase> failed;  ///< In order; for functions only the first few.
  /// A renderer's pictures of all its cases.
  std::vector<properties::ShownPicture> pictures;
  /// The scenes that were skipped.
  std::vector<scene::Scene> not_asked;
};

/// Tries the cases of an item, until there is a reason to stop.
ItemTrial try_item(const ItemTask& task, const ItemCases& cases, const GradedCandidate& graded,
                   const std::function<ItemReason()>& reason_to_stop, ItemGrade grade);

/// The candidate's answer; empty if it gives none.
template <class Ask>
auto answered(const Ask& ask) -> std::optional<decltype(ask())> {
  try {
    return ask();
  } catch (const properties::NoAnswer&) {
    return {};
  }
}

/// The simplest case found that fails as `first` does: by the same law, in the same quantity and
/// way, with the same message if the candidate failed entirely, and, for a renderer whose mistakes
/// are known (`fault`), with a picture that they make. Time-outs are not shrunk, since every case
/// tried might take as long.
properties::Case simplest(const FailedCase& first, const GradedCandidate& graded,
                          const properties::Fault& fault, const std::function<bool()>& is_late);

/// Whether the running candidate answers wrongly at the place where it broke a law, but a fresh
/// process answers rightly. False if it gave no answer, and for renderers, which start anew for
/// each scene.
bool keeps_state(const FailedCase& failed, const GradedCandidate& graded);

/// The report on a case; `first`: the original failure. Empty if the case no longer breaks the law.
std::optional<FailingCase> failing_case(const properties::Case& the_case, const FailedCase& first,
                                        const GradedCandidate& graded);

/// Causes other than mistakes in formulas; a submission has at most one of each kind.
enum class OtherCause { kRoundings, kSidesExchanged, kShapeOfScenes };

/// Why an item fails.
struct ItemCause {
  properties::Fault fault = {};         ///< The mistakes behind its wrong answers. Empty: unknown.
  std::vector<OtherCause> others = {};  ///< Its other causes.
  /// These explain the item's failure completely, with enough evidence.
  bool is_all = false;
};

/// The step that an item's first law judges; empty for pictures.
std::optional<properties::Step> step_of(const Item& item);

/// The shape of the scenes on which a renderer fails, if the items together determine it: scenes
/// without a picture or, with `of_wrong_ones`, without a right picture.
struct ShapeOfFailures {
  std::optional<properties::ShapeCause> cause = {};
  bool of_wrong_ones = false;
};
/// If `are_unexplained`, wrong pictures that are not square count as failures, too.
ShapeOfFailures shape_of_failures(const Rubric& rubric, const std::vector<ItemTrial>& trials,
                                  bool are_unexplained);

/// Finds the causes of a renderer's wrong pictures, over all items together, and names them in each
/// item. If the form of driver files is unknown, no mistake is named that another form would
/// explain; if the form was found by trial, a mistake that would be a different one in another form
/// is worded as both. Domain: a trial for each item of the rubric.
std::vector<ItemCause> causes_of_pictures(const Rubric& rubric, FormKnown form_known,
                                          const scene::FileFormat& format,
                                          std::vector<ItemTrial>& trials);

/// The same for functions.
std::vector<ItemCause> causes_of_functions(const Rubric& rubric,
                                           const properties::Candidate& candidate,
                                           std::vector<ItemTrial>& trials);

}  // namespace raycheck::tools
