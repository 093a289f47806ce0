#include "tools/view/chart/chart.h"

#include <fmt/core.h>

#include <cctype>

#include "tools/report/words.h"

namespace raycheck::tools {

using properties::Quantity;
using properties::Stage;
using properties::Tally;

namespace {

Json errors_json(const ChartPoint::Errors& errors) {
  return {{"compared", errors.compared},
          {"at", list_json(errors.at, error_json)},
          {"told", list_json(errors.at, error_text)},
          {"front", errors.is_front}};
}

/// A mark for wrong decisions, and its meaning.
struct Mark {
  const char *standing, *text;
};
constexpr Mark kRight = {"right", "every decision right"};
constexpr Mark kExcused = {"excused", "wrong decisions, all excused by rounding of the inputs"};
constexpr Mark kDefect = {"defect", "wrong decisions without an excuse"};

const Mark& mark_of(const ChartPoint& point) {
  return point.defects > 0 ? kDefect : point.wrong > 0 ? kExcused : kRight;
}

std::string decisions_text(const ChartPoint& point) {
  std::string text = fmt::format("{} of {} decisions wrong", point.wrong, point.decisions);
  if (point.wrong > 0) text += fmt::format(", {} of them without an excuse", point.defects);
  return text;
}

Json point_json(const std::optional<ChartPoint>& point) {
  return or_null(point, [](const ChartPoint& its) {
    return Json{{"decisions", its.decisions},  {"wrong", its.wrong},
                {"defects", its.defects},      {"standing", mark_of(its).standing},
                {"text", decisions_text(its)}, {"errors", list_json(its.errors, errors_json)}};
  });
}

Json time_json(const ChartTime& time) {
  return {{"ratio", time.ratio},
          {"low", time.low},
          {"high", time.high},
          {"ns", time.nanoseconds},
          {"told", fmt::format("{:.3g}", time.ratio)}};
}

/// Remarks on a candidate's run time, if other candidates have one.
std::string time_text(const ChartSeries& series, const ChartFacet& facet) {
  if (facet.baseline.empty()) return {};
  if (!series.time) return series.note.empty() ? "not timed" : series.note;
  const auto& [ratio, low, high, nanoseconds] = *series.time;
  std::string text = fmt::format(
      "{:.3g} times the run time of {} (middle half {:.3g} to {:.3g}; {:.3g} ns an item)", ratio,
      facet.baseline, low, high, nanoseconds);
  return series.note.empty() ? text : text + ", " + series.note;
}

Json series_json(const ChartSeries& series, const ChartFacet& facet) {
  auto points = series.points;
  if (!facet.baseline.empty()) points.insert(points.begin(), series.whole);
  return {{"name", series.name},
          {"number", series.number},
          {"time", or_null(series.time, time_json)},
          {"text", time_text(series, facet)},
          {"points", list_json(points, point_json)}};
}

/// The condition number of the problem at a severity; it is the same for every candidate that was
/// compared.
Json condition_json(const ChartFacet& facet, std::size_t severity, std::size_t quantity,
                    std::size_t share) {
  for (const ChartSeries& series : facet.series) {
    const auto& point = series.points[severity];
    const auto condition = point ? point->errors[quantity].condition[share] : std::nullopt;
    if (condition) return error_json(condition);
  }
  return nullptr;
}

/// The condition numbers for each quantity, share and severity.
Json conditions_json(const ChartFacet& facet) {
  Json json = Json::array();
  for (std::size_t quantity = 0; quantity < facet.quantities.size(); ++quantity) {
    json.push_back(Json::array());
    for (std::size_t share = 0; share < kChartShares.size(); ++share) {
      json.back().push_back(Json::array());
      for (std::size_t severity = 0; severity < facet.severities.size(); ++severity) {
        json.back().back().push_back(condition_json(facet, severity, quantity, share));
      }
    }
  }
  return json;
}

Json facet_json(const ChartFacet& facet) {
  const bool is_timed = !facet.baseline.empty();
  std::vector<std::string> severities = facet.severities;
  if (is_timed) severities.insert(severities.begin(), "all");
  const auto quantity_json = [&](Quantity quantity) {
    const std::string_view name = info(quantity).name;
    return Json{{"name", name},
                {"error", fmt::format("{}{}", name, name.ends_with("error") ? "" : " error")},
                {"unit", unit_name(quantity, facet.precision)}};
  };
  return {{"title", fmt::format("{} on {}", facet.stage, facet.subject)},
          {"subject", facet.subject},
          {"stage", facet.stage},
          {"severities", std::move(severities)},
          {"baseline", facet.baseline},
          {"under", is_timed ? fmt::format("run time, divided by that of {}", facet.baseline)
                             : fmt::format("severity: {}", facet.meaning)},
          {"key", is_timed ? "Steps: no faster method without defects has as small an error"
                           : "kappa: how much the problem magnifies errors of the inputs"},
          {"quantities", list_json(facet.quantities, quantity_json)},
          {"condition", conditions_json(facet)},
          {"series", list_json(facet.series,
                               [&](const ChartSeries& one) { return series_json(one, facet); })}};
}

}  // namespace

std::vector<Quantity> chart_quantities(Stage stage) {
  if (stage == Stage::kRays) return {Quantity::kDirection, Quantity::kPixelPoint};
  return {Quantity::kParameter, Quantity::kBackwardError};
}

std::string chart_stage(Stage stage, scene::Precision precision) {
  std::string text = fmt::format("{}{}", name(stage), precision_words(precision));
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::optional<ChartPoint> chart_point(const std::map<Quantity, Tally>& tallies,
                                      const std::vector<Quantity>& quantities) {
  ChartPoint point;
  std::uint64_t compared = 0;
  for (const auto& [quantity, tally] : tallies) {
    compared += tally.cases;
    if (is_decision(quantity)) {
      point.decisions += tally.cases;
      point.wrong += tally.wrong_answers();
    }
    point.defects += tally.count(properties::Outcome::kWrongDecision);
  }
  if (compared == 0) return std::nullopt;
  for (const Quantity quantity : quantities) {
    ChartPoint::Errors& errors = point.errors.emplace_back();
    const auto found = tallies.find(quantity);
    if (found == tallies.end()) continue;
    const Tally& tally = found->second;
    errors.compared = tally.errors.count();
    for (std::size_t k = 0; k < kChartShares.size(); ++k) {
      const bool is_last = k + 1 == kChartShares.size();
      errors.at[k] = is_last ? tally.max() : tally.quantile(kChartShares[k].share);
      errors.condition[k] = tally.condition_quantile(kChartShares[k].share);
    }
  }
  return point;
}

Json chart_json(const ChartView& chart) {
  return {{"shares", list_json(kChartShares, [](const ChartShare& share) { return share.name; })},
          {"share", chart.share},
          {"key", list_json(std::array{kRight, kExcused, kDefect},
                            [](const Mark& mark) {
                              return Json{{"standing", mark.standing}, {"text", mark.text}};
                            })},
          {"facets", list_json(chart.facets, facet_json)}};
}

}  // namespace raycheck::tools
