#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <utility>

#include "properties/cases/random.h"
#include "scene/interruption.h"
#include "scene/invalid_input.h"
#include "tools/report/words.h"
#include "tools/stress/stress.h"
#include "tools/view/scene_view.h"

namespace raycheck::tools {
namespace {

using properties::Stage;
using properties::StressResult;

/// The number of severities, evenly spaced, that are shown as scenes.
constexpr int kMostScenes = 18;
/// The number of cases tried per severity; the scene shows the worst.
constexpr int kCasesTried = 20;

/// A measure of how bad answers are. Wrong decisions count more than errors.
double badness(const StressResult& result, properties::Quantity quantity) {
  return properties::defects(result.inside) > 0 ? HUGE_VAL
                                                : result.inside.tally(quantity).max().value_or(-1);
}

/// The place where the main quantity, or a decision, is worst.
properties::Place worst_place(const StressResult& result, properties::Quantity quantity) {
  const auto worst = result.inside.worst(1);
  if (!worst.empty()) return worst.front().place;
  return result.inside.tally(quantity).worst_place;
}

struct ShownCase {
  properties::Case the_case;
  properties::Place place;
  std::optional<properties::Discrepancy> wrong;  ///< The candidate's defect there, if any.
};

/// Of the first cases at a severity, the one on which a candidate is worst. Empty if nothing was
/// judged.
ShownCase worst_of_first(const properties::CaseSource& family, int severity,
                         const StressCurve& curve, std::uint64_t seed) {
  const std::vector<properties::Candidate> candidate = {in_random_cases(curve.candidate.make())};
  const properties::Quantity quantity = properties::main_quantity(curve.stage);
  properties::Random seeds(seed + static_cast<std::uint64_t>(severity));
  ShownCase shown;
  double worst = -2;
  for (int k = 0; k < kCasesTried; ++k) {
    properties::Case the_case = family.make(severity, seeds.bits());
    std::vector<StressResult> results(1);
    properties::stress(the_case, curve.stage, candidate, results);
    const double bad = badness(results.front(), quantity);
    if (bad <= worst) continue;
    worst = bad;
    properties::Place place = worst_place(results.front(), quantity);
    // For intersections, the case has the camera's rays, one for each pixel.
    if (the_case.scene.camera && !place.pixel && place.ray < the_case.pixels.size()) {
      place.pixel = the_case.pixels[place.ray];
    }
    shown = {std::move(the_case), place, {}};
    const auto wrong = results.front().inside.worst(1);
    if (!wrong.empty() && wrong.front().excuse.standing() == properties::Standing::kDefect) {
      shown.wrong = wrong.front();
    }
  }
  return shown;
}

FindingView finding_of(const ShownCase& shown, int severity, const std::string& method) {
  return {.sentence = fmt::format("severity {}: {} {}", severity, info(shown.wrong->quantity).name,
                                  wrongness_text(*shown.wrong)),
          .candidate = method,
          .method = method,
          .selection = selection_of(shown.place, shown.the_case.scene)};
}

/// A facet restricted to some of its severities.
ChartFacet of_severities(ChartFacet facet, const std::vector<int>& chosen) {
  const auto keep = [&](auto& list) {
    std::decay_t<decltype(list)> kept;
    for (const int k : chosen) kept.push_back(std::move(list[static_cast<std::size_t>(k)]));
    list = std::move(kept);
  };
  keep(facet.severities);
  for (ChartSeries& series : facet.series) keep(series.points);
  return facet;
}

}  // namespace

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

ViewDocument dial_document(const StressOptions& options, bool is_of_methods,
                           const properties::RunControl& control) {
  if (options.families.size() != 1) {
    throw scene::InvalidInput("family", "", "give one source");
  }
  const StressReport report = run_stress(options, control);
  if (report.interrupted) throw scene::Interrupted();
  const FamilyReport& family = report.families.front();
  if (family.curves.empty()) {
    throw scene::InvalidInput("method", "", "this source has no questions for the given methods");
  }
  // The stage that the source tests: intersections if it has spheres to intersect.
  const properties::Stage stage = family.curves.back().stage;
  ViewDocument document;
  document.title = std::string(family.family->name);
  DialView dial;
  dial.sentence = fmt::format("{}; severity is {}", family.family->sentence,
                              family.family->severities->meaning);
  SceneViewOptions view;
  view.is_of_methods = is_of_methods;
  const StressCurve* first = nullptr;
  for (const StressCurve& curve : family.curves) {
    if (curve.stage != stage) continue;
    if (first == nullptr) first = &curve;
    show(curve.candidate, view);
  }
  dial.sentence +=
      fmt::format("; scenes: at each severity, the one of the first {} cases on which {} is worst",
                  kCasesTried, first->candidate.name);
  const std::vector<int>& severities = family.curves.back().severities;
  const auto chosen =
      properties::some_severities(0, static_cast<int>(severities.size()) - 1, kMostScenes);
  ChartFacet facet = stress_facet(family, stage, first->candidate.precision);
  document.chart = ChartView{{of_severities(std::move(facet), chosen)}, kChartShares.size() - 1};
  view.limits.panel_bytes = kPanelBytes / chosen.size();
  for (const int k : chosen) {
    if (control.interrupted()) break;
    const int severity = severities[static_cast<std::size_t>(k)];
    const ShownCase shown = worst_of_first(*family.family, severity, *first, options.seed);
    view.name = fmt::format("{}@{}", document.title, severity);
    view.file = view.name + ".toml";
    view.wanted = selections_of(shown.the_case, shown.place);
    if (shown.wrong) {
      document.findings.push_back(finding_of(shown, severity, first->candidate.name));
      document.findings.back().scene = document.scenes.size();
    }
    dial.scenes.push_back(document.scenes.size());
    document.scenes.push_back(view_of(shown.the_case.scene, view, document.left_out, control));
  }
  document.found = std::to_string(document.findings.size());
  document.dial = std::move(dial);
  return document;
}

}  // namespace raycheck::tools
