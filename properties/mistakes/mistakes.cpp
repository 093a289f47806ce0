#include "properties/mistakes/mistakes.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "properties/candidates/fast_candidate.h"
#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {

Candidate right_candidate() { return fast_candidate(fast::kDirectRays, fast::kCross); }

void find_hits_by(Mistake& mistake, const HitFormulas& formulas) {
  answer_by_choice(mistake.candidate,
                   formulas.roots ? formulas.roots : MakeRoots(fast::kCross.roots),
                   formulas.choose ? formulas.choose : ChooseHit(usual_choice));
  mistake.hits = formulas;
}

Mistake hit_mistake(std::string sentence, const HitFormulas& formulas) {
  Mistake mistake = {.sentence = std::move(sentence), .step = Step::kIntersect};
  mistake.candidate = right_candidate();
  find_hits_by(mistake, formulas);
  return mistake;
}

std::span<const Mistake> mistakes() {
  static const std::vector<Mistake> kMistakes = [] {
    std::vector<Mistake> all;
    for (std::vector<Mistake> more : {input_mistakes(), number_mistakes(), camera_mistakes(),
                                      intersect_mistakes(), threshold_mistakes()}) {
      std::move(more.begin(), more.end(), std::back_inserter(all));
    }
    return all;
  }();
  return kMistakes;
}

const Mistake* find_mistake(std::string_view sentence) {
  const auto all = mistakes();
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const Mistake& mistake) { return mistake.sentence == sentence; });
  return found == all.end() ? nullptr : &*found;
}

scene::Scene mistaken(const Mistake& mistake, scene::Scene scene) {
  const scene::Conventions given = scene.conventions;
  if (mistake.camera) mistake.camera(scene.camera.value(), given);
  if (mistake.conventions) mistake.conventions(scene.conventions);
  if (mistake.sphere) {
    for (scene::Sphere& sphere : scene.spheres) mistake.sphere(sphere);
  }
  return scene;
}

}  // namespace raycheck::properties
