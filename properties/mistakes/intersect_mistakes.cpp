// Wrong choices among roots and among spheres.

#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

using fast::Roots;

Mistake of_hits(std::string sentence, HitFormulas formulas) {
  return {.sentence = std::move(sentence),
          .step = formulas.rank ? Step::kNearest : Step::kIntersect,
          .hits = std::move(formulas)};
}

/// A mistake that s and Q show, and pictures do not.
Mistake of_answers(std::string sentence, ChooseHit choose, std::string_view group = {}) {
  Mistake mistake = of_hits(std::move(sentence), {.choose = std::move(choose)});
  mistake.group = group;
  mistake.shows_in_pictures = false;
  return mistake;
}

/// A mistake that changes right hits.
Mistake of_value(std::string sentence, ChangeHit change,
                 bool (*is_offered)(const Candidate&) = nullptr) {
  return {.sentence = std::move(sentence),
          .step = Step::kIntersect,
          .hit = std::move(change),
          .is_offered = is_offered};
}

bool returns_multiples(const Candidate& candidate) {
  return candidate.interface.returns == Returns::kHit ||
         candidate.interface.returns == Returns::kParameter;
}

Hit wherever_behind(const Ray& ray, const Roots& roots, Conventions conventions) {
  conventions.valid.t_min = -std::numeric_limits<double>::infinity();
  return usual_choice(ray, roots, conventions);
}

/// A miss if v < 0; otherwise the smaller root, even if it is negative.
Hit ahead_or_behind(const Ray& ray, const Roots& roots, const Conventions& conventions) {
  return roots.axial_distance < 0 ? Hit() : wherever_behind(ray, roots, conventions);
}

Hit larger_wherever_behind(const Ray& ray, const Roots& roots, const Conventions& conventions) {
  const bool is_near = !meets(roots, conventions) || smaller_counts(roots, conventions.valid);
  return is_near ? usual_choice(ray, roots, conventions) : Hit(hit_at(ray, roots.larger));
}

Hit near_wherever_ahead(const Ray& ray, const Roots& roots, const Conventions& conventions) {
  return larger_counts(roots, conventions.valid) ? wherever_behind(ray, roots, conventions) : Hit();
}

/// From inside, s = 0. If both roots are negative: a miss, or with `counts_behind` the larger root.
ChooseHit of_solid(bool counts_behind) {
  return [counts_behind](const Ray& ray, const Roots& roots, const Conventions& conventions) {
    const double least = conventions.valid.t_min;
    if (!meets(roots, conventions) || !(roots.smaller < least))
      return usual_choice(ray, roots, conventions);
    if (roots.larger < least && !counts_behind) return Hit();
    return Hit(hit_at(ray, roots.larger < least ? roots.larger : 0));
  };
}

/// |v - d|
Hit without_sign(const Ray& ray, const Roots& roots, const Conventions& conventions) {
  if (!meets(roots, conventions) || roots.larger < 0) return {};
  return hit_at(ray, std::abs(roots.smaller));
}

/// The roots after a slip in the formula, given the right roots and |D|.
using Slip = Roots (*)(const Roots& right, double size, const Ray& ray, const Sphere& sphere);

/// The roots v - d and v + d, in multiples of the direction.
Roots roots_of(double v, double half_chord_sq, double size) {
  const double d = std::sqrt(half_chord_sq);
  return {v, half_chord_sq, (v - d) / size, (v + d) / size};
}

