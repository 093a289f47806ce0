// Wrong comparisons with a number: with an epsilon that is too large instead of zero, or with a
// largest s. Of a group, the first mistake whose answers equal the candidate's is named. It
// drops the fewest answers: the actual number may be more extreme.

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

using fast::Roots;

/// The sizes of a group, beginning with the one that drops the fewest answers.
constexpr std::array<const char*, 11> kSizes = {"1e-10", "1e-9",  "1e-8", "1e-7", "1e-6", "1e-5",
                                                "1e-4",  "0.001", "0.01", "0.1",  "1"};
/// Of d^2, c and discriminants, which code compares with squares of epsilons, too.
constexpr std::array<const char*, 14> kSquaredSizes = {"1e-16", "1e-14", "1e-12", "1e-10", "1e-9",
                                                       "1e-8",  "1e-7",  "1e-6",  "1e-5",  "1e-4",
                                                       "0.001", "0.01",  "0.1",   "1"};
/// Of quotients that count as too large.
constexpr std::array<const char*, 6> kQuotients = {"1e16", "1e14", "1e12", "1e10", "1e8", "1e6"};
constexpr std::array<const char*, 8> kLargeSizes = {"1e9", "1e8", "1e7",  "1e6",
                                                    "1e5", "1e4", "1000", "100"};

/// A group of mistakes, and its sentence before and after the size.
struct ThresholdGroup {
  const char* before;
  const char* after;
  std::string_view group;
  std::span<const char* const> sizes;
  Hit (*choose)(double size, const Ray&, const Roots&, const Conventions&);  ///< Null: as usual.
  Roots (*roots)(double size, const Ray&, const Sphere&) = nullptr;
  bool shows_in_pictures = true;
  /// Whether s is in multiples of P - E, because directions are not normalised.
  bool of_steps = false;
};

Hit up_to(double most, const Ray& ray, const Roots& roots, const Conventions& c) {
  const Hit hit = usual_choice(ray, roots, c);
  return hit && hit->parameter <= most ? hit : Hit();
}

/// Sets d^2 = -1 if the line is less than `least` inside the sphere.
Roots roots_of_inner(double least, const Ray& ray, const Sphere& sphere) {
  Roots roots = fast::kCross.roots(ray, sphere);
  const double d_sq = roots.half_chord_sq, r = sphere.radius;
  if (!(d_sq >= 0)) return roots;
  const double depth = d_sq / (r + std::sqrt(std::fmax(0, r * r - d_sq)));
  if (depth < least) roots.half_chord_sq = -1;
  return roots;
}

/// A hit at this distance along the ray: both roots are there.
Roots both_at(double distance, double size) {
  return {distance, 1, distance / size, distance / size};
}

/// The root -c / b twice where c / a, the product of the roots, is above `most`, times `unit`.
Roots linear_roots(double most, double unit, const Ray& ray, const Roots& roots) {
  const double size = norm(ray.direction);
  const double v = roots.axial_distance, d_sq = roots.half_chord_sq;
  const double product = d_sq >= 0 ? roots.smaller * roots.larger : (v * v - d_sq) / (size * size);
  if (!(product > most * unit)) return roots;
  return v == 0 ? Roots{0, -1, 0, 0} : both_at(product * size * size / (2 * v), size);
}

/// A hit by ray marching in steps as long as the distance to the sphere: both roots are where that
/// distance is below `least`.
Roots marched_roots(double least, const Ray& ray, const Sphere& sphere) {
  constexpr int kMostSteps = 200;
  const double size = norm(ray.direction);
  const double farthest = norm(sphere.centre - ray.origin) + sphere.radius;
  double reached = 0;
  for (int step = 0; step < kMostSteps && reached <= farthest; ++step) {
    const auto to_centre = sphere.centre - hit_at(ray, reached / size).point;
    const double left = norm(to_centre) - sphere.radius;
    if (left < least) return both_at(reached, size);
    reached += left;
  }
  return {0, -1, 0, 0};
}

