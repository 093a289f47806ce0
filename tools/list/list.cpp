#include "tools/list/list.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "fast/camera_frame.h"
#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "scene/conventions.h"
#include "tools/methods/methods.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;

std::string caveat(std::string_view not_kept) {
  if (not_kept.empty()) return "\n";
  return fmt::format("\n  {:<17} not kept on {}\n", "", not_kept);
}

/// The lengths of a method that has its own; empty for most.
std::string lengths(const fast::Domain& domain) {
  if (domain == fast::Domain{}) return {};
  return fmt::format("; lengths {:.3g} to {:.3g}", domain.smallest_length, domain.largest_length);
}

Json lengths_json(const fast::Domain& domain) {
  return Json::array({domain.smallest_length, domain.largest_length});
}

Json bound_json(Quantity quantity, double bound) {
  return {{"quantity", info(quantity).name}, {"unit", info(quantity).unit}, {"max", bound}};
}

/// A bound; those of single precision are large.
std::string bound(double ulp) {
  return ulp < 1e6 ? fmt::format("{}", ulp) : fmt::format("{:.3g}", ulp);
}

template <class Names>
std::string joined(const Names& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : " | ") + std::string(name);
  return text;
}

}  // namespace

std::string list_text() {
  std::string text = "ray methods (--rays):\n";
  for (const auto* method : fast::pixel_ray_methods()) {
    text += fmt::format("  {:<17} {}\n", method->name, method->sentence);
    text +=
        fmt::format("  {:<17} bounds: {}direction {} u, unit defect {} u{}{}", "",
                    method->pixel_points ? fmt::format("point {} u, ", bound(method->max_point_ulp))
                                         : std::string(),
                    bound(method->max_direction_ulp), bound(method->max_unit_defect_ulp),
                    lengths(method->domain), caveat(method->not_kept));
  }
  text += "\nintersection methods (--intersect):\n";
  for (const auto* method : fast::intersect_methods()) {
    text += fmt::format("  {:<17} {}\n  {:<17} bounds: parameter {} ulp, hit point {} u{}{}{}",
                        method->name, method->sentence, "", bound(method->max_ulp),
                        bound(method->max_point_ulp), method->exact_class ? "; exact class" : "",
                        lengths(method->domain), caveat(method->not_kept));
  }
  text += fmt::format(
      "\nBounds hold up to condition number {}, in proportion beyond, for lengths from {:.3g} to "
      "{:.3g} where no others are named.\n",
      properties::kModerateCondition, fast::kSmallestLength, fast::kLargestLength);
  text += "\nlaws (--filter):\n";
  for (const properties::Law& law : properties::laws()) {
    text += fmt::format("  {:<17} {}\n", law.name, law.sentence);
  }
  text += "\nsources of random cases (--source), those with severities as NAME or NAME@SEVERITY:\n";
  for (const properties::CaseSource& source : properties::case_sources()) {
    text += fmt::format("  {:<17} {}\n", source.name, source.sentence);
    if (!source.dial) continue;
    text += fmt::format("  {:<17} @0 to @{}: {}\n", "", source.dial->highest, source.dial->meaning);
  }
  text += "\nconventions (the first is the default):\n";
  text += fmt::format("  rows              {}\n", joined(scene::kRowsNames));
  text += fmt::format("  samples           {}\n", joined(scene::kSamplesNames));
  text += fmt::format("  origin            {}\n", joined(scene::kOriginNames));
  text += fmt::format("  root              {}\n", joined(scene::kRootNames));
  text += fmt::format("  tangent           {}\n", joined(scene::kTangentNames));
  return text;
}

std::string list_json() {
  Json json = json_header("list");
  json["ray_methods"] = Json::array();
  for (const auto* method : fast::pixel_ray_methods()) {
    Json bounds = Json::array();
    if (method->pixel_points) {
      bounds.push_back(bound_json(Quantity::kPixelPoint, method->max_point_ulp));
    }
    bounds.push_back(bound_json(Quantity::kDirection, method->max_direction_ulp));
    bounds.push_back(bound_json(Quantity::kUnitDefect, method->max_unit_defect_ulp));
    json["ray_methods"].push_back({{"name", method->name},
                                   {"sentence", method->sentence},
                                   {"bounds", bounds},
                                   {"lengths", lengths_json(method->domain)},
                                   {"not_kept_on", method->not_kept}});
  }
  json["intersection_methods"] = Json::array();
  for (const auto* method : fast::intersect_methods()) {
    json["intersection_methods"].push_back(
        {{"name", method->name},
         {"sentence", method->sentence},
         {"bounds",
          {bound_json(Quantity::kParameter, method->max_ulp),
           bound_json(Quantity::kHitPoint, method->max_point_ulp)}},
         {"exact_class", method->exact_class},
         {"lengths", lengths_json(method->domain)},
         {"not_kept_on", method->not_kept}});
  }
  json["laws"] = Json::array();
  for (const properties::Law& law : properties::laws()) {
    json["laws"].push_back({{"name", law.name}, {"sentence", law.sentence}});
  }
  json["sources"] = Json::array();
  for (const properties::CaseSource& source : properties::case_sources()) {
    Json entry = {{"name", source.name}, {"sentence", source.sentence}, {"dial", nullptr}};
    if (source.dial) {
      entry["dial"] = {{"meaning", source.dial->meaning},
                       {"base", source.dial->base},
                       {"highest", source.dial->highest}};
    }
    json["sources"].push_back(std::move(entry));
  }
  json["conventions"] = {{"rows", scene::kRowsNames},
                         {"samples", scene::kSamplesNames},
                         {"origin", scene::kOriginNames},
                         {"root", scene::kRootNames},
                         {"tangent", scene::kTangentNames}};
  return json.dump(2) + "\n";
}

}  // namespace raycheck::tools
