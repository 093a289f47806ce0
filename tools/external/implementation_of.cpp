#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "tools/external/external_candidate.h"
#include "tools/external/in_process.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {
namespace {

/// "renderer:python3 ../mine/rt.py {scene}" becomes "python3 rt.py {scene}".
std::string without_folders(std::string_view name) {
  name.remove_prefix(name.find(':') + 1);
  std::string words;
  while (!name.empty()) {
    const std::size_t end = std::min(name.find(' '), name.size() - 1) + 1;
    const std::string_view word = name.substr(0, end);
    words += word.substr(word.rfind('/') + 1);
    name.remove_prefix(end);
  }
  return words;
}

/// How a renderer is run and judged, where that is not as usual.
std::string arguments_of(const Renderer& renderer, scene::Precision precision) {
  const Renderer usual{};
  std::string words;
  if (!(renderer.driver == usual.driver)) {
    const std::string form = renderer.driver.name();
    const char* const quote = form.find_first_of(" ()<>|&;*?[#~{") == std::string::npos ? "" : "'";
    words += fmt::format(" --dialect {1}{0}{1}", form, quote);
  }
  if (precision != scene::Precision::kDouble)
    words += fmt::format(" --precision {}", name(precision));
  if (renderer.excused_change != properties::excused_image_change(precision)) {
    words += fmt::format(" --image-change {}", renderer.excused_change);
  }
  if (renderer.threshold != usual.threshold) {
    words += fmt::format(" --t-threshold {}", renderer.threshold);
  }
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

}  // namespace

Implementation implementation_of(const External& external) {
  const std::string& said = external.introduction.name;
  Implementation implementation{
      .name = external.name,
      .lasting_name = said.empty() ? without_folders(external.name) : said,
      .isolated_by = external.program.layers.text(),
      .bounds_of = candidate_of(external.bounds).name,
      .source_file = external.source_file,
      .stages = stages_of(external.introduction.functions),
      .precision = external.precision,
      .make = [external] { return external_candidate(external); },
      .in_process = [external] { return calls_in_process(external); }};
  if (external.renderer) {
    implementation.bounds_of.clear();
    implementation.arguments = arguments_of(*external.renderer, external.precision);
    implementation.reading = [external](scene::Dialect dialect) {
      return implementation_of(reading(external, form_of(dialect)));
    };
  }
  return implementation;
}

}  // namespace raycheck::tools
