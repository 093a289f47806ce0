#include "tools/check/check.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>

#include "properties/cases/scene_cases.h"
#include "properties/given_rays.h"
#include "properties/laws/law.h"
#include "properties/mistakes/answer_explanation.h"
#include "properties/mistakes/picture_causes.h"
#include "properties/rounded_case.h"
#include "scene/interruption.h"
#include "scene/plan/plan.h"
#include "tools/check/timing.h"
#include "tools/run/in_order.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::FailureSearch;
using properties::Law;
using properties::Per;
using properties::RunControl;
using properties::SceneCases;
using properties::Trial;
using properties::TrialOptions;
using properties::Truth;
using properties::Verdict;

/// Rays judged at a time: between chunks progress is shown and an interrupt is heeded. Methods are
/// timed, and mistakes looked for, on the first chunk.
constexpr std::size_t kChunk = 512;

/// Reasons by law.
using ReasonsLeftOut = std::map<std::string_view, std::string>;

/// A candidate's report in the making.
struct Draft {
  CandidateReport report;
  ReasonsLeftOut left_out;
};

/// What is found out about one candidate on a chunk of the rays.
struct ChunkVerdict {
  Verdict verdict;
  ReasonsLeftOut left_out;
  bool given_rays = false;
  Swallowed swallowed;

  bool has_failed() const {
    const auto found = verdict.tallies().find(properties::Quantity::kRefusal);
    return found != verdict.tallies().end() && found->second.count(properties::Wrong::kFailed) > 0;
  }
};

/// A scene in a format, and its rays.
struct ScenesOfFormats {
  ScenesOfFormats(const scene::Scene& given, std::optional<std::int64_t> pixels)
      : cases{SceneCases(given, pixels), {}} {
    single = properties::rounded_case({given, {}}, scene::Precision::kSingle);
    if (single.the_case) cases[1].emplace(single.the_case->scene, pixels);
  }
  /// Empty where the format cannot hold the scene.
  const std::optional<SceneCases>& of(scene::Precision precision) const {
    return cases[static_cast<std::size_t>(precision)];
  }

  properties::RoundedCase single;
  std::array<std::optional<SceneCases>, 2> cases;
};

Draft prepare(const Contestant& contestant, const ScenesOfFormats& scenes) {
  const Candidate candidate = candidate_of(contestant);
  Draft draft;
  draft.report.precision = candidate.precision;
  const bool is_single = candidate.precision == scene::Precision::kSingle;
  const scene::Scene& given = scenes.of(scene::Precision::kDouble)->scene();
  if (is_single) {
    draft.report.rounded_numbers = scenes.single.changed;
    draft.report.not_asked = scenes.single.reason;
  }
  const auto& cases = scenes.of(candidate.precision);
  const scene::Scene& scene = cases ? cases->scene() : given;
  draft.report.contestant = contestant;
  draft.report.name = candidate.name;
  draft.report.conventions = candidate.declared.over(scene.conventions);
  draft.report.inside_domain = is_inside_domain(candidate, scene);
  return draft;
}

ChunkVerdict judge_chunk(const Case& chunk, std::uint64_t first, std::shared_ptr<Truth> truth,
                         std::optional<double> max_error, const Candidate& candidate,
                         FailureSearch* search = nullptr) {
  Trial trial(chunk, candidate,
              {.max_error = max_error, .truth = std::move(truth), .search = search});
  ChunkVerdict found;
  const bool wants_rays = std::any_of(
      properties::laws().begin(), properties::laws().end(),
      [&](const Law& law) { return law.judges_values && wants_given_rays(law, trial); });
  const auto given =
      wants_rays ? given_rays(chunk, trial.conventions(), candidate.precision) : std::nullopt;
  found.given_rays = given.has_value();
  std::optional<Trial> on_given;
  if (given) {
    on_given.emplace(given->the_case, candidate,
                     TrialOptions{.max_error = max_error, .search = search});
  }
  for (const Law& law : properties::laws()) {
    if (!law.judges_values || (law.per == Per::kScene && first > 0)) continue;
    // Of others than renderers it need not be said that they make no images.
    if (law.per == Per::kImage && !candidate.image) continue;
    const bool is_given = on_given && wants_given_rays(law, trial);
    Verdict verdict = apply(law, is_given ? *on_given : trial);
    if (is_given) {
      verdict.relocate([&](const properties::Place& place) { return given->place(place); });
    }
    if (!verdict.reason_left_out().empty()) found.left_out[law.name] = verdict.reason_left_out();
    if (!chunk.scene.camera) verdict.shift_rays(first);
    found.verdict.merge(std::move(verdict));
  }
  found.swallowed = swallowed(trial);
  if (!chunk.scene.camera) {
    for (SwallowedHit& hit : found.swallowed.worst) hit.place.ray += first;
  }
  return found;
}

