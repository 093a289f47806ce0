#include "tools/view/chart_json.h"

#include <nlohmann/json.hpp>

namespace raycheck::tools {
namespace {

Json quantiles_json(const ChartQuantiles& quantiles) {
  Json json = Json::array();
  for (const std::optional<double>& error : quantiles) json.push_back(error_json(error));
  return json;
}

Json errors_json(const ChartPoint::Errors& errors) {
  return {{"compared", errors.compared},
          {"at", quantiles_json(errors.at)},
          {"condition", quantiles_json(errors.condition)},
          {"front", errors.is_front}};
}

Json point_json(const std::optional<ChartPoint>& point) {
  if (!point) return nullptr;
  Json json = {
      {"decisions", point->decisions}, {"wrong", point->wrong}, {"defects", point->defects}};
  json["errors"] = Json::array();
  for (const ChartPoint::Errors& errors : point->errors) {
    json["errors"].push_back(errors_json(errors));
  }
  return json;
}

Json series_json(const ChartSeries& series) {
  Json json = {{"name", series.name}, {"number", series.number}, {"time", nullptr}};
  if (series.time) {
    json["time"] = {{"ratio", series.time->ratio},
                    {"low", series.time->low},
                    {"high", series.time->high},
                    {"ns", series.time->nanoseconds}};
  }
  json["note"] = series.note;
  json["whole"] = point_json(series.whole);
  json["points"] = Json::array();
  for (const auto& point : series.points) json["points"].push_back(point_json(point));
  return json;
}

Json facet_json(const ChartFacet& facet) {
  Json json = {{"subject", facet.subject},
               {"stage", facet.stage},
               {"meaning", facet.meaning},
               {"severities", facet.severities},
               {"baseline", facet.baseline}};
  json["quantities"] = Json::array();
  for (const properties::Quantity quantity : facet.quantities) {
    json["quantities"].push_back(
        {{"name", info(quantity).name}, {"unit", unit_name(quantity, facet.precision)}});
  }
  json["series"] = Json::array();
  for (const ChartSeries& series : facet.series) json["series"].push_back(series_json(series));
  return json;
}

}  // namespace

Json chart_json(const ChartView& chart) {
  Json json;
  json["shares"] = Json::array();
  for (const ChartShare& share : kChartShares) json["shares"].push_back(share.name);
  json["share"] = kChartShare;
  json["facets"] = Json::array();
  for (const ChartFacet& facet : chart.facets) json["facets"].push_back(facet_json(facet));
  return json;
}

}  // namespace raycheck::tools
