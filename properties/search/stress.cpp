#include "properties/search/stress.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "properties/cases/random.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

void keep_first_of_each(std::vector<Example>& found, Example one) {
  const Discrepancy& its = one.discrepancy;
  const bool is_known = std::any_of(found.begin(), found.end(), [&](const Example& other) {
    const Discrepancy& known = other.discrepancy;
    return known.law == its.law && known.quantity == its.quantity && known.wrong == its.wrong &&
           known.excuse.kind == its.excuse.kind;
  });
  if (!is_known) found.push_back(std::move(one));
}

/// Judges the candidates of one format.
void stress(const Case& the_case, Stage stage, std::span<const Candidate> candidates,
            InputFormat format, std::vector<StressResult>& results) {
  const auto first =
      std::find_if(candidates.begin(), candidates.end(),
                   [=](const Candidate& candidate) { return candidate.input_format() == format; });
  if (first == candidates.end()) return;
  const bool makes_rays = first->pixel_rays || first->focal_rays;
  const Candidate& rays = makes_rays ? *first : candidates.front();
  const RoundedCase rounded = case_of_stage(the_case, stage, rays, format);
  const std::optional<Case>& asked = rounded.the_case;
  if (!asked && rounded.reason.empty()) return;
  std::optional<SharedTruths> truths;
  if (asked) truths.emplace(*asked);
  const std::vector<const Law*> laws =
      laws_that([&](const Law& law) { return law.stage == stage && law.tells_stability; });
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const Candidate& candidate = candidates[k];
    if (candidate.input_format() != format) continue;
    if (!asked) {
      ++results[k].left_out;
      continue;
    }
    if (!is_problem(*asked, candidate.declared)) continue;
    const auto conventions = candidate.declared.over(asked->scene.conventions);
    Trial trial(*asked, candidate,
                {.conditioning = true,
                 .truth = truths->under(conventions, candidate.interface.from_inside)});
    for (const Law* law : laws) {
      if (!what_is_missing(law->needs, trial).empty()) continue;
      Verdict verdict = apply(*law, trial);
      for (Discrepancy& one : verdict.worst(kKeptDiscrepancies)) {
        keep_first_of_each(results[k].found, {*asked, std::move(one)});
      }
      (trial.inside_domain() ? results[k].inside : results[k].outside).merge(std::move(verdict));
    }
  }
}

}  // namespace

std::optional<Case> case_of_stage(const Case& the_case, Stage stage, const Candidate& rays) {
  if (stage == Stage::kRays) {
    return the_case.scene.camera ? std::optional(the_case) : std::nullopt;
  }
  if (the_case.scene.spheres.empty()) return std::nullopt;
  if (!the_case.scene.camera) return the_case;
  Case result;
  result.scene.spheres = the_case.scene.spheres;
  result.scene.conventions = the_case.scene.conventions;
  const auto& make = rays.rays_from(the_case.scene.conventions.origin);
  if (!make) return std::nullopt;
  for (const Ray& ray : make(*the_case.scene.camera, the_case.scene.conventions, the_case.pixels)) {
    if (scene::defects(ray).empty()) result.scene.rays.push_back(ray);
  }
  return result.scene.rays.empty() ? std::nullopt : std::optional(std::move(result));
}

RoundedCase case_of_stage(const Case& the_case, Stage stage, const Candidate& rays,
                          InputFormat format) {
  RoundedCase rounded = rounded_case(the_case, format);
  if (!rounded.the_case) return rounded;
  std::optional<Case> asked = case_of_stage(*rounded.the_case, stage, rays);
  return asked ? rounded_case(*std::move(asked), format) : RoundedCase{};
}

void StressResult::merge(StressResult other) {
  inside.merge(std::move(other.inside));
  outside.merge(std::move(other.outside));
  for (Example& one : other.found) keep_first_of_each(found, std::move(one));
  left_out += other.left_out;
}

void stress(const Case& the_case, Stage stage, std::span<const Candidate> candidates,
            std::vector<StressResult>& results) {
  ByFormat<bool> is_done;
  for (const Candidate& candidate : candidates) {
    const InputFormat format = candidate.input_format();
    if (!std::exchange(is_done[format], true)) stress(the_case, stage, candidates, format, results);
  }
}

std::vector<StressResult> stress(const ChosenSource& source, Stage stage,
                                 std::span<const Candidate> candidates,
                                 const StressOptions& options, const RunControl& control) {
  std::vector<StressResult> results(candidates.size());
  Random seeds(options.seed);
  seeds.skip(static_cast<std::uint64_t>(options.first));
  const scene::Interruptible interruptible(control.interrupted);
  try {
    for (int k = 0; k < options.cases; ++k) {
      scene::poll();
      stress(source.make(seeds.bits()), stage, candidates, results);
    }
  } catch (const scene::Interrupted&) {
    // The result has the cases judged so far.
  }
  for (StressResult& result : results) {
    result.inside.drop_discrepancies();
    result.outside.drop_discrepancies();
  }
  return results;
}

AnswersFailed answers_failed(const StressResult& result) {
  AnswersFailed failed;
  for (const Verdict* verdict : {&result.inside, &result.outside}) {
    for (const auto& [quantity, tally] : verdict->tallies()) {
      failed.count += tally.count(Wrong::kFailed);
    }
  }
  const auto first = std::ranges::find_if(
      result.found, [](const Example& one) { return one.discrepancy.wrong == Wrong::kFailed; });
  if (first != result.found.end()) failed.first = first->discrepancy.what;
  return failed;
}

std::uint64_t defects(const Verdict& verdict) {
  std::uint64_t sum = 0;
  for (const auto& [quantity, tally] : verdict.tallies()) {
    sum += tally.count(Outcome::kWrongDecision);
  }
  return sum;
}

std::optional<double> worst_ratio(const Verdict& verdict) {
  std::optional<double> worst;
  for (const auto& [quantity, tally] : verdict.tallies()) {
    if (quantity != Quantity::kBackwardError) worst = std::max(worst, tally.worst_ratio);
  }
  return worst;
}

bool is_stable(const Verdict& verdict) {
  return defects(verdict) == 0 && worst_ratio(verdict) <= kStableRatio;
}

std::optional<double> error_slope(int base, std::span<const int> severities,
                                  std::span<const double> errors) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (!(errors[k] > 0) || !std::isfinite(errors[k])) continue;
    points.emplace_back(severities[k] * std::log10(base), std::log10(errors[k]));
  }
  if (points.size() < 3) return std::nullopt;
  const auto lower = [](const auto& a, const auto& b) { return a.second < b.second; };
  const double largest = std::max_element(points.begin(), points.end(), lower)->second;
  const auto grown = std::find_if(points.begin(), points.end(),
                                  [&](const auto& point) { return point.second >= largest - 1; });
  if (grown - points.begin() >= 2) points.erase(grown + 1, points.end());
  double mean_x = 0;
  double mean_y = 0;
  for (const auto& [x, y] : points) {
    mean_x += x / static_cast<double>(points.size());
    mean_y += y / static_cast<double>(points.size());
  }
  double covariance = 0;
  double variance = 0;
  for (const auto& [x, y] : points) {
    covariance += (x - mean_x) * (y - mean_y);
    variance += (x - mean_x) * (x - mean_x);
  }
  return covariance / variance;
}

}  // namespace raycheck::properties
