#include "properties/mistakes/altered_hits.h"

#include <span>
#include <utility>

namespace raycheck::properties {

using scene::Conventions;
using scene::Ray;
using scene::Sphere;

namespace {

HitFormulas completed(HitFormulas formulas) {
  if (!formulas.roots) formulas.roots = fast::kCross.roots;
  if (!formulas.choose) formulas.choose = usual_choice;
  return formulas;
}

}  // namespace

HitAnswer hit_at(const Ray& ray, double s) {
  return {s, scene::Point3{ray.origin.x + s * ray.direction.x, ray.origin.y + s * ray.direction.y,
                           ray.origin.z + s * ray.direction.z}};
}

AskSphere hits_of(const Candidate& candidate) {
  return [ask = candidate.intersect](Candidate::Rays rays, const Sphere& sphere,
                                     const Conventions& conventions) {
    std::vector<Hit> hits(rays.size());
    const auto found = ask(rays, std::span(&sphere, 1), conventions);
    for (const auto& [ray, hit] : found.front()) hits[ray] = hit;
    return hits;
  };
}

void answer_by(Candidate& candidate, const AskSphere& ask) {
  candidate.intersect = [ask](Candidate::Rays rays, Candidate::Spheres spheres,
                              const Conventions& conventions) {
    std::vector<SphereHits> answers(spheres.size());
    for (std::size_t index = 0; index < spheres.size(); ++index) {
      const std::vector<Hit> hits = ask(rays, spheres[index], conventions);
      for (std::size_t k = 0; k < hits.size(); ++k) {
        if (hits[k]) answers[index].push_back({k, *hits[k]});
      }
    }
    return answers;
  };
  candidate.nearest = [ask](Candidate::Rays rays, Candidate::Spheres spheres,
                            const Conventions& conventions) {
    std::vector<std::optional<std::size_t>> nearest(rays.size());
    std::vector<double> parameter(rays.size());
    for (std::size_t index = 0; index < spheres.size(); ++index) {
      const std::vector<Hit> hits = ask(rays, spheres[index], conventions);
      for (std::size_t k = 0; k < rays.size(); ++k) {
        if (!hits[k] || (nearest[k] && parameter[k] <= hits[k]->parameter)) continue;
        nearest[k] = index;
        parameter[k] = hits[k]->parameter;
      }
    }
    return nearest;
  };
}

bool meets(const fast::Roots& roots, const Conventions& conventions) {
  return conventions.tangent == scene::Tangent::kMiss ? roots.half_chord_sq > 0
                                                      : roots.half_chord_sq >= 0;
}

Hit usual_choice(const Ray& ray, const fast::Roots& roots, const Conventions& conventions) {
  if (!meets(roots, conventions)) return {};
  if (roots.smaller >= 0) return hit_at(ray, roots.smaller);
  if (conventions.root == scene::Root::kSmaller || !(roots.larger >= 0)) return {};
  return hit_at(ray, roots.larger);
}

std::optional<HitFormulas> joined(HitFormulas one, const HitFormulas& other) {
  const auto join = [](auto& its, const auto& others) {
    const bool is_free = !its || !others;
    if (others) its = others;
    return is_free;
  };
  const bool all_free =
      join(one.roots, other.roots) && join(one.choose, other.choose) && join(one.rank, other.rank);
  return all_free ? std::optional(std::move(one)) : std::nullopt;
}

AskSphere hits_by(HitFormulas formulas) {
  return [formulas = completed(std::move(formulas))](Candidate::Rays rays, const Sphere& sphere,
                                                     const Conventions& conventions) {
    std::vector<Hit> hits;
    for (const Ray& ray : rays) {
      hits.push_back(formulas.choose(ray, formulas.roots(ray, sphere), conventions));
    }
    return hits;
  };
}

NearestSpheres nearest_by(HitFormulas given) {
  return [formulas = completed(std::move(given))](Candidate::Rays rays, Candidate::Spheres spheres,
                                                  const Conventions& conventions) {
    std::vector<std::optional<std::size_t>> nearest(rays.size());
    for (std::size_t k = 0; k < rays.size(); ++k) {
      double least = 0;
      for (std::size_t index = 0; index < spheres.size(); ++index) {
        const fast::Roots roots = formulas.roots(rays[k], spheres[index]);
        const Hit hit = formulas.choose(rays[k], roots, conventions);
        if (!hit) continue;
        const double its =
            formulas.rank ? formulas.rank(index, rays[k], spheres[index], roots, hit->parameter)
                          : hit->parameter;
        if (nearest[k] && least <= its) continue;
        nearest[k] = index;
        least = its;
      }
    }
    return nearest;
  };
}

}  // namespace raycheck::properties
