#include "tools/check/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <span>

#include "properties/cases/scene_cases.h"
#include "properties/laws/law.h"
#include "properties/mistakes/answer_explanation.h"
#include "properties/mistakes/picture_causes.h"
#include "scene/files/format.h"
#include "scene/interruption.h"
#include "scene/invalid_input.h"
#include "tools/check/judgement.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::Law;
using properties::RunControl;
using properties::SceneCases;

Draft prepare(const Implementation& implementation, const ScenesOfFormats& scenes) {
  const Candidate candidate = implementation.make();
  Draft draft;
  draft.report.precision = candidate.precision;
  const auto& [rounded, cases] = scenes.in(candidate.input_format());
  draft.report.rounded_numbers = rounded.changed;
  draft.report.made_unit = rounded.made_unit;
  draft.report.not_asked = rounded.reason;
  const scene::Scene& scene = cases ? cases->scene() : scenes.given().scene();
  if (!(candidate.input_format() == properties::InputFormat{})) draft.report.asked = scene;
  draft.report.implementation = implementation;
  draft.report.name = candidate.name;
  draft.report.conventions = candidate.declared.over(scene.conventions);
  draft.report.inside_domain = is_inside_domain(candidate, scene);
  return draft;
}

/// The mistakes that explain the errors of a candidate: in its picture, which is stored, or in its
/// answers about some rays.
std::vector<properties::Explanation> explained(const CandidateReport& report,
                                               const scene::Scene& scene) {
  if (report.implementation.methods || report.verdict.holds()) return {};
  // Mistakes in pictures are searched for only if every root >= 0 counts.
  if (report.implementation.draws() && !report.conventions.valid.is_usual()) return {};
  const Candidate candidate = report.implementation.make();
  try {
    if (candidate.image) {
      const auto shown = properties::shown_picture(scene, candidate);
      if (!shown) return {};
      return properties::explanations(properties::picture_causes(std::span(&*shown, 1)));
    }
    const SceneCases some(scene, kChunk);
    const Case rays = some.from(0, std::min<std::uint64_t>(kChunk, some.rays_judged()));
    return properties::explanations(properties::answer_causes(std::span(&rays, 1), candidate));
  } catch (const properties::NoAnswer&) {
    return {};  // the verdict reports the missing answer
  } catch (const scene::Interrupted&) {
    return {};
  }
}

CandidateReport finish(Draft draft, const scene::Scene& given) {
  if (!draft.report.not_asked.empty()) return std::move(draft.report);
  draft.report.explanations = explained(draft.report, draft.report.asked.value_or(given));
  for (const Law& law : properties::laws()) {
    const auto found = draft.left_out.find(law.name);
    // Some rays without hits do not leave out a law of hits.
    const bool is_judged = law.per == properties::Per::kPair &&
                           law.quantity != properties::Quantity::kClass &&
                           draft.report.verdict.tally(law.quantity).cases > 0;
    if (found != draft.left_out.end() && !is_judged) {
      draft.report.left_out.push_back({std::string(law.name), found->second});
    }
  }
  return std::move(draft.report);
}

/// The scene. Renderers that do not keep their form are changed to that of the file.
scene::LoadedScene load(const CheckOptions& options, std::vector<Implementation>& implementations) {
  // Unless it is a user's, the format is that of the renderers' files.
  const bool draw = std::ranges::any_of(implementations, &Implementation::draws);
  const bool is_of_file = !draw || (options.read_as != nullptr && options.read_as->is_of_user());
  scene::LoadedScene loaded =
      scene::load_scene(options.path, is_of_file ? options.read_as : nullptr);
  if (loaded.format.empty() || options.keeps_forms) return loaded;
  for (Implementation& one : implementations) {
    if (one.draws()) one = one.reading(loaded.format);
  }
  return loaded;
}

/// The implementations without pairs that do the same as an earlier pair on this scene. If the
/// scene has no camera, pairs that differ only in the ray method are the same; if it has no
/// spheres, pairs that differ only in the intersection method.
std::vector<Implementation> without_equals(const std::vector<Implementation>& implementations,
                                           const scene::Scene& scene) {
  if (implementations.size() == 1) return implementations;
  std::vector<Implementation> result;
  std::vector<MethodPair> pairs;
  for (const Implementation& one : implementations) {
    if (!one.methods) {
      result.push_back(one);
      continue;
    }
    MethodPair pair = *one.methods;
    if (!scene.camera) pair.rays = kDefaultMethods.rays;
    if (scene.spheres.empty()) pair.intersect = kDefaultMethods.intersect;
    if (std::ranges::find(pairs, pair) != pairs.end()) continue;
    pairs.push_back(pair);
    result.push_back(built_in(pair));
  }
  return result;
}

}  // namespace

bool CheckReport::holds() const {
  return std::ranges::all_of(
      candidates, [this](const CandidateReport& one) { return one.verdict.holds(strict); });
}

bool CheckReport::is_enough_judged() const {
  const bool knows_undecided = ratchet && ratchet->is_conclusive;
  return !candidates.empty() && std::ranges::all_of(candidates, [&](const CandidateReport& one) {
    return knows_undecided ? one.is_judged() : one.is_enough_judged();
  });
}

CheckReport check(const CheckOptions& options, const RunControl& control, Units* units) {
  const scene::Interruptible interruptible(control.interrupted);
  std::vector<Implementation> implementations = options.implementations;
  CheckReport report;
  static_cast<scene::LoadedScene&>(report) = load(options, implementations);
  report.path = options.path;
  report.top = options.top;
  report.strict = options.strict;
  report.max_error = options.max_error;
  if (!report.scene.camera && options.pixels) {
    throw scene::InvalidInput(
        "pixels", "", options.path + " has given rays and no pixels; all its rays are judged");
  }
  const ScenesOfFormats scenes(report.scene, options.pixels, implementations);
  const SceneCases& cases = scenes.given();
  report.rays_in_scene = cases.rays_in_scene();
  std::vector<Draft> drafts;
  try {
    const auto judged = without_equals(implementations, report.scene);
    const std::vector<std::string> names = lasting_names(judged);
    for (std::size_t k = 0; k < judged.size(); ++k) {
      scene::poll();
      drafts.push_back(prepare(judged[k], scenes));
      drafts.back().report.lasting_name = names[k];
    }
    Judgement(options.max_error, scenes, drafts).run(control, units, report.rays_judged, [&] {
      control.progress(
          fmt::format("{} of {} rays judged", report.rays_judged, cases.rays_judged()));
    });
  } catch (const scene::Interrupted&) {
    // The report covers the part that was judged.
  }
  report.interrupted = control.interrupted();
  if (units != nullptr && !units->are_all()) return report;
  for (Draft& draft : drafts) report.candidates.push_back(finish(std::move(draft), report.scene));
  report.interrupted = control.interrupted();
  return report;
}

}  // namespace raycheck::tools