const ThresholdGroup kGroups[] = {
    {"hits with an s below about ",
     " (the limit may be larger) are dropped: the epsilon is too large", "dropped hits", kSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       const Hit hit = usual_choice(ray, roots, c);
       return hit && hit->parameter >= least ? hit : Hit();
     }},
    {"where the near root is below about ",
     " (the limit may be larger) the far one is taken: the epsilon is too large", "far roots",
     kSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       const Hit hit = usual_choice(ray, roots, c);
       if (!hit || hit->parameter >= least) return hit;
       const bool takes_far = c.root != scene::Root::kSmaller && roots.larger >= least;
       return takes_far ? Hit(hit_at(ray, roots.larger)) : Hit();
     }},
    {"where |c| is below about ",
     " (the limit may be larger) the origin counts as on the sphere, and only the other root "
     "counts: the epsilon is too large",
     "roots of the surface", kSquaredSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       const double size = norm(ray.direction), low = roots.smaller, high = roots.larger;
       if (!meets(roots, c) || std::abs(low * high) * size * size >= least)
         return usual_choice(ray, roots, c);
       const double other = std::abs(low) < std::abs(high) ? high : low;
       return usual_choice(ray, both_at(other * size, size), c);
     },
     nullptr, false},
    {"where c / a is above about ",
     " (the limit may be smaller) a counts as 0: the linear equation bs + c = 0 is solved",
     "linear equations", kQuotients, nullptr,
     [](double most, const Ray& ray, const Sphere& sphere) {
       return linear_roots(most, 1, ray, fast::kCross.roots(ray, sphere));
     },
     false},
    {"where c / a is above about ",
     " r^2 (the limit may be smaller) a counts as 0: the linear equation bs + c = 0 is solved",
     "linear equations by radii", kQuotients, nullptr,
     [](double most, const Ray& ray, const Sphere& sphere) {
       const double r = sphere.radius;
       return linear_roots(most, r * r, ray, fast::kCross.roots(ray, sphere));
     },
     false},
    {"a d^2 below about ", " (the limit may be larger) counts as a miss: the epsilon is too large",
     "dropped chords", kSquaredSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       return roots.half_chord_sq >= least ? usual_choice(ray, roots, c) : Hit();
     }},
    {"hits with an s above about ",
     " (the limit may be smaller) are dropped: the largest s that counts is too small", "far hits",
     kLargeSizes, up_to},
    {"hits with an s above about ",
     " (the limit may be smaller), in multiples of P - E, are dropped: the largest s that counts "
     "is too small",
     "far hits", kLargeSizes, up_to, nullptr, true, true},
    {"where d^2 is below about ",
     " (the limit may be larger) v is taken for both roots: the epsilon is too large",
     "merged roots", kSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       const double v = roots.axial_distance;
       if (!meets(roots, c) || roots.half_chord_sq >= least) return usual_choice(ray, roots, c);
       return usual_choice(ray, both_at(v, norm(ray.direction)), c);
     },
     nullptr, false},
    {"where b^2 - 4ac is within about ",
     " (the limit may be larger) of 0, -b/2a is taken for both roots: the epsilon is too large",
     "merged discriminants", kSquaredSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       const double size = norm(ray.direction);
       const bool is_merged = std::abs(4 * size * size * roots.half_chord_sq) <= least;
       return usual_choice(ray, is_merged ? both_at(roots.axial_distance, size) : roots, c);
     },
     nullptr, false},
    {"hits are found by marching, which stops when a sphere is nearer than about ", "", "marched",
     kSizes, nullptr, marched_roots, false},
    {"a d^2 below about ",
     " (the limit may be larger) is replaced by that: the epsilon is too large", "least chords",
     kSquaredSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       if (!meets(roots, c) || roots.half_chord_sq >= least) return usual_choice(ray, roots, c);
       const double v = roots.axial_distance, d = std::sqrt(least), size = norm(ray.direction);
       return usual_choice(ray, {v, least, (v - d) / size, (v + d) / size}, c);
     },
     nullptr, false},
    {"rays that pass less than about ",
     " radii (the limit may be larger) inside a sphere's outline miss it: the tolerance is too "
     "large",
     "shallow chords", kSizes, nullptr,
     [](double least, const Ray& ray, const Sphere& sphere) {
       return roots_of_inner(least * sphere.radius, ray, sphere);
     },
     false},
    {"rays that pass less than about ",
     " (the limit may be larger) inside a sphere's outline miss it: the tolerance is too large",
     "shallow lengths", kSizes, nullptr, roots_of_inner, false},
    {"directions with a |D|^2 below about ",
     " (the limit may be larger) hit nothing: the epsilon is too large", "short directions", kSizes,
     [](double least, const Ray& ray, const Roots& roots, const Conventions& c) {
       const double length = norm(ray.direction);
       return length * length < least ? Hit() : usual_choice(ray, roots, c);
     },
     nullptr, false},
};

