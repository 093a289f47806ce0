#include <nlohmann/json.hpp>

#include "scene/conventions.h"
#include "tools/list/list.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;

/// A bound in u or ulp of the method's own precision.
Json bound_json(Quantity quantity, double bound, double roundoff) {
  const scene::Precision precision = precision_of(roundoff);
  return {{"quantity", info(quantity).name},
          {"unit", unit_name(quantity, precision)},
          {"max", in_own_unit(bound, precision)}};
}

Json lengths_json(const fast::Domain& domain) {
  return Json::array({domain.smallest_length, domain.largest_length});
}

}  // namespace

std::string list_json(const Catalogue& catalogue, const ViewOptions& /*options*/) {
  Json json = json_header("list");
  json["ray_methods"] = Json::array();
  for (const auto* method : catalogue.ray_methods) {
    Json bounds = Json::array();
    if (method->pixel_points) {
      bounds.push_back(
          bound_json(Quantity::kPixelPoint, method->max_point_ulp, method->unit_roundoff));
    }
    bounds.push_back(
        bound_json(Quantity::kDirection, method->max_direction_ulp, method->unit_roundoff));
    bounds.push_back(
        bound_json(Quantity::kUnitDefect, method->max_unit_defect_ulp, method->unit_roundoff));
    json["ray_methods"].push_back({{"name", method->name},
                                   {"sentence", method->sentence},
                                   {"bounds", bounds},
                                   {"lengths", lengths_json(method->domain)},
                                   {"not_kept_on", method->not_kept}});
  }
  json["intersection_methods"] = Json::array();
  for (const auto* method : catalogue.intersect_methods) {
    json["intersection_methods"].push_back(
        {{"name", method->name},
         {"sentence", method->sentence},
         {"bounds",
          {bound_json(Quantity::kParameter, method->max_ulp, method->unit_roundoff),
           bound_json(Quantity::kHitPoint, method->max_point_ulp, method->unit_roundoff)}},
         {"exact_class", method->exact_class},
         {"lengths", lengths_json(method->domain)},
         {"not_kept_on", method->not_kept}});
  }
  json["single_precision_lengths"] =
      Json::array({properties::kSmallestSingleLength, properties::kLargestSingleLength});
  json["laws"] = Json::array();
  for (const properties::Law& law : catalogue.laws) {
    json["laws"].push_back({{"name", law.name}, {"sentence", law.sentence}});
  }
  json["sources"] = Json::array();
  for (const properties::CaseSource& source : catalogue.sources) {
    Json entry = {{"name", source.name},
                  {"sentence", source.sentence},
                  {"level", source.dial ? Json(nullptr) : Json(name(source.level))},
                  {"dial", nullptr}};
    if (source.dial) {
      entry["dial"] = {{"meaning", source.dial->meaning},
                       {"base", source.dial->base},
                       {"highest", source.dial->highest},
                       {"highest_ordinary", source.dial->ordinary},
                       {"highest_demanding", source.dial->demanding}};
    }
    json["sources"].push_back(std::move(entry));
  }
  json["conventions"] = {{"rows", scene::kRowsNames},       {"samples", scene::kSamplesNames},
                         {"origin", scene::kOriginNames},   {"root", scene::kRootNames},
                         {"tangent", scene::kTangentNames}, {"interval", scene::kEndsNames},
                         {"t_unit", scene::kTUnitNames},    {"culling", scene::kCullingNames}};
  return json_text(json);
}

}  // namespace raycheck::tools