/// The mistake that explains the errors of someone else's: of a picture, which is asked for again
/// and was kept, or of the answers about some rays.
std::vector<properties::Explanation> explained(const CandidateReport& report,
                                               const scene::Scene& scene) {
  if (external_of(report.contestant) == nullptr || report.verdict.holds()) return {};
  if (!report.conventions.valid.is_usual()) return {};  // mistakes are those of who takes all roots
  const Candidate candidate = candidate_of(report.contestant);
  try {
    if (candidate.image) {
      const auto shown = properties::shown_picture(scene, candidate);
      if (!shown) return {};
      return properties::explanations(properties::picture_causes(std::span(&*shown, 1)));
    }
    const SceneCases some(scene, kChunk);
    const Case rays = some.from(0, std::min<std::uint64_t>(kChunk, some.rays_judged()));
    return properties::explanations(properties::answer_causes(std::span(&rays, 1), candidate));
  } catch (const std::runtime_error&) {
    return {};  // it gives no answer, as the verdict says
  } catch (const scene::Interrupted&) {
    return {};
  }
}

CandidateReport finish(Draft draft, const scene::Scene& scene) {
  if (!draft.report.not_asked.empty()) return std::move(draft.report);
  draft.report.explanations = explained(draft.report, scene);
  for (const Law& law : properties::laws()) {
    const auto found = draft.left_out.find(law.name);
    if (found != draft.left_out.end()) {
      draft.report.left_out.push_back({std::string(law.name), found->second});
    }
  }
  return std::move(draft.report);
}

/// What was left out, a line for each reason, with the candidate's name where not all left it out.
std::vector<std::string> left_out_lines(const CheckReport& report) {
  std::vector<std::string> lines;
  if (report.rays_judged < report.rays_in_scene && !report.interrupted) {
    lines.push_back(fmt::format("{} of {} pixels: only {} were asked for",
                                report.rays_in_scene - report.rays_judged, report.rays_in_scene,
                                report.rays_judged));
  }
  if (report.scene.camera && report.scene.camera->far) {
    lines.emplace_back("camera.far: no quantity depends on it");
  }
  lines.emplace_back("laws that relate several answers: raycheck properties tries them");
  /// The laws that were left out for one reason, of all candidates or of one, in their order.
  struct Group {
    std::string whose, reason;
    std::vector<std::string> laws;
  };
  std::vector<Group> groups;
  const auto add = [&](const std::string& whose, const LeftOut& entry) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& known) {
      return known.whose == whose && known.reason == entry.reason;
    });
    if (group == groups.end()) group = groups.insert(group, {whose, entry.reason, {}});
    if (std::find(group->laws.begin(), group->laws.end(), entry.law) == group->laws.end()) {
      group->laws.push_back(entry.law);
    }
  };
  for (const CandidateReport& candidate : report.candidates) {
    for (const LeftOut& entry : candidate.left_out) {
      const bool all = std::all_of(
          report.candidates.begin(), report.candidates.end(), [&](const CandidateReport& other) {
            return std::find(other.left_out.begin(), other.left_out.end(), entry) !=
                   other.left_out.end();
          });
      add(all ? "" : candidate.name + ", ", entry);
    }
  }
  for (const auto& [whose, reason, laws] : groups) {
    lines.push_back(fmt::format("{}{}: {}", whose, fmt::join(laws, ", "), reason));
  }
  return lines;
}

}  // namespace

std::uint64_t CheckReport::discrepancies() const {
  std::uint64_t sum = 0;
  for (const CandidateReport& candidate : candidates) sum += candidate.verdict.discrepancies();
  return sum;
}

std::uint64_t CheckReport::count(properties::Standing standing) const {
  std::uint64_t sum = 0;
  for (const CandidateReport& candidate : candidates) sum += candidate.verdict.count(standing);
  return sum;
}

std::uint64_t CheckReport::compared() const {
  std::uint64_t sum = 0;
  for (const CandidateReport& candidate : candidates) sum += candidate.verdict.compared();
  return sum;
}

bool CheckReport::holds() const {
  return std::all_of(candidates.begin(), candidates.end(),
                     [this](const CandidateReport& one) { return one.verdict.holds(strict); });
}

bool CheckReport::is_enough_judged() const {
  return !candidates.empty() &&
         std::all_of(candidates.begin(), candidates.end(),
                     [](const CandidateReport& one) { return one.is_enough_judged(); });
}

