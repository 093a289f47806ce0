#include "tools/check/judgement.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "properties/laws/law.h"
#include "properties/search/campaign.h"
#include "scene/interruption.h"
#include "tools/shards/run_units.h"

namespace raycheck::tools {

using properties::Candidate;
using properties::Case;
using properties::Law;
using properties::Per;
using properties::RunControl;
using properties::Trials;
using properties::Verdict;

struct ChunkVerdict {
  Verdict verdict;
  ReasonsLeftOut left_out;
  bool given_rays = false;
  ExcludedHits excluded;
  template <class Archive>
  void serialize(Archive& archive) {
    archive(verdict, left_out, given_rays, excluded);
  }

  bool has_failed() const {
    return verdict.tally(properties::Quantity::kRefusal).count(properties::Wrong::kFailed) > 0;
  }
};

namespace {

void keep_worst(std::vector<ExcludedHit>& worst) {
  std::ranges::stable_sort(worst, std::greater{}, &ExcludedHit::in_radii);
  if (worst.size() > kKeptExcluded) worst.resize(kKeptExcluded);
}

/// The excluded hits of a trial's rays and spheres, from exact answers; empty if every root >= 0
/// counts.
ExcludedHits excluded_hits(properties::Trial& trial) {
  ExcludedHits found;
  const scene::Conventions& conventions = trial.conventions();
  if (conventions.valid.is_usual()) return found;
  const auto& spheres = trial.scene().spheres;
  found.spheres.resize(spheres.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
      const reference::ExactRay& exact = trial.exact_ray(ray);
      const reference::Intersection without =
          properties::exact_intersection(exact, spheres[k], properties::planned(conventions),
                                         trial.candidate().interface.from_inside);
      const reference::Intersection with = trial.exact_intersection(ray, k);
      const bool is_within = reference::counts_as_hit(with.hit_class, conventions.tangent);
      const bool is_usual = reference::counts_as_hit(without.hit_class, conventions.tangent);
      if (is_within || is_usual) ++found.spheres[k].hits;
      if (!is_usual) continue;
      if (is_within) {
        found.spheres[k].moved += with == without ? 0 : 1;
        continue;
      }
      ++found.spheres[k].excluded;
      const double s = exact.rounded_parameter(spheres[k], without, trial.precision());
      const double radius = spheres[k].radius;
      found.worst.push_back({trial.place(ray, k), s,
                             radius > 0 ? s / radius : std::numeric_limits<double>::infinity()});
    }
  }
  keep_worst(found.worst);
  return found;
}

ChunkVerdict judge_chunk(const Case& chunk, std::uint64_t first, const Candidate& candidate,
                         const properties::TrialOptions& options) {
  Trials trials(chunk, candidate, options);
  ChunkVerdict found;
  for (const Law& law : properties::laws()) {
    if (!law.judges_values || (law.per == Per::kScene && first > 0)) continue;
    // Candidates that are not renderers make no images; a line about that is needless.
    if (law.per == Per::kImage && !candidate.image) continue;
    Verdict verdict = trials.apply(law);
    if (!verdict.reason_left_out().empty())
      found.left_out[std::string(law.name)] = verdict.reason_left_out();
    if (!chunk.scene.camera) verdict.shift_rays(first);
    found.verdict.merge(std::move(verdict));
  }
  found.given_rays = trials.gave_rays();
  found.excluded = excluded_hits(trials.on_case());
  if (!chunk.scene.camera) {
    for (ExcludedHit& hit : found.excluded.worst) hit.place.ray += first;
  }
  return found;
}

}  // namespace

ExcludedOfSphere ExcludedHits::all() const {
  ExcludedOfSphere sum;
  for (const ExcludedOfSphere& one : spheres) {
    sum.hits += one.hits;
    sum.excluded += one.excluded;
    sum.moved += one.moved;
  }
  return sum;
}

void ExcludedHits::merge(const ExcludedHits& other) {
  spheres.resize(std::max(spheres.size(), other.spheres.size()));
  for (std::size_t k = 0; k < other.spheres.size(); ++k) {
    spheres[k].hits += other.spheres[k].hits;
    spheres[k].excluded += other.spheres[k].excluded;
    spheres[k].moved += other.spheres[k].moved;
  }
  worst.insert(worst.end(), other.worst.begin(), other.worst.end());
  keep_worst(worst);
}

