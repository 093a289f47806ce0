#pragma once

// A case with one ray and one sphere; candidates that give the same answer to every question, or
// miss some spheres.

#include "properties/candidates/fast_candidate.h"
#include "properties/laws/law.h"
#include "properties/trial.h"
#include "tests/standard.h"

namespace raycheck::properties {

inline Case one_ray(const scene::Ray& ray, const scene::Sphere& sphere) {
  Case the_case;
  the_case.scene.rays = {ray};
  the_case.scene.spheres = {sphere};
  return the_case;
}

/// A unit sphere at the origin and a ray along x at a height.
inline Case at_height(double height) {
  return one_ray({{-5, height, 0}, {1, 0, 0}}, {{0, 0, 0}, 1});
}

inline Candidate that_answers(std::optional<HitAnswer> answer) {
  Candidate candidate;
  candidate.intersect = [answer](Candidate::Rays rays, Candidate::Spheres spheres, const auto&) {
    SphereHits hits;
    for (std::size_t k = 0; answer && k < rays.size(); ++k) hits.push_back({k, *answer});
    return std::vector(spheres.size(), hits);
  };
  return candidate;
}

/// direct/cross, but it misses the spheres for which `misses` is true.
inline Candidate that_misses(bool (*misses)(const scene::Sphere&)) {
  Candidate candidate = fast_candidate(fast::kDirectRays, fast::kCross);
  candidate.classes_in = {};
  candidate.intersect = [misses, ask = candidate.intersect](
                            Candidate::Rays rays, Candidate::Spheres spheres, const auto& by) {
    auto answers = ask(rays, spheres, by);
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      if (misses(spheres[k])) answers[k].clear();
    }
    return answers;
  };
  return candidate;
}

inline Verdict judge(std::string_view law, const Case& the_case, const Candidate& candidate,
                     const TrialOptions& options = {}) {
  Trial trial(the_case, candidate, options);
  return apply(*find_law(law), trial);
}

}  // namespace raycheck::properties
