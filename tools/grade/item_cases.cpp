#include "tools/grade/item_cases.h"

#include <fmt/core.h>

#include <utility>

#include "properties/random.h"
#include "properties/stress.h"
#include "properties/trial.h"
#include "tools/methods.h"
#include "tools/scene_cases.h"

namespace raycheck::tools {

ItemCases::ItemCases(const Questions& questions, bool pictures, std::uint64_t seed,
                     const properties::DeclaredConventions& declared)
    : questions_(questions), pictures_(pictures), declared_(declared) {
  properties::Random random(seed);
  for (int k = 0; k < questions.cases; ++k) seeds_.push_back(random.bits());
}

std::optional<Asked> ItemCases::operator[](std::size_t k) const {
  const std::size_t scenes = questions_.scenes.size();
  std::optional<Asked> asked = k < scenes ? of_scene(questions_.scenes[k]) : of_source(k - scenes);
  if (!asked || !questions_.given_rays) return asked;
  asked->the_case.scene.conventions = declared_.over(asked->the_case.scene.conventions);
  auto alone = properties::alone(asked->the_case, properties::Stage::kIntersection,
                                 candidate_of(kDefaultMethods));
  if (!alone) return {};
  asked->the_case = std::move(*alone);
  return asked;
}

Asked ItemCases::of_scene(const RubricScene& scene) const {
  const std::optional<std::uint64_t> at_most =
      pictures_ ? std::nullopt : std::optional(kMostGradedRays);
  const SceneCases cases(scene.scene, at_most);
  return {cases.from(0, cases.rays_judged()), "scene " + scene.name};
}

/// A submission that heeds no conventions is right under the default ones.
std::optional<Asked> ItemCases::of_source(std::size_t k) const {
  const properties::ChosenSource& source = questions_.sources[k % questions_.sources.size()];
  Asked asked{source.make(seeds_[k]), fmt::format("{}, random case {}", source.name(), k + 1)};
  asked.the_case.scene.conventions = {};
  if (!pictures_) return asked;
  const auto& camera = asked.the_case.scene.camera;
  if (!camera || camera->width > kMostGradedPixels / camera->height) return {};
  asked.the_case.pixels = properties::all_pixels(*camera);
  return asked;
}

}  // namespace raycheck::tools
