#include "properties/cases/case_text.h"
#include "tools/report/json.h"
#include "tools/worst/worst.h"

namespace raycheck::tools {
namespace {

void add(Json& json, const properties::WorstCase& worst) {
  json["random"] = error_json(worst.height_random);
  json["climbed"] = error_json(worst.height_climbed);
  json["shrunk"] = error_json(worst.height);
  json["error"] = error_json(worst.error);
  json["condition"] = error_json(worst.stability.condition);
  json["ratio"] = error_json(worst.stability.ratio);
  json["outcome"] = name(worst.stability.outcome);
  json["discrepancy"] = discrepancy_json(worst.shown);
  json["scene"] = properties::scene_text(worst.the_case);
}

}  // namespace

std::string worst_json(const WorstReport& report, const ViewOptions& /*options*/) {
  const properties::SearchOptions& search = report.search;
  Json json = json_header("worst");
  json["method"] = report.candidate.name;
  json["isolated_by"] = text_or_null(report.candidate.isolated_by);
  json["bounds_of"] = text_or_null(report.candidate.bounds_of);
  json["family"] = report.source().name();
  json["seed"] = search.seed;
  json["searches"] = report.searches;
  json["climbed_on"] = properties::kClimbNames[static_cast<std::size_t>(search.climb)];
  json["precision"] = name(report.candidate.precision);
  json["unit"] = unit_name(search.quantity, report.candidate.precision);
  json["measured"] = report.worst.has_value();
  json["failures"] = {{"count", report.failures}, {"first", report.first_failure}};
  json["interrupted"] = report.interrupted;
  if (report.worst) add(json, *report.worst);
  return json_text(json);
}

}  // namespace raycheck::tools
