#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "properties/laws/law_list.h"
#include "properties/sphere_choice.h"
#include "reference/error_measure.h"
#include "reference/visibility/visibility.h"

namespace raycheck::properties {
namespace {

constexpr int kDistanceBits = 256;

/// The pixels of the case, and others spread over the image.
std::vector<Pixel> with_spread_pixels(const Trial& trial) {
  constexpr std::int64_t kMost = 4;
  std::vector<Pixel> pixels = trial.pixels();
  const Camera& camera = *trial.scene().camera;
  const std::int64_t columns = std::min(camera.width, kMost);
  const std::int64_t rows = std::min(camera.height, kMost);
  for (std::int64_t j = 0; j < rows; ++j) {
    for (std::int64_t i = 0; i < columns; ++i) {
      pixels.push_back(
          {(2 * i + 1) * camera.width / (2 * columns), (2 * j + 1) * camera.height / (2 * rows)});
    }
  }
  return pixels;
}

void judge_nearest_sphere(Trial& trial, Verdict& verdict) {
  const std::vector<Sphere> reversed(trial.scene().spheres.rbegin(), trial.scene().spheres.rend());
  const auto backwards = trial.rank(trial.rays(), reversed);
  const SpheresMet met = spheres_met(trial);
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    if (met.is_unjudged[k]) continue;
    const auto& exact = trial.exact_nearest()[k];
    const Index last_first = backwards.at(k);
    const Index reversed_got = last_first ? Index(reversed.size() - 1 - *last_first) : Index();
    // One decision per ray: the answer is right if it is right in both orders of the spheres.
    Choice choice{k, trial.nearest()[k], exact};
    if (is_right(choice)) {
      choice.got = reversed_got;
      choice.what = "with the spheres in reverse order (numbered as in the scene)";
    }
    judge_choice(trial, verdict, choice, met.expected(k),
                 [&] { return excuse(trial, k, choice.got, trial.excused_change()); });
  }
  if (met.some_start_inside) {
    verdict.leave_out("rays that start inside a sphere, where the hit is not a root that counts");
  }
}

/// The exact s of a ray that meets a sphere, and the distance of that hit from the eye.
struct ExactDepth {
  Enclosure s, distance;
};
ExactDepth exact_depth(Trial& trial, std::size_t k) {
  const ExactRay& ray = trial.exact_ray(k);
  const NearestSphere& exact = *trial.exact_nearest()[k];
  const Enclosure s = ray.parameter(trial.scene().spheres[exact.index], exact.intersection);
  const bool is_from_eye = trial.conventions().origin == scene::Origin::kFocal;
  return {s, is_from_eye ? s : s + ray.enclose(kDistanceBits).length()};
}

/// Judges s of a ray if its sphere is the exact one.
void measure_parameter(Trial& trial, Verdict& verdict, std::size_t k, double got) {
  const ExactRay& ray = trial.exact_ray(k);
  const NearestSphere& exact = *trial.exact_nearest()[k];
  const Sphere& sphere = trial.scene().spheres[exact.index];
  const auto [s, distance] = exact_depth(trial, k);
  const Enclosure least(std::numeric_limits<double>::denorm_min(), kDistanceBits);
  const Enclosure error = abs(Enclosure(got, kDistanceBits) - s) - least;
  scene::Measured relative;
  if (error.certain_sign().value_or(1) > 0) {
    relative = distance.contains_zero() ? scene::Measured{std::numeric_limits<double>::infinity()}
                                        : in_units_of_u(error / distance);
  }
  trial.measure(
      verdict,
      {Quantity::kHitPoint, trial.place(k, exact.index), relative,
       reference::kVisibleParameterError / scene::unit_roundoff(trial.precision())},
      [] { return 0; },
      [&](Discrepancy& d) {
        d.what = "s, as a share of the distance from the eye";
        d.symbol = info(Quantity::kParameter).symbol;
        d.got = {got};
        d.exact = {ray.rounded_parameter(sphere, exact.intersection, trial.precision())};
      });
}

void judge_visible_sphere(Trial& trial, Verdict& verdict) {
  Case wider{trial.scene(), with_spread_pixels(trial)};
  Trial seen(wider, trial.candidate());
  const auto answers = trial.candidate().visible(trial.scene(), trial.conventions(), wider.pixels);
  if (answers.size() != wider.pixels.size())
    throw CandidateFailed("visible() returned too few or too many answers");
  const bool exactly = trial.candidate().exact_visible;
  const SpheresMet met = spheres_met(seen);
  for (std::size_t k = 0; k < answers.size(); ++k) {
    if (met.is_unjudged[k]) continue;
    const auto& exact = seen.exact_nearest()[k];
    const Choice choice{k, answers[k] ? Index(answers[k]->sphere) : Index(), exact, "sphere index",
                        exactly};
    judge_choice(seen, verdict, choice, met.expected(k), [&] {
      return exactly ? Excuse{} : excuse(seen, k, choice.got, seen.excused_change());
    });
    if (is_right(choice) && exactly && exact) {
      measure_parameter(seen, verdict, k, answers[k]->parameter);
    }
  }
}

bool is_within_threshold(Trial& trial, std::size_t ray, double threshold) {
  const auto& exact = trial.exact_nearest()[ray];
  return threshold > 0 && exact &&
         trial.exact_ray(ray).rounded_parameter(trial.scene().spheres[exact->index],
                                                exact->intersection) <= threshold;
}

Excuse excuse_of(Trial& trial, const Choice& choice) {
  const Candidate& candidate = trial.candidate();
  if (is_within_threshold(trial, choice.ray, candidate.image_threshold)) {
    return {ExcuseKind::kThreshold, candidate.image_threshold};
  }
  if (candidate.any_sample &&
      may_be_elsewhere_in_pixel(trial.exact_ray(choice.ray), trial.scene().spheres,
                                trial.conventions(), choice.got, candidate.excused_image_change)) {
    return {ExcuseKind::kElsewhereInPixel};
  }
  return excuse(trial, choice.ray, choice.got, candidate.excused_image_change);
}

/// A right depth is off by this, in ulp of float, since depth pictures hold floats.
constexpr double kDepthRounding = 0.5;
constexpr double kFloatRoundoff = scene::unit_roundoff(scene::Precision::kSingle);

Enclosure exact_number(Trial& trial, std::size_t k) {
  const auto [s, distance] = exact_depth(trial, k);
  const Depth depth = trial.candidate().depth;
  if (depth == Depth::kS) return s;
  if (depth == Depth::kDistance) return distance;
  const Enclosure of_plane = distance / trial.exact_ray(k).enclose(kDistanceBits).length();
  const double near = std::abs(trial.scene().camera->near);
  return depth == Depth::kZ ? of_plane * Enclosure(near, kDistanceBits) : of_plane;
}

/// An upper bound of the condition number of a depth: that of s, and that of |P - E| and of the
/// angle with the view axis. Source: l = |P - E| has dl/l = (n dn + a da + b db)/l^2, where a and b
/// are at most l and their changes are relative to the window's bounds.
double condition_of_depth(Trial& trial, std::size_t k) {
  const double of_s = trial.condition_of_parameter(k, trial.exact_nearest()[k]->index);
  if (trial.candidate().depth == Depth::kS) return of_s;
  const Camera& camera = *trial.scene().camera;
  const double window = std::max(std::abs(camera.left), std::abs(camera.right)) +
                        std::max(std::abs(camera.bottom), std::abs(camera.top));
  return of_s + 3 + 2 * window / std::abs(camera.near);
}

/// The excuse for a depth with this relative error: the change of the scene that excuses wrong
/// pixels changes the depth as much, or the ray may then meet the other root, or another sphere,
/// first.
Excuse excuse_of_depth(Trial& trial, std::size_t k, double error) {
  const auto& exact = trial.exact_nearest()[k];
  const Candidate& candidate = trial.candidate();
  const double change = candidate.excused_image_change;
  if (is_within_threshold(trial, k, candidate.image_threshold)) {
    return {ExcuseKind::kThreshold, candidate.image_threshold};
  }
  // sqrt(x + y) - sqrt(x) is at most twice the derivative times y, also near a tangent.
  const double condition = condition_of_depth(trial, k);
  if (error <= 2 * condition * change) return {ExcuseKind::kIllConditioned, condition};
  const Sphere& first = trial.scene().spheres[exact->index];
  Intersection other_root = exact->intersection;
  other_root.root =
      other_root.root == WhichRoot::kSmaller ? WhichRoot::kLarger : WhichRoot::kSmaller;
  const double other_s = trial.exact_ray(k).rounded_parameter(first, other_root);
  Excuse found = properties::excuse_of(
      right_nearby(trial.exact_ray(k), first, trial.neighbourhood(change), other_s), change);
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const Choice other{k, sphere, exact};
    if (is_right(other)) continue;
    Excuse one = excuse_of(trial, other);
    if (one.standing() < found.standing()) continue;
    found = std::move(one);
    if (found.standing() == Standing::kExcused) break;
  }
  return found;
}

