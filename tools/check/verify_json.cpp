
#include "tools/check/check.h"
#include "tools/check/verify.h"
#include "tools/report/json.h"

namespace raycheck::tools {

std::string verify_json(const VerifyReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("verify");
  json["answers"] = report.answers;
  json["cases"] = report.cases;
  json["cases_asked"] = report.options.cases;
  json["cases_left_out"] = report.cases_left_out;
  json["not_answered"] = report.not_answered;
  json["missing"] = report.missing;
  json["interrupted"] = report.interrupted;
  json["strict"] = report.options.strict;
  json["holds"] = report.holds();
  json.update(candidate_json(report.candidate, report.options.top));
  for (const char* key : {"rays", "intersect", "isolated_by", "bounds_of", "explanations"}) {
    json.erase(key);  // for methods, processes and renderers only
  }
  const auto name = [&](Json& place) {
    const auto ray = place["ray"].get<std::size_t>();
    place["ray"] = report.ray_in_case(ray);
    place["id"] = report.ray_id(ray);
  };
  for (Json& one : json["worst"]) name(one);
  for (Json& one : json["quantities"]) {
    if (!one["worst_at"].is_null()) name(one["worst_at"]);
  }
  return json_text(json);
}

}  // namespace raycheck::tools
