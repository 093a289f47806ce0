#include "properties/laws/law.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "properties/laws/law_list.h"
#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

struct Need {
  Needs of;  ///< Its bits in Needs.
  bool (*is_met)(const Trial&);
  std::string_view reason;    ///< Why a law is left out if the need is not met.
  bool is_of_scenes = false;  ///< Whether it is about scenes. If not, it is about candidates.
};

bool has_camera(const Trial& trial) { return trial.scene().camera.has_value(); }

/// Whether a candidate has this function.
template <auto Functions::*function>
bool has(const Trial& trial) {
  return static_cast<bool>(trial.candidate().*function);
}

/// Whether a trial meets a need, or its hits are those of pixels.
template <auto is_met>
bool picks_or(const Trial& trial) {
  return trial.picks() || is_met(trial);
}

/// Whether a candidate has a function other than `image`.
bool has_other_than_image(const Trial& trial) {
  const Functions& its = trial.candidate();
  return !its.image || its.frame || its.pixel_points || its.pixel_rays || its.focal_rays ||
         its.intersect || its.nearest;
}

/// Whether a trial has rays, or starts them elsewhere than at `origin`.
template <scene::Origin origin>
bool has_rays_from(const Trial& trial) {
  return trial.has_rays() || trial.conventions().origin != origin;
}

constexpr std::string_view kNoPixelRay = "the candidate does not implement pixel_ray()";
constexpr std::string_view kNoFocalRay = "the candidate does not implement focal_ray()";

/// In the order of checking: an image has a size only where there is a camera.
constexpr Need kNeeds[] = {
    {Needs::kImage, has<&Functions::image>, "the candidate draws no images"},
    {Needs::kMadeRays, has_camera, "the rays are given, not made from a camera", true},
    {kOfCameras, has_camera, "the scene has no camera", true},
    {kOfFunctions, has_other_than_image,
     "applies to functions; the law image judges a renderer's pictures"},
    {Needs::kFrame, has<&Functions::frame>, "the candidate does not implement frame()"},
    {Needs::kPixelPoints, has<&Functions::pixel_points>,
     "the candidate does not implement pixel_point()"},
    {Needs::kBothOrigins, has<&Functions::pixel_rays>, kNoPixelRay},
    {Needs::kBothOrigins, has<&Functions::focal_rays>, kNoFocalRay},
    {Needs::kIntersect, picks_or<has<&Functions::intersect>>,
     "the candidate does not implement intersect()"},
    {Needs::kAnyRay, [](const Trial& trial) { return !trial.picks(); },
     "pick() is asked for pixels, not for rays"},
    {Needs::kEither | Needs::kParameters | Needs::kPoints,
     [](const Trial& trial) { return trial.candidate().interface.returns != Returns::kClass; },
     "the candidate returns only hit or miss"},
    {Needs::kParameters,
     [](const Trial& trial) { return gives_parameter(trial.candidate().interface.returns); },
     "the candidate returns points, not s"},
    {Needs::kPoints,
     [](const Trial& trial) { return gives_point(trial.candidate().interface.returns); },
     "the candidate returns s, not points"},
    {Needs::kNearest, has<&Functions::nearest>, "the candidate does not implement nearest()"},
    {Needs::kVisible, has<&Functions::visible>,
     "only some of raycheck's own methods are asked this"},
    {Needs::kPlan, has<&Functions::plan>, "only some of raycheck's own methods are asked this"},
    {Needs::kRefusals, [](const Trial& trial) { return trial.candidate().refuses; },
     "only raycheck's methods are given invalid input"},
    {Needs::kImage,
     [](const Trial& trial) {
       const Camera& camera = *trial.scene().camera;
       return camera.width <= trial.candidate().most_image_pixels / camera.height;
     },
     "the image is larger than those that the candidate is asked for"},
    {Needs::kSpheres, [](const Trial& trial) { return !trial.scene().spheres.empty(); },
     "the scene has no spheres", true},
    {Needs::kVisible,
     [](const Trial& trial) {
       const Camera& camera = *trial.scene().camera;
       return std::max(camera.width, camera.height) <= trial.candidate().most_visible_across;
     },
     "the image is larger than those that visible() is asked for"},
    {Needs::kMadeRays, has_rays_from<scene::Origin::kPixel>, kNoPixelRay},
    {Needs::kMadeRays, has_rays_from<scene::Origin::kFocal>, kNoFocalRay},
    {Needs::kRays, picks_or<has_rays_from<scene::Origin::kPixel>>, kNoPixelRay},
    {Needs::kRays, picks_or<has_rays_from<scene::Origin::kFocal>>, kNoFocalRay},
    {Needs::kSeveralSpheres, [](const Trial& trial) { return trial.scene().spheres.size() > 1; },
     "the scene has one sphere, which is judged as hit or miss", true},
};

