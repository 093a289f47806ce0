#include "tools/commands/list.h"
#include "tools/report/json.h"

namespace raycheck::tools {
namespace {

template <class Method>
Json promised_json(const Method& method) {
  return list_json(promises_of(method), [](const Promise& one) {
    return Json{{"quantity", one.name}, {"unit", one.unit}, {"max", one.max}};
  });
}

Json lengths_json(const fast::Domain& domain) {
  return Json::array({domain.smallest_length, domain.largest_length});
}

Json ray_method_json(const fast::PixelRayMethod* method) {
  return {{"name", method->name},
          {"sentence", method->sentence},
          {"bounds", promised_json(*method)},
          {"lengths", lengths_json(method->domain)},
          {"not_kept_on", method->not_kept}};
}

Json intersect_method_json(const fast::IntersectMethod* method) {
  return {{"name", method->name},
          {"sentence", method->sentence},
          {"bounds", promised_json(*method)},
          {"exact_class", method->exact_class},
          {"lengths", lengths_json(method->domain)},
          {"not_kept_on", method->not_kept}};
}

Json dial_json(const properties::SeverityRange& range) {
  return {{"meaning", range.meaning},
          {"base", range.base},
          {"highest", range.highest},
          {"highest_ordinary", range.ordinary},
          {"highest_demanding", range.demanding}};
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
                {"level", source.severities ? Json(nullptr) : Json(name(source.level))},
                {"dial", or_null(source.severities, dial_json)}};
  });
  for (const Choice& choice : catalogue.conventions) {
    if (!choice.values.empty()) json["conventions"][choice.name] = choice.values;
  }
  json["declarations"] = list_json(catalogue.declarations, [](const Choice& one) {
    return Json{{"name", one.name},
                {"sentence", one.meaning},
                {"default", one.usual},
                {"values", one.values}};
  });
  return json_text(json);
}

std::string bounds_json(const BoundsReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("list");
  json["proved"] = list_json(report.proved, [](const ProvedBound& one) {
    const proofs::Bound& bound = *one.bound;
    return Json{
        {"name", bound.name},      {"what", bound.what},
        {"formula", bound.where},  {"script", "proofs/" + std::string(bound.name) + ".gappa"},
        {"max", bound.value},      {"unit", bound.unit},
        {"observed", one.observed}};
  });
  json["samples"] = report.samples;
  json["promised"] = {{"ray_methods", list_json(report.catalogue.ray_methods, ray_method_json)},
                      {"intersection_methods",
                       list_json(report.catalogue.intersect_methods, intersect_method_json)}};
  return json_text(json);
}

}  // namespace raycheck::tools
