#include "tools/report/json.h"
#include "tools/tradeoff/tradeoff.h"

namespace raycheck::tools {
namespace {

Json duration_json(const Duration& duration) {
  return {{"median_ns", duration.median},
          {"quartile_ns", duration.low},
          {"upper_quartile_ns", duration.high}};
}

Json cost_json(const MethodCost& cost) {
  Json json;
  json["name"] = cost.candidate.name;
  json["isolated_by"] = text_or_null(cost.candidate.isolated_by);
  json["bounds_of"] = text_or_null(cost.candidate.bounds_of);
  json["called_in_process"] = cost.is_called_here;
  json["pareto"] = cost.pareto;
  json["call"] = or_null(cost.scalar, duration_json);
  json["batch"] = or_null(cost.batch, duration_json);
  json["note"] = cost.not_timed;
  json["unstable_on"] = cost.unstable_on;
  const scene::Precision precision = cost.promises.precision;
  json["precision"] = name(precision);
  json["left_out"] = cost.accuracy.left_out;
  json["inside"] = tallies_json(cost.accuracy.inside, precision);
  json["outside"] = tallies_json(cost.accuracy.outside, precision);
  return json;
}

}  // namespace

std::string tradeoff_json(const TradeoffReport& report, const ViewOptions& /*options*/) {
  Json json = json_header("tradeoff");
  json["interrupted"] = report.interrupted;
  json["subject"] = report.subject;
  json["cases"] = report.cases;
  json["seed"] = report.seed;
  json["stable_ratio"] = properties::kStableRatio;
  json["rays"] = list_json(report.rays, cost_json);
  json["intersections"] = list_json(report.intersections, cost_json);
  json["left_out"] = report.left_out;
  return json_text(json);
}

}  // namespace raycheck::tools