bool wants_given_rays(const Law& law, const Trial& trial) {
  return needs_any(law.needs, Needs::kRays) && !trial.has_rays() && !trial.picks() &&
         (trial.candidate().intersect || trial.candidate().nearest);
}

/// A verdict, and whether the candidate failed anywhere.
struct LawJudgement {
  Verdict verdict;
  bool failed = false;
};

/// Whether each sphere of a ray is a separate question. If a ray cannot be made, it is one
/// question.
bool asks_by_sphere(const Law& law, const Trial& trial) {
  return law.per == Per::kPair && !trial.lacks_rays();
}

/// The verdict of a law if the candidate threw an exception with this message.
LawJudgement judged_failure(const Law& law, const Trial& trial, Wrong wrong, const char* message,
                            const FailureSite& failed = {}) {
  Verdict verdict(law.name);
  Place place;
  if (failed.count > 0) {
    const bool is_pair = failed.blame == Blame::kQuestion && asks_by_sphere(law, trial) &&
                         !trial.scene().spheres.empty();
    place = trial.place(0, is_pair ? std::optional<std::size_t>(0) : std::nullopt);
  }
  trial.judge(
      verdict, {Quantity::kRefusal, Expected::kRefusal, place, wrong}, [] { return Excuse{}; },
      [&](Discrepancy& discrepancy) {
        discrepancy.what = message;
        discrepancy.failed = failed;
      });
  return {std::move(verdict), true};
}

/// Whether a law judges each ray, or each pair of ray and sphere, separately.
bool asks_apart(const Law& law) {
  return law.judges_values && (law.per == Per::kRay || law.per == Per::kPair);
}

LawJudgement judge(const Law& law, Trial& trial);

/// Judges the halves one after the other. If the whole is known to fail and the first half does
/// not, the second half is to blame, and is halved at once.
LawJudgement judge_halves(const Law& law, Trial& trial) {
  const bool by_sphere = asks_by_sphere(law, trial);
  LawJudgement all{Verdict(law.name)};
  bool is_second = false;
  for (const std::shared_ptr<TrialPart>& half : trial.halves()) {
    const bool is_to_blame = is_second && !all.failed && count_asked(half->trial, by_sphere) > 1;
    const bool halves_at_once = is_to_blame && !half->trial.options().search->is_over();
    LawJudgement one = halves_at_once ? judge_halves(law, half->trial) : judge(law, half->trial);
    one.verdict.relocate([&](const Place& place) { return half->place(place); });
    all.failed |= one.failed;
    all.verdict.merge(one.verdict);
    is_second = true;
  }
  if (all.verdict.compared() > 0) all.verdict.leave_out({});
  return all;
}

/// Called after a batch failed. Judges the failure if the batch is one question, otherwise the
/// halves.
LawJudgement judge_apart(const Law& law, Trial& trial, const CandidateFailed& error) {
  const char* const message = error.what();
  scene::poll();  // an interrupt may have ended the candidate, too
  FailureSearch* const search = trial.options().search;
  if (search == nullptr || !asks_apart(law)) {
    return judged_failure(law, trial, Wrong::kFailed, message,
                          {Blame::kNone, 0, {}, error.line, error.timed_out});
  }
  const bool by_sphere = asks_by_sphere(law, trial);
  const std::uint64_t questions = count_asked(trial, by_sphere);
  const auto failed_once = [&](Blame blame, int& count) {
    if (!trial.is_new(message)) return LawJudgement{Verdict(law.name), true};
    ++count;
    FailureSite failed{blame, questions, {}, error.line, error.timed_out};
    if (blame == Blame::kQuestion) failed.scene = trial.asked_scene();
    return judged_failure(law, trial, Wrong::kFailed, message, failed);
  };
  if (questions <= 1) return failed_once(Blame::kQuestion, search->found);
  if (search->is_over() && !trial.is_halved()) {
    return failed_once(Blame::kAmong, search->not_sought);
  }
  LawJudgement judged = judge_halves(law, trial);
  if (!judged.failed) {
    judged.verdict.merge(failed_once(Blame::kTogether, search->together).verdict);
    judged.failed = true;
  }
  return judged;
}

/// The verdict if the candidate fails on every question; a search reports that once.
LawJudgement judge_unavailable(const Law& law, Trial& trial, const char* message) {
  scene::poll();
  FailureSearch* const search = trial.options().search;
  if (search != nullptr && !search->whatever_asked.insert(message).second) {
    return {Verdict(law.name), true};
  }
  return judged_failure(law, trial, Wrong::kFailed, message, {Blame::kAnything, 0, {}, {}});
}