namespace {

bool is_renderer(const Contestant& contestant) {
  const External* const external = external_of(contestant);
  return external != nullptr && external->renderer;
}

/// The scene, and the contestants as they are to be given it: renderers in the form asked for, or
/// in the file's own dialect.
scene::LoadedScene load(const CheckOptions& options, std::vector<Contestant>& contestants) {
  const bool renders = std::any_of(contestants.begin(), contestants.end(), is_renderer);
  std::optional<scene::Dialect> dialect;
  if (options.driver && !renders) dialect = options.driver->dialect;
  scene::LoadedScene loaded = scene::load_scene(options.path, dialect);
  std::optional<DriverForm> form = options.driver;
  if (!form && loaded.dialect) form = form_of(*loaded.dialect);
  if (!form || options.keeps_forms) return loaded;
  for (Contestant& contestant : contestants) {
    if (is_renderer(contestant)) contestant = reading(*external_of(contestant), *form);
  }
  return loaded;
}

/// The contestants without those that would do the same as an earlier one on this scene: pairs that
/// differ in the ray method alone where it has no camera, in the intersection method alone where it
/// has no spheres.
std::vector<Contestant> without_equals(const std::vector<Contestant>& contestants,
                                       const scene::Scene& scene) {
  if (contestants.size() == 1) return contestants;
  std::vector<Contestant> result;
  std::vector<MethodPair> pairs;
  for (const Contestant& contestant : contestants) {
    const MethodPair* const methods = methods_of(contestant);
    if (methods == nullptr) {
      result.push_back(contestant);
      continue;
    }
    MethodPair pair = *methods;
    if (!scene.camera) pair.rays = kDefaultMethods.rays;
    if (scene.spheres.empty()) pair.intersect = kDefaultMethods.intersect;
    if (std::find(pairs.begin(), pairs.end(), pair) != pairs.end()) continue;
    pairs.push_back(pair);
    result.emplace_back(pair);
  }
  return result;
}

/// Judges the rays chunk by chunk. Every thread has candidates of its own; chunks share nothing but
/// the plans, and their verdicts are merged in the order of the rays.
class Judgement {
 public:
  Judgement(const CheckOptions& options, const ScenesOfFormats& scenes, std::vector<Draft>& drafts)
      : options_(options), scenes_(scenes), drafts_(drafts) {
    for (const Draft& draft : drafts) {
      const auto& cases = scenes.of(draft.report.precision);
      if (!cases || !cases->scene().camera) continue;
      auto& plans = plans_[static_cast<std::size_t>(draft.report.precision)];
      const scene::Conventions conventions = properties::planned(draft.report.conventions);
      const bool is_planned = std::any_of(
          plans.begin(), plans.end(),
          [&](const scene::ScenePlan& plan) { return plan.conventions == conventions; });
      if (!is_planned) {
        plans.push_back(plan_scene(cases->scene(), conventions, scene::Wanted::kParameter));
      }
    }
  }

  /// Counts the rays judged, and tells.
  template <class Tell>
  void run(const RunControl& control, std::uint64_t& rays_judged, const Tell& tell) {
    const std::uint64_t rays = scenes_.of(scene::Precision::kDouble)->rays_judged();
    const auto chunks = static_cast<std::int64_t>((rays + kChunk - 1) / kChunk);
    in_order<std::vector<ChunkVerdict>>(
        chunks, control,
        [&](std::int64_t k) { return judge(static_cast<std::uint64_t>(k) * kChunk); },
        [&](std::vector<ChunkVerdict>& verdicts) {
          const scene::Interruptible interruptible(control.interrupted);
          for (std::size_t k = 0; k < drafts_.size(); ++k) {
            if (verdicts[k].has_failed()) seek_failures(k, rays_judged, verdicts[k]);
            drafts_[k].report.verdict.merge(std::move(verdicts[k].verdict));
            drafts_[k].report.given_rays |= verdicts[k].given_rays;
            drafts_[k].report.swallowed.merge(verdicts[k].swallowed);
            for (auto& [law, reason] : verdicts[k].left_out) {
              drafts_[k].left_out[law] = std::move(reason);
            }
          }
          rays_judged = std::min(rays_judged + kChunk, rays);
          tell();
        });
  }

 private:
  /// Judges a chunk on which a candidate failed again, in parts: by a candidate of its own, chunk
  /// after chunk, so that what is sought does not depend on the threads. Where it does not fail
  /// now, the verdict stays what it was.
  void seek_failures(std::size_t k, std::uint64_t first, ChunkVerdict& failed) {
    CandidateReport& report = drafts_[k].report;
    if (report.search.is_over()) {
      ++report.search.not_sought;
      return;
    }
    searchers_.resize(drafts_.size());
    if (!searchers_[k]) searchers_[k] = candidate_of(report.contestant);
    const auto& cases = scenes_.of(report.precision);
    const Case chunk = cases->from(first, std::min(first + kChunk, cases->rays_judged()));
    properties::SharedTruths truths(chunk, plans_[static_cast<std::size_t>(report.precision)]);
    ++report.search.batches;
    ChunkVerdict found = judge_chunk(chunk, first, truths.under(report.conventions),
                                     options_.max_error, *searchers_[k], &report.search);
    if (found.has_failed()) failed = std::move(found);
  }

