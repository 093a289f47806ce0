#include "properties/cases/case_text.h"
#include "scene/number.h"
#include "tools/properties/properties.h"
#include "tools/report/json.h"

namespace raycheck::tools {

namespace {

using properties::Finding;

Json counts_json(const properties::CaseCounts& counts, const properties::Verdict& verdict) {
  return {{"cases", counts.cases},
          {"comparisons", verdict.compared()},
          {"discrepancies_by_standing", standings_json(verdict)},
          {"tolerated", verdict.tolerated()},
          {"tangents", verdict.fact(properties::Fact::kTangent).asked},
          {"tangents_missed", verdict.fact(properties::Fact::kTangent).asked -
                                  verdict.fact(properties::Fact::kTangent).right},
          {"missed_at_zero", verdict.fact(properties::Fact::kMissedAtZero).asked},
          {"left_out", counts.left_out},
          {"not_judged", counts.not_judged},
          {"given_rays", counts.given_rays},
          {"reason_left_out", text_or_null(counts.reason)}};
}

Json part_json(const properties::CampaignPart& part) {
  Json json = counts_json(part.counts, part.verdict);
  json["source"] = part.source.source->name;
  json["severity"] = or_null(part.source.severity);
  json["level"] = name(part.source.level());
  const properties::Break first = part.is_broken() ? part.breaks.front() : properties::Break{};
  json["replay"] = text_or_null(first.replay);
  json["defects"] = list_json(first.defects, kind_text);
  return json;
}

void add_failure(Json& json, const properties::Failure& failure) {
  json["replay"] = text_or_null(failure.replay);
  json["scene"] = properties::scene_text(failure.shrunk);
  json["discrepancies"] = list_json(failure.verdict.worst(10), discrepancy_json);
}

Json span_json(const properties::Span& span) { return hexfloats({span.least, span.greatest}); }

Json range_json(const properties::NumberRange& range) {
  return {{"number", range.name},
          {"value", scene::hexfloat(range.value)},
          {"least", scene::hexfloat(range.span.least)},
          {"greatest", scene::hexfloat(range.span.greatest)},
          {"any", range.is_any},
          {"by", range.certified == range.span ? "certificate" : "samples"},
          {"samples", range.samples},
          {"certified", or_null(range.certified, span_json)}};
}

Json ranges_json(const properties::Ranges& ranges) { return list_json(ranges.numbers, range_json); }

Json campaign_json(const CampaignReport& campaign) {
  const properties::CampaignResult& result = campaign.result;
  Json json = counts_json(result.counts, result.verdict);
  json["law"] = campaign.law->name;
  json["sentence"] = campaign.law->sentence;
  json["candidate"] = campaign.candidate;
  json["level"] = name(result.level);
  json["precision"] = name(campaign.precision);
  json["lengths"] = hexfloats({campaign.domain.smallest_length, campaign.domain.largest_length});
  json["finding"] = name(campaign.finding);
  json["holds"] = campaign.finding == Finding::kHolds;
  json["too_few_judged"] = campaign.finding == Finding::kTooFewJudged
                               ? or_null(result.too_few_right(), too_few_json)
                               : Json(nullptr);
  json["explanations"] = explanations_json(campaign.explanations);
  json["quantities"] = tallies_json(result.verdict, campaign.precision);
  json["parts"] = list_json(result.parts, part_json);
  if (campaign.worst) {
    json["worst"] = {{"random", campaign.worst->height_random},
                     {"climbed", campaign.worst->height_climbed},
                     {"scene", properties::scene_text(campaign.worst->the_case)}};
  }
  if (result.failure) {
    add_failure(json, *result.failure);
    json["ranges"] = or_null(campaign.ranges, ranges_json);
    json["numbers_not_tried"] = campaign.ranges ? campaign.ranges->not_tried : std::size_t{0};
  }
  if (!result.others.empty()) {
    json["others"] = list_json(result.others, [](const properties::Failure& failure) {
      Json other;
      add_failure(other, failure);
      return other;
    });
  }
  return json;
}

}  // namespace

std::string properties_json(const PropertiesReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("properties");
  json["seed"] = or_null(report.seed);
  json["cases"] = report.cases;
  json["interrupted"] = report.interrupted;
  json["borrowed_bounds"] = list_json(report.borrowed, [](const BorrowedBounds& bounds) {
    return Json{{"candidate", bounds.candidate}, {"methods", bounds.methods}};
  });
  if (report.target)
    json["target"] = properties::kClimbNames[static_cast<std::size_t>(*report.target)];
  if (!report.corpus.empty()) {
    json["corpus"] = list_json(report.corpus, [](const CorpusFinding& one) {
      return Json{{"file", one.file},           {"law", one.law},
                  {"candidate", one.candidate}, {"finding", name(one.finding)},
                  {"mended", one.is_mended()},  {"defects", list_json(one.defects, kind_text)}};
    });
  }
  json["campaigns"] = list_json(report.campaigns, campaign_json);
  json["strict"] = report.strict;
  json["fewest_right"] = properties::kFewestRight;
  json["failures"] = report.failures();
  json["held_against"] = ratchet_json(report.ratchet);
  return json_text(json);
}

}  // namespace raycheck::tools
