#include "properties/mistakes/altered_hits.h"

#include <cmath>
#include <span>
#include <utility>

namespace raycheck::properties {

namespace {

HitFormulas completed(HitFormulas formulas) {
  if (!formulas.roots) formulas.roots = fast::kCross.roots;
  if (!formulas.choose) formulas.choose = usual_choice;
  return formulas;
}

bool is_between(double s, const scene::ValidRoots& valid) {
  return (valid.includes_min() ? s >= valid.t_min : s > valid.t_min) &&
         (valid.includes_max() ? s <= valid.t_max : s < valid.t_max);
}

/// Domain: formulas with roots and choose.
Hit chosen(const HitFormulas& formulas, const Ray& ray, const Sphere& sphere,
           const fast::Roots& roots, Conventions conventions) {
  conventions.valid = in_multiples(conventions.valid, ray, sphere);
  return formulas.choose(ray, roots, conventions);
}

}  // namespace

HitAnswer hit_at(const Ray& ray, double s) {
  return {s, Point3{ray.origin.x + s * ray.direction.x, ray.origin.y + s * ray.direction.y,
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

bool smaller_counts(const fast::Roots& roots, const scene::ValidRoots& valid) {
  return valid.culling != scene::Culling::kFrontFaces && is_between(roots.smaller, valid);
}

bool larger_counts(const fast::Roots& roots, const scene::ValidRoots& valid) {
  return valid.culling != scene::Culling::kBackFaces && is_between(roots.larger, valid);
}

scene::ValidRoots in_multiples(scene::ValidRoots valid, const Ray& ray, const Sphere& sphere) {
  if (valid.unit == scene::TUnit::kAbsolute) return valid;
  const auto& [x, y, z] = ray.direction;
  const double length =
      (valid.unit == scene::TUnit::kRadius ? sphere.radius : 1) / std::hypot(x, y, z);
  valid.unit = scene::TUnit::kAbsolute;
  if (valid.t_min != 0) valid.t_min *= length;
  valid.t_max *= length;
  return valid;
}

Hit usual_choice(const Ray& ray, const fast::Roots& roots, const Conventions& conventions) {
  if (!meets(roots, conventions)) return {};
  if (smaller_counts(roots, conventions.valid)) return hit_at(ray, roots.smaller);
  const bool is_tried = conventions.root == scene::Root::kNearest;
  return is_tried && larger_counts(roots, conventions.valid) ? Hit(hit_at(ray, roots.larger))
                                                             : Hit();
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
      hits.push_back(chosen(formulas, ray, sphere, formulas.roots(ray, sphere), conventions));
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
        const Hit hit = chosen(formulas, rays[k], spheres[index], roots, conventions);
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
