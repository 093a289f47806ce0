#include <algorithm>
#include <map>
#include <utility>

#include "properties/case.h"
#include "properties/cases/shrink.h"
#include "properties/mistakes/picture_evidence.h"
#include "tools/grade/judging/item_trial.h"

namespace raycheck::tools {
namespace {

using properties::Candidate;
using properties::Case;
using properties::Discrepancy;
using properties::Law;
using properties::Per;
using properties::Trial;
using properties::Verdict;
using properties::Wrong;

/// At most this many cases are tried while a failing case is shrunk: for functions, for programs
/// that fail on everything, and for pictures, each of which starts a program.
constexpr int kTries = 400;
constexpr int kTriesOfFailures = 40;
constexpr int kTriesOfPictures = 60;

/// The step of the computation that a wrong quantity points to; empty for a wrong hit class, which
/// several steps decide: the discriminant, the root and its sign.
std::optional<std::string> step_that_gives(properties::Quantity quantity) {
  using properties::Quantity;
  if (quantity == Quantity::kClass) return {};
  if (quantity == Quantity::kUnitDefect) quantity = Quantity::kDirection;
  if (quantity == Quantity::kParameter) quantity = Quantity::kRoot;
  return std::string(info(quantity).name);
}

/// Whether two cameras have the same sign of near and the same order of bounds, on which programs
/// may rely.
bool is_alike(const scene::Scene& now, const scene::Scene& before) {
  if (!before.camera) return true;
  const scene::Camera& a = *now.camera;
  const scene::Camera& b = *before.camera;
  return (a.near < 0) == (b.near < 0) && (a.left < a.right) == (b.left < b.right) &&
         (a.bottom < a.top) == (b.bottom < b.top);
}

/// Whether the candidate's picture equals the fault's picture, except for at most one pixel.
bool is_made_by(const properties::Fault& fault, const Case& the_case, const Candidate& candidate) {
  scene::Scene scene = the_case.scene;
  scene.conventions = candidate.declared.over(scene.conventions);
  const auto image = answered([&] { return candidate.image(scene, scene.conventions); });
  return image && properties::count_otherwise(*image, properties::predicted(fault, scene)) <= 1;
}

/// The case reduced to the ray or pixel, and the sphere, of one place.
Case only_at(const properties::Place& place, Case the_case) {
  scene::Scene& scene = the_case.scene;
  if (place.pixel) the_case.pixels = {*place.pixel};
  if (!scene.camera && place.ray < scene.rays.size()) scene.rays = {scene.rays[place.ray]};
  if (place.sphere) scene.spheres = {scene.spheres[*place.sphere]};
  return the_case;
}

std::optional<std::string> first_wrong_step(Trial& trial) {
  for (const Law& law : properties::laws()) {
    if (!law.judges_values || law.per == Per::kImage) continue;
    if (!apply(law, trial).holds()) return step_that_gives(law.quantity);
  }
  return {};
}

/// The candidate's answers about one ray of a trial, up to the stage of the broken law.
RayAnswers ray_answers(Trial& trial, std::size_t ray, const Law& broken) {
  const Candidate& candidate = trial.candidate();
  RayAnswers answers;
  if (trial.scene().camera) {
    if (candidate.frame) answers.frame = answered([&] { return trial.frame(); });
    if (trial.pixels().empty()) return answers;
    if (candidate.pixel_points) {
      answers.pixel_point = answered([&] { return trial.pixel_points()[ray]; });
    }
    if (trial.has_rays()) answers.ray = answered([&] { return trial.rays()[ray]; });
  }
  if (!is_about_intersections(broken) || !trial.has_rays() || !candidate.intersect) return answers;
  answers.hits = answered([&] {
    std::map<std::size_t, properties::HitAnswer> hits;
    for (std::size_t k = 0; k < trial.scene().spheres.size(); ++k) {
      if (const auto* const hit = properties::find_hit(trial.hits(k), ray)) hits[k] = *hit;
    }
    return hits;
  });
  return answers;
}

/// The answers about the ray of a place, which need not be in the case (a law may use other
/// pixels); if the place has no pixel, about the first ray.
RayAnswers ray_answers(Trial& trial, const properties::Place& place, const Law& broken) {
  if (!trial.scene().camera) return ray_answers(trial, place.ray, broken);
  if (!place.pixel) return ray_answers(trial, std::size_t{0}, broken);
  const auto& pixels = trial.pixels();
  const auto known = std::ranges::find(pixels, *place.pixel);
  if (known != pixels.end()) {
    return ray_answers(trial, static_cast<std::size_t>(known - pixels.begin()), broken);
  }
  const Case there{trial.scene(), {*place.pixel}};
  Trial of_place(there, trial.candidate());
  return ray_answers(of_place, std::size_t{0}, broken);
}

/// Both pictures of a case; empty if the candidate draws no picture. A renderer does not run again
/// if this was its last picture.
std::optional<ComparedPictures> compared_pictures(const Case& the_case,
                                                  const GradedCandidate& graded) {
  const scene::Conventions& conventions = the_case.scene.conventions;
  auto got = answered([&] { return graded.candidate.image(the_case.scene, conventions); });
  if (!got) return {};
  ComparedPictures pictures{*std::move(got), properties::exact_image(the_case.scene, conventions)};
  if (pictures.got.size() != pictures.exact->size()) return {};
  if (graded.masks_only) pictures.exact = mask_of(*std::move(pictures.exact));
  return pictures;
}

}  // namespace

bool keeps_state(const FailedCase& failed, const GradedCandidate& graded) {
  if (failed.failure || !graded.candidate.restart) return false;
  const auto is_right = [&](const Case& asked) {
    Trial trial(asked, graded.candidate, graded.options());
    const Verdict verdict = apply(*failed.broken, trial);
    return verdict.holds() && verdict.compared() > 0;
  };
  const Case at_place = only_at(failed.discrepancy.place, failed.item_case.the_case);
  if (is_right(at_place)) return false;
  graded.candidate.restart();
  const bool is_right_first = is_right(at_place);
  graded.candidate.reset_timeouts();
  return is_right_first;
}

Case simplest(const FailedCase& first, const GradedCandidate& graded,
              const properties::Fault& fault, const std::function<bool()>& is_late) {
  const Case& from = first.item_case.the_case;
  if (first.failure == FailureKind::kTimeUp) return from;
  const bool failed = first.discrepancy.wrong == Wrong::kFailed;
  properties::ShrinkBudget budget;
  budget.tries = failed ? kTriesOfFailures : graded.pictures ? kTriesOfPictures : kTries;
  // Every pixel of a picture is judged.
  const auto whole = [&](Case the_case) {
    if (graded.pictures) the_case.pixels = properties::all_pixels(*the_case.scene.camera);
    return the_case;
  };
  Case start = from;
  if (graded.pictures) start.pixels.clear();
  return whole(properties::smallest(std::move(start), budget, [&](const Case& next) {
    if (is_late() || !is_alike(next.scene, from.scene)) return false;
    if (!properties::is_of_format(next.scene, graded.candidate.input_format())) return false;
    const Case judged = whole(next);
    Trial trial(judged, graded.candidate, graded.options());
    const Verdict verdict = apply(*first.broken, trial);
    if (verdict.holds()) return false;
    const Discrepancy now = verdict.worst(1).front();
    if (now.wrong != first.discrepancy.wrong || now.quantity != first.discrepancy.quantity) {
      return false;
    }
    if (failed) return now.what == first.discrepancy.what;
    return !graded.pictures || fault.empty() || is_made_by(fault, judged, graded.unmasked);
  }));
}

std::optional<FailingCase> failing_case(const Case& the_case, const FailedCase& first,
                                        const GradedCandidate& graded) {
  Trial trial(the_case, graded.candidate, graded.options());
  Discrepancy d = first.discrepancy;
  if (first.failure != FailureKind::kTimeUp) {
    const Verdict verdict = apply(*first.broken, trial);
    if (verdict.holds()) return {};
    // A program that failed may have been dropped, so its first discrepancy stays.
    if (d.wrong != Wrong::kFailed) d = verdict.worst(1).front();
  }
  FailingCase failing{
      .origin = first.item_case.origin, .step = {}, .answer = d, .the_case = the_case};
  failing.the_case.scene.conventions = trial.conventions();
  if (graded.pictures) {
    failing.the_case.pixels.clear();
    if (d.wrong != Wrong::kFailed) failing.pictures = compared_pictures(failing.the_case, graded);
  } else if (d.wrong != Wrong::kFailed) {
    failing.step = first_wrong_step(trial);
    failing.answers = ray_answers(trial, d.place, *first.broken);
  }
  return failing;
}

namespace {

using Tried = std::vector<properties::TriedScene>;

/// The property ("wider than high", "several spheres") that exactly those scenes have for which no
/// picture was made, if all items together determine it.
std::optional<properties::ShapeCause> without_picture(const std::vector<ItemTrial>& trials) {
  Tried tried;
  for (const ItemTrial& trial : trials) {
    for (const properties::ShownPicture& one : trial.pictures) tried.push_back({&one.scene, false});
    for (const FailedCase& one : trial.failed) {
      if (!one.shown) tried.push_back({&one.item_case.the_case.scene, true});
    }
  }
  return properties::shape_cause(tried);
}

/// The property of the failing scenes, if all failing pictures are not square. Right pictures that
/// are not square may be right by luck; they must be fewer than the failing ones, and do not count.
std::optional<properties::ShapeCause> oblong_failures(const Rubric& rubric,
                                                      const std::vector<ItemTrial>& trials,
                                                      bool with_bonus) {
  const auto is_oblong = [](const properties::TriedScene& one) {
    return one.scene->camera->width != one.scene->camera->height;
  };
  Tried failed, right;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    if (rubric.items[k].bonus && !with_bonus) continue;
    Tried of_item;
    for (const FailedCase& one : trials[k].failed) {
      of_item.push_back({&one.item_case.the_case.scene, true});
    }
    failed.insert(failed.end(), of_item.begin(), of_item.end());
    for (const properties::ShownPicture& one : trials[k].pictures) {
      const bool is_failed = std::ranges::any_of(of_item, [&](const auto& other) {
        return other.scene->camera == one.scene.camera && other.scene->spheres == one.scene.spheres;
      });
      if (!is_failed) right.push_back({&one.scene, false});
    }
  }
  if (!std::ranges::all_of(failed, is_oblong)) return {};
  if (std::erase_if(right, is_oblong) >= failed.size()) return {};
  failed.insert(failed.end(), right.begin(), right.end());
  return properties::shape_cause(failed);
}

}  // namespace

ShapeOfFailures shape_of_failures(const Rubric& rubric, const std::vector<ItemTrial>& trials,
                                  bool are_unexplained) {
  for (const bool with_bonus : {true, false}) {
    if (!are_unexplained) break;
    if (const auto cause = oblong_failures(rubric, trials, with_bonus)) return {cause, true};
  }
  return {without_picture(trials), false};
}

}  // namespace raycheck::tools
