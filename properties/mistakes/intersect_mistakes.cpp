// Wrong choices among roots and among spheres.

#include <cmath>
#include <utility>

#include "properties/mistakes/altered_hits.h"
#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

using fast::Roots;
using scene::Conventions;
using scene::Ray;
using scene::Sphere;

double length(const scene::Vector3& v) { return std::hypot(v.x, v.y, v.z); }

Mistake choice(std::string sentence, const ChooseHit& choose) {
  return hit_mistake(std::move(sentence), {.choose = choose});
}

/// Right hits, changed afterwards; pictures do not show it.
Mistake value(std::string sentence, const std::function<HitAnswer(const Ray&, HitAnswer)>& change) {
  Candidate candidate = right_candidate();
  answer_by(candidate,
            [ask = hits_of(candidate), change](Candidate::Rays rays, const Sphere& sphere,
                                               const Conventions& conventions) {
              std::vector<Hit> hits = ask(rays, sphere, conventions);
              for (std::size_t k = 0; k < hits.size(); ++k) {
                if (hits[k]) hits[k] = change(rays[k], *hits[k]);
              }
              return hits;
            });
  return {
      .sentence = std::move(sentence), .step = Step::kIntersect, .candidate = std::move(candidate)};
}

Hit wherever_behind(const Ray& ray, const Roots& roots, const Conventions& conventions) {
  return meets(roots, conventions) ? Hit(hit_at(ray, roots.smaller)) : Hit();
}

/// -v - d and -v + d
Roots roots_of_turned(const Ray& ray, const Sphere& sphere) {
  const auto [v, half_chord_sq, smaller, larger] = fast::kCross.roots(ray, sphere);
  return {-v, half_chord_sq, -larger, -smaller};
}

/// v - d^2 and v + d^2
Roots roots_without_root(const Ray& ray, const Sphere& sphere) {
  const auto [v, half_chord_sq, smaller, larger] = fast::kCross.roots(ray, sphere);
  const double size = length(ray.direction);
  return {v, half_chord_sq, (v - half_chord_sq) / size, (v + half_chord_sq) / size};
}

std::vector<Mistake> root_mistakes() {
  return {
      hit_mistake("T = L - C: v has the wrong sign", {.roots = roots_of_turned}),
      hit_mistake("the square root is left out: s = v - d^2", {.roots = roots_without_root}),
      choice("s >= 0 is not tested: spheres behind the origin are hit", wherever_behind),
      choice("the far root is taken for the near one",
             [](const Ray& ray, const Roots& roots, const Conventions& conventions) -> Hit {
               if (!meets(roots, conventions) || !(roots.larger >= 0)) return {};
               return hit_at(ray, roots.larger);
             }),
      choice("v < 0 counts as a miss, so that spheres around the origin are not seen where their "
             "centres lie behind it",
             [](const Ray& ray, const Roots& roots, const Conventions& conventions) -> Hit {
               return roots.axial_distance < 0 ? Hit() : usual_choice(ray, roots, conventions);
             }),
      value("Q = s D: the origin is not added",
            [](const Ray& ray, const HitAnswer& hit) {
              return HitAnswer{hit.parameter, hit_at({{}, ray.direction}, hit.parameter).point};
            }),
      value("s is a length whatever the length of the direction",
            [](const Ray& ray, const HitAnswer& hit) {
              return HitAnswer{hit.parameter * length(ray.direction), hit.point};
            }),
  };
}

/// The hits stay as they are.
Mistake winner(std::string sentence, const RankSphere& rank, const ChooseHit& choose = {}) {
  Mistake mistake = {.sentence = std::move(sentence), .step = Step::kNearest};
  mistake.hits = {.choose = choose, .rank = rank};
  mistake.candidate = right_candidate();
  mistake.candidate.nearest = nearest_by(mistake.hits);
  return mistake;
}

std::vector<Mistake> winner_mistakes() {
  const auto by_index = [](double sign) {
    return [sign](std::size_t index, auto&&...) { return sign * static_cast<double>(index); };
  };
  const auto by_discriminant = [](double sign) {
    return [sign](std::size_t, const Ray&, const Sphere&, const Roots& roots, double) {
      return sign * roots.half_chord_sq;
    };
  };
  const auto by_parameter = [](double sign) {
    return
        [sign](std::size_t, const Ray&, const Sphere&, const Roots&, double s) { return sign * s; };
  };
  return {
      winner("the first sphere in the file wins", by_index(1)),
      winner("the last sphere in the file wins", by_index(-1)),
      winner("the sphere with the largest discriminant wins", by_discriminant(-1)),
      winner("the sphere with the smallest discriminant wins", by_discriminant(1)),
      winner("the sphere whose centre is nearest wins",
             [](std::size_t, const Ray& ray, const Sphere& sphere, const Roots&, double) {
               return length(sphere.centre - ray.origin);
             }),
      winner("the smallest s wins, though it is negative", by_parameter(1), wherever_behind),
      winner(
          "s >= 0 is not tested, and the least |s| wins, though s is negative",
          [](std::size_t, const Ray&, const Sphere&, const Roots&, double s) {
            return std::abs(s);
          },
          wherever_behind),
      winner("the farthest sphere wins", by_parameter(-1)),
  };
}

}  // namespace

std::vector<Mistake> intersect_mistakes() {
  std::vector<Mistake> all = root_mistakes();
  for (Mistake& mistake : winner_mistakes()) all.push_back(std::move(mistake));
  return all;
}

}  // namespace raycheck::properties
