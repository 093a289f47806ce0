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

/// A scene of the one ray and the one sphere, as explain takes given ones.
scene::Scene alone(const scene::Scene& scene, const Selection& selection) {
  scene::Scene result;
  result.conventions = scene.conventions;
  result.rays = {scene.rays.at(selection.ray.value_or(0))};
  if (!scene.spheres.empty()) result.spheres = {scene.spheres.at(selection.sphere.value_or(0))};
  return result;
}

std::string symbol_latex(const std::string& symbol) {
  constexpr std::pair<std::string_view, std::string_view> kOthers[] = {
      {"alpha", "\\alpha"},
      {"beta", "\\beta"},
      {"direction", "\\mathit{direction}"},
      {"s |direction|", "s\\,|\\mathit{direction}|"}};
  for (const auto& [name, latex] : kOthers) {
    if (symbol == name) return std::string(latex);
  }
  return symbol;
}

std::string rounded_latex(const std::vector<double>& values) {
  std::string text;
  for (const double x : values) text += fmt::format("{}{:.17g}", text.empty() ? "" : ", ", x);
  return values.size() == 1 ? text : fmt::format("\\left({}\\right)", text);
}

/// The steps for a paper: of each its closed form, where that is short, and the rounded value.
std::string latex_of(const ExplainReport& report) {
  std::string text = "\\begin{align*}\n";
  for (const Step& step : report.steps) {
    text += symbol_latex(step.symbol);
    if (is_typeset(step)) text += fmt::format(" &= {}", latex(step.closed_form));
    text += fmt::format(" {} {} \\\\\n", is_typeset(step) ? "\\approx" : "&\\approx",
                        rounded_latex(step.rounded));
  }
  return text + "\\end{align*}\n";
}

/// Leaves of raycheck's methods those of the pairs.
void keep_methods(const std::vector<MethodPair>& pairs, ExplainReport& report) {
  if (pairs.empty()) return;
  std::erase_if(report.methods, [&](const MethodReport& method) {
    const bool is_other = report.other && method.name == report.other->name;
    return !is_other && std::none_of(pairs.begin(), pairs.end(), [&](const MethodPair& pair) {
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
                            const PanelOptions& options) {
  if (!report.pixel) {
    if (!report.sphere) return {};  // It explains no ray alone.
    const scene::Sphere& sphere = report.scene.spheres[*report.sphere];
    return fmt::format("raycheck explain --ray={},{} --sphere={},{}{}", listed(report.ray.origin),
                       listed(report.ray.direction), listed(sphere.centre),
                       scene::shortest(sphere.radius), options.more_arguments);
  }
  std::string command = fmt::format("raycheck explain {} --pixel {},{}", options.scene_argument,
                                    report.pixel->i, report.pixel->j);
  if (asked.sphere) command += fmt::format(" --sphere {}", *asked.sphere);
  if (options.rays != kDefaultMethods.rays)
    command += fmt::format(" --rays {}", options.rays->name);
  return command + options.more_arguments;
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
  keep_methods(options.methods, panel.report);
  panel.command = explain_command(report, selection, options);
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
