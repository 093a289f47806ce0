#include "tools/tradeoff/tradeoff.h"

#include <fmt/core.h>

#include <tuple>

#include "properties/cases/random.h"
#include "properties/cases/scene_cases.h"
#include "scene/interruption.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::CaseSource;
using properties::ChosenSource;
using properties::Stage;
using properties::StressResult;

/// Ranges of more severities than this are reported in this many stretches.
constexpr int kMostStretches = 17;

/// If there are more sources than this, titles do not name them.
constexpr std::size_t kMostNamed = 3;

/// The number of rays of a scene that are judged at a time.
constexpr std::uint64_t kChunk = 512;

std::vector<ChosenSource> chosen_sources(const TradeoffOptions& options) {
  if (!options.all_families) return options.sources;
  std::vector<ChosenSource> sources;
  for (const CaseSource& source : properties::case_sources()) {
    if (source.severities) sources.push_back({&source});
  }
  return sources;
}

JudgedSource judged_source(const ChosenSource& source) {
  JudgedSource judged{.name = source.name()};
  if (source.severity) {
    judged.severities = {*source.severity};
    judged.last = *source.severity;
  } else if (source.source->severities) {
    judged.last = source.source->severities->highest;
    judged.severities = properties::some_severities(0, judged.last, kMostStretches);
  }
  if (source.source->severities) judged.meaning = source.source->severities->meaning;
  return judged;
}

/// Candidates are timed on the first cases, until the spheres, rays and pixels of these exceed this
/// number.
constexpr std::size_t kMostTimed = std::size_t{1} << 21;

/// The timed cases of one source, or of a scene.
class TimedCases {
 public:
  explicit TimedCases(std::size_t sources) : most_(kMostTimed / sources) {}

  void add(const Case& one) {
    if (size_ > most_) return;
    size_ += one.scene.spheres.size() + one.scene.rays.size() + one.pixels.size();
    cases_.push_back(one);
  }
  const std::vector<Case>& cases() const { return cases_; }

 private:
  std::size_t most_;
  std::size_t size_ = 0;
  std::vector<Case> cases_;
};

std::vector<MethodCost> costs_of(const std::vector<Implementation>& methods, Stage stage) {
  std::vector<MethodCost> costs;
  for (const Implementation& method : methods) {
    if (!method.offers(stage)) continue;
    MethodCost& cost = costs.emplace_back();
    cost.stage = stage;
    cost.candidate = method;
    cost.promises = method.make();
  }
  return costs;
}

/// Judges the candidates of a stage on the cases of one source, or of a scene, one case at a time.
class StageJudge {
 public:
  StageJudge(Stage stage, const JudgedSource& source, std::vector<MethodCost>& costs)
      : stage_(stage), source_(source), costs_(costs), results_(costs.size()) {
    for (MethodCost& cost : costs) {
      candidates_.push_back(cost.candidate.make());
      cost.by_severity.emplace_back(source.severities.size());
    }
  }

  void judge(const Case& one, int severity) {
    std::vector<StressResult> found(costs_.size());
    properties::stress(one, stage_, candidates_, found);
    for (std::size_t k = 0; k < costs_.size(); ++k) {
      Tallies& tallies = costs_[k].by_severity.back()[source_.stretch_of(severity)];
      for (const auto& [quantity, tally] : found[k].inside.tallies()) {
        tallies[quantity].merge(tally);
      }
      results_[k].merge(std::move(found[k]));
    }
  }
  /// Adds the results to the costs.
  void finish() {
    for (std::size_t k = 0; k < costs_.size(); ++k) {
      if (results_[k].inside.compared() > 0 && !is_stable(results_[k].inside)) {
        costs_[k].unstable_on.push_back(source_.name);
      }
      costs_[k].accuracy.merge(std::move(results_[k]));
    }
  }

 private:
  Stage stage_;
  const JudgedSource& source_;
  std::vector<MethodCost>& costs_;
  std::vector<Candidate> candidates_;
  std::vector<StressResult> results_;
};

