#include <cstdint>
#include <stdexcept>

#include "properties/laws/law_list.h"
#include "properties/sphere_choice.h"

namespace raycheck::properties {
namespace {

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
  return excuse(trial, choice.ray, choice.got, candidate.excused_image_change);
}

void judge_image(Trial& trial, Verdict& verdict) {
  const Candidate& candidate = trial.candidate();
  const scene::Camera& camera = *trial.scene().camera;
  const ImageAnswer image = candidate.image(trial.scene(), trial.conventions());
  const std::int64_t width = camera.width;
  if (image.size() != static_cast<std::size_t>(width * camera.height)) {
    throw CandidateFailed("image() returned too few or too many pixels");
  }
  const SpheresMet met = spheres_met(trial);
  std::size_t unidentified = 0;
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    if (met.is_unjudged[k]) continue;
    const scene::Pixel& pixel = trial.pixels()[k];
    const Choice choice{k, image[static_cast<std::size_t>(pixel.j * width + pixel.i)],
                        trial.exact_nearest()[k], "in the picture"};
    unidentified += choice.got == kSomeSphere && choice.exact ? 1 : 0;
    judge_choice(trial, verdict, choice, met.expected(k), [&] { return excuse_of(trial, choice); });
  }
  if (unidentified > 0) {
    verdict.leave_out("pixels whose colour is not that of a sphere are judged only as hit or miss");
  }
}

constexpr Law kImageLawTable[] = {
    {.name = "image",
     .sentence = "every pixel of an image shows the sphere that its ray meets first",
     .per = Per::kImage,
     .needs = Needs::kImage | Needs::kSpheres,
     .quantity = Quantity::kNearestSphere,
     .judges_values = true,
     .judge = judge_image},
};

}  // namespace

constinit const std::span<const Law> kImageLaws = kImageLawTable;

}  // namespace raycheck::properties
