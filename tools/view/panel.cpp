#include "tools/view/panel.h"

#include <fmt/core.h>

#include "scene/number.h"
#include "tools/explain/explain_views.h"
#include "tools/view/microscope.h"
#include "tools/view/sage.h"

namespace raycheck::tools {
namespace {

/// A scene of the one ray and the one sphere, as explain takes given ones.
scene::Scene alone(const scene::Scene& scene, const Selection& selection) {
  scene::Scene result;
  result.conventions = scene.conventions;
  result.rays = {scene.rays.at(selection.ray.value_or(0))};
  if (!scene.spheres.empty()) result.spheres = {scene.spheres.at(selection.sphere.value_or(0))};
  return result;
}

std::string listed(const auto& triple) {
  return fmt::format("{},{},{}", scene::shortest(triple.x), scene::shortest(triple.y),
                     scene::shortest(triple.z));
}

/// What explains the same at a desk.
std::string command_of(const ExplainReport& report, const Selection& asked,
                       const PanelOptions& options) {
  if (!report.pixel) {
    const scene::Sphere& sphere = report.scene.spheres[*report.sphere];
    return fmt::format("raycheck explain --ray={},{} --sphere={},{}{}", listed(report.ray.origin),
                       listed(report.ray.direction), listed(sphere.centre),
                       scene::shortest(sphere.radius), options.more_arguments);
  }
  std::string command = fmt::format("raycheck explain {} --pixel {},{}", options.scene_argument,
                                    report.pixel->i, report.pixel->j);
  if (asked.sphere) command += fmt::format(" --sphere {}", *asked.sphere);
  if (options.rays != kDefaultMethods.rays) command += fmt::format(" --rays {}", options.rays->name);
  return command + options.more_arguments;
}

/// The steps for a paper: symbol, formula and closed form of each.
std::string latex_of(const ExplainReport& report) {
  std::string text = "\\begin{align*}\n";
  for (const Step& step : report.steps) {
    text += fmt::format("{} &= {}", symbol_latex(step.symbol), formula_latex(step));
    if (!step.closed_form.empty()) text += fmt::format(" = {}", latex(step.closed_form));
    text += " \\\\\n";
  }
  return text + "\\end{align*}\n";
}

}  // namespace

Panel panel_of(const scene::Scene& scene, const DrawnFrame& frame, const Selection& selection,
               const PanelOptions& options) {
  ExplainOptions explained;
  explained.rays = options.rays;
  explained.other = options.other;
  if (scene.camera) {
    explained.scene = scene;
    explained.pixel = selection.pixel;
    explained.sphere = selection.sphere;
  } else {
    explained.scene = alone(scene, selection);
  }
  Panel panel;
  panel.report = explain(explained);
  const ExplainReport& report = panel.report;
  panel.selection = selection;
  if (scene.camera) {
    panel.selection.sphere = report.sphere;
  } else if (report.sphere) {
    panel.selection.sphere = selection.sphere.value_or(0);
  }
  panel.text = explain_text(report, {});
  panel.command = report.sphere || report.pixel ? command_of(report, selection, options) : "";
  panel.sage = sage_input(report);
  panel.latex = latex_of(report);
  const scene::Sphere* const sphere =
      report.sphere ? &report.scene.spheres[*report.sphere] : nullptr;
  const reference::ExactRay ray =
      report.pixel ? reference::ExactRay(
                         reference::ExactCamera(*report.scene.camera, report.scene.conventions),
                         *report.pixel)
                   : reference::ExactRay(report.ray);
  panel.drawing = drawing_of(frame, ray, sphere, report.scene.conventions);
  if (sphere != nullptr) panel.microscope = microscope_of(report, ray, *sphere);
  return panel;
}

}  // namespace raycheck::tools
