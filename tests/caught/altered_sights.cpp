#include "tests/caught/altered_sights.h"

#include <functional>

namespace raycheck::caught {
namespace {

using properties::Candidate;
using properties::HitAnswer;
using properties::SeenAnswer;
using properties::SphereHits;
using scene::Conventions;
using scene::Scene;

/// What is seen of the spheres, changed; the nearest is the one of the least s.
using ChangeSight = std::function<void(Sight&)>;

void rank(Sight& sight) {
  const auto is_hit = [&](std::size_t k) { return sight.spheres[k].hit.has_value(); };
  // Where doubles tie, the exact order stays.
  if (sight.nearest && !is_hit(*sight.nearest)) sight.nearest.reset();
  for (std::size_t k = 0; k < sight.spheres.size(); ++k) {
    if (!is_hit(k)) continue;
    if (!sight.nearest ||
        sight.spheres[k].hit->parameter < sight.spheres[*sight.nearest].hit->parameter) {
      sight.nearest = k;
    }
  }
}

Candidate with_sights(const ExactParts& exact, const ChangeSight& change) {
  Candidate candidate = exact.candidate;
  const auto of_rays = [sights = exact.sights, change](Candidate::Rays rays,
                                                       Candidate::Spheres spheres,
                                                       const Conventions& conventions) {
    std::vector<Sight> seen =
        sights->of({rays.begin(), rays.end()}, {spheres.begin(), spheres.end()}, conventions);
    for (Sight& sight : seen) change(sight);
    return seen;
  };
  candidate.intersect = [of_rays](Candidate::Rays rays, Candidate::Spheres spheres,
                                  const Conventions& conventions) {
    const std::vector<Sight> seen = of_rays(rays, spheres, conventions);
    std::vector<SphereHits> answers(spheres.size());
    for (std::size_t k = 0; k < seen.size(); ++k) {
      for (std::size_t sphere = 0; sphere < spheres.size(); ++sphere) {
        if (const auto& hit = seen[k].spheres[sphere].hit) answers[sphere].push_back({k, *hit});
      }
    }
    return answers;
  };
  candidate.nearest = [of_rays](Candidate::Rays rays, Candidate::Spheres spheres,
                                const Conventions& conventions) {
    std::vector<std::optional<std::size_t>> answers;
    for (const Sight& sight : of_rays(rays, spheres, conventions)) answers.push_back(sight.nearest);
    return answers;
  };
  candidate.visible = [sights = exact.sights, change](const Scene& scene,
                                                      const Conventions& conventions,
                                                      Candidate::Pixels pixels) {
    std::vector<std::optional<SeenAnswer>> answers;
    for (Sight sight : sights->of(scene, conventions, {pixels.begin(), pixels.end()})) {
      change(sight);
      answers.emplace_back();
      if (sight.nearest) {
        answers.back() = {*sight.nearest, sight.spheres[*sight.nearest].hit->parameter};
      }
    }
    return answers;
  };
  candidate.image = [see = candidate.visible, looked_at = exact.looked_at](
                        const Scene& scene, const Conventions& conventions) {
    return image_of(scene, *looked_at, see(scene, conventions, *looked_at));
  };
  return candidate;
}

}  // namespace

Candidate flipped_band(const ExactParts& exact, double size) {
  return with_sights(exact, [size](Sight& sight) {
    for (Sighting& sphere : sight.spheres) {
      if (!(sphere.to_tangency < size)) continue;
      if (sphere.hit) {
        sphere.hit.reset();
      } else if (sphere.middle >= 0) {
        sphere.hit = HitAnswer{sphere.middle, {}};
      }
    }
    rank(sight);
  });
}

Candidate epsilon_in_s(const ExactParts& exact, double size) {
  return with_sights(exact, [size](Sight& sight) {
    for (Sighting& sphere : sight.spheres) {
      if (sphere.hit && sphere.hit->parameter < size) sphere.hit.reset();
    }
    rank(sight);
  });
}

Candidate farther_sphere(const ExactParts& exact, double size) {
  return with_sights(exact, [size](Sight& sight) {
    if (!sight.nearest) return;
    const double least = sight.spheres[*sight.nearest].hit->parameter;
    double most = least;
    for (std::size_t k = 0; k < sight.spheres.size(); ++k) {
      const auto& hit = sight.spheres[k].hit;
      if (!hit || !(hit->parameter > most) || hit->parameter > least * (1 + size)) continue;
      most = hit->parameter;
      sight.nearest = k;
    }
  });
}

}  // namespace raycheck::caught
