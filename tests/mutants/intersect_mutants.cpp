#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "fast/intersect.h"
#include "properties/fast_candidate.h"
#include "tests/mutants/mutants.h"

namespace raycheck::mutants {
namespace {

using properties::Candidate;
using properties::HitAnswer;
using scene::Conventions;
using scene::Point3;
using scene::Ray;
using scene::Root;
using scene::Sphere;
using Hit = std::optional<HitAnswer>;
using Index = std::optional<std::size_t>;

Candidate named(std::string name) {
  Candidate candidate = unmutated();
  candidate.name = std::move(name);
  return candidate;
}

HitAnswer hit_at(const Ray& ray, double s) {
  return {s, Point3{ray.origin.x + s * ray.direction.x, ray.origin.y + s * ray.direction.y,
                    ray.origin.z + s * ray.direction.z}};
}

/// One sphere at a time, an answer a ray: what mutants change.
using AskSphere =
    std::function<std::vector<Hit>(Candidate::Rays, const Sphere&, const Conventions&)>;

AskSphere unmutated_hits() {
  return [base = unmutated().intersect](Candidate::Rays rays, const Sphere& sphere,
                                        const Conventions& conventions) {
    std::vector<Hit> hits(rays.size());
    const auto found = base(rays, std::span(&sphere, 1), conventions);
    for (const auto& [ray, hit] : found.front()) hits[ray] = hit;
    return hits;
  };
}

/// The hits by `ask`, and the nearest sphere by these, as nearest_spheres() has it.
void answer_by(Candidate& candidate, const AskSphere& ask) {
  candidate.intersect = [ask](Candidate::Rays rays, Candidate::Spheres spheres,
                              const Conventions& conventions) {
    std::vector<properties::SphereHits> answers(spheres.size());
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
    std::vector<Index> nearest(rays.size());
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

/// Spheres changed before they are intersected.
Candidate with_sphere(std::string name, std::function<Sphere(const Sphere&)> change) {
  Candidate candidate = named(std::move(name));
  answer_by(candidate, [base = unmutated_hits(), change](Candidate::Rays rays, const Sphere& sphere,
                                                         const Conventions& conventions) {
    return base(rays, change(sphere), conventions);
  });
  return candidate;
}

/// Answers changed after the fact.
Candidate with_hits(std::string name,
                    std::function<Hit(const Ray&, const Sphere&, const Hit&)> change) {
  Candidate candidate = named(std::move(name));
  answer_by(candidate, [base = unmutated_hits(), change](Candidate::Rays rays, const Sphere& sphere,
                                                         const Conventions& conventions) {
    std::vector<Hit> hits = base(rays, sphere, conventions);
    for (std::size_t k = 0; k < hits.size(); ++k) hits[k] = change(rays[k], sphere, hits[k]);
    return hits;
  });
  return candidate;
}

/// Another choice among the two roots, of which the method is sure; input is checked as before.
Candidate with_choice(std::string name,
                      std::function<Hit(const Ray&, const fast::Roots&, const Conventions&)> choose,
                      bool checked = true) {
  Candidate candidate = named(std::move(name));
  answer_by(candidate,
            [base = unmutated_hits(), choose, checked](Candidate::Rays rays, const Sphere& sphere,
                                                       const Conventions& conventions) {
              if (checked) base(rays, sphere, conventions);
              std::vector<Hit> hits;
              for (const Ray& ray : rays) {
                hits.push_back(choose(ray, fast::kCross.roots(ray, sphere), conventions));
              }
              return hits;
            });
  return candidate;
}

/// What direct/cross chooses, but for a least s and a least discriminant.
Hit usual_choice(const Ray& ray, const fast::Roots& roots, const Conventions& conventions,
                 double least_s = 0, double least_half_chord_sq = 0) {
  if (!(roots.half_chord_sq >= least_half_chord_sq)) return {};
  if (roots.smaller >= least_s) return hit_at(ray, roots.smaller);
  if (conventions.root == Root::kSmaller || !(roots.larger >= least_s)) return {};
  return hit_at(ray, roots.larger);
}

std::vector<Mutant> choice_mutants() {
  using fast::Roots;
  return {
      {"always the far root",
       {"nearest-root"},
       with_choice("far-root",
                   [](const Ray& ray, const Roots& roots, const Conventions&) -> Hit {
                     if (!(roots.half_chord_sq >= 0 && roots.larger >= 0)) return {};
                     return hit_at(ray, roots.larger);
                   })},
      {"no test for s >= 0: what is behind counts",
       {"class", "nearest-sphere"},
       with_choice("behind-counts",
                   [](const Ray& ray, const Roots& roots, const Conventions&) -> Hit {
                     if (!(roots.half_chord_sq >= 0)) return {};
                     return hit_at(ray, roots.smaller);
                   })},
      {"the larger root is never tried: from inside, nothing is seen",
       {"class", "growing-radius"},
       with_choice("never-from-inside",
                   [](const Ray& ray, const Roots& roots, const Conventions&) -> Hit {
                     if (!(roots.half_chord_sq >= 0 && roots.smaller >= 0)) return {};
                     return hit_at(ray, roots.smaller);
                   })},
      {"the near root counts from s = 1e-3 on",
       {"nearest-root", "scaling"},
       with_choice("epsilon-on-s",
                   [](const Ray& ray, const Roots& roots, const Conventions& conventions) {
                     return usual_choice(ray, roots, conventions, 1e-3);
                   })},
      {"a discriminant above -1e-9 is taken for a tangent",
       {"class"},
       with_choice("epsilon-on-discriminant",
                   [](const Ray& ray, Roots roots, const Conventions& conventions) {
                     if (roots.half_chord_sq < 0 && roots.half_chord_sq > -1e-9) {
                       const double size = std::sqrt(ray.direction.x * ray.direction.x +
                                                     ray.direction.y * ray.direction.y +
                                                     ray.direction.z * ray.direction.z);
                       roots.half_chord_sq = 0;
                       roots.smaller = roots.larger = roots.axial_distance / size;
                     }
                     return usual_choice(ray, roots, conventions);
                   })},
      {"input is not checked",
       {"refusal"},
       with_choice(
           "no-input-check",
           [](const Ray& ray, const Roots& roots, const Conventions& conventions) {
             return usual_choice(ray, roots, conventions);
           },
           false)},
  };
}

std::vector<Mutant> value_mutants() {
  return {
      {"spheres are fattened by 1e-6",
       {"class", "parameter", "scaling"},
       with_sphere("fattened",
                   [](Sphere sphere) {
                     sphere.radius += 1e-6;
                     return sphere;
                   })},
      {"spheres wider than 16 are culled",
       {"growing-radius", "class"},
       with_hits("large-spheres-vanish",
                 [](const Ray&, const Sphere& sphere, const Hit& hit) {
                   return sphere.radius > 16 ? Hit() : hit;
                 })},
      {"the centre's z is kept in single precision",
       {"axes", "parameter", "hit-point"},
       with_sphere("single-z",
                   [](Sphere sphere) {
                     if (std::abs(sphere.centre.z) < 1e30) {
                       sphere.centre.z = static_cast<double>(static_cast<float>(sphere.centre.z));
                     }
                     return sphere;
                   })},
      {"Q = s D: the origin is forgotten",
       {"hit-point"},
       with_hits("origin-forgotten",
                 [](const Ray& ray, const Sphere&, Hit hit) {
                   if (hit) hit->point = hit_at({{}, ray.direction}, hit->parameter).point;
                   return hit;
                 })},
      {"Q is kept in single precision",
       {"hit-point"},
       with_hits("single-point",
                 [](const Ray&, const Sphere&, Hit hit) {
                   if (!hit) return hit;
                   for (double* x : {&hit->point.x, &hit->point.y, &hit->point.z}) {
                     if (std::abs(*x) < 1e30) *x = static_cast<double>(static_cast<float>(*x));
                   }
                   return hit;
                 })},
      {"s is kept in single precision",
       {"parameter", "backward-error"},
       with_hits("single-parameter",
                 [](const Ray& ray, const Sphere&, const Hit& hit) -> Hit {
                   if (!hit || !(hit->parameter < 1e30)) return hit;
                   return hit_at(ray, static_cast<double>(static_cast<float>(hit->parameter)));
                 })},
      {"s is a length whatever the length of the direction",
       {"parameter"},
       with_hits("s-is-a-length",
                 [](const Ray& ray, const Sphere&, Hit hit) {
                   if (hit) {
                     hit->parameter *=
                         std::hypot(ray.direction.x, ray.direction.y, ray.direction.z);
                   }
                   return hit;
                 })},
  };
}

Candidate naive_discriminant() {
  Candidate candidate = properties::fast_candidate(fast::kDirectRays, fast::kQuadratic);
  candidate.name = "naive-discriminant";
  return candidate;
}

/// The first sphere of the file that is met, or the last.
Candidate by_file_order(std::string name, bool first) {
  Candidate candidate = named(std::move(name));
  candidate.nearest = [ask = unmutated_hits(), first](Candidate::Rays rays,
                                                      Candidate::Spheres spheres,
                                                      const Conventions& conventions) {
    std::vector<Index> chosen(rays.size());
    for (std::size_t index = 0; index < spheres.size(); ++index) {
      const std::vector<Hit> hits = ask(rays, spheres[index], conventions);
      for (std::size_t k = 0; k < rays.size(); ++k) {
        if (hits[k] && !(first && chosen[k])) chosen[k] = index;
      }
    }
    return chosen;
  };
  return candidate;
}

}  // namespace

std::vector<Mutant> intersect_mutants() {
  std::vector<Mutant> all = {
      {"the textbook's b^2 - 4ac",
       {"class", "parameter", "backward-error", "nearest-sphere"},
       naive_discriminant()},
      {"the first sphere of the file wins", {"nearest-sphere"}, by_file_order("first-wins", true)},
      {"the last sphere of the file wins", {"nearest-sphere"}, by_file_order("last-wins", false)}};
  for (auto& more : {choice_mutants(), value_mutants()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace raycheck::mutants
