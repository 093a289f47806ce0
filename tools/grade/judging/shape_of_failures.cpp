#include <algorithm>
#include <vector>

#include "tools/grade/judging/item_trial.h"

namespace raycheck::tools {
namespace {

using Tried = std::vector<properties::TriedScene>;

/// The property ("wider than high", "several spheres") that exactly those scenes have for which no
/// picture was made, if all items together determine it.
std::optional<properties::ShapeCause> without_picture(const std::vector<ItemTrial>& trials) {
  Tried tried;
  for (const ItemTrial& trial : trials) {
    for (const properties::ShownPicture& one : trial.pictures) tried.push_back({&one.scene, false});
    for (const FailedCase& one : trial.failed) {
      if (!one.shown) tried.push_back({&one.item_case.the_case.scene, true});
    }
  }
  return properties::shape_cause(tried);
}

/// The property of the failing scenes, if all failing pictures are not square. Right pictures that
/// are not square may be right by luck; they must be fewer than the failing ones, and do not count.
std::optional<properties::ShapeCause> oblong_failures(const Rubric& rubric,
                                                      const std::vector<ItemTrial>& trials,
                                                      bool with_bonus) {
  const auto is_oblong = [](const properties::TriedScene& one) {
    return one.scene->camera->width != one.scene->camera->height;
  };
  Tried failed, right;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    if (rubric.items[k].bonus && !with_bonus) continue;
    Tried of_item;
    for (const FailedCase& one : trials[k].failed) {
      of_item.push_back({&one.item_case.the_case.scene, true});
    }
    failed.insert(failed.end(), of_item.begin(), of_item.end());
    for (const properties::ShownPicture& one : trials[k].pictures) {
      const bool is_failed = std::any_of(of_item.begin(), of_item.end(), [&](const auto& other) {
        return other.scene->camera == one.scene.camera && other.scene->spheres == one.scene.spheres;
      });
      if (!is_failed) right.push_back({&one.scene, false});
    }
  }
  if (!std::all_of(failed.begin(), failed.end(), is_oblong)) return {};
  if (std::erase_if(right, is_oblong) >= failed.size()) return {};
  failed.insert(failed.end(), right.begin(), right.end());
  return properties::shape_cause(failed);
}

}  // namespace

ShapeOfFailures shape_of_failures(const Rubric& rubric, const std::vector<ItemTrial>& trials,
                                  bool are_unexplained) {
  for (const bool with_bonus : {true, false}) {
    if (!are_unexplained) break;
    if (const auto cause = oblong_failures(rubric, trials, with_bonus)) return {cause, true};
  }
  return {without_picture(trials), false};
}

}  // namespace raycheck::tools