Judgement::Judgement(std::optional<double> max_error, const ScenesOfFormats& scenes,
                     std::vector<Draft>& drafts)
    : max_error_(max_error), scenes_(scenes), drafts_(drafts) {
  for (const Draft& draft : drafts) {
    const auto format = draft.report.implementation.input_format();
    auto& plans = plans_[format];
    const auto& cases = scenes.in(format).cases;
    if (!cases || !cases->scene().camera) continue;
    const scene::Conventions conventions = properties::planned(draft.report.conventions);
    const bool is_planned = std::ranges::any_of(
        plans, [&](const scene::ScenePlan& plan) { return plan.conventions == conventions; });
    if (!is_planned) {
      plans.push_back(plan_scene(cases->scene(), conventions, scene::Wanted::kParameter));
    }
  }
}

void Judgement::run(const RunControl& control, Units* units, std::uint64_t& rays_judged,
                    const std::function<void()>& tell) {
  const std::uint64_t rays = scenes_.given().rays_judged();
  const std::uint64_t chunks = (rays + kChunk - 1) / kChunk;
  const auto at_once = static_cast<std::uint64_t>(  // chunks per unit
      properties::pieces_of_unit(static_cast<std::int64_t>(chunks)));
  using Unit = std::vector<ChunkVerdicts>;
  run_units<Unit>(
      static_cast<std::int64_t>((chunks + at_once - 1) / at_once), units, control,
      [&](std::int64_t k) {
        Unit unit;
        for (const Candidate& one : candidates_.local()) {
          if (units != nullptr) one.begin_anew();
        }
        const std::uint64_t first = static_cast<std::uint64_t>(k) * at_once;
        for (std::uint64_t chunk = first; chunk < std::min(first + at_once, chunks); ++chunk) {
          unit.push_back(judge(chunk * kChunk));
        }
        return unit;
      },
      [&](Unit& unit) {
        const scene::Interruptible interruptible(control.interrupted);
        for (ChunkVerdicts& chunk : unit) {
          merge(chunk, rays_judged);
          rays_judged = std::min(rays_judged + kChunk, rays);
        }
        tell();
      });
}

/// Adds a chunk's verdict on each draft; `first` is its first ray.
void Judgement::merge(ChunkVerdicts& verdicts, std::uint64_t first) {
  for (std::size_t k = 0; k < drafts_.size(); ++k) {
    if (verdicts[k].has_failed()) seek_failures(k, first, verdicts[k]);
    Draft& draft = drafts_[k];
    draft.report.verdict.merge(std::move(verdicts[k].verdict));
    draft.report.given_rays |= verdicts[k].given_rays;
    draft.report.excluded.merge(verdicts[k].excluded);
    for (auto& [law, reason] : verdicts[k].left_out) draft.left_out[law] = std::move(reason);
  }
}

/// Judges a failed chunk again, in parts. A separate candidate does this, one chunk after the
/// other, so that the search does not depend on threads. If the chunk does not fail this time, its
/// verdict stays.
void Judgement::seek_failures(std::size_t k, std::uint64_t first, ChunkVerdict& failed) {
  CandidateReport& report = drafts_[k].report;
  if (report.search.is_over()) {
    ++report.search.not_sought;
    return;
  }
  searchers_.resize(drafts_.size());
  if (!searchers_[k]) searchers_[k] = report.implementation.make();
  const auto format = report.implementation.input_format();
  const auto& cases = scenes_.in(format).cases;
  const Case chunk = cases->from(first, std::min(first + kChunk, cases->rays_judged()));
  properties::SharedTruths truths(chunk, plans_.at(format));
  ++report.search.batches;
  ChunkVerdict found = judge_chunk(
      chunk, first, *searchers_[k],
      {.max_error = max_error_,
       .truth = truths.under(report.conventions, report.implementation.interface.from_inside),
       .search = &report.search});
  if (found.has_failed()) failed = std::move(found);
}

ChunkVerdicts Judgement::judge(std::uint64_t first) {
  std::vector<Candidate>& candidates = candidates_.local();
  if (candidates.empty()) {
    for (const Draft& draft : drafts_) {
      candidates.push_back(draft.report.implementation.make());
    }
  }
  ChunkVerdicts found(drafts_.size());
  for (const auto& one : scenes_) {
    const properties::InputFormat format = one.first;
    const auto& cases = one.second.cases;
    const auto is_asked = [&](const Draft& draft) {
      return draft.report.implementation.input_format() == format;
    };
    if (!cases || std::ranges::none_of(drafts_, is_asked)) continue;
    const Case chunk = cases->from(first, std::min(first + kChunk, cases->rays_judged()));
    properties::SharedTruths truths(chunk, plans_.at(format));
    for (std::size_t k = 0; k < drafts_.size(); ++k) {
      if (!is_asked(drafts_[k])) continue;
      found[k] = judge_chunk(chunk, first, candidates[k],
                             {.max_error = max_error_,
                              .truth = truths.under(drafts_[k].report.conventions,
                                                    candidates[k].interface.from_inside)});
    }
  }
  return found;
}

}  // namespace raycheck::tools
