#include <nlohmann/json.hpp>

#include "properties/cases/case_text.h"
#include "tools/gates/ratchet_json.h"
#include "tools/properties/properties_views.h"
#include "tools/report/json.h"

namespace raycheck::tools {

namespace {

using properties::Finding;

Json counts_json(const properties::CaseCounts& counts, const properties::Verdict& verdict) {
  return {{"cases", counts.cases},
          {"comparisons", verdict.compared()},
          {"discrepancies_by_standing", standings_json(verdict)},
          {"left_out", counts.left_out},
          {"not_judged", counts.not_judged},
          {"given_rays", counts.given_rays},
          {"reason_left_out", counts.reason.empty() ? Json(nullptr) : Json(counts.reason)}};
}

Json severity_json(const std::optional<int>& severity) {
  return severity ? Json(*severity) : Json(nullptr);
}

Json replay_json(const std::string& replay) {
  return replay.empty() ? Json(nullptr) : Json(replay);
}

Json part_json(const properties::CampaignPart& part) {
  Json json = counts_json(part.counts, part.verdict);
  json["source"] = part.source.source->name;
  json["severity"] = severity_json(part.source.severity);
  json["level"] = name(part.source.level());
  json["replay"] = replay_json(part.replay);
  json["defects"] = Json::array();
  for (const properties::DefectKind& kind : part.defects) {
    json["defects"].push_back(kind_text(kind));
  }
  return json;
}

Json reach_json(const properties::Reach& reach) {
  return {{"holds_to", severity_json(reach.holds_to)},
          {"broken_at", severity_json(reach.broken_at)},
          {"replay", replay_json(reach.replay)}};
}

Json campaign_json(const CampaignReport& campaign) {
  const properties::CampaignResult& result = campaign.result;
  Json json = counts_json(result.counts, result.verdict);
  json["law"] = campaign.law->name;
  json["sentence"] = campaign.law->sentence;
  json["candidate"] = campaign.candidate;
  json["level"] = name(result.level);
  json["precision"] = name(campaign.precision);
  json["finding"] = name(campaign.finding);
  json["holds"] = campaign.finding == Finding::kHolds;
  const auto too_few = result.too_few_right();
  json["too_few_judged"] =
      campaign.finding == Finding::kTooFewJudged
          ? Json{{"quantity", info(too_few->first).name}, {"question", name(too_few->second)}}
          : Json(nullptr);
  json["explanations"] = explanations_json(campaign.explanations);
  json["quantities"] = tallies_json(result.verdict, campaign.precision);
  json["parts"] = Json::array();
  for (const auto& part : result.parts) json["parts"].push_back(part_json(part));
  json["frontier"] = Json::array();
  for (const Frontier& frontier : campaign.frontier) {
    Json entry = reach_json(frontier.candidate);
    entry["source"] = frontier.candidate.family->name;
    entry["baseline"] = reach_json(frontier.baseline);
    json["frontier"].push_back(std::move(entry));
  }
  if (result.failure) {
    json["replay"] = result.failure->replay;
    json["scene"] = properties::scene_text(result.failure->shrunk);
    json["discrepancies"] = Json::array();
    for (const auto& discrepancy : result.failure->verdict.worst(10)) {
      json["discrepancies"].push_back(discrepancy_json(discrepancy));
    }
  }
  return json;
}

}  // namespace

std::string properties_json(const PropertiesReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("properties");
  json["seed"] = report.seed ? Json(*report.seed) : Json(nullptr);
  json["cases"] = report.cases;
  json["interrupted"] = report.interrupted;
  json["baseline"] = report.baseline.empty() ? Json(nullptr) : Json(report.baseline);
  json["borrowed_bounds"] = Json::array();
  for (const BorrowedBounds& bounds : report.borrowed) {
    json["borrowed_bounds"].push_back(
        {{"candidate", bounds.candidate}, {"methods", bounds.methods}});
  }
  json["campaigns"] = Json::array();
  for (const CampaignReport& campaign : report.campaigns) {
    json["campaigns"].push_back(campaign_json(campaign));
  }
  json["strict"] = report.strict;
  json["fewest_right"] = properties::kFewestRight;
  json["failures"] = report.failures();
  json["held_against"] = ratchet_json(report.ratchet);
  return json_text(json);
}

}  // namespace raycheck::tools
