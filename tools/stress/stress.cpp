#include "tools/stress/stress.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace raycheck::tools {
namespace {

using properties::CaseSource;
using properties::Stage;
using properties::StressResult;
using properties::Verdict;

std::vector<const CaseSource*> chosen_families(const std::vector<std::string>& names) {
  std::vector<const CaseSource*> families;
  std::string known;
  for (const CaseSource& source : properties::case_sources()) {
    if (!source.dial) continue;
    if (names.empty()) families.push_back(&source);
    known += (known.empty() ? "" : ", ") + std::string(source.name);
  }
  for (const std::string& name : names) {
    const CaseSource* const family = properties::find_case_source(name);
    if (family == nullptr || !family->dial) {
      throw std::invalid_argument("family " + name + ": no such family; the families are " + known);
    }
    if (std::find(families.begin(), families.end(), family) == families.end()) {
      families.push_back(family);
    }
  }
  return families;
}

std::pair<int, int> range_of(const CaseSource& family, const StressOptions& options) {
  const int highest = family.dial->highest;
  if (!options.severities) return {0, highest};
  const auto [from, to] = *options.severities;
  return {from, std::min(to, highest)};
}

/// Requires that every family has the first severity asked for, and one family the last.
void require_severities(const std::vector<const CaseSource*>& families,
                        const StressOptions& options) {
  if (!options.severities || families.empty()) return;
  const auto [from, to] = *options.severities;
  const auto by_highest = [](const CaseSource* a, const CaseSource* b) {
    return a->dial->highest < b->dial->highest;
  };
  const auto [fewest, most] = std::minmax_element(families.begin(), families.end(), by_highest);
  const CaseSource* const beyond = from > (*fewest)->dial->highest ? *fewest
                                   : to > (*most)->dial->highest   ? *most
                                                                   : nullptr;
  if (beyond == nullptr) return;
  throw std::invalid_argument(fmt::format("severity {}..{}: the severities of {} are 0..{}", from,
                                          to, beyond->name, beyond->dial->highest));
}

std::vector<int> severities_of(const CaseSource& family, const StressOptions& options) {
  const auto [from, to] = range_of(family, options);
  return properties::some_severities(from, to);
}

/// The stages that a family's cases can judge.
std::vector<Stage> stages_of(const CaseSource& family) {
  if (family.has_camera) return {Stage::kRays, Stage::kIntersection};
  return {Stage::kIntersection};
}

std::vector<StressCurve> run_stage(const CaseSource& family, Stage stage,
                                   const StressOptions& options,
                                   const properties::RunControl& control) {
  std::vector<StressCurve> curves;
  std::vector<properties::Candidate> candidates;
  const std::vector<int> severities = severities_of(family, options);
  for (const Implementation& method : options.implementations) {
    if (!method.offers(stage)) continue;
    curves.push_back({stage, method, severities, {}});
    candidates.push_back(method.make());
  }
  if (curves.empty()) return curves;
  properties::StressOptions each;
  each.cases = options.cases;
  for (const int severity : severities) {
    if (control.interrupted()) break;
    control.progress(
        fmt::format("{} at severity {} of {}", family.name, severity, severities.back()));
    each.seed = options.seed + static_cast<std::uint64_t>(severity);
    std::vector<StressResult> results =
        stress({&family, severity}, stage, candidates, each, control);
    for (std::size_t k = 0; k < curves.size(); ++k) {
      curves[k].results.push_back(std::move(results[k]));
    }
  }
  return curves;
}

}  // namespace

bool StressCurve::is_judged() const {
  return std::any_of(results.begin(), results.end(),
                     [](const StressResult& result) { return result.inside.compared() > 0; });
}

std::optional<int> StressCurve::first_failing() const {
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (!is_stable(results[k].inside)) return severities[k];
  }
  return std::nullopt;
}

std::optional<double> StressCurve::worst_ratio() const {
  std::optional<double> worst;
  for (const StressResult& result : results) {
    worst = std::max(worst, properties::worst_ratio(result.inside));
  }
  return worst;
}

std::uint64_t StressCurve::left_out() const {
  std::uint64_t sum = 0;
  for (const StressResult& result : results) sum += result.left_out;
  return sum;
}

std::optional<double> StressCurve::slope(int base) const {
  std::vector<double> errors;
  for (std::size_t k = 0; k < results.size(); ++k) {
    errors.push_back(tally(k).quantile(0.999).value_or(0));
  }
  return properties::error_slope(base, severities, errors);
}

bool StressReport::all_stable() const {
  for (const FamilyReport& family : families) {
    for (const StressCurve& curve : family.curves) {
      if (curve.first_failing()) return false;
    }
  }
  return true;
}

std::uint64_t StressReport::compared() const {
  std::uint64_t sum = 0;
  for (const FamilyReport& family : families) {
    for (const StressCurve& curve : family.curves) {
      for (const StressResult& result : curve.results) {
        sum += result.inside.compared() + result.outside.compared();
      }
    }
  }
  return sum;
}

StressReport run_stress(const StressOptions& options, const properties::RunControl& control) {
  StressReport report;
  report.cases = options.cases;
  report.seed = options.seed;
  const std::vector<const CaseSource*> families = chosen_families(options.families);
  require_severities(families, options);
  for (const CaseSource* family : families) {
    FamilyReport one{family, {}};
    for (const Stage stage : stages_of(*family)) {
      auto curves = run_stage(*family, stage, options, control);
      std::move(curves.begin(), curves.end(), std::back_inserter(one.curves));
    }
    report.families.push_back(std::move(one));
  }
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
