#include "tools/tradeoff/tradeoff.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "properties/cases/random.h"
#include "properties/cases/scene_cases.h"
#include "tools/tradeoff/tradeoff_timing.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::CaseSource;
using properties::ChosenSource;
using properties::Law;
using properties::Stage;
using properties::StressResult;

/// What is looked at when nothing is asked for.
const std::vector<std::string> kOrdinary = {"rays", "cameras"};

/// The rays judged at a time.
constexpr std::uint64_t kChunk = 512;

std::vector<ChosenSource> chosen_sources(const TradeoffOptions& options) {
  std::vector<ChosenSource> sources;
  if (options.all_families) {
    for (const CaseSource& source : properties::case_sources()) {
      if (source.dial) sources.push_back({&source});
    }
    return sources;
  }
  for (const std::string& name : options.sources.empty() ? kOrdinary : options.sources) {
    try {
      sources.push_back(properties::chosen_source(name));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("family " + name + ": " + error.what() +
                                  "; `raycheck list` shows the sources");
    }
  }
  return sources;
}

std::vector<Case> cases_of(const ChosenSource& source, int count, std::uint64_t seed) {
  properties::Random seeds(seed);
  std::vector<Case> cases;
  for (int k = 0; k < count; ++k) cases.push_back(source.make(seeds.bits()));
  return cases;
}

std::vector<MethodCost> costs_of(const std::vector<StagedMethod>& methods, Stage stage) {
  std::vector<MethodCost> costs;
  for (const StagedMethod& method : methods) {
    if (method.stage != stage) continue;
    costs.emplace_back();
    costs.back().method = method;
  }
  return costs;
}

/// Judges a stage's methods on cases that belong together.
void judge(const std::vector<Case>& cases, const std::string& name, Stage stage,
           const properties::RunControl& control, std::vector<MethodCost>& costs) {
  std::vector<Candidate> candidates;
  for (const MethodCost& cost : costs) candidates.push_back(candidate_of(cost.method));
  std::vector<StressResult> results(costs.size());
  for (const Case& one : cases) {
    if (control.interrupted()) break;
    properties::stress(one, stage, candidates, results);
  }
  for (std::size_t k = 0; k < costs.size(); ++k) {
    if (results[k].inside.compared() > 0 && !is_stable(results[k].inside)) {
      costs[k].unstable_on.push_back(name);
    }
    costs[k].accuracy.merge(std::move(results[k]));
  }
}

/// Marks what nothing beats: in time, defects and error at once.
template <class Costs, class Key>
void mark_pareto(Costs& costs, Key key) {
  for (auto& one : costs) {
    const auto mine = key(one);
    if (!mine) continue;
    one.pareto = std::none_of(costs.begin(), costs.end(), [&](const auto& other) {
      const auto its = key(other);
      if (!its || &other == &one) return false;
      const auto [time, defects, error] = *mine;
      const auto [its_time, its_defects, its_error] = *its;
      const bool no_worse = its_time <= time && its_defects <= defects && its_error <= error;
      return no_worse && (its_time < time || its_defects < defects || its_error < error);
    });
  }
}

using Rank = std::tuple<double, double, double>;

std::optional<Rank> rank_of(const MethodCost& cost) {
  const auto badness = cost.badness();
  const auto& time = cost.batch ? cost.batch : cost.scalar;
  if (!badness || !time) return std::nullopt;
  return Rank{time->median, badness->first, badness->second};
}

std::optional<std::pair<double, double>> badness_of(const properties::Verdict& verdict,
                                                    properties::Quantity quantity) {
  const auto found = verdict.tallies().find(quantity);
  if (found == verdict.tallies().end() || found->second.errors.empty()) return std::nullopt;
  std::uint64_t decisions = 0;
  for (const auto& [judged, tally] : verdict.tallies()) {
    if (tally.errors.empty()) decisions += tally.cases;
  }
  const double share = decisions == 0 ? 0
                                      : static_cast<double>(properties::defects(verdict)) /
                                            static_cast<double>(decisions);
  return std::pair(share, *found->second.quantile(0.999));
}

/// End to end, the methods that are Pareto-optimal in their own stage, with the default ones.
std::vector<MethodPair> pairs_worth_timing(const TradeoffReport& report) {
  std::vector<MethodPair> pairs;
  for (const MethodCost& rays : report.rays) {
    if (!rays.pareto && rays.method.rays != kDefaultMethods.rays) continue;
    for (const MethodCost& cost : report.intersections) {
      if (!cost.pareto && cost.method.intersect != kDefaultMethods.intersect) continue;
      pairs.push_back({rays.method.rays, cost.method.intersect});
    }
  }
  return pairs;
}

