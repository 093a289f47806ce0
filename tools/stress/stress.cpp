#include "tools/stress/stress.h"

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "properties/search/campaign.h"
#include "scene/invalid_input.h"
#include "tools/shards/run_units.h"

namespace raycheck::tools {
namespace {

using properties::CaseSource;
using properties::Stage;
using properties::StressResult;

std::vector<const CaseSource*> chosen_families(const std::vector<std::string>& names) {
  std::vector<const CaseSource*> families;
  std::string known;
  for (const CaseSource& source : properties::case_sources()) {
    if (!source.severities) continue;
    if (names.empty()) families.push_back(&source);
    known += (known.empty() ? "" : ", ") + std::string(source.name);
  }
  for (const std::string& name : names) {
    const CaseSource* const family = properties::find_case_source(name);
    if (family == nullptr || !family->severities) {
      throw scene::InvalidInput("family", name,
                                "no such source with severities; there are " + known);
    }
    if (std::ranges::find(families, family) == families.end()) {
      families.push_back(family);
    }
  }
  return families;
}

/// Requires that every source has the first requested severity, and at least one source the last.
void require_severities(const std::vector<const CaseSource*>& families,
                        const StressOptions& options) {
  if (!options.severities || families.empty()) return;
  const auto [from, to] = *options.severities;
  const auto by_highest = [](const CaseSource* a, const CaseSource* b) {
    return a->severities->highest < b->severities->highest;
  };
  const auto [fewest, most] = std::ranges::minmax_element(families, by_highest);
  const CaseSource* const beyond = from > (*fewest)->severities->highest ? *fewest
                                   : to > (*most)->severities->highest   ? *most
                                                                         : nullptr;
  if (beyond == nullptr) return;
  throw scene::InvalidInput(
      "severity", fmt::format("{}..{}", from, to),
      fmt::format("the severities of {} are 0..{}", beyond->name, beyond->severities->highest));
}

std::vector<int> severities_of(const CaseSource& family, const StressOptions& options) {
  const int highest = family.severities->highest;
  const auto [from, to] = options.severities.value_or(std::pair(0, highest));
  return properties::some_severities(from, std::min(to, highest));
}

std::vector<Stage> stages_of(const CaseSource& family) {
  if (family.has_camera) return {Stage::kRays, Stage::kIntersection};
  return {Stage::kIntersection};
}

/// A source at a stage: its curves, and a candidate for each curve.
struct Series {
  const CaseSource* family;
  Stage stage;
  std::vector<int> severities;
  std::vector<StressCurve> curves;

  std::vector<properties::Candidate> candidates() const {
    std::vector<properties::Candidate> all;
    for (const StressCurve& curve : curves) all.push_back(in_random_cases(curve.candidate.make()));
    return all;
  }
};

std::vector<Series> all_series(const StressOptions& options) {
  const std::vector<const CaseSource*> families = chosen_families(options.families);
  require_severities(families, options);
  std::vector<Series> all;
  for (const CaseSource* family : families) {
    for (const Stage stage : stages_of(*family)) {
      Series one = {family, stage, severities_of(*family, options), {}};
      for (const Implementation& method : options.implementations) {
        if (method.offers(stage)) one.curves.push_back({stage, method, one.severities, {}});
      }
      all.push_back(std::move(one));
    }
  }
  return all;
}

struct StressUnit {
  std::size_t series, severity;
  int first, cases;
};

std::vector<StressUnit> units_of(const std::vector<Series>& all, int cases) {
  std::int64_t severities = 0;
  for (const Series& one : all) {
    if (!one.curves.empty()) severities += static_cast<std::int64_t>(one.severities.size());
  }
  const std::int64_t most =
      properties::kUnitCases *
      properties::pieces_of_unit(severities * (cases / properties::kUnitCases));
  std::vector<StressUnit> units;
  for (std::size_t series = 0; series < all.size(); ++series) {
    if (all[series].curves.empty()) continue;
    for (std::size_t at = 0; at < all[series].severities.size(); ++at) {
      for (std::int64_t first = 0; first < cases; first += most) {
        units.push_back({series, at, static_cast<int>(first),
                         static_cast<int>(std::min<std::int64_t>(most, cases - first))});
      }
    }
  }
  return units;
}

}  // namespace

bool StressCurve::is_judged() const {
  return std::ranges::any_of(
      results, [](const StressResult& result) { return result.inside.compared() > 0; });
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

properties::AnswersFailed StressCurve::failed() const {
  properties::AnswersFailed all;
  for (const StressResult& result : results) {
    properties::AnswersFailed failed = properties::answers_failed(result);
    if (all.count == 0) all.first = std::move(failed.first);
    all.count += failed.count;
  }
  return all;
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

StressReport run_stress(const StressOptions& options, const properties::RunControl& control,
                        Units* kept) {
  StressReport report;
  report.cases = options.cases;
  report.seed = options.seed;
  std::vector<Series> all = all_series(options);
  const std::vector<StressUnit> units = units_of(all, options.cases);
  using Candidates = std::vector<std::vector<properties::Candidate>>;
  tbb::enumerable_thread_specific<Candidates> candidates([&] { return Candidates(all.size()); });
  using Results = std::vector<StressResult>;
  std::size_t next = 0;
  properties::RunControl allowed = control;
  // A candidate that times out three times is dropped. This does not depend on the number of
  // threads.
  if (kept == nullptr &&
      std::ranges::any_of(options.implementations,
                          [](const Implementation& one) { return !one.methods; })) {
    allowed.threads = 1;
  }
  run_units<Results>(
      static_cast<std::int64_t>(units.size()), kept, allowed,
      [&](std::int64_t k) {
        const auto& [series, at, first, cases] = units[static_cast<std::size_t>(k)];
        const Series& its = all[series];
        auto& own = candidates.local()[series];
        if (own.empty()) own = its.candidates();
        for (const properties::Candidate& one : own) {
          if (kept != nullptr) one.begin_anew();
        }
        const int severity = its.severities[at];
        return stress({its.family, severity}, its.stage, own,
                      {first, cases, options.seed + static_cast<std::uint64_t>(severity)}, control);
      },
      [&](Results& results) {
        const StressUnit& unit = units[next++];
        Series& series = all[unit.series];
        for (std::size_t k = 0; k < results.size(); ++k) {
          series.curves[k].results.resize(unit.severity + 1);
          series.curves[k].results.back().merge(std::move(results[k]));
        }
        control.progress(fmt::format("{} at severity {} of {}", series.family->name,
                                     series.severities[unit.severity], series.severities.back()));
      });
  report.interrupted = control.interrupted();
  if (kept != nullptr && !kept->are_all()) return report;
  for (Series& series : all) {
    if (report.families.empty() || report.families.back().family != series.family) {
      report.families.push_back({series.family, {}});
    }
    std::move(series.curves.begin(), series.curves.end(),
              std::back_inserter(report.families.back().curves));
  }
  return report;
}

}  // namespace raycheck::tools
