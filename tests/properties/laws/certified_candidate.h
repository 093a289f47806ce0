#pragma once

#include "properties/candidate.h"
#include "reference/visibility/visibility.h"
#include "scene/plan/plan.h"
#include "tests/standard.h"

namespace raycheck::properties {

/// It computes whole rows, so it does not get larger images.
inline constexpr std::int64_t kMostCertifiedPixelsAcross = 1 << 12;

/// A row of the image.
struct Row {
  std::vector<std::int32_t> sphere;
  std::vector<double> parameter;
};

inline Row seen_row(const reference::Visibility& visibility, std::int64_t j) {
  const auto width = static_cast<std::size_t>(visibility.scene().camera->width);
  Row row{std::vector<std::int32_t>(width), std::vector<double>(width)};
  reference::SeenRows wanted;
  wanted.sphere = row.sphere;
  wanted.parameter = row.parameter;
  visibility.nearest(j, j + 1, wanted);
  return row;
}

/// Certified visibility (reference/visibility/visibility.h) as a candidate, `certified`. It has
/// only `visible`, uses a plan with these `items`, and promises every decision.
inline Candidate certified_candidate(const scene::PlanItems& items = {}) {
  Candidate candidate;
  candidate.name = "certified";
  candidate.plan = [items](const scene::Scene& scene, const scene::Conventions& conventions,
                           scene::Wanted wanted) {
    return scene::plan_scene(scene, conventions, wanted, items);
  };
  candidate.visible = [plan = candidate.plan](const scene::Scene& scene,
                                              const scene::Conventions& conventions,
                                              Candidate::Pixels pixels) {
    const reference::Visibility visibility(scene,
                                           plan(scene, conventions, scene::Wanted::kNearest));
    std::map<std::int64_t, Row> rows;
    std::vector<std::optional<SeenAnswer>> answers;
    for (const auto& [i, j] : pixels) {
      const auto [row, is_new] = rows.try_emplace(j);
      if (is_new) row->second = seen_row(visibility, j);
      const auto column = static_cast<std::size_t>(i);
      const std::int32_t sphere = row->second.sphere[column];
      answers.emplace_back();
      if (sphere != reference::kNoSphere) {
        answers.back() = {static_cast<std::size_t>(sphere), row->second.parameter[column]};
      }
    }
    return answers;
  };
  candidate.exact_visible = true;
  candidate.most_visible_across = kMostCertifiedPixelsAcross;
  return candidate;
}

}  // namespace raycheck::properties
