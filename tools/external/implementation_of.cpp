#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "contract/declarations.h"
#include "scene/text.h"
#include "tools/external/external_candidate.h"
#include "tools/implementations/built_in.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

/// "renderer:python3 ../mine/rt.py {scene}" becomes "python3 rt.py {scene}".
std::string without_folders(const std::string& name) {
  std::string result;
  for (std::size_t at = name.find(':') + 1; at < name.size();) {
    const std::size_t end = std::min(name.find(' ', at), name.size());
    const std::size_t folders = name.substr(at, end - at).rfind('/') + 1;  // 0 without folders
    result += name.substr(at + folders, end + 1 - at - folders);
    at = end + 1;
  }
  return result;
}

/// The options of a renderer that differ from the defaults, as arguments.
std::string arguments_of(const Renderer& renderer, scene::Precision precision) {
  const Renderer usual{};
  std::string words;
  if (!(renderer.driver == usual.driver)) {
    words += " --dialect " + shell_word(renderer.driver.name());
  }
  if (precision != scene::Precision::kDouble)
    words += fmt::format(" --precision {}", name(precision));
  if (renderer.excused_change != properties::excused_image_change(precision)) {
    words += fmt::format(" --image-change {}", renderer.excused_change);
  }
  if (renderer.threshold != usual.threshold) {
    words += fmt::format(" --t-threshold {}", renderer.threshold);
  }
  if (renderer.any_sample) words += " --any-sample";
  if (renderer.depth) words += " --depth " + shell_word(renderer.depth->text());
  return words;
}

std::vector<properties::Stage> stages_of(const std::set<std::string>& functions) {
  std::vector<properties::Stage> stages;
  for (const char* one : {"frame", "pixel_point", "pixel_ray", "focal_ray"}) {
    if (stages.empty() && functions.contains(one)) stages.push_back(properties::Stage::kRays);
  }
  if (functions.contains("intersect")) stages.push_back(properties::Stage::kIntersection);
  return stages;
}

std::string tolerances_of(const contract::Declarations& declared) {
  contract::Declarations only;
  only.tolerances = declared.tolerances;
  return scene::joined(contract::statements(only), " and ");
}

}  // namespace

Implementation implementation_of(const External& external) {
  const std::string said = external.introduction.name == "-" ? "" : external.introduction.name;
  Implementation implementation{
      .name = external.name,
      .lasting_name = said.empty() ? without_folders(external.name) : said,
      .own_name = said,
      .isolated_by = external.program.layers.text(),
      .bounds_of = candidate_of(external.bounds).name,
      .source_file = external.source_file,
      .built_of = external.built_of,
      .stages = stages_of(external.introduction.functions),
      .precision = external.precision,
      .interface = external.introduction.declared.interface,
      .tolerances = tolerances_of(external.introduction.declared),
      .make = [external] { return external_candidate(external); },
      .in_process = [external] { return calls_in_process(external); }};
  if (!external.declares.empty()) {
    implementation.arguments = " --declare " + shell_word(external.declares);
  }
  if (external.renderer) {
    implementation.bounds_of.clear();
    implementation.arguments += arguments_of(*external.renderer, external.precision);
    implementation.reading = [external](const std::string& form) {
      return implementation_of(reading(external, driver_rule(form).form));
    };
  }
  return implementation;
}

}  // namespace raycheck::tools
