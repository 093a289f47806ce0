#include "scene/conventions.h"
#include "tools/list/list_views.h"
#include "tools/report/format.h"

namespace raycheck::tools {
namespace {

Json lengths_json(const fast::Domain& domain) {
  return Json::array({domain.smallest_length, domain.largest_length});
}

}  // namespace

std::string list_json(const Catalogue& catalogue, const ViewOptions& /*options*/) {
  Json json = json_header("list");
  json["ray_methods"] = Json::array();
  for (const auto* method : catalogue.ray_methods) {
    json["ray_methods"].push_back(
        {{"name", method->name},
         {"sentence", method->sentence},
         {"max_point_ulp", method->pixel_points ? Json(method->max_point_ulp) : Json(nullptr)},
         {"max_direction_ulp", method->max_direction_ulp},
         {"max_unit_defect_ulp", method->max_unit_defect_ulp},
         {"lengths", lengths_json(method->domain)},
         {"not_kept_on", method->not_kept}});
  }
  json["intersection_methods"] = Json::array();
  for (const auto* method : catalogue.intersect_methods) {
    json["intersection_methods"].push_back({{"name", method->name},
                                            {"sentence", method->sentence},
                                            {"max_ulp", method->max_ulp},
                                            {"max_point_ulp", method->max_point_ulp},
                                            {"exact_class", method->exact_class},
                                            {"lengths", lengths_json(method->domain)},
                                            {"not_kept_on", method->not_kept}});
  }
  json["laws"] = Json::array();
  for (const properties::Law& law : catalogue.laws) {
    json["laws"].push_back({{"name", law.name}, {"sentence", law.sentence}});
  }
  json["sources"] = Json::array();
  for (const properties::CaseSource& source : catalogue.sources) {
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
