#include "tools/view/panel/panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "scene/number.h"
#include "tools/explain/explain.h"
#include "tools/report/typeset.h"

namespace raycheck::tools {
namespace {

/// A scene of only this ray and sphere, as given input for explain.
scene::Scene alone(const scene::Scene& scene, const Selection& selection) {
  scene::Scene result;
  result.conventions = scene.conventions;
  result.rays = {scene.rays.at(selection.ray.value_or(0))};
  if (!scene.spheres.empty()) result.spheres = {scene.spheres.at(selection.sphere.value_or(0))};
  return result;
}

/// Of raycheck's methods, keeps those that are to be shown.
void keep_methods(const SceneViewOptions& options, ExplainReport& report) {
  std::vector<MethodPair> pairs;
  if (options.is_of_methods) pairs = options.methods;
  if (options.renderer) pairs = {kDefaultMethods};  // pictures have no steps: correct ones
  if (pairs.empty()) return;
  std::erase_if(report.methods, [&](const MethodReport& method) {
    return !method.is_other &&
           std::none_of(pairs.begin(), pairs.end(), [&](const MethodPair& pair) {
             return method.name == (method.intersects ? pair.intersect->name : pair.rays->name);
           });
  });
}

std::string listed(const auto& triple) {
  return fmt::format("{},{},{}", scene::shortest(triple.x), scene::shortest(triple.y),
                     scene::shortest(triple.z));
}

/// What explains the same ray and sphere at a desk.
std::string explain_command(const ExplainReport& report, const Selection& asked,
                            const SceneViewOptions& options) {
  const std::string candidate = options.other ? options.more_arguments : "";  // no renderers
  if (!report.pixel) {
    if (!report.sphere) return {};  // explain takes no ray without a sphere
    const scene::Sphere& sphere = report.scene.spheres[*report.sphere];
    return fmt::format("raycheck explain --ray={},{} --sphere={},{}{}", listed(report.ray.origin),
                       listed(report.ray.direction), listed(sphere.centre),
                       scene::shortest(sphere.radius), candidate);
  }
  std::string command = fmt::format("raycheck explain {} --pixel {},{}", options.file,
                                    report.pixel->i, report.pixel->j);
  if (asked.sphere) command += fmt::format(" --sphere {}", *asked.sphere);
  if (report.rays_method != kDefaultMethods.rays->name) command += " --rays " + report.rays_method;
  return command + candidate;
}

}  // namespace

bool is_typeset(const Step& step) {
  constexpr std::size_t kLongestTypeset = 160;
  return !step.closed_form.empty() && std::all_of(step.closed_form.begin(), step.closed_form.end(),
                                                  [](const reference::ClosedForm& form) {
                                                    return form.text().size() <= kLongestTypeset;
                                                  });
}

Panel panel_of(const scene::Scene& scene, const DrawnFrame& frame, const Selection& selection,
               const SceneViewOptions& options) {
  ExplainOptions explained;
  if (!options.methods.empty()) explained.rays = options.methods.front().rays;
  explained.other = options.other;
  if (scene.camera) {
    explained.scene = scene;
    explained.pixel = selection.pixel;
    explained.sphere = selection.sphere;
  } else {
    explained.scene = alone(scene, selection);
  }
  ExplainReport report = explain(explained);
  Panel panel;
  panel.selection = selection;
  if (scene.camera) {
    panel.selection.sphere = report.sphere;
  } else if (report.sphere) {
    panel.selection.sphere = selection.sphere.value_or(0);
  }
  panel.told = selection_json(panel.selection);
  panel.told["command"] = explain_command(report, selection, options);
  panel.told["text"] = explain_text(report, {});
  keep_methods(options, report);
  for (const MethodReport& method : report.methods) {
    if (method.goes_wrong()) panel.wrong.push_back(method.name);
  }
  const scene::Sphere* const sphere =
      report.sphere ? &report.scene.spheres[*report.sphere] : nullptr;
  const reference::ExactRay ray =
      report.pixel ? reference::ExactRay(
                         reference::ExactCamera(*report.scene.camera, report.scene.conventions),
                         *report.pixel)
                   : reference::ExactRay(report.ray);
  panel.told.update(told_json(report));
  panel.told["drawing"] = drawing_json(frame, ray, sphere, report.scene.conventions);
  panel.told["microscope"] =
      sphere != nullptr ? microscope_json(report, ray, *sphere) : Json(nullptr);
  return panel;
}

}  // namespace raycheck::tools
