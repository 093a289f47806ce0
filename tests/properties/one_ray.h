#pragma once

// One ray and one sphere as a case, and candidates that answer every question alike.

#include <optional>
#include <string_view>
#include <vector>

#include "properties/laws/law.h"
#include "properties/trial.h"

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
  candidate.intersect = [answer](Candidate::Rays rays, Candidate::Spheres spheres,
                                 const scene::Conventions&) {
    SphereHits hits;
    for (std::size_t k = 0; answer && k < rays.size(); ++k) hits.push_back({k, *answer});
    return std::vector(spheres.size(), hits);
  };
  return candidate;
}

inline Verdict judge(std::string_view law, const Case& the_case, const Candidate& candidate,
                     const TrialOptions& options = {}) {
  Trial trial(the_case, candidate, options);
  return apply(*find_law(law), trial);
}

}  // namespace raycheck::properties
