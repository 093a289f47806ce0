#include "tools/view/panel/panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "scene/number.h"
#include "tools/report/typeset.h"

namespace raycheck::tools {
namespace {

/// A scene with only this ray and this sphere, for explain().
scene::Scene pair_scene(const scene::Scene& scene, const Selection& selection) {
  scene::Scene result;
  result.conventions = scene.conventions;
  result.rays = {scene.rays.at(selection.ray.value_or(0))};
  if (!scene.spheres.empty()) result.spheres = {scene.spheres.at(selection.sphere.value_or(0))};
  return result;
}

/// Removes those of raycheck's methods that are not to be shown.
void keep_methods(const SceneViewOptions& options, ExplainReport& report) {
  std::vector<MethodPair> pairs;
  if (options.is_of_methods) pairs = options.methods;
  if (options.renderer) pairs = {kDefaultMethods};  // pictures have no steps: show correct ones
  if (pairs.empty()) return;
  std::erase_if(report.methods, [&](const MethodReport& method) {
    return !method.is_other && std::ranges::none_of(pairs, [&](const MethodPair& pair) {
      return method.name == (method.intersects ? pair.intersect->name : pair.rays->name);
    });
  });
}

std::string listed(const auto& triple) {
  return fmt::format("{},{},{}", scene::shortest(triple.x), scene::shortest(triple.y),
                     scene::shortest(triple.z));
}

/// The command that explains the same ray and sphere.
std::string explain_command(const ExplainReport& report, const Selection& asked,
                            const SceneViewOptions& options) {
  const std::string candidate = options.other ? options.more_arguments : "";  // no renderers
  if (!report.pixel) {
    if (!report.sphere) return {};  // `raycheck explain` needs a sphere
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

constexpr int kDigits = 17;

/// The number of correct characters in a value's decimals. All are correct if the value is within
/// an ulp of the correctly rounded exact value; otherwise, those up to the last digit to which both
/// round in the same way.
std::size_t right_characters(double value, double exact) {
  const std::string text = digits_text(value);
  const bool is_next = value == std::nextafter(exact, value);
  if (value == exact || is_next) return text.size();
  if (!std::isfinite(value) || !std::isfinite(exact) || exact == 0) return 0;
  int right = kDigits;
  while (right > 0 &&
         fmt::format("{:.{}e}", value, right - 1) != fmt::format("{:.{}e}", exact, right - 1)) {
    --right;
  }
  if (right == 0) return 0;
  std::size_t at = 0;
  bool is_leading = true;
  for (; at < text.size() && text[at] != 'e'; ++at) {
    if (text[at] == '-' || text[at] == '.' || (is_leading && text[at] == '0')) continue;
    is_leading = false;
    if (right-- == 0) break;
  }
  return at;
}

/// Appends a part to a rich text, unless the part is empty.
void add(Json& said, const char* kind, const std::string& text) {
  if (!text.empty()) said.push_back({kind, text});
}

/// Adds a value, with the digits that differ from the exact value as a separate part. If there is
/// no exact value, all digits are wrong.
void add_value(Json& said, double value, const std::optional<double>& exact) {
  const std::string text = digits_text(value);
  const std::size_t right = exact ? right_characters(value, *exact) : 0;
  add(said, "number", text.substr(0, right));
  add(said, "mark", text.substr(right));
}

/// The result of a method at a step, without its name, because methods that agree share it.
Json answer_json(const MethodReport& method, const MethodStep& mine, const Step& step) {
  Json said = Json::array();
  const std::size_t count = mine.value.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (count > 1) add(said, "", k == 0 ? "(" : ", ");
    add_value(said, mine.value[k],
              k < step.rounded.size() ? std::optional(step.rounded[k]) : std::nullopt);
  }
  if (count != 1) add(said, "", count == 0 ? "a miss" : ")");
  return {{"names", Json::array()},
          {"said", std::move(said)},
          {"off", off_text(mine)},
          {"wrong", method.goes_wrong_at == step.symbol}};
}

/// The results of all methods at a step. Methods that agree fully share one answer.
Json answers_json(const Step& step, const ExplainReport& report) {
  Json answers = Json::array();
  for (const MethodReport& method : report.methods) {
    for (const MethodStep& mine : method.steps) {
      if (mine.symbol != step.symbol) continue;
      const Json answer = answer_json(method, mine, step);
      const auto same = std::ranges::find_if(answers, [&](const Json& other) {
        return other["said"] == answer["said"] && other["off"] == answer["off"] &&
               other["wrong"] == answer["wrong"];
      });
      Json& shared = same == answers.end() ? answers.emplace_back(answer) : *same;
      shared["names"].push_back(method.name);
    }
  }
  return answers;
}

/// A remark if a difference loses digits because its terms are much larger.
std::string cancellation_text(const Step& step, const ExplainReport& report) {
  const Step* const to_centre = report.find("T");
  if (!step.condition || step.symbol != "d^2" || to_centre == nullptr ||
      to_centre->rounded.size() != 3) {
    return {};
  }
  const auto& t = to_centre->rounded;
  // std::hypot, because squares may overflow.
  const double distance = std::hypot(t[0], t[1], t[2]);
  const double half_chord = std::sqrt(std::abs(step.rounded.front()));
  const double decades = 2 * std::log10(distance / half_chord);
  constexpr double kFewest = 3, kOfDoubles = 15.95;
  if (!(decades >= kFewest) || !std::isfinite(decades)) return {};
  const double left = std::floor(kOfDoubles - decades);
  return fmt::format(
      "; |T|^2 is 1e+{:02.0f} times as large as d^2, so that a difference of such squares in "
      "doubles keeps {} of 16 digits",
      std::floor(decades), left >= 1 ? fmt::format("{:.0f}", left) : "none");
}

/// Whether a step's closed form is short enough to be typeset. (The text of `explain` cuts longer
/// ones, too.)
bool is_typeset(const Step& step) {
  constexpr std::size_t kLongestTypeset = 160;
  return !step.closed_form.empty() &&
         std::ranges::all_of(step.closed_form, [](const reference::ClosedForm& form) {
           return form.text().size() <= kLongestTypeset;
         });
}

Json step_json(const Step& step, const ExplainReport& report) {
  return {{"symbol", step.symbol},
          {"formula", step.formula},
          {"mathml", is_typeset(step) ? Json("<math>" + mathml(step.closed_form) + "</math>")
                                      : Json(nullptr)},
          {"rounded", numbers_text(step.rounded)},
          {"condition", condition_text(step) + cancellation_text(step, report)},
          {"answers", answers_json(step, report)}};
}

Json verdict_json(const MethodReport& method, const ExplainReport& report) {
  Json said = Json::array();
  if (!method.failure().empty()) {
    add(said, "wrong", "failed: " + method.failure());
  } else {
    if (method.parameter) {
      add(said, "symbol", "s");
      add(said, "", " = ");
      add_value(said, *method.parameter, report.spheres[*report.sphere].parameter);
    } else if (method.intersects) {
      add(said, "", "a miss");
    }
    add(said, "", answer_remarks(method));
    if (!method.goes_wrong_at.empty()) {
      add(said, "wrong", "; goes wrong at ");
      add(said, "symbol", method.goes_wrong_at);
      add(said, "", wrong_step_remark(method, report));
    }
  }
  return {{"name", method.name}, {"said", std::move(said)}, {"wrong", method.goes_wrong()}};
}

Json exact_json(const ExplainReport& report) {
  if (!report.sphere) {
    return {{"class", nullptr}, {"s", nullptr}, {"said", {{"", "no sphere"}}}};
  }
  const SphereReport& exact = report.spheres[*report.sphere];
  Json said = Json::array();
  if (exact.parameter) {
    add(said, "symbol", "s");
    add(said, "", " = ");
    add(said, "number", digits_text(*exact.parameter));
    add(said, "", direction_remark(report));
  } else {
    add(said, "", fmt::format("a {}", name(exact.intersection.hit_class)));
  }
  return {{"class", name(exact.intersection.hit_class)},
          {"s", or_null(exact.parameter, digits_text)},
          {"said", std::move(said)}};
}

/// The steps, with the answer of each method and the exact one. A rich text is a list of pairs
/// [kind, text]; the kind is "", "symbol", "number", "mark" (wrong digits) or "wrong".
Json explained_json(const ExplainReport& report) {
  const auto step = [&](const Step& one) { return step_json(one, report); };
  const auto verdict = [&](const MethodReport& one) { return verdict_json(one, report); };
  return {{"steps", list_json(report.steps, step)},
          {"verdicts", list_json(report.methods, verdict)},
          {"exact", exact_json(report)}};
}

}  // namespace

std::string direction_remark(const ExplainReport& report) {
  if (report.pixel) return {};
  const scene::Vector3& D = report.ray.direction;
  const double length = std::hypot(D.x, D.y, D.z);
  const std::string length_text = fmt::format("{:.6g}", length);
  return length_text == "1"
             ? ""
             : fmt::format(" times the ray's direction, which is {} long", length_text);
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
    explained.scene = pair_scene(scene, selection);
  }
  ExplainReport report = explain(explained);
  Panel panel;
  panel.selection = selection;
  if (scene.camera) {
    panel.selection.sphere = report.sphere;
  } else if (report.sphere) {
    panel.selection.sphere = selection.sphere.value_or(0);
  }
  panel.json = selection_json(panel.selection);
  panel.json["command"] = explain_command(report, selection, options);
  panel.json["text"] = explain_text(report, {});
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
  panel.json.update(explained_json(report));
  panel.json["drawing"] = drawing_json(frame, ray, sphere, report.scene.conventions);
  panel.json["microscope"] =
      sphere != nullptr ? microscope_json(report, ray, *sphere) : Json(nullptr);
  return panel;
}

}  // namespace raycheck::tools