void judge_pixels(const std::vector<Case>& chunks, TradeoffReport& report) {
  const std::vector<MethodPair> pairs = pairs_worth_timing(report);
  const std::vector<Duration> durations = time_pixels(chunks.front(), pairs);
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    candidates.push_back(candidate_of(pairs[k]));
    report.pixels.push_back({candidates.back().name, durations[k], {}, false});
  }
  const std::vector<const Law*> laws = properties::laws_that([](const Law& law) {
    return law.stage == Stage::kIntersection && law.per == properties::Per::kPair &&
           law.judges_values && law.tells_stability;
  });
  for (const Case& chunk : chunks) {
    properties::SharedTruths truths(chunk);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto conventions = candidates[k].declared.over(chunk.scene.conventions);
      properties::Trial trial(chunk, candidates[k], {.truth = truths.under(conventions)});
      for (const Law* law : laws) report.pixels[k].verdict.merge(apply(*law, trial));
    }
  }
  mark_pareto(report.pixels, [](const PixelCost& cost) -> std::optional<Rank> {
    const auto badness = badness_of(cost.verdict, properties::Quantity::kParameter);
    if (!badness) return std::nullopt;
    return Rank{cost.per_pixel.median, badness->first, badness->second};
  });
}

/// Cases of the right kind for a stage, alone.
std::vector<Case> asked_of(const std::vector<Case>& cases, Stage stage) {
  const Candidate rays = candidate_of(kDefaultMethods);
  std::vector<Case> asked;
  for (const Case& one : cases) {
    if (auto own = properties::alone(one, stage, rays)) asked.push_back(std::move(*own));
  }
  return asked;
}

void finish(const std::vector<Case>& all, TradeoffReport& report) {
  // Sources in turn, so that what is timed is of all of them.
  for (const Stage stage : {Stage::kRays, Stage::kIntersection}) {
    std::vector<MethodCost>& costs = stage == Stage::kRays ? report.rays : report.intersections;
    const std::vector<Case> asked = asked_of(all, stage);
    if (asked.empty()) {
      costs.clear();
      report.left_out.push_back(fmt::format("{}: nothing asks for them", name(stage)));
      continue;
    }
    if (stage == Stage::kRays) {
      time_rays(asked, costs);
    } else {
      time_intersections(asked, costs);
    }
    mark_pareto(costs, rank_of);
  }
}

void run_on_scene(const TradeoffOptions& options, const std::vector<StagedMethod>& methods,
                  const properties::RunControl& control, TradeoffReport& report) {
  scene::LoadedScene loaded = scene::load_scene(options.scene, options.dialect);
  report.warnings = std::move(loaded.warnings);
  report.subject = options.scene;
  const properties::SceneCases chunks(std::move(loaded.scene),
                                      static_cast<std::uint64_t>(options.cases));
  if (chunks.rays_judged() < chunks.rays_in_scene()) {
    report.left_out.push_back(fmt::format("{} of {} rays: only {} were asked for",
                                          chunks.rays_in_scene() - chunks.rays_judged(),
                                          chunks.rays_in_scene(), chunks.rays_judged()));
  }
  std::vector<Case> all;
  for (std::uint64_t first = 0; first < chunks.rays_judged(); first += kChunk) {
    all.push_back(chunks.from(first, std::min(first + kChunk, chunks.rays_judged())));
  }
  report.cases = chunks.rays_judged();
  for (const Stage stage : {Stage::kRays, Stage::kIntersection}) {
    std::vector<MethodCost>& costs = stage == Stage::kRays ? report.rays : report.intersections;
    costs = costs_of(methods, stage);
    judge(all, options.scene, stage, control, costs);
  }
  finish(all, report);
  if (!report.rays.empty() && !report.intersections.empty()) {
    judge_pixels(all, report);
  } else {
    report.left_out.emplace_back("pixels end to end: the scene has no camera or no sphere");
  }
}

void run_on_sources(const TradeoffOptions& options, const std::vector<StagedMethod>& methods,
                    const properties::RunControl& control, TradeoffReport& report) {
  report.rays = costs_of(methods, Stage::kRays);
  report.intersections = costs_of(methods, Stage::kIntersection);
  const std::vector<ChosenSource> sources = chosen_sources(options);
  const int share = std::max(1, options.cases / static_cast<int>(sources.size()));
  std::vector<std::vector<Case>> by_source;
  for (const ChosenSource& source : sources) {
    const std::string name = source.name();
    report.subject += (report.subject.empty() ? "" : ", ") + name;
    control.progress("judging " + name);
    by_source.push_back(cases_of(source, share, options.seed));
    report.cases += by_source.back().size();
    judge(by_source.back(), name, Stage::kRays, control, report.rays);
    judge(by_source.back(), name, Stage::kIntersection, control, report.intersections);
  }
  control.progress("timing");
  std::vector<Case> mixed;
  for (std::size_t k = 0; k < by_source.front().size(); ++k) {
    for (const auto& cases : by_source) mixed.push_back(cases[k]);
  }
  finish(mixed, report);
}

}  // namespace

const properties::Tally* MethodCost::main() const {
  const auto& tallies = accuracy.inside.tallies();
  const auto found = tallies.find(quantity());
  return found == tallies.end() ? nullptr : &found->second;
}

std::optional<std::pair<double, double>> MethodCost::badness() const {
  return badness_of(accuracy.inside, quantity());
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
  const std::vector<StagedMethod> methods = find_methods(options.methods);
  if (options.scene.empty()) {
    run_on_sources(options, methods, control, report);
  } else {
    run_on_scene(options, methods, control, report);
  }
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