struct RootSlip {
  const char* sentence;
  Slip slip;
  bool shows_in_pictures = false;
};
constexpr RootSlip kRootSlips[] = {
    {"T = L - C: v has the wrong sign",
     [](const Roots& right, double, auto&, auto&) -> Roots {
       return {-right.axial_distance, right.half_chord_sq, -right.larger, -right.smaller};
     },
     true},
    {"the square root is left out: s = v - d^2",
     [](const Roots& right, double size, auto&, auto&) -> Roots {
       const double v = right.axial_distance, square = right.half_chord_sq;
       return {v, square, (v - square) / size, (v + square) / size};
     },
     true},
    {"b lacks its factor of 2: b^2 - 4ac with b = D . (L - C)",
     [](const Roots& right, double size, auto&, auto&) -> Roots {
       const double v = right.axial_distance;
       return roots_of(v, 4 * right.half_chord_sq - 3 * v * v, 2 * size);
     },
     true},
    {"the test for a miss compares |T|^2 - v^2 with r in place of r^2",
     [](const Roots& right, double, auto&, const Sphere& sphere) -> Roots {
       const double r = sphere.radius, test = r - (r * r - right.half_chord_sq);
       return {right.axial_distance, test, right.smaller, right.larger};
     }},
    {"the square root is left out: s = (-b - (b^2 - 4ac))/2a",
     [](const Roots& right, double size, auto&, auto&) -> Roots {
       const double v = right.axial_distance, square = right.half_chord_sq;
       return {v, square, (v - 2 * square) / size, (v + 2 * square) / size};
     }},
    {"-2b is taken for -b: s = (-2b - sqrt(b^2 - 4ac))/2a",
     [](const Roots& right, double size, auto&, auto&) -> Roots {
       const double more = right.axial_distance / size;
       return {right.axial_distance, right.half_chord_sq, right.smaller + more,
               right.larger + more};
     }},
    {"-b is not divided by 2a: s = -b - sqrt(b^2 - 4ac)/2a",
     [](const Roots& right, double size, auto&, auto&) -> Roots {
       const double v = right.axial_distance, more = 2 * v * size - v / size;
       return {v, right.half_chord_sq, right.smaller + more, right.larger + more};
     }},
    {"s is d, half the chord, whatever v is",
     [](const Roots& right, double size, auto&, auto&) -> Roots {
       const double s = std::sqrt(right.half_chord_sq) / size;
       return {right.axial_distance, right.half_chord_sq, s, s};
     }},
    {"|T| is taken for |T|^2: d^2 = v^2 - |T| + r^2",
     [](const Roots& right, double size, const Ray& ray, const Sphere& sphere) -> Roots {
       const double v = right.axial_distance, r = sphere.radius;
       return roots_of(v, v * v - norm(sphere.centre - ray.origin) + r * r, size);
     }},
    {"d^2 < 0 counts as |d^2|: spheres that are missed are hit",
     [](const Roots& right, double size, auto&, auto&) -> Roots {
       return right.half_chord_sq < 0 ? roots_of(right.axial_distance, -right.half_chord_sq, size)
                                      : right;
     }},
    {"v is taken without its sign: s = |v| + d if the centre of a sphere around the origin "
     "lies behind it",
     [](const Roots& right, double size, auto&, auto&) -> Roots {
       return right.larger >= 0
                  ? roots_of(std::abs(right.axial_distance), right.half_chord_sq, size)
                  : right;
     }},
    {"v is taken without its sign: s = |v| - d or |v| + d, and spheres behind the origin are hit",
     [](const Roots& right, double size, auto&, auto&) -> Roots {
       return roots_of(std::abs(right.axial_distance), right.half_chord_sq, size);
     }},
};

std::vector<Mistake> root_slips() {
  std::vector<Mistake> all;
  for (const auto& [sentence, slip, shows] : kRootSlips) {
    all.push_back(of_hits(sentence, {.roots = [slip = slip](const Ray& ray, const Sphere& sphere) {
                            return slip(fast::kCross.roots(ray, sphere), norm(ray.direction), ray,
                                        sphere);
                          }}));
    all.back().shows_in_pictures = shows;
  }
  return all;
}

/// A mistake in the branch for b^2 - 4ac = 0, whose s counts even if it is negative.
Mistake at_one_root(std::string sentence, double (*parameter)(double v, double size)) {
  Mistake mistake =
      of_hits(std::move(sentence),
              {.roots =
                   [](const Ray& ray, const Sphere& sphere) {
                     Roots roots = fast::kCross.roots(ray, sphere);
                     if (fast::kQuadratic.roots(ray, sphere).half_chord_sq == 0)
                       roots.half_chord_sq = 0;
                     return roots;
                   },
               .choose =
                   [parameter](const Ray& ray, const Roots& roots, const Conventions& c) {
                     if (roots.half_chord_sq != 0) return usual_choice(ray, roots, c);
                     return Hit(hit_at(ray, parameter(roots.axial_distance, norm(ray.direction))));
                   }});
  mistake.shows_in_pictures = false;
  return mistake;
}

