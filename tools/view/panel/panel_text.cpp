#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/explain/explain.h"
#include "tools/view/panel/panel.h"

namespace raycheck::tools {
std::string direction_remark(const ExplainReport& report) {
  if (report.pixel) return {};
  const scene::Vector3& D = report.ray.direction;
  const double length = std::hypot(D.x, D.y, D.z);
  const std::string told = fmt::format("{:.6g}", length);
  return told == "1" ? "" : fmt::format(" times the ray's direction, which is {} long", told);
}

std::vector<std::string> microscope_sentences(const Microscope& microscope,
                                              const ExplainReport& report, double gap) {
  const bool is_single = microscope_precision(report) == scene::Precision::kSingle;
  std::vector<std::string> sentences = {
      fmt::format("Around the {}, s = {:.17g}{}. 1 ulp = {:.3g}{}.",
                  microscope.is_hit ? "exact hit point" : "ray's point nearest to the centre",
                  microscope.parameter, direction_remark(report), microscope.ulp,
                  is_single ? ", of a float: the candidate's format" : "")};
  if (microscope.is_hit) {
    sentences.push_back(
        microscope.region ? fmt::format("Shaded: rounding the inputs moves s by up to {:.6g} ulp.",
                                        *microscope.region)
                          : "Shaded: rounding the inputs may move s anywhere.");
  } else {
    std::string text = fmt::format(
        "A miss has no hit point; here the ray is {:.3g} ulp from the sphere", std::abs(gap));
    double nearest = HUGE_VAL;
    for (const MicroscopeMark& mark : microscope.marks) {
      nearest = std::min(nearest, std::max(std::abs(mark.x), std::abs(mark.y)));
    }
    if (nearest < HUGE_VAL) {
      text += fmt::format(", and the nearest hit that a method claims is {:.3g} ulp away", nearest);
    }
    sentences.push_back(text + ".");
  }
  std::vector<std::pair<std::string, std::string>> absent;  // verdict, names
  for (const MethodReport& method : report.methods) {
    const bool is_drawn =
        std::any_of(microscope.marks.begin(), microscope.marks.end(),
                    [&](const MicroscopeMark& mark) { return mark.method == method.name; });
    if (!method.intersects || is_drawn) continue;
    const std::string verdict = method_verdict(method, report);
    const auto same = std::find_if(absent.begin(), absent.end(),
                                   [&](const auto& other) { return other.first == verdict; });
    if (same == absent.end()) {
      absent.emplace_back(verdict, method.name);
    } else {
      same->second += ", " + method.name;
    }
  }
  for (const auto& [verdict, names] : absent) {
    sentences.push_back(fmt::format("Nothing to draw of {}: {}.", names, verdict));
  }
  return sentences;
}

}  // namespace raycheck::tools