LawJudgement judge(const Law& law, Trial& trial) {
  scene::poll();
  try {
    LawJudgement judged{Verdict(law.name)};
    law.judge(trial, judged.verdict);
    return judged;
  } catch (const CandidateRefused& error) {
    return judged_failure(law, trial, Wrong::kRefused, error.what());
  } catch (const CannotBeSaid& error) {
    LawJudgement judged{Verdict(law.name)};
    judged.verdict.leave_out(error.what());
    return judged;
  } catch (const CandidateUnavailable& error) {
    return judge_unavailable(law, trial, error.what());
  } catch (const CandidateFailed& error) {
    return judge_apart(law, trial, error);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const InternalError& error) {
    throw InternalError(error.what(), Case{trial.scene(), trial.pixels()});
  } catch (const std::exception& error) {
    throw InternalError("law " + std::string(law.name) + ": " + error.what(),
                        Case{trial.scene(), trial.pixels()});
  }
}

}  // namespace

std::string_view what_is_missing(Needs needs, const Trial& trial) {
  for (const Need& need : kNeeds) {
    if (needs_any(needs, need.of) && !need.is_met(trial)) return need.reason;
  }
  return {};
}

bool scene_suits(Needs needs, const Trial& trial) {
  return std::all_of(std::begin(kNeeds), std::end(kNeeds), [&](const Need& need) {
    return !need.is_of_scenes || !needs_any(needs, need.of) || need.is_met(trial);
  });
}

Place GivenRays::place(Place of_ray) const {
  const Pixel& pixel = pixels.at(of_ray.ray);
  of_ray.ray = static_cast<std::size_t>(pixel.j * width + pixel.i);
  of_ray.pixel = pixel;
  return of_ray;
}

std::optional<GivenRays> given_rays(const Case& the_case, const Conventions& conventions,
                                    InputFormat format) {
  const ExactCamera camera(the_case.scene.camera.value(), conventions);
  GivenRays given;
  given.width = the_case.scene.camera->width;
  Scene& scene = given.the_case.scene;
  scene.spheres = the_case.scene.spheres;
  scene.conventions = the_case.scene.conventions;
  const std::vector<Ray> rays = rounded_rays(camera, the_case.pixels, format);
  for (std::size_t k = 0; k < rays.size(); ++k) {
    if (!scene::defects(rays[k]).empty()) continue;
    scene.rays.push_back(rays[k]);
    given.pixels.push_back(the_case.pixels[k]);
  }
  return scene.rays.empty() ? std::nullopt : std::optional(std::move(given));
}

std::span<const Law> laws() {
  static const std::vector<Law> all = [] {
    std::vector<Law> joined;
    for (const std::span<const Law> some :
         {kFrameLaws, kPixelPlaneLaws, kPixelRayLaws, kIntersectLaws, kNearestSphereLaws, kPlanLaws,
          kMetamorphicLaws, kRefusalLaws}) {
      joined.insert(joined.end(), some.begin(), some.end());
    }
    return joined;
  }();
  return all;
}

const Law* find_law(std::string_view name) {
  const auto found =
      std::find_if(laws().begin(), laws().end(), [&](const Law& law) { return law.name == name; });
  return found == laws().end() ? nullptr : &*found;
}

Verdict apply(const Law& law, Trial& trial) {
  scene::poll();
  const std::string_view missing = what_is_missing(law.needs, trial);
  if (missing.empty()) return judge(law, trial).verdict;
  Verdict verdict(law.name);
  verdict.leave_out(std::string(missing));
  return verdict;
}

Trials::Trials(const Case& the_case, const Candidate& candidate, const TrialOptions& options)
    : case_(the_case), options_(options), on_case_(the_case, candidate, options) {
  options_.truth = nullptr;
}

Trial& Trials::of(const Law& law) {
  if (!wants_given_rays(law, on_case_)) return on_case_;
  if (!given_)
    given_ = given_rays(case_, on_case_.conventions(), on_case_.candidate().input_format());
  if (!given_) return on_case_;
  if (!on_given_) on_given_.emplace(given_->the_case, on_case_.candidate(), options_);
  return *on_given_;
}

Verdict Trials::apply(const Law& law, const Verdict* earlier) {
  Trial& trial = of(law);
  trial.set_earlier(earlier);
  Verdict verdict = properties::apply(law, trial);
  if (&trial != &on_case_) {
    verdict.relocate([this](const Place& place) { return given_->place(place); });
  }
  return verdict;
}

}  // namespace raycheck::properties
