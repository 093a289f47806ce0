#include "tools/grade/item_cases.h"

#include <cmath>
#include <utility>

#include "properties/cases/random.h"
#include "properties/cases/scene_cases.h"
#include "properties/search/stress.h"
#include "properties/trial.h"
#include "tools/methods/methods.h"

namespace raycheck::tools {

ItemCases::ItemCases(const ItemTask& task, bool pictures, std::uint64_t seed,
                     const properties::DeclaredConventions& declared)
    : task_(task), pictures_(pictures), declared_(declared) {
  properties::Random random(seed);
  scene_seed_ = random.bits();
  for (int k = 0; k < task.cases; ++k) seeds_.push_back(random.bits());
}

std::optional<ItemCase> ItemCases::operator[](std::size_t k) const {
  const std::size_t scenes = task_.scenes.size();
  std::optional<ItemCase> found = k < scenes ? of_scene(task_.scenes[k]) : of_source(k - scenes);
  if (!found || !task_.given_rays) return found;
  found->the_case.scene.conventions = declared_.over(found->the_case.scene.conventions);
  auto alone = properties::alone(found->the_case, properties::Stage::kIntersection,
                                 candidate_of(kDefaultMethods));
  if (!alone) return {};
  found->the_case = std::move(*alone);
  return found;
}

namespace {

/// The same scene for pictures, in other numbers: lengths times a power of two, some more pixels
/// (an even number, so that a middle one stays), so that no picture can be known beforehand.
scene::Scene varied(scene::Scene scene, std::uint64_t seed) {
  properties::Random random(seed);
  const double factor = std::ldexp(1.0, static_cast<int>(random.integer(0, 6)));
  const std::int64_t more = 2 * random.integer(0, 5);
  const auto scale = [factor](auto&... lengths) { ((lengths *= factor), ...); };
  scene::Camera& c = *scene.camera;
  scale(c.eye.x, c.eye.y, c.eye.z, c.look_at.x, c.look_at.y, c.look_at.z, c.near);
  scale(c.left, c.right, c.bottom, c.top);
  for (auto& [centre, radius] : scene.spheres) scale(centre.x, centre.y, centre.z, radius);
  c.width += more;
  c.height += more;
  return scene;
}

}  // namespace

ItemCase ItemCases::of_scene(const RubricScene& scene) const {
  const std::optional<std::uint64_t> at_most =
      pictures_ ? std::nullopt : std::optional(kMostGradedRays);
  const properties::SceneCases cases(pictures_ ? varied(scene.scene, scene_seed_) : scene.scene,
                                     at_most);
  return {cases.from(0, cases.rays_judged()), {.scene = scene.name}};
}

/// A submission that heeds no conventions is right under the default ones.
std::optional<ItemCase> ItemCases::of_source(std::size_t k) const {
  const properties::ChosenSource& source = properties::chosen_by(task_.sources, seeds_[k]);
  ItemCase found{source.make(seeds_[k]), {.source = std::string(source.name()), .number = k + 1}};
  found.the_case.scene.conventions = {};
  if (!pictures_) return found;
  const auto& camera = found.the_case.scene.camera;
  if (!camera || camera->width > kMostGradedPixels / camera->height) return {};
  found.the_case.pixels = properties::all_pixels(*camera);
  return found;
}

}  // namespace raycheck::tools