/// Judges the candidates of both stages on cases of a source until an interrupt; returns the number
/// of cases. `make` returns the k-th case and its severity. Only cases to be timed are kept.
template <class Make>
std::uint64_t judge(std::uint64_t count, const Make& make, const JudgedSource& source,
                    TradeoffReport& report, TimedCases& timed) {
  report.sources.push_back(source);
  StageJudge rays(Stage::kRays, source, report.rays);
  StageJudge intersections(Stage::kIntersection, source, report.intersections);
  std::uint64_t judged = 0;
  try {
    for (; judged < count; ++judged) {
      scene::poll();
      const auto [severity, one] = make(judged);
      rays.judge(one, severity);
      intersections.judge(one, severity);
      timed.add(one);
    }
  } catch (const scene::Interrupted&) {
    // The result covers the cases judged so far.
  }
  rays.finish();
  intersections.finish();
  return judged;
}

using Rank = std::tuple<double, double, double>;

std::optional<Rank> rank_of(const MethodCost& cost) {
  const auto badness = cost.badness();
  const auto& time = cost.batch ? cost.batch : cost.scalar;
  if (!badness || !time) return std::nullopt;
  return Rank{time->median, badness->first, badness->second};
}

/// Marks candidates if no other is at least as good in time, defects and error.
void mark_pareto(std::vector<MethodCost>& costs) {
  for (MethodCost& one : costs) {
    const auto mine = rank_of(one);
    if (!mine) continue;
    one.pareto = std::ranges::none_of(costs, [&](const MethodCost& other) {
      const auto its = rank_of(other);
      if (!its || &other == &one) return false;
      const auto [time, defects, error] = *mine;
      const auto [its_time, its_defects, its_error] = *its;
      const bool no_worse = its_time <= time && its_defects <= defects && its_error <= error;
      return no_worse && (its_time < time || its_defects < defects || its_error < error);
    });
  }
}

std::optional<std::pair<double, double>> badness_of(const properties::Verdict& verdict,
                                                    properties::Quantity quantity) {
  const properties::Tally& main = verdict.tally(quantity);
  if (main.errors.empty()) return std::nullopt;
  std::uint64_t decisions = 0;
  for (const auto& [judged, tally] : verdict.tallies()) {
    if (tally.errors.empty()) decisions += tally.cases;
  }
  const double share = decisions == 0 ? 0
                                      : static_cast<double>(properties::defects(verdict)) /
                                            static_cast<double>(decisions);
  return std::pair(share, *main.quantile(0.999));
}

/// The cases that suit a stage, reduced to that stage.
std::vector<Case> asked_of(const std::vector<Case>& cases, Stage stage) {
  const Candidate rays = candidate_of(kDefaultMethods);
  std::vector<Case> asked;
  for (const Case& one : cases) {
    if (auto own = properties::case_of_stage(one, stage, rays)) asked.push_back(std::move(*own));
  }
  return asked;
}

/// Times the candidates. On an interrupt throws scene::Interrupted; candidates that are not yet
/// timed stay without times.
void finish(const std::vector<Case>& timed, TradeoffReport& report) {
  scene::poll();
  for (const Stage stage : {Stage::kRays, Stage::kIntersection}) {
    std::vector<MethodCost>& costs = stage == Stage::kRays ? report.rays : report.intersections;
    const std::vector<Case> asked = asked_of(timed, stage);
    if (asked.empty()) {
      costs.clear();
      report.left_out.push_back(fmt::format("{}: no case asks for this",
                                            stage == Stage::kRays ? "making rays" : name(stage)));
      continue;
    }
    if (stage == Stage::kRays) {
      time_rays(asked, costs);
    } else {
      time_intersections(asked, costs);
    }
    mark_pareto(costs);
  }
}

