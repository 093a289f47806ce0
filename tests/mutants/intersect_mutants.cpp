
#include "fast/intersect.h"
#include "properties/candidates/fast_candidate.h"
#include "properties/mistakes/altered_hits.h"
#include "tests/mutants/mutants.h"

namespace raycheck::mutants {
namespace {

AskSphere unmutated_hits() { return hits_of(unmutated()); }

/// A mutant that changes spheres before it intersects them.
Candidate with_sphere(std::string name, std::function<Sphere(const Sphere&)> change) {
  Candidate candidate = named(std::move(name));
  answer_by(candidate, [base = unmutated_hits(), change](Candidate::Rays rays, const Sphere& sphere,
                                                         const Conventions& by) {
    return base(rays, change(sphere), by);
  });
  return candidate;
}

/// A mutant that changes right answers.
Candidate with_hits(std::string name,
                    std::function<Hit(const Ray&, const Sphere&, const Conventions&, Hit)> change,
                    bool checked = true) {
  Candidate candidate = named(std::move(name));
  answer_by(candidate,
            [base = unmutated_hits(), change, checked](Candidate::Rays rays, const Sphere& sphere,
                                                       const Conventions& conventions) {
              std::vector<Hit> hits(rays.size());
              if (checked) hits = base(rays, sphere, conventions);
              for (std::size_t k = 0; k < hits.size(); ++k) {
                hits[k] = change(rays[k], sphere, conventions, hits[k]);
              }
              return hits;
            });
  return candidate;
}

/// A mutant that chooses other roots. It checks its input like a right candidate.
Candidate with_choice(std::string name,
                      std::function<Hit(const Ray&, const fast::Roots&, const Conventions&)> choose,
                      bool checked = true) {
  return with_hits(
      std::move(name),
      [choose](const Ray& ray, const Sphere& sphere, const Conventions& conventions, const Hit&) {
        return choose(ray, fast::kCross.roots(ray, sphere), conventions);
      },
      checked);
}

/// The roots of a s^2 + b s + c by q = -(b - sign(b) sqrt(b^2 - 4ac))/2, which cancels; the other
/// sign would not. For an origin on the surface, q is 0 and c/q is NaN.
Hit hit_by_cancelling_roots(const Ray& ray, const Sphere& sphere, const Conventions& conventions,
                            const Hit&) {
  const auto dot = [](const scene::Vector3& u, const scene::Vector3& v) {
    return u.x * v.x + u.y * v.y + u.z * v.z;
  };
  const scene::Vector3 from_centre = ray.origin - sphere.centre;
  const double a = dot(ray.direction, ray.direction);
  const double b = 2 * dot(from_centre, ray.direction);
  const double c = dot(from_centre, from_centre) - sphere.radius * sphere.radius;
  fast::Roots roots;
  roots.half_chord_sq = b * b - 4 * a * c;
  if (!properties::meets(roots, conventions)) return {};
  const double q = -(b - std::copysign(std::sqrt(roots.half_chord_sq), b)) / 2;
  std::tie(roots.smaller, roots.larger) = std::minmax({q / a, c / q});
  if (std::isnan(c / q)) return {};
  return properties::usual_choice(ray, roots, conventions);
}

/// The choice of direct/cross, with a least s and a least discriminant.
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
      from_mistake("far-root", "the far root is taken for the near one", {"nearest-root"}),
      from_mistake("behind-counts", "s >= 0 is not tested: spheres behind the origin are hit",
                   {"class", "nearest-sphere"}),
      from_mistake("never-from-inside",
                   "only the near root counts, so that spheres around the origin are not seen",
                   {"class", "growing-radius", "exchange"}),
      from_mistake("near-from-inside",
                   "the near root is given even if it is negative: spheres around the origin are "
                   "hit behind it",
                   {"nearest-root"}),
      from_mistake("solid", "spheres are solid: from inside s is 0", {"nearest-root"}),
      from_mistake("level-is-missed",
                   "T . D = 0 counts as a miss: rays at right angles to T never hit spheres around "
                   "their origin",
                   {"class"}),
      from_mistake(
          "merged-roots",
          "where d^2 is below about 1e-5 (the limit may be larger) v is taken for both roots: the "
          "epsilon is too large",
          {"parameter", "scaling"}),
      from_mistake(
          "shallow-is-missed",
          "rays that pass less than about 1e-7 radii (the limit may be larger) inside a sphere's "
          "outline miss it: the tolerance is too large",
          {"class"}),
      from_mistake(
          "short-is-missed",
          "directions with a |D|^2 below about 1e-9 (the limit may be larger) hit nothing: the "
          "epsilon is too large",
          {"class"}),
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
                 [](const auto&, const Sphere& sphere, const auto&, const Hit& hit) {
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
      from_mistake("origin-forgotten", "Q = s D: the origin is not added", {"hit-point"}),
      from_mistake("single-point", "Q is rounded to floats", {"hit-point"}),
      from_mistake("single-parameter", "s is rounded to a float", {"parameter", "backward-error"}),
      from_mistake("single-spheres", "the spheres' numbers are rounded to floats", {"parameter"}),
      from_mistake("single-rays", "rays are rounded to floats", {"parameter"}),
      from_mistake("half-the-radius",
                   "the radius is taken for the diameter: spheres are half as large",
                   {"class", "parameter"}),
      from_mistake("twice-the-radius",
                   "the diameter is taken for the radius: spheres are twice as large",
                   {"class", "parameter"}),
      from_mistake("wrapped-square",
                   "r^2 is an integer of 32 bits: it wraps around from a radius of 46,341 on",
                   {"class", "growing-radius", "scaling"}),
      from_mistake("half-of-s", "s is half of the right one", {"parameter"}),
      from_mistake("twice-s", "s is twice the right one", {"parameter"}),
      from_mistake("s-is-a-length", "s is a length, not a multiple of the direction",
                   {"parameter"}),
  };
}

Candidate naive_discriminant() {
  Candidate candidate = properties::fast_candidate(fast::kDirectRays, fast::kQuadratic);
  candidate.name = "naive-discriminant";
  return candidate;
}

}  // namespace

std::vector<Mutant> intersect_mutants() {
  return joined<Mutant>(
      {{{"the textbook's b^2 - 4ac",
         {"class", "parameter", "backward-error", "nearest-sphere"},
         naive_discriminant(),
         properties::Level::kDemanding},
        {"the stable quadratic formula with the sign of its square root the wrong way round",
         {"class", "parameter", "backward-error"},
         with_hits("cancelling-roots", hit_by_cancelling_roots),
         properties::Level::kExtreme},
        from_mistake("first-wins", "the first sphere in the file wins", {"nearest-sphere"}),
        from_mistake("last-wins", "the last sphere in the file wins", {"nearest-sphere"})},
       choice_mutants(),
       value_mutants()});
}

}  // namespace raycheck::mutants
