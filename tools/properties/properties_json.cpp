#include <nlohmann/json.hpp>

#include "properties/cases/case_text.h"
#include "tools/properties/properties_views.h"
#include "tools/report/json.h"

namespace raycheck::tools {

std::string properties_json(const PropertiesReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("properties");
  json["seed"] = report.seed ? Json(*report.seed) : Json(nullptr);
  json["cases"] = report.cases;
  json["interrupted"] = report.interrupted;
  json["campaigns"] = Json::array();
  for (const CampaignReport& campaign : report.campaigns) {
    const properties::CampaignResult& result = campaign.result;
    Json entry;
    entry["law"] = campaign.law->name;
    entry["sentence"] = campaign.law->sentence;
    entry["candidate"] = campaign.candidate;
    entry["holds"] = !result.failure.has_value();
    entry["cases"] = result.cases;
    entry["comparisons"] = result.verdict.compared();
    entry["discrepancies_by_standing"] = standings_json(result.verdict);
    entry["quantities"] = tallies_json(result.verdict);
    entry["left_out"] = result.left_out;
    entry["reason_left_out"] = result.reason.empty() ? Json(nullptr) : Json(result.reason);
    if (result.failure) {
      entry["replay"] = result.failure->replay;
      entry["scene"] = properties::scene_text(result.failure->shrunk);
      entry["discrepancies"] = Json::array();
      for (const auto& discrepancy : result.failure->verdict.worst(10)) {
        entry["discrepancies"].push_back(discrepancy_json(discrepancy));
      }
    }
    json["campaigns"].push_back(std::move(entry));
  }
  json["failures"] = report.failures();
  return json.dump(2) + "\n";
}

}  // namespace raycheck::tools