void run_on_scene(const TradeoffOptions& options, TradeoffReport& report) {
  scene::LoadedScene loaded = scene::load_scene(options.scene, options.read_as);
  report.warnings = std::move(loaded.warnings);
  report.subject = options.scene;
  const properties::SceneCases cases(std::move(loaded.scene),
                                     static_cast<std::uint64_t>(options.cases));
  if (cases.rays_judged() < cases.rays_in_scene()) {
    report.left_out.push_back(fmt::format(
        "{} of {} rays: only {} were selected; a larger --cases selects more",
        cases.rays_in_scene() - cases.rays_judged(), cases.rays_in_scene(), cases.rays_judged()));
  }
  const auto rays = [&](std::uint64_t chunks) {
    return std::min(chunks * kChunk, cases.rays_judged());
  };
  const auto chunk = [&](std::uint64_t k) {
    return std::pair(0, cases.from(k * kChunk, rays(k + 1)));
  };
  const std::uint64_t chunks = (cases.rays_judged() + kChunk - 1) / kChunk;
  TimedCases timed(1);
  report.cases = rays(judge(chunks, chunk, {.name = options.scene}, report, timed));
  finish(timed.cases(), report);
}

void run_on_sources(const TradeoffOptions& options, const properties::RunControl& control,
                    TradeoffReport& report) {
  const std::vector<ChosenSource> sources = chosen_sources(options);
  const int share = std::max(1, options.cases / static_cast<int>(sources.size()));
  std::vector<TimedCases> by_source;
  for (const ChosenSource& source : sources) {
    const std::string name = source.name();
    report.subject += (report.subject.empty() ? "" : ", ") + name;
    control.progress("judging " + name);
    properties::Random seeds(options.seed);
    const auto next = [&](std::uint64_t /*number*/) {
      const std::uint64_t seed = seeds.bits();
      return std::pair(source.severity_of(seed), source.make(seed));
    };
    by_source.emplace_back(sources.size());
    report.cases += judge(static_cast<std::uint64_t>(share), next, judged_source(source), report,
                          by_source.back());
  }
  control.progress("timing");
  // The cases alternate between sources, so that all sources are timed.
  std::vector<Case> mixed;
  for (std::size_t k = 0, added = 1; added > 0; ++k) {
    added = 0;
    for (const TimedCases& timed : by_source) {
      if (k >= timed.cases().size()) continue;
      mixed.push_back(timed.cases()[k]);
      ++added;
    }
  }
  finish(mixed, report);
}

}  // namespace

std::size_t JudgedSource::stretch_of(int severity) const {
  const auto next = std::ranges::upper_bound(severities, severity);
  return static_cast<std::size_t>(next - severities.begin()) - 1;
}

std::string subject_text(const TradeoffReport& report) {
  const std::size_t count = report.sources.size();
  return count > kMostNamed ? fmt::format("{} sources", count) : report.subject;
}

const MethodCost* baseline(const std::vector<MethodCost>& costs) {
  const auto first =
      std::ranges::find_if(costs, [](const MethodCost& cost) { return cost.batch.has_value(); });
  return first == costs.end() ? nullptr : &*first;
}

std::optional<std::pair<double, double>> MethodCost::badness() const {
  auto badness = badness_of(accuracy.inside, quantity());
  if (badness) {
    badness->second *= scene::unit_roundoff(promises.precision) / properties::kDoubleRoundoff;
  }
  return badness;
}

std::uint64_t TradeoffReport::compared() const {
  std::uint64_t sum = 0;
  for (const auto* costs : {&rays, &intersections}) {
    for (const MethodCost& cost : *costs) {
      sum += cost.accuracy.inside.compared() + cost.accuracy.outside.compared();
    }
  }
  return sum;
}

TradeoffReport run_tradeoff(const TradeoffOptions& options, const properties::RunControl& control) {
  TradeoffReport report;
  report.seed = options.seed;
  report.rays = costs_of(options.implementations, Stage::kRays);
  report.intersections = costs_of(options.implementations, Stage::kIntersection);
  const scene::Interruptible interruptible(control.interrupted);
  try {
    if (options.scene.empty()) {
      run_on_sources(options, control, report);
    } else {
      run_on_scene(options, report);
    }
  } catch (const scene::Interrupted&) {
    // The report covers what was judged and timed so far.
  }
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