  std::vector<ChunkVerdict> judge(std::uint64_t first) {
    std::vector<Candidate>& candidates = candidates_.local();
    if (candidates.empty()) {
      for (const Draft& draft : drafts_) {
        candidates.push_back(candidate_of(draft.report.contestant));
      }
    }
    std::vector<ChunkVerdict> found(drafts_.size());
    for (const auto precision : {scene::Precision::kDouble, scene::Precision::kSingle}) {
      const auto& cases = scenes_.of(precision);
      const bool is_asked = std::any_of(drafts_.begin(), drafts_.end(), [&](const Draft& draft) {
        return draft.report.precision == precision;
      });
      if (!cases || !is_asked) continue;
      const Case chunk = cases->from(first, std::min(first + kChunk, cases->rays_judged()));
      properties::SharedTruths truths(chunk, plans_[static_cast<std::size_t>(precision)]);
      for (std::size_t k = 0; k < drafts_.size(); ++k) {
        if (drafts_[k].report.precision != precision) continue;
        found[k] = judge_chunk(chunk, first, truths.under(drafts_[k].report.conventions),
                               options_.max_error, candidates[k]);
      }
    }
    return found;
  }

  const CheckOptions& options_;
  const ScenesOfFormats& scenes_;
  std::vector<Draft>& drafts_;
  std::array<std::vector<scene::ScenePlan>, 2> plans_;  ///< By format.
  tbb::enumerable_thread_specific<std::vector<Candidate>> candidates_;
  std::vector<std::optional<Candidate>> searchers_;  ///< Where they have failed.
};

/// Times every candidate on the first rays, before any other thread runs.
void time_all(const SceneCases& cases, std::vector<Draft>& drafts) {
  const Case chunk = cases.from(0, std::min<std::uint64_t>(kChunk, cases.rays_judged()));
  for (Draft& draft : drafts) {
    const MethodPair* const methods = methods_of(draft.report.contestant);
    if (methods == nullptr) continue;
    draft.report.timing =
        time_methods(*methods, cases.scene(), draft.report.conventions, chunk.pixels);
  }
}

}  // namespace

CheckReport check(const CheckOptions& options, const RunControl& control) {
  const scene::Interruptible interruptible(control.interrupted);
  std::vector<Contestant> contestants = options.contestants;
  scene::LoadedScene loaded = load(options, contestants);
  CheckReport report;
  report.path = options.path;
  report.scene = std::move(loaded.scene);
  report.warnings = std::move(loaded.warnings);
  report.dialect = loaded.dialect;
  report.not_needed = std::move(loaded.not_needed);
  report.top = options.top;
  report.strict = options.strict;
  report.max_error = options.max_error;
  if (!report.scene.camera && options.pixels) {
    throw std::invalid_argument("pixels: " + options.path +
                                " has given rays and no pixels; all its rays are judged");
  }
  const ScenesOfFormats scenes(report.scene, options.pixels);
  const SceneCases& cases = *scenes.of(scene::Precision::kDouble);
  report.rays_in_scene = cases.rays_in_scene();
  std::vector<Draft> drafts;
  try {
    for (const Contestant& contestant : without_equals(contestants, report.scene)) {
      scene::poll();
      drafts.push_back(prepare(contestant, scenes));
    }
    time_all(cases, drafts);
    Judgement(options, scenes, drafts).run(control, report.rays_judged, [&] {
      control.progress(
          fmt::format("{} of {} rays judged", report.rays_judged, cases.rays_judged()));
    });
  } catch (const scene::Interrupted&) {
    // What was judged until then is the answer.
  }
  const bool has_single = std::any_of(drafts.begin(), drafts.end(), [](const Draft& draft) {
    return draft.report.precision == scene::Precision::kSingle;
  });
  if (has_single && scenes.single.the_case) report.single_scene = scenes.single.the_case->scene;
  for (Draft& draft : drafts) {
    const scene::Scene& scene = report.scene_of(draft.report);
    report.candidates.push_back(finish(std::move(draft), scene));
  }
  report.interrupted = control.interrupted();
  report.left_out = left_out_lines(report);
  return report;
}

}  // namespace raycheck::tools
