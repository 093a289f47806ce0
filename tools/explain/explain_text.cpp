#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "scene/number.h"
#include "scene/text.h"
#include "tools/explain/explain.h"
#include "tools/implementations/implementation.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

/// Longer closed forms are cut in this report; --format json has them whole.
constexpr std::size_t kLongestClosedForm = 160;

std::string shown(const std::string& closed_form) {
  if (closed_form.size() <= kLongestClosedForm) return closed_form;
  return fmt::format("({} characters: see --format json)", closed_form.size());
}

std::string listed(const std::vector<std::string>& parts) {
  const std::string text =
      scene::joined(parts, ", ", [](const std::string& part) { return shown(part); });
  return parts.size() == 1 ? text : "(" + text + ")";
}

/// "s = 0.001 lies before t_min = 0.01"
std::string left_out_text(const RootLeftOut& root, const scene::ValidRoots& valid) {
  using reference::RootCounts;
  const std::string s = fmt::format("s = {}", scene::shortest(root.s));
  const auto end = [&](const char* name, double t) {
    return fmt::format("{} = {}{}", name, scene::shortest(t),
                       valid.unit == scene::TUnit::kRadius ? " radii" : "");
  };
  switch (root.why) {
    case RootCounts::kCulled:
      return fmt::format("{} lies on a {} face, which is culled", s,
                         root.root == reference::WhichRoot::kSmaller ? "front" : "back");
    case RootCounts::kBeforeMin:
      return fmt::format("{} lies before {}", s, end("t_min", valid.t_min));
    case RootCounts::kOnOpenMin:
      return fmt::format("{} lies on {}, which does not belong to {}", s, end("t_min", valid.t_min),
                         interval_text(valid));
    case RootCounts::kOnOpenMax:
      return fmt::format("{} lies on {}, which does not belong to {}", s, end("t_max", valid.t_max),
                         interval_text(valid));
    default:
      return fmt::format("{} lies beyond {}", s, end("t_max", valid.t_max));
  }
}

std::string answer_of(const SphereReport& sphere) {
  std::string text(name(sphere.intersection.hit_class));
  if (sphere.parameter) {
    text += fmt::format(", s = {}", scene::digits_and_hexfloat(*sphere.parameter));
  }
  return text;
}

void append_steps(const ExplainReport& report, std::string& text) {
  std::size_t width = 0;
  for (const Step& step : report.steps) width = std::max(width, step.symbol.size());
  for (const Step& step : report.steps) {
    text += fmt::format("  {:<{}} = {}\n", step.symbol, width, step.formula);
    if (!step.closed_form.empty()) {
      text += fmt::format("  {:<{}} = {}\n", "", width, listed(reference::texts(step.closed_form)));
    }
    text += fmt::format("  {:<{}} = {}\n", "", width, numbers_text(step.rounded));
    if (step.condition) text += fmt::format("  {:<{}}   {}\n", "", width, condition_text(step));
    for (const MethodReport& method : report.methods) {
      for (const MethodStep& mine : method.steps) {
        if (mine.symbol != step.symbol) continue;
        text += fmt::format("  {:<{}}   {:<17} {}{}{}{}\n", "", width, method.name,
                            mine.value.empty() ? "miss" : numbers_text(mine.value),
                            mine.error ? "  " : "", off_text(mine),
                            method.goes_wrong_at == step.symbol ? "  <- goes wrong here" : "");
      }
    }
  }
}

}  // namespace

std::string digits_text(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{:.17g}", value);
}

std::string numbers_text(const std::vector<double>& values) {
  std::vector<std::string> parts;
  for (const double x : values) parts.push_back(digits_text(x));
  return listed(parts);
}

std::string off_text(const MethodStep& step) {
  return (step.error ? fmt::format("off by {} {}", error_text(step.error), step.unit) : "") +
         (step.error_alone ? fmt::format(" ({} by this step only)", error_text(step.error_alone))
                           : "");
}

std::string condition_text(const Step& step) {
  if (!step.condition) return {};
  return fmt::format("condition number {}{}", error_text(step.condition),
                     step.condition_alone
                         ? fmt::format(" (from the scene's numbers; of this step only: {})",
                                       error_text(step.condition_alone))
                         : "");
}

