#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "properties/run_control.h"
#include "properties/search/stress.h"
#include "scene/files/scene_file.h"
#include "tools/implementations/implementation.h"
#include "tools/report/view.h"
#include "tools/view/document.h"

namespace raycheck::tools {

struct TradeoffOptions {
  std::string scene;  ///< If empty, cases of at least one source are used.
  const scene::FileFormat* read_as = nullptr;
  std::vector<properties::ChosenSource> sources;
  bool all_families = false;  ///< Use all sources instead of `sources`.
  std::vector<Implementation> implementations;
  int cases = 20000;
  std::uint64_t seed = 1;
};

/// Nanoseconds per item: the median and the quartiles of the repetitions.
struct Duration {
  double median = 0;
  double low = 0;
  double high = 0;
};

/// The comparisons within a candidate's stated domain.
using Tallies = std::map<properties::Quantity, properties::Tally>;

/// The run time and the errors of one candidate.
struct MethodCost {
  properties::Stage stage = properties::Stage::kRays;
  Implementation candidate;
  properties::Promises promises;  ///< Its promises, with the bounds on its errors.
  properties::StressResult accuracy;
  /// The comparisons by source, and by severity (see JudgedSource).
  std::vector<std::vector<Tallies>> by_severity;
  /// The time of one call per item; if empty, `not_timed` gives the reason.
  std::optional<Duration> scalar;
  std::optional<Duration> batch;
  std::string not_timed;
  /// Names of sources; empty if it is stable on all of them.
  std::vector<std::string> unstable_on;
  /// Whether no other candidate is at least as fast and at least as accurate.
  bool pareto = false;
  bool is_called_here = false;  ///< Whether it is external and was timed in raycheck's process.

  properties::Quantity quantity() const { return properties::main_quantity(stage); }
  std::string_view unit() const { return unit_name(quantity(), promises.precision); }
  /// The errors by which candidates are ranked: first the share of decisions that are wrong without
  /// an excuse, then the 99.9% error, in u or ulp of doubles for every format. Empty if nothing was
  /// judged in the stated domain.
  std::optional<std::pair<double, double>> badness() const;
};

inline bool has_any(const std::vector<MethodCost>& costs, scene::Precision precision) {
  return std::ranges::any_of(
      costs, [=](const MethodCost& cost) { return cost.promises.precision == precision; });
}

/// The first candidate that was timed; ratios are relative to its batch time. Null if none was
/// timed.
const MethodCost* baseline(const std::vector<MethodCost>& costs);

/// A source of the report, or the scene.
struct JudgedSource {
  std::string name = {};          ///< "distance", "distance@3", or the scene.
  std::string_view meaning = {};  ///< The meaning of its severities; empty if it has none.
  /// The first severity of each stretch that is reported together; one entry if there are no
  /// severities.
  std::vector<int> severities = {0};
  int last = 0;  ///< Severity.

  std::size_t stretch_of(int severity) const;
};

struct TradeoffReport {
  std::string subject;  ///< The scene or the sources.
  std::uint64_t cases = 0;
  std::uint64_t seed = 0;
  std::vector<JudgedSource> sources;
  std::vector<MethodCost> rays;
  std::vector<MethodCost> intersections;
  std::vector<std::string> left_out;
  std::vector<std::string> warnings;
  bool interrupted = false;

  std::uint64_t compared() const;
};

/// The subject for a title; if there are many sources, only their number.
std::string subject_text(const TradeoffReport& report);

/// Judges and times candidates on the same inputs. Throws std::invalid_argument naming the field,
/// and what the reader of scenes throws.
TradeoffReport run_tradeoff(const TradeoffOptions& options,
                            const properties::RunControl& control = {});

/// Times every candidate's calls on the items of the cases, one by one and in batches. The
/// candidates take turns in every repetition, so that disturbances of the machine affect all of
/// them. A batch is timed only if its answers are those of single calls, bit for bit. Fills in
/// `scalar`, `batch` and `not_timed`. Items are pairs of a ray and a sphere for intersections, and
/// pixels for rays; only items in the candidate's stated domain are used.
void time_intersections(const std::vector<properties::Case>& cases, std::vector<MethodCost>& costs);
void time_rays(const std::vector<properties::Case>& cases, std::vector<MethodCost>& costs);

std::string tradeoff_text(const TradeoffReport& report, const ViewOptions& options);
std::string tradeoff_json(const TradeoffReport& report, const ViewOptions& options);
std::string tradeoff_markdown(const TradeoffReport& report, const ViewOptions& options);

inline constexpr View<TradeoffReport> kTradeoffViews[] = {
    {"text", tradeoff_text},
    {"json", tradeoff_json},
    {"markdown", tradeoff_markdown},
};

/// A report as a page: error against run time, on all its sources together and on each source.
ViewDocument tradeoff_document(const TradeoffReport& report);

/// The Pareto front of points (time, error): the indices of the points whose error is below that of
/// every point that is at least as fast. The fastest comes first; of equal points, only the first
/// is included.
std::vector<std::size_t> pareto_front(const std::vector<std::pair<double, double>>& points);

}  // namespace raycheck::tools
