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
  std::string scene;  ///< Empty: cases of sources, at least one.
  std::optional<scene::Dialect> dialect;
  std::vector<properties::ChosenSource> sources;
  bool all_families = false;  ///< Instead of `sources`.
  std::vector<Implementation> implementations;
  int cases = 20000;
  std::uint64_t seed = 1;
};

/// Nanoseconds per item: the median of the repetitions, and the range of their middle half.
struct Duration {
  double median = 0;
  double low = 0;
  double high = 0;
};

/// The comparisons within a method's stated domain.
using Tallies = std::map<properties::Quantity, properties::Tally>;

/// The run time and the errors of one method.
struct MethodCost {
  properties::Stage stage = properties::Stage::kRays;
  Implementation method;
  properties::Promises promises;  ///< The bounds on its errors.
  properties::StressResult accuracy;
  /// The parts by source and severity.
  std::vector<std::vector<Tallies>> by_severity;
  std::optional<Duration> scalar;  ///< One call per item; empty: see `not_timed`.
  std::optional<Duration> batch;
  std::string not_timed;
  std::vector<std::string> unstable_on;  ///< Sources; empty: stable on all of them.
  bool pareto = false;                   ///< No other method is as fast and as accurate.
  bool is_called_here = false;           ///< External, timed in raycheck's process.

  properties::Quantity quantity() const { return properties::main_quantity(stage); }
  std::string_view unit() const { return unit_name(quantity(), promises.precision); }
  /// Errors by which methods are ranked: decisions wrong without an excuse per decision, then the
  /// 99.9% error, for every format in u or ulp of doubles. Empty if nothing was judged in the
  /// stated domain.
  std::optional<std::pair<double, double>> badness() const;
};

inline bool has_any(const std::vector<MethodCost>& costs, scene::Precision precision) {
  return std::ranges::any_of(
      costs, [=](const MethodCost& cost) { return cost.promises.precision == precision; });
}

/// The method whose batch time ratios refer to: the first that was timed; null if none was.
const MethodCost* baseline(const std::vector<MethodCost>& costs);

/// Cases that belong together.
struct JudgedSource {
  std::string name = {};          ///< "distance", "distance@3", or the scene.
  std::string_view meaning = {};  ///< The meaning of its severities; empty: none.
  /// The first severity of each stretch that is reported; one entry if there are none.
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

/// The subject in a title; of many sources only the number.
std::string subject_text(const TradeoffReport& report);

/// Judges and times methods on the same inputs. Throws std::invalid_argument naming the field, and
/// as the reader of scenes.
TradeoffReport run_tradeoff(const TradeoffOptions& options,
                            const properties::RunControl& control = {});

/// Times every method's calls on the items of the cases, one by one and in batches, taking turns in
/// every repetition, so that disturbances of the machine affect all of them. A batch is timed only
/// when its answers are those of single calls, bit for bit. Fills in `scalar`, `batch` and
/// `not_timed`. Items: rays and spheres of the cases for an intersection method, pixels for a ray
/// method; only those in the method's stated domain.
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

/// A report as a page: error against run time, on all of its sources together and on each.
ViewDocument tradeoff_document(const TradeoffReport& report);

/// The Pareto front of points (time, error): the indices of points whose error is below that of all
/// at least as fast, the fastest first; of equal points the first.
std::vector<std::size_t> pareto_front(const std::vector<std::pair<double, double>>& points);

}  // namespace raycheck::tools