/// Code that moves the point of a hit outside, where shadow rays start.
Mistake point_outside(const char* distance) {
  return {.sentence = std::string("Q lies ") + distance +
                      " outside the sphere: it is moved along the normal",
          .step = Step::kIntersect,
          .hit =
              [by = std::atof(distance)](const Ray&, const Sphere& sphere, HitAnswer hit) {
                const Vector3 N = hit.point - sphere.centre;
                const double share = by / norm(N);
                hit.point = {hit.point.x + share * N.x, hit.point.y + share * N.y,
                             hit.point.z + share * N.z};
                return hit;
              },
          .is_offered = returns_points};
}

/// Axes and directions from vectors that are not normalised, or become 0, if |v|^2 is below
/// `least`.
Mistake short_vectors(const char* least, bool are_zero) {
  const auto unit = [size = std::atof(least), are_zero](const Vector3& v) {
    const double length = norm(v);
    return length * length >= size ? normalised(v) : are_zero ? Vector3{} : v;
  };
  return {
      .sentence = std::string("vectors with a squared length below about ") + least +
                  " (the limit may be larger) are " +
                  (are_zero ? "taken for 0" : "not normalised") + ": the epsilon is too large",
      .step = Step::kFrame,
      .rays = {.frame =
                   [=](const Camera& camera) {
                     const Vector3 W = unit(camera.eye - camera.look_at);
                     const Vector3 U = unit(cross(camera.up, W)), V = cross(W, U);
                     return FrameAnswer{{U.x, U.y, U.z}, {V.x, V.y, V.z}, {W.x, W.y, W.z}};
                   },
               .direction = [=](const auto&, const auto&, const Vector3& g) { return unit(g); }},
      .shows_in_pictures = false,
      .group = are_zero ? "vectors made 0" : "vectors left as they are"};
}

}  // namespace

std::vector<Mistake> threshold_mistakes() {
  std::vector<Mistake> all;
  for (const bool are_zero : {false, true}) {
    for (const char* size : kSizes) all.push_back(short_vectors(size, are_zero));
  }
  for (const char* size : kSizes) all.push_back(point_outside(size));
  for (const auto& [before, after, group, sizes, choose, roots, shows, of_steps] : kGroups) {
    for (const char* size : sizes) {
      HitFormulas hits = {.choose = usual_choice};
      if (choose) hits.choose = std::bind_front(choose, std::atof(size));
      if (roots) hits.roots = std::bind_front(roots, std::atof(size));
      all.push_back({.sentence = std::string(before) + size + after,
                     .step = Step::kIntersect,
                     .hits = std::move(hits),
                     .shows_in_pictures = shows,
                     .group = group});
      if (!of_steps) continue;
      all.back().is_offered = never_of_functions;
      all.back().rays.direction = [](auto&, auto&, const Vector3& g) { return g; };
    }
  }
  return all;
}

}  // namespace raycheck::properties