std::string answer_remarks(const MethodReport& method) {
  if (!method.intersects) {
    const MethodStep& last = method.steps.back();
    return fmt::format("rays: {} off by {} {}", last.symbol, error_text(last.error), last.unit);
  }
  std::string text;
  if (method.ulp_error) {
    text += fmt::format(", off by {} {}", error_text(method.ulp_error),
                        unit_name(properties::Quantity::kParameter, method.precision));
  }
  if (!method.wrong) return text;
  const properties::Discrepancy& wrong = *method.wrong;
  if (wrong.wrong != properties::Wrong::kNot) {
    text += ", " + wrongness_text(wrong);
  } else if (wrong.quantity != properties::Quantity::kParameter) {
    text += fmt::format(", {} {}", info(wrong.quantity).name, wrongness_text(wrong));
  }
  if (wrong.excluded_by) {
    text += fmt::format(", which the interval {} excludes", interval_text(*wrong.excluded_by));
  }
  const properties::Standing standing = wrong.excuse.standing();
  if (standing != properties::Standing::kDefect) {
    text += fmt::format(" ({}{})", name(standing),
                        standing == properties::Standing::kNotJudged ? ": outside its domain" : "");
  }
  return text;
}

std::string wrong_step_remark(const MethodReport& method, const ExplainReport& report) {
  if (method.goes_wrong_at != "D" || !method.intersects) return {};
  if (method.is_other) return " (of the ray that it makes)";
  return " (of the ray that `" + report.rays_method + "` makes)";
}

std::string method_verdict(const MethodReport& method, const ExplainReport& report, bool colours) {
  if (!method.failure().empty()) return red("failed: " + method.failure(), colours);
  std::string text;
  if (method.intersects) {
    text = method.parameter ? fmt::format("s = {}", scene::digits_and_hexfloat(*method.parameter))
                            : "miss";
  }
  text += answer_remarks(method);
  if (method.goes_wrong_at.empty()) return text;
  return red(fmt::format("{}; goes wrong at {}{}", text, method.goes_wrong_at,
                         wrong_step_remark(method, report)),
             colours);
}

std::string explain_text(const ExplainReport& report, const ViewOptions& options) {
  std::string text;
  if (report.pixel) {
    text += fmt::format("pixel ({}, {}); {}\n", report.pixel->i, report.pixel->j,
                        conventions_text(report.scene.conventions));
  } else {
    text += "a given ray; s is in multiples of its direction\n";
    if (!report.scene.conventions.valid.is_usual()) {
      text += conventions_text(report.scene.conventions) + "\n";
    }
  }
  if (report.rounded_numbers > 0) text += rounded_numbers_text(report.rounded_numbers) + "\n";
  text +=
      "each step: its exact value in closed form, the same correctly rounded, and each method's "
      "value\n";
  if (report.sphere && report.pixel) {
    text += fmt::format(
        "(the methods compute v, d^2, s and Q on the ray that `{}` makes, and are judged by the "
        "exact values for this ray)\n",
        report.rays_method);
    const MethodReport& last = report.methods.back();
    if (last.is_other && last.intersects) {
      text += fmt::format(
          "({}: on {})\n", last.name,
          last.makes_ray ? "the ray that it makes" : "the exact ray, correctly rounded");
    }
  }
  if (report.sphere) {
    const scene::Sphere& sphere = report.scene.spheres[*report.sphere];
    text += fmt::format("sphere {}: C = {}, r = {}\n", *report.sphere,
                        numbers_text({sphere.centre.x, sphere.centre.y, sphere.centre.z}),
                        digits_text(sphere.radius));
  }
  text += "\n";
  append_steps(report, text);
  if (!report.spheres.empty()) text += "\nexact:\n";
  for (std::size_t k = 0; k < report.spheres.size(); ++k) {
    const SphereReport& sphere = report.spheres[k];
    text += fmt::format("  sphere {}: {}", k, answer_of(sphere));
    text += report.nearest == k ? ", the nearest\n" : "\n";
    for (const RootLeftOut& root : sphere.left_out) {
      text += fmt::format("    does not count: {}\n",
                          left_out_text(root, report.scene.conventions.valid));
    }
  }
  text += report.sphere && report.pixel ? "\nmethods, judged for the pixel:\n" : "\nmethods:\n";
  if (report.other) {
    text += indented(isolation_text({*report.other}), "  ");
  }
  if (report.by_every_root) {
    text += fmt::format(
        "  raycheck's methods are judged as if every root >= 0 counts; exact then: {}\n",
        answer_of(*report.by_every_root));
  }
  for (const MethodReport& method : report.methods) {
    text +=
        fmt::format("  {:<17} {}\n", method.name, method_verdict(method, report, options.colours));
  }
  return text;
}

}  // namespace raycheck::tools
