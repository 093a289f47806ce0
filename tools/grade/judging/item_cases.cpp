#include "tools/grade/judging/item_cases.h"

#include <utility>

#include "properties/case.h"
#include "properties/cases/random.h"
#include "properties/cases/scene_cases.h"
#include "properties/cases/varied_scene.h"
#include "properties/search/stress.h"
#include "properties/trial.h"
#include "tools/external/pictures/sphere_colours.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {

ItemCases::ItemCases(const ItemTask& task, bool pictures, std::uint64_t seed,
                     const properties::DeclaredConventions& declared, scene::Precision precision)
    : task_(task), pictures_(pictures), declared_(declared), precision_(precision) {
  properties::Random random(seed);
  properties::Random of_scenes(random.bits());
  for (std::size_t k = 0; k < task.scenes.size(); ++k) scene_seeds_.push_back(of_scenes.bits());
  for (int k = 0; k < task.cases; ++k) seeds_.push_back(random.bits());
}

std::optional<ItemCase> ItemCases::operator[](std::size_t k) const {
  const std::size_t scenes = task_.scenes.size();
  std::optional<ItemCase> found = k < scenes ? of_scene(k) : of_source(k - scenes);
  const auto round = [&]() -> bool {
    auto rounded = properties::rounded_case(std::move(found->the_case), precision_).the_case;
    if (rounded) found->the_case = *std::move(rounded);
    return rounded.has_value();
  };
  if (!found || !round()) return {};
  if (!task_.given_rays) return found;
  found->the_case.scene.conventions = declared_.over(found->the_case.scene.conventions);
  auto alone = properties::alone(found->the_case, properties::Stage::kIntersection,
                                 candidate_of(kDefaultMethods));
  if (!alone) return {};
  found->the_case = std::move(*alone);
  if (!round()) return {};
  return found;
}

ItemCase ItemCases::of_scene(std::size_t k) const {
  const RubricScene& scene = task_.scenes[k];
  const std::optional<std::uint64_t> at_most =
      pictures_ ? std::nullopt : std::optional(kMostGradedRays);
  const properties::SceneCases cases(
      pictures_ ? properties::varied_scene(scene.scene, task_.vary, scene_seeds_[k]) : scene.scene,
      at_most);
  return {cases.from(0, cases.rays_judged()), {.scene = scene.name}};
}

/// A submission that ignores conventions is right under the defaults.
std::optional<ItemCase> ItemCases::of_source(std::size_t k) const {
  const properties::ChosenSource& source = properties::chosen_by(task_.sources, seeds_[k]);
  ItemCase found{source.make(seeds_[k]), {.source = std::string(source.name()), .number = k + 1}};
  found.the_case.scene.conventions = {};
  if (!pictures_) return found;
  const auto& camera = found.the_case.scene.camera;
  if (!camera || camera->width > kMostGradedPixels / camera->height) return {};
  // With more spheres not all renderers' colours tell which is seen.
  auto& spheres = found.the_case.scene.spheres;
  if (spheres.size() > kMostSaturated) spheres.resize(kMostSaturated);
  found.the_case.pixels = properties::all_pixels(*camera);
  return found;
}

}  // namespace raycheck::tools