/// Judges the number of a pixel that shows the sphere, as it should.
void measure_depth(Trial& trial, Verdict& verdict, std::size_t k, float got) {
  const NearestSphere& exact = *trial.exact_nearest()[k];
  const Enclosure number = exact_number(trial, k);
  const scene::Measured error = reference::ulp_error(got, number, scene::Precision::kSingle);
  const double stated = trial.bound(Quantity::kParameter) *
                        (scene::unit_roundoff(trial.precision()) / kFloatRoundoff);
  trial.measure(
      verdict, {Quantity::kDepth, trial.place(k, exact.index), error, kDepthRounding + stated},
      [&] { return condition_of_depth(trial, k); },
      [&](Discrepancy& d) {
        d.symbol = kDepthNames[static_cast<std::size_t>(trial.candidate().depth)];
        d.got = {got};
        d.exact = {number.upper_rounded()};
        // An ulp is at most 2 u of the exact number.
        if (std::isfinite(got)) d.excuse = excuse_of_depth(trial, k, 2 * kFloatRoundoff * d.error);
      });
}

void judge_image(Trial& trial, Verdict& verdict) {
  const Candidate& candidate = trial.candidate();
  if (candidate.any_sample && !trial.conventions().valid.is_usual()) {
    return verdict.leave_out(
        "any point of a pixel may be its sample, but not every root >= 0 counts");
  }
  const Camera& camera = *trial.scene().camera;
  const ImageAnswer image = candidate.image(trial.scene(), trial.conventions());
  const std::int64_t width = camera.width;
  if (image.size() != static_cast<std::size_t>(width * camera.height)) {
    throw CandidateFailed("image() returned too few or too many pixels");
  }
  DepthAnswer depths;
  if (candidate.depths && !candidate.any_sample) {
    depths = candidate.depths(trial.scene(), trial.conventions());
    if (depths.size() != image.size())
      throw CandidateFailed("depths() returned too few or too many pixels");
  }
  const SpheresMet met = spheres_met(trial);
  std::size_t unidentified = 0, unclear = 0;
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    if (met.is_unjudged[k]) continue;
    const Pixel& pixel = trial.pixels()[k];
    const auto at = static_cast<std::size_t>(pixel.j * width + pixel.i);
    const Choice choice{k, image[at], trial.exact_nearest()[k], "in the picture"};
    if (choice.got == kUnclear) {
      ++unclear;
      continue;
    }
    unidentified += choice.got == kSomeSphere && choice.exact ? 1 : 0;
    judge_choice(trial, verdict, choice, met.expected(k), [&] { return excuse_of(trial, choice); });
    if (!depths.empty() && choice.got && choice.exact) {
      measure_depth(trial, verdict, k, depths[at]);
    }
  }
  if (candidate.depths && depths.empty()) {
    verdict.leave_out("depths, because any point of a pixel may be its sample");
  }
  if (unidentified > 0 && !candidate.depths) {
    verdict.leave_out("pixels whose colour is not that of a sphere are judged only as hit or miss");
  }
  if (unclear > 0)
    verdict.leave_out(
        "pixels whose colour is unclear, because a JPEG does not keep colours exactly");
}

constexpr Law kNearestSphereLawTable[] = {
    {"nearest-sphere", "the nearest sphere wins, whatever the order in the file", Per::kRay,
     Needs::kNearest | Needs::kSpheres | Needs::kRays | Needs::kSeveralSpheres,
     Quantity::kNearestSphere, judge_nearest_sphere, kValues, Stage::kIntersection, kStability},
    {"visible-sphere", "every pixel shows the nearest sphere of its ray, under every plan",
     Per::kRay, Needs::kVisible | Needs::kSpheres, Quantity::kNearestSphere, judge_visible_sphere},
    {"image", "every pixel of an image shows the sphere that its ray meets first", Per::kImage,
     Needs::kImage | Needs::kSpheres, Quantity::kNearestSphere, judge_image, kValues},
};

}  // namespace

constinit const std::span<const Law> kNearestSphereLaws = kNearestSphereLawTable;

}  // namespace raycheck::properties
