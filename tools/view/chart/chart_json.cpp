#include "tools/view/chart/chart_json.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

Json quantiles_json(const ChartQuantiles& quantiles) {
  Json json = Json::array();
  for (const std::optional<double>& error : quantiles) json.push_back(error_json(error));
  return json;
}

Json errors_json(const ChartPoint::Errors& errors) {
  Json told = Json::array();
  for (const std::optional<double>& error : errors.at) told.push_back(error_text(error));
  return {{"compared", errors.compared},
          {"at", quantiles_json(errors.at)},
          {"told", std::move(told)},
          {"front", errors.is_front}};
}

/// A mark that says which decisions are wrong, and what it says.
struct Mark {
  const char *standing, *text;
};
constexpr Mark kRight = {"right", "every decision right"};
constexpr Mark kExcused = {"excused", "wrong ones, all within rounding of the inputs"};
constexpr Mark kDefect = {"defect", "wrong without an excuse"};

const Mark& mark_of(const ChartPoint& point) {
  return point.defects > 0 ? kDefect : point.wrong > 0 ? kExcused : kRight;
}

std::string decisions_text(const ChartPoint& point) {
  std::string text = fmt::format("{} of {} decisions wrong", point.wrong, point.decisions);
  if (point.wrong > 0) text += fmt::format(", {} of them without an excuse", point.defects);
  return text;
}

Json point_json(const std::optional<ChartPoint>& point) {
  if (!point) return nullptr;
  Json json = {{"decisions", point->decisions},
               {"wrong", point->wrong},
               {"defects", point->defects},
               {"standing", mark_of(*point).standing},
               {"text", decisions_text(*point)}};
  json["errors"] = Json::array();
  for (const ChartPoint::Errors& errors : point->errors) {
    json["errors"].push_back(errors_json(errors));
  }
  return json;
}

/// What there is to say of a method's run time, where others have one.
std::string time_text(const ChartSeries& series, const ChartFacet& facet) {
  if (facet.baseline.empty()) return {};
  if (!series.time) return series.note.empty() ? "no run time was taken" : series.note;
  const auto& [ratio, low, high, nanoseconds] = *series.time;
  std::string text = fmt::format(
      "{:.3g} times the run time of {} (middle half {:.3g} to {:.3g}; {:.3g} ns an item)", ratio,
      facet.baseline, low, high, nanoseconds);
  return series.note.empty() ? text : text + ", " + series.note;
}

Json series_json(const ChartSeries& series, const ChartFacet& facet) {
  Json json = {{"name", series.name}, {"number", series.number}, {"time", nullptr}};
  if (series.time) {
    json["time"] = {{"ratio", series.time->ratio},
                    {"low", series.time->low},
                    {"high", series.time->high},
                    {"ns", series.time->nanoseconds},
                    {"told", fmt::format("{:.3g}", series.time->ratio)}};
  }
  json["text"] = time_text(series, facet);
  json["points"] = Json::array();
  if (!facet.baseline.empty()) json["points"].push_back(point_json(series.whole));
  for (const auto& point : series.points) json["points"].push_back(point_json(point));
  return json;
}

/// Of each quantity, share and severity what the problem magnifies errors by: the same for every
/// method that was compared there.
Json condition_json(const ChartFacet& facet) {
  Json json = Json::array();
  for (std::size_t quantity = 0; quantity < facet.quantities.size(); ++quantity) {
    Json& shares = json.emplace_back(Json::array());
    for (std::size_t share = 0; share < kChartShares.size(); ++share) {
      Json& severities = shares.emplace_back(Json::array());
      for (std::size_t k = 0; k < facet.severities.size(); ++k) {
        std::optional<double> found;
        for (const ChartSeries& series : facet.series) {
          const auto& point = series.points[k];
          if (!found && point) found = point->errors[quantity].condition[share];
        }
        severities.push_back(error_json(found));
      }
    }
  }
  return json;
}

Json facet_json(const ChartFacet& facet) {
  const bool is_timed = !facet.baseline.empty();
  std::vector<std::string> severities = facet.severities;
  if (is_timed) severities.insert(severities.begin(), "all");
  Json json = {{"title", chart_title(facet)}, {"subject", facet.subject},
               {"stage", facet.stage},        {"severities", std::move(severities)},
               {"baseline", facet.baseline},  {"under", chart_under(facet)},
               {"key", chart_key(facet)}};
  json["quantities"] = Json::array();
  for (const properties::Quantity quantity : facet.quantities) {
    json["quantities"].push_back({{"name", info(quantity).name},
                                  {"error", chart_error(quantity)},
                                  {"unit", unit_name(quantity, facet.precision)}});
  }
  json["condition"] = condition_json(facet);
  json["series"] = Json::array();
  for (const ChartSeries& series : facet.series)
    json["series"].push_back(series_json(series, facet));
  return json;
}

}  // namespace

Json chart_json(const ChartView& chart) {
  Json json;
  json["shares"] = Json::array();
  for (const ChartShare& share : kChartShares) json["shares"].push_back(share.name);
  json["share"] = chart.share;
  json["key"] = Json::array();
  for (const Mark& mark : {kRight, kExcused, kDefect}) {
    json["key"].push_back({{"standing", mark.standing}, {"text", mark.text}});
  }
  json["facets"] = Json::array();
  for (const ChartFacet& facet : chart.facets) json["facets"].push_back(facet_json(facet));
  return json;
}

}  // namespace raycheck::tools