bool declares_t_max(const Candidate& candidate) {
  return candidate.declared.valid && std::isfinite(candidate.declared.valid->t_max);
}
Mistake of_segments(std::string sentence, ChooseHit choose) {
  Mistake mistake = of_answers(std::move(sentence), std::move(choose));
  mistake.is_offered = declares_t_max;
  return mistake;
}

/// Code that does not test the sign of d^2: if it is negative, the roots are NaN, or those of d^2 =
/// 0.
ChooseHit untested(bool is_number) {
  return [is_number](const Ray& ray, const Roots& roots, const Conventions& conventions) -> Hit {
    if (!(roots.half_chord_sq < 0)) return usual_choice(ray, roots, conventions);
    if (!is_number) return hit_at(ray, std::numeric_limits<double>::quiet_NaN());
    const double s = roots.axial_distance / norm(ray.direction);
    return s >= 0 ? Hit(hit_at(ray, s)) : Hit();
  };
}

/// Multiplies s by a factor; Q follows from s.
ChangeHit times(double factor) {
  return [factor](const Ray& ray, const Sphere&, const HitAnswer& hit) {
    return hit_at(ray, factor * hit.parameter);
  };
}

/// A hit at this s for every ray.
Mistake always_at(double s, std::string sentence) {
  Mistake mistake =
      of_hits(std::move(sentence),
              {.choose = [s](const Ray& ray, auto&&...) { return Hit(hit_at(ray, s)); }});
  mistake.group = "always";  // hit classes do not show s
  mistake.shows_in_pictures = false;
  return mistake;
}

RankSphere by_index(double sign) {
  return [sign](std::size_t index, auto&&...) { return sign * static_cast<double>(index); };
}
RankSphere by_discriminant(double sign) {
  return
      [sign](auto, auto&, auto&, const Roots& roots, double) { return sign * roots.half_chord_sq; };
}
RankSphere by_parameter(double sign) {
  return [sign](auto, auto&, auto&, auto&, double s) { return sign * s; };
}

}  // namespace

