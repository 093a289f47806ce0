#include <fmt/core.h>

#include "tools/stress/stress.h"

namespace raycheck::tools {

using properties::Stage;

ChartFacet stress_facet(const FamilyReport& family, Stage stage, scene::Precision precision) {
  ChartFacet facet{.subject = std::string(family.family->name),
                   .stage = chart_stage(stage, precision),
                   .meaning = std::string(family.family->severities->meaning),
                   .quantities = chart_quantities(stage),
                   .precision = precision};
  for (const StressCurve& curve : family.curves) {
    if (curve.stage != stage) continue;
    ChartSeries series{.name = curve.candidate.name, .number = curve.candidate.number};
    if (curve.candidate.precision != precision || !curve.is_judged()) continue;
    if (facet.severities.empty()) {
      for (const int severity : curve.severities) {
        facet.severities.push_back(std::to_string(severity));
      }
    }
    for (const properties::StressResult& result : curve.results) {
      series.points.push_back(chart_point(result.inside.tallies(), facet.quantities));
    }
    series.points.resize(curve.severities.size());  // only those before an interrupt
    facet.series.push_back(std::move(series));
  }
  return facet;
}

ViewDocument stress_document(const StressReport& report) {
  ViewDocument document;
  document.title = report.families.size() == 1
                       ? fmt::format("Error against severity: {}", report.families[0].family->name)
                       : fmt::format("Error against severity: {} sources", report.families.size());
  std::vector<ChartFacet>& facets = document.chart.emplace().facets;
  for (const Stage stage : {Stage::kIntersection, Stage::kRays}) {
    for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
      for (const FamilyReport& family : report.families) {
        ChartFacet facet = stress_facet(family, stage, precision);
        if (!facet.series.empty()) facets.push_back(std::move(facet));
      }
    }
  }
  return document;
}

}  // namespace raycheck::tools
