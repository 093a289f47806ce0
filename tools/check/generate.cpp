#include "tools/check/generate.h"

#include <fmt/core.h>

#include "properties/rounded_case.h"
#include "scene/number.h"

namespace raycheck::tools {

std::string case_id(const properties::ChosenSource& source, std::uint64_t seed) {
  return fmt::format("{}:{:x}", source.name(), seed);
}

std::optional<properties::Case> case_asked(const properties::ChosenSource& source,
                                           std::uint64_t seed, scene::Precision precision) {
  return properties::rounded_case(source.make(seed), precision).the_case;
}

std::vector<AskedPair> questions_of(const properties::Case& asked, const std::string& id) {
  std::vector<AskedPair> all;
  for (std::size_t ray = 0; ray < asked.scene.rays.size(); ++ray) {
    for (std::size_t sphere = 0; sphere < asked.scene.spheres.size(); ++sphere) {
      all.push_back({fmt::format("{}:{}:{}", id, ray, sphere), ray, sphere});
    }
  }
  return all;
}

std::string question_lines(const properties::ChosenSource& source, std::uint64_t seed,
                           scene::Precision precision) {
  const std::optional<properties::Case> asked = case_asked(source, seed, precision);
  if (!asked) return "";
  const scene::Scene& scene = asked->scene;
  std::string lines;
  for (const auto& [id, ray, sphere] : questions_of(*asked, case_id(source, seed))) {
    const auto& [origin, direction] = scene.rays[ray];
    const auto& [centre, radius] = scene.spheres[sphere];
    lines += fmt::format("{} {} {} {} {} {} {}\n", id, name(scene.conventions.root),
                         name(scene.conventions.tangent), scene::shortest_words(origin),
                         scene::shortest_words(direction), scene::shortest_words(centre),
                         scene::shortest(radius));
  }
  return lines;
}

}  // namespace raycheck::tools