std::vector<Mistake> intersect_mistakes() {
  return all_of(
      {root_slips(),
       {
           of_hits("no ray ever hits a sphere",
                   {.choose = [](const Ray&, const Roots&, const Conventions&) { return Hit(); }}),
           always_at(0, "every ray hits every sphere"),
           always_at(1, "every ray hits every sphere, at s = 1"),
           of_hits("d^2 < 0 is not tested: s is NaN where spheres are missed",
                   {.choose = untested(false)}),
           of_hits("d^2 < 0 counts as d^2 = 0: spheres that are missed are hit",
                   {.choose = untested(true)}),
           of_hits("s >= 0 is not tested: spheres behind the origin are hit",
                   {.choose = wherever_behind}),
           of_answers(
               "v >= 0 is tested in place of s >= 0: spheres around the origin are hit behind it",
               ahead_or_behind),
           of_answers("v + d counts even if it is negative: spheres behind the origin are hit",
                      larger_wherever_behind, "negative far roots"),
           of_answers(
               "spheres are solid: from inside s is 0; and v + d counts even if it is negative",
               of_solid(true), "negative far roots"),
           of_answers(
               "the near root is given even if it is negative: spheres around the origin are hit "
               "behind it",
               near_wherever_ahead),
           of_answers("spheres are solid: from inside s is 0", of_solid(false), "marched"),
           of_answers(
               "T . D = 0 counts as a miss: rays at right angles to T never hit spheres around "
               "their origin",
               [](const Ray& ray, const Roots& roots, const Conventions& c) {
                 return roots.axial_distance == 0 ? Hit() : usual_choice(ray, roots, c);
               }),
           of_answers("s is |v - d|, which is not a root if the ray starts inside a sphere",
                      without_sign),
           of_answers("the root with the smaller |s| is taken; if it is negative, that is a miss",
                      [](const Ray& ray, const Roots& roots, const Conventions& c) -> Hit {
                        if (!meets(roots, c)) return {};
                        const bool is_first = std::abs(roots.smaller) <= std::abs(roots.larger);
                        const double s = is_first ? roots.smaller : roots.larger;
                        return s >= 0 ? Hit(hit_at(ray, s)) : Hit();
                      }),
           at_one_root("where b^2 - 4ac = 0, s is -b/2*a (not -b/(2a)), even if it is negative",
                       [](double v, double size) { return v * size * size * size; }),
           at_one_root("where b^2 - 4ac = 0, s is 0: the hit is the ray's origin",
                       [](double, double) { return 0.0; }),
           of_answers("s is read as an integer: its fraction is dropped, and 0 is a miss",
                      [](const Ray& ray, const Roots& roots, const Conventions& c) -> Hit {
                        const Hit hit = usual_choice(ray, roots, c);
                        return hit && hit->parameter >= 1
                                   ? Hit(hit_at(ray, std::trunc(hit->parameter)))
                                   : Hit();
                      }),
           of_hits("the far root is taken for the near one",
                   {.choose =
                        [](const Ray& ray, const Roots& roots, const Conventions& c) {
                          return meets(roots, c) && larger_counts(roots, c.valid)
                                     ? Hit(hit_at(ray, roots.larger))
                                     : Hit();
                        }}),
           of_hits(
               "v < 0 counts as a miss, so that spheres around the origin are not seen if their "
               "centres lie behind it",
               {.choose =
                    [](const Ray& ray, const Roots& roots, const Conventions& c) {
                      return roots.axial_distance < 0 ? Hit() : usual_choice(ray, roots, c);
                    }}),
           of_value(
               "Q = s D: the origin is not added",
               [](const Ray& ray, const Sphere&, const HitAnswer& hit) {
                 return HitAnswer{hit.parameter, hit_at({{}, ray.direction}, hit.parameter).point};
               },
               returns_points),
           of_value("s is half of the right one", times(0.5)),
           of_value("s is twice the right one", times(2)),
           of_value("from a point on the sphere s is half of the right one",
                    [](const Ray& ray, const Sphere& sphere, const HitAnswer& hit) {
                      const auto [x, y, z] = ray.origin - sphere.centre;
                      const bool is_on = x * x + y * y + z * z == sphere.radius * sphere.radius;
                      return is_on ? hit_at(ray, 0.5 * hit.parameter) : hit;
                    }),
           of_segments("t_max is tested the wrong way round: only hits beyond it count",
                       [](const Ray& ray, const Roots& roots, const Conventions& c) {
                         return meets(roots, c) && roots.smaller > c.valid.t_max
                                    ? Hit(hit_at(ray, roots.smaller))
                                    : Hit();
                       }),
           of_segments("segments that start or end inside a sphere miss it",
                       [](const Ray& ray, const Roots& roots, const Conventions& c) {
                         return smaller_counts(roots, c.valid) && larger_counts(roots, c.valid)
                                    ? usual_choice(ray, roots, c)
                                    : Hit();
                       }),
           of_value(
               "s is a length, not a multiple of the direction",
               [](const Ray& ray, const Sphere&, const HitAnswer& hit) {
                 return HitAnswer{hit.parameter * norm(ray.direction), hit.point};
               },
               returns_multiples),
           of_value(
               "s is a length, but Q = L + s D with a D that is not a unit vector",
               [](const Ray& ray, const Sphere&, const HitAnswer& hit) {
                 return hit_at(ray, hit.parameter * norm(ray.direction));
               },
               returns_points),
           of_hits("the first sphere in the file wins", {.rank = by_index(1)}),
           of_hits("the last sphere in the file wins", {.rank = by_index(-1)}),
           of_hits("the sphere with the largest discriminant wins", {.rank = by_discriminant(-1)}),
           of_hits("the sphere with the smallest discriminant wins", {.rank = by_discriminant(1)}),
           of_hits("the sphere whose centre is nearest wins",
                   {.rank = [](auto, const Ray& ray, const Sphere& sphere, auto&,
                               double) { return norm(sphere.centre - ray.origin); }}),
           of_hits("the smallest s wins, even if it is negative",
                   {.choose = wherever_behind, .rank = by_parameter(1)}),
           of_hits("s >= 0 is not tested, and the least |s| wins, even if s is negative",
                   {.choose = wherever_behind,
                    .rank = [](auto, auto&, auto&, auto&, double s) { return std::abs(s); }}),
           of_hits("the farthest sphere wins", {.rank = by_parameter(-1)}),
       }});
}

}  // namespace raycheck::properties
