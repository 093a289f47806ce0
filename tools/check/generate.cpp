#include "tools/check/generate.h"

#include <fmt/core.h>

#include <stdexcept>

#include "properties/rounded_case.h"
#include "scene/number.h"

namespace raycheck::tools {

std::string case_id(const properties::ChosenSource& source, std::uint64_t seed) {
  return fmt::format("{}:{:x}", source.name(), seed);
}

properties::ChosenSource source_of_questions(const std::string& family) {
  properties::ChosenSource source;
  try {
    source = properties::chosen_source(family);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("family " + family + ": " + error.what() +
                                "; `raycheck list` shows the sources");
  }
  if (source.source->has_camera) {
    throw std::invalid_argument("family " + family +
                                ": its cases have cameras, which one line does not hold");
  }
  return source;
}

std::optional<properties::Case> case_asked(const properties::ChosenSource& source,
                                           std::uint64_t seed, scene::Precision precision) {
  return properties::rounded_case(source.make(seed), precision).the_case;
}

std::string questions(const properties::ChosenSource& source, std::uint64_t seed,
                      scene::Precision precision) {
  const std::optional<properties::Case> asked = case_asked(source, seed, precision);
  if (!asked) return "";
  const scene::Scene& scene = asked->scene;
  std::string lines;
  for (std::size_t ray = 0; ray < scene.rays.size(); ++ray) {
    for (std::size_t sphere = 0; sphere < scene.spheres.size(); ++sphere) {
      const auto& [origin, direction] = scene.rays[ray];
      const auto& [centre, radius] = scene.spheres[sphere];
      lines += fmt::format("{}:{}:{} {} {} {} {} {} {}\n", case_id(source, seed), ray, sphere,
                           name(scene.conventions.root), name(scene.conventions.tangent),
                           scene::shortest_words(origin), scene::shortest_words(direction),
                           scene::shortest_words(centre), scene::shortest(radius));
    }
  }
  return lines;
}

}  // namespace raycheck::tools
