#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/run_control.h"
#include "properties/search/stress.h"
#include "tools/implementations/implementation.h"
#include "tools/report/view.h"
#include "tools/shards/units.h"
#include "tools/view/document.h"

namespace raycheck::tools {

struct StressOptions {
  std::vector<std::string> families;  ///< Names of sources; if empty, every source with severities.
  std::vector<Implementation> implementations;
  int cases = 200;  ///< The number of cases at each severity.
  std::uint64_t seed = 1;
  /// The first and the last severity; if empty, all severities of the source.
  std::optional<std::pair<int, int>> severities;
};

/// The results of one candidate on one source.
struct StressCurve {
  properties::Stage stage = properties::Stage::kRays;
  Implementation candidate;
  std::vector<int> severities;
  std::vector<properties::StressResult> results;  ///< One per severity.

  properties::Quantity quantity() const { return properties::main_quantity(stage); }
  /// The unit of that quantity's errors: "ulp", "u of float".
  std::string_view unit() const { return unit_name(quantity(), candidate.precision); }
  /// The tally of the main quantity within the stated domain at the k-th severity.
  const properties::Tally& tally(std::size_t k) const {
    return results[k].inside.tally(quantity());
  }
  /// The smallest severity at which the candidate is not stable within its stated domain.
  std::optional<int> first_failing() const;
  /// Whether anything was judged within the stated domain.
  bool is_judged() const;
  std::optional<double> worst_ratio() const;
  std::uint64_t left_out() const;
  std::optional<double> slope(int base) const;
  /// The answers that the candidate failed to give.
  properties::AnswersFailed failed() const;
};

struct FamilyReport {
  const properties::CaseSource* family;
  std::vector<StressCurve> curves;
};

struct StressReport {
  std::vector<FamilyReport> families;
  int cases = 0;
  std::uint64_t seed = 0;
  bool interrupted = false;

  bool all_stable() const;
  std::uint64_t compared() const;
};

/// Judges each stage of candidates separately, on sources at increasing severities. If a source has
/// more than properties::kMostSeverities severities, only some are judged. Throws
/// std::invalid_argument naming the field. If `units` is given, runs only the shard's missing
/// units, and returns an empty report unless the shard is the whole campaign.
StressReport run_stress(const StressOptions& options, const properties::RunControl& control = {},
                        Units* units = nullptr);

std::string stress_text(const StressReport& report, const ViewOptions& options);
std::string stress_json(const StressReport& report, const ViewOptions& options);
std::string stress_markdown(const StressReport& report, const ViewOptions& options);

inline constexpr View<StressReport> kStressViews[] = {
    {"text", stress_text},
    {"json", stress_json},
    {"markdown", stress_markdown},
};

/// Certificates of the first discrepancy of each kind at each severity, one per line.
std::string stress_certificates(const StressReport& report);

/// The candidates of one stage that are judged in one format, on a source.
ChartFacet stress_facet(const FamilyReport& family, properties::Stage stage,
                        scene::Precision precision);

/// A report as a page: error against severity, on each of its sources.
ViewDocument stress_document(const StressReport& report);

/// A source as a page: the error of each candidate at every severity and, at some severities, the
/// scene of the first cases on which the first candidate is worst. `is_of_methods`: whether panels
/// show only the steps of these methods.
/// Domain: options with one source; otherwise throws std::invalid_argument naming the field.
ViewDocument dial_document(const StressOptions& options, bool is_of_methods,
                           const properties::RunControl& control);

}  // namespace raycheck::tools
