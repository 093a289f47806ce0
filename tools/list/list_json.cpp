
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

Json ray_method_json(const fast::PixelRayMethod* method) {
  const double unit = method->unit_roundoff;
  Json bounds = Json::array();
  if (method->pixel_points) {
    bounds.push_back(bound_json(Quantity::kPixelPoint, method->max_point_ulp, unit));
  }
  bounds.push_back(bound_json(Quantity::kDirection, method->max_direction_ulp, unit));
  bounds.push_back(bound_json(Quantity::kUnitDefect, method->max_unit_defect_ulp, unit));
  return {{"name", method->name},
          {"sentence", method->sentence},
          {"bounds", bounds},
          {"lengths", lengths_json(method->domain)},
          {"not_kept_on", method->not_kept}};
}

Json intersect_method_json(const fast::IntersectMethod* method) {
  const double unit = method->unit_roundoff;
  return {{"name", method->name},
          {"sentence", method->sentence},
          {"bounds",
           {bound_json(Quantity::kParameter, method->max_ulp, unit),
            bound_json(Quantity::kHitPoint, method->max_point_ulp, unit)}},
          {"exact_class", method->exact_class},
          {"lengths", lengths_json(method->domain)},
          {"not_kept_on", method->not_kept}};
}

Json dial_json(const properties::Dial& dial) {
  return {{"meaning", dial.meaning},
          {"base", dial.base},
          {"highest", dial.highest},
          {"highest_ordinary", dial.ordinary},
          {"highest_demanding", dial.demanding}};
}

}  // namespace

std::string list_json(const Catalogue& catalogue, const ViewOptions& /*options*/) {
  Json json = json_header("list");
  json["ray_methods"] = list_json(catalogue.ray_methods, ray_method_json);
  json["intersection_methods"] = list_json(catalogue.intersect_methods, intersect_method_json);
  json["single_precision_lengths"] =
      Json::array({properties::kSmallestSingleLength, properties::kLargestSingleLength});
  json["laws"] = list_json(catalogue.laws, [](const properties::Law& law) {
    return Json{{"name", law.name}, {"sentence", law.sentence}};
  });
  json["sources"] = list_json(catalogue.sources, [](const properties::CaseSource& source) {
    return Json{{"name", source.name},
                {"sentence", source.sentence},
                {"level", source.dial ? Json(nullptr) : Json(name(source.level))},
                {"dial", or_null(source.dial, dial_json)}};
  });
  json["conventions"] = {{"rows", scene::kRowsNames},       {"samples", scene::kSamplesNames},
                         {"origin", scene::kOriginNames},   {"root", scene::kRootNames},
                         {"tangent", scene::kTangentNames}, {"interval", scene::kEndsNames},
                         {"t_unit", scene::kTUnitNames},    {"culling", scene::kCullingNames}};
  return json_text(json);
}

}  // namespace raycheck::tools
