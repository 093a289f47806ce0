#include "properties/mistakes/changed_question.h"

#include <utility>

#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

using scene::Camera;
using scene::Conventions;
using scene::Origin;
using scene::Pixel;

/// The arguments of a question about a camera's pixels.
struct Input {
  Camera camera;
  Conventions conventions;
  std::vector<Pixel> pixels;
};

Input changed(const Mistake& mistake, const Camera& camera, const Conventions& conventions,
              Candidate::Pixels pixels) {
  Input input = {camera, conventions, {pixels.begin(), pixels.end()}};
  if (mistake.camera) mistake.camera(input.camera, conventions);
  if (mistake.conventions) mistake.conventions(input.conventions);
  if (mistake.pixel) {
    for (Pixel& one : input.pixels) one = mistake.pixel(camera, conventions, one);
  }
  return input;
}

/// Computes hits with other spheres, or under other conventions.
void change_hits(Candidate& candidate, const Mistake& mistake) {
  if (!mistake.conventions && !mistake.sphere) return;
  const auto asked_of = [mistake](const auto& answer) {
    return [mistake, answer](Candidate::Rays rays, Candidate::Spheres spheres,
                             Conventions conventions) {
      std::vector<scene::Sphere> others(spheres.begin(), spheres.end());
      if (mistake.sphere) {
        for (scene::Sphere& sphere : others) mistake.sphere(sphere);
      }
      if (mistake.conventions) mistake.conventions(conventions);
      return answer(rays, others, conventions);
    };
  };
  candidate.intersect = asked_of(candidate.intersect);
  candidate.nearest = asked_of(candidate.nearest);
}

/// Changes every question before it is answered; one about given rays only in its conventions and
/// spheres.
Mistake with_candidate(Mistake mistake) {
  const Candidate right = right_candidate();
  Candidate candidate = right;
  candidate.frame = [right, mistake](const Camera& camera) {
    return right.frame(changed(mistake, camera, {}, {}).camera);
  };
  candidate.pixel_points = [right, mistake](const Camera& camera, const Conventions& conventions,
                                            Candidate::Pixels pixels) {
    const Input input = changed(mistake, camera, conventions, pixels);
    return right.pixel_points(input.camera, input.conventions, input.pixels);
  };
  const auto rays_from = [&](Origin origin) {
    return [right, mistake, origin](const Camera& camera, Conventions conventions,
                                    Candidate::Pixels pixels) {
      conventions.origin = origin;
      const Input input = changed(mistake, camera, conventions, pixels);
      const auto& rays =
          input.conventions.origin == Origin::kPixel ? right.pixel_rays : right.focal_rays;
      return rays(input.camera, input.conventions, input.pixels);
    };
  };
  candidate.pixel_rays = rays_from(Origin::kPixel);
  candidate.focal_rays = rays_from(Origin::kFocal);
  change_hits(candidate, mistake);
  mistake.candidate = std::move(candidate);
  return mistake;
}

}  // namespace

Mistake scene_mistake(std::string sentence, Step step, const ChangeCamera& camera,
                      const ChangeSphere& sphere) {
  Mistake mistake = {.sentence = std::move(sentence), .step = step};
  mistake.camera = camera;
  mistake.sphere = sphere;
  return with_candidate(std::move(mistake));
}

Mistake camera_mistake(std::string sentence, const ChangeCamera& change, Step step) {
  return scene_mistake(std::move(sentence), step, change, {});
}

Mistake convention_mistake(std::string sentence, const ChangeConventions& change, Step step) {
  Mistake mistake = {.sentence = std::move(sentence), .step = step};
  mistake.conventions = change;
  return with_candidate(std::move(mistake));
}

Mistake pixel_mistake(std::string sentence, const ChangePixel& change) {
  Mistake mistake = {.sentence = std::move(sentence), .step = Step::kPixelPoint};
  mistake.pixel = change;
  return with_candidate(std::move(mistake));
}

}  // namespace raycheck::properties
