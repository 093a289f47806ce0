// Metamorphic laws: two cases whose answers must correspond.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "properties/laws/law_list.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/ray_error.h"
#include "scene/fields.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

using reference::Enclosure;
using scene::Scene;

/// What comparing hits needs, besides rays.
constexpr Needs kOfHits = Needs::kIntersect | Needs::kSpheres;

bool is_at_other_root(Trial& trial, std::size_t ray, std::size_t sphere, const HitAnswer& hit) {
  return reference::is_at_other_root(trial.exact_ray(ray), trial.scene().spheres[sphere],
                                     trial.exact_intersection(ray, sphere), hit.parameter);
}

/// Compares the hits of a case and its transformed case; `factor` takes a parameter of the first to
/// the second. The exact answers, equal in class and root, tell which of two contradicting answers
/// is wrong, and how well-conditioned a pair is.
void compare_hits(Trial& trial, Trial& transformed, Verdict& verdict, const std::string& what,
                  double factor) {
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const auto& hits = trial.hits(sphere);
    const auto& others = transformed.hits(sphere);
    for (std::size_t k = 0; k < trial.ray_count(); ++k) {
      const Place place = trial.place(k, sphere);
      const HitAnswer* const hit = find_hit(hits, k);
      const HitAnswer* const other = find_hit(others, k);
      const auto describe = [&](Discrepancy& d) {
        d.what = what;
        d.symbol = info(Quantity::kParameter).symbol;
        if (other != nullptr) d.got = {other->parameter};
        if (hit != nullptr) d.exact = {hit->parameter * factor};
      };
      const scene::Sphere& the_sphere = trial.scene().spheres[sphere];
      const scene::Sphere& other_sphere = transformed.scene().spheres[sphere];
      const bool differ = (hit == nullptr) != (other == nullptr);
      const bool unjudged =
          is_unjudged(trial.exact_intersection(k, sphere), trial.conventions().tangent);
      if (differ && unjudged) continue;
      const auto excuse = [&] {
        return trial.excuse({answer_of(trial.exact_ray(k), the_sphere, hit),
                             answer_of(transformed.exact_ray(k), other_sphere, other)});
      };
      const bool is_hit = trial.exact_hit(k, sphere);
      const Expected expected = is_hit ? Expected::kHit : Expected::kMiss;
      // Two answers that are equally wrong agree, but are not right.
      if (!differ && !unjudged && (hit != nullptr) != is_hit) {
        verdict.not_right(Quantity::kClass, expected);
        continue;
      }
      trial.judge(verdict,
                  {Quantity::kClass, expected, place,
                   !differ          ? Wrong::kNot
                   : hit != nullptr ? Wrong::kMissed
                                    : Wrong::kFalseHit},
                  excuse, describe);
      if (hit == nullptr || other == nullptr) continue;
      // Of ulps as of u: where floats underflow gradually, that is not held against a method.
      double error = reference::ulp_error(other->parameter, Enclosure(hit->parameter * factor, 128),
                                          trial.precision()) *
                     (scene::unit_roundoff(trial.precision()) / kDoubleRoundoff);
      if (std::isinf(error) && is_hit && std::isfinite(other->parameter)) {
        // One of them is 0: their size is the exact one's.
        const Enclosure apart = Enclosure(other->parameter, 128) / Enclosure(factor, 128) -
                                Enclosure(hit->parameter, 128);
        error = reference::in_units_of_u(
            apart / trial.exact_ray(k).parameter(the_sphere, trial.exact_intersection(k, sphere)));
      }
      const double bound = 2 * trial.bound(Quantity::kParameter);
      if (is_hit) {
        // Parameters at different roots are a chord apart, however accurate both are.
        const bool is_other_root =
            error > bound && is_at_other_root(trial, k, sphere, *hit) !=
                                 is_at_other_root(transformed, k, sphere, *other);
        trial.judge(verdict,
                    {Quantity::kRoot, root_expected(trial.exact_intersection(k, sphere)), place,
                     is_other_root ? Wrong::kWrongRoot : Wrong::kNot},
                    excuse, describe);
        if (is_other_root) continue;
      }
      const auto condition = [&] {
        return is_hit ? reference::condition_of_parameter(trial.exact_ray(k), the_sphere,
                                                          trial.exact_intersection(k, sphere))
                      : std::numeric_limits<double>::infinity();
      };
      trial.measure(verdict, {Quantity::kInvariance, place, error, bound}, condition, describe);
    }
  }
}

/// Compares the directions of a case and its transformed case; `map` takes the first to the second.
void compare_directions(Trial& trial, Trial& transformed, Verdict& verdict, const std::string& what,
                        const std::function<scene::Vector3(const scene::Vector3&)>& map) {
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const scene::Vector3 expected = map(trial.rays()[k].direction);
    const scene::Vector3& got = transformed.rays()[k].direction;
    trial.measure(
        verdict,
        {Quantity::kInvariance, trial.place(k),
         reference::relative_error(scene::UnitVector3{got.x, got.y, got.z},
                                   reference::enclose_exactly(expected)),
         2 * trial.bound(Quantity::kDirection)},
        [&] { return reference::condition_of_direction(trial.exact_ray(k)); },
        [&](Discrepancy& d) {
          d.what = what;
          d.symbol = info(Quantity::kDirection).symbol;
          d.got = numbers(got);
          d.exact = numbers(expected);
        });
  }
}

/// The scene with every length times 2^exponent; directions and `up` as they are. Empty where that
/// would round in the format.
std::optional<Scene> scaled(Scene scene, int exponent, scene::Precision precision) {
  bool exact = true;
  for_each_length(scene, [&](double& x) {
    const double result = scene::rounded_to(precision, std::ldexp(x, exponent));
    exact = exact && std::isfinite(result) && std::ldexp(result, -exponent) == x;
    x = result;
  });
  // s is a length, or counts directions, which are not scaled: both scale with lengths.
  scene::ValidRoots& valid = scene.conventions.valid;
  if (valid.unit == scene::TUnit::kAbsolute) {
    for (double* t : {&valid.t_min, &valid.t_max}) {
      const double result = std::ldexp(*t, exponent);
      exact = exact &&
              (std::isinf(*t) || (std::isfinite(result) && std::ldexp(result, -exponent) == *t));
      *t = result;
    }
  }
  if (scene.camera) scene.camera->far.reset();
  return exact ? std::optional(scene) : std::nullopt;
}

/// Whether an interval of parameters is the same in every unit of length.
bool is_scale_free(const scene::ValidRoots& valid) {
  return valid.t_min == 0 && std::isinf(valid.t_max);
}

void judge_scaling(Trial& trial, Verdict& verdict) {
  const std::string_view no_hits = what_is_missing(kOfHits, trial);
  const bool hits = no_hits.empty();
  const bool directions = trial.scene().camera.has_value();
  if (!hits && !directions) return verdict.leave_out(std::string(no_hits));
  bool is_tried = false;
  // A candidate's own absolute ends stay where they are.
  const auto& own = trial.candidate().declared.valid;
  if (own && own->unit == scene::TUnit::kAbsolute && !is_scale_free(*own)) {
    return verdict.leave_out("the candidate's own t_min or t_max does not scale with the scene");
  }
  for (const int exponent : {-120, -40, 3, 40, 120}) {
    const auto scene = scaled(trial.scene(), exponent, trial.precision());
    if (!scene || !is_inside_domain(trial.candidate(), *scene)) continue;
    is_tried = true;
    const Case transformed_case{*scene, trial.pixels()};
    Trial transformed(transformed_case, trial.candidate());
    const std::string what = "scaled by 2^" + std::to_string(exponent);
    if (directions) {
      compare_directions(trial, transformed, verdict, what,
                         [](const scene::Vector3& v) { return v; });
    }
    if (hits) {
      compare_hits(trial, transformed, verdict, what, std::ldexp(1.0, exponent));
    }
  }
  if (!is_tried) verdict.leave_out("no scaled scene stays in the method's stated domain");
}

/// A permutation of the world axes with signs: coordinates are never rounded.
struct AxesMap {
  const char* what;
  bool is_mirror;  ///< It turns a right-handed frame into a left-handed one: not for cameras.
  scene::Vector3 (*apply)(const scene::Vector3&);
};
constexpr AxesMap kAxesMaps[] = {
    {"axes permuted: (y, z, x)", false,
     [](const scene::Vector3& v) {
       return scene::Vector3{v.y, v.z, v.x};
     }},
    {"axes negated: (-x, -y, z)", false,
     [](const scene::Vector3& v) {
       return scene::Vector3{-v.x, -v.y, v.z};
     }},
    {"axes negated: (x, -y, -z)", false,
     [](const scene::Vector3& v) {
       return scene::Vector3{v.x, -v.y, -v.z};
     }},
    {"axes swapped: (y, x, z)", true,
     [](const scene::Vector3& v) {
       return scene::Vector3{v.y, v.x, v.z};
     }},
    {"axis negated: (x, y, -z)", true,
     [](const scene::Vector3& v) {
       return scene::Vector3{v.x, v.y, -v.z};
     }},
};

Scene rotated(Scene scene, const AxesMap& map) {
  const auto rotate_point = [&](scene::Point3& p) {
    const scene::Vector3 v = map.apply({p.x, p.y, p.z});
    p = {v.x, v.y, v.z};
  };
  if (scene.camera) {
    rotate_point(scene.camera->eye);
    rotate_point(scene.camera->look_at);
    scene.camera->up = map.apply(scene.camera->up);
  }
  for (scene::Ray& ray : scene.rays) {
    rotate_point(ray.origin);
    ray.direction = map.apply(ray.direction);
  }
  for (scene::Sphere& sphere : scene.spheres) rotate_point(sphere.centre);
  return scene;
}

void judge_axes(Trial& trial, Verdict& verdict) {
  const std::string_view no_hits = what_is_missing(kOfHits, trial);
  const bool hits = no_hits.empty();
  const bool directions = trial.scene().camera.has_value();
  if (!hits && !directions) return verdict.leave_out(std::string(no_hits));
  for (const AxesMap& map : kAxesMaps) {
    if (map.is_mirror && trial.scene().camera) continue;
    const Case transformed_case{rotated(trial.scene(), map), trial.pixels()};
    Trial transformed(transformed_case, trial.candidate());
    if (directions) {
      compare_directions(trial, transformed, verdict, map.what, map.apply);
    }
    if (hits) compare_hits(trial, transformed, verdict, map.what, 1);
  }
}

/// a + b, where that is a number of the format.
std::optional<double> exact_sum(double a, double b, scene::Precision precision) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double error = (a - (sum - b_part)) + (b - b_part);
  const bool is_exact = error == 0 && scene::rounded_to(precision, sum) == sum;
  return is_exact ? std::optional(sum) : std::nullopt;
}

/// p a + q b, where p a and q b do not round and the sum is of the format.
template <class To, class A, class B>
std::optional<To> exact_sum_of(const A& a, const B& b, double p, double q,
                               scene::Precision precision) {
  const auto sum = [&](double from_a, double from_b) -> std::optional<double> {
    if (p * from_a / p != from_a || q * from_b / q != from_b) return std::nullopt;
    return exact_sum(p * from_a, q * from_b, precision);
  };
  const auto x = sum(a.x, b.x);
  const auto y = sum(a.y, b.y);
  const auto z = sum(a.z, b.z);
  if (!x || !y || !z) return std::nullopt;
  return To{*x, *y, *z};
}

/// Two cameras with the same axes: the candidate's frames must agree.
void compare_frames(Trial& trial, Verdict& verdict, const scene::Camera& other_camera,
                    const std::string& what) {
  if (!scene::defects(other_camera).empty()) return;
  const FrameAnswer other = trial.candidate().frame(other_camera);
  const FrameAnswer& frame = trial.frame();
  const reference::ExactCamera exact_other(other_camera, trial.conventions());
  const auto compare = [&](const char* axis, const scene::UnitVector3& got,
                           const scene::UnitVector3& expected) {
    trial.measure(
        verdict,
        {Quantity::kInvariance, Place{},
         reference::relative_error(got, reference::enclose_exactly(expected)),
         2 * trial.bound(Quantity::kFrame)},
        [&] {
          return std::max(reference::condition_of_frame(trial.exact_camera()),
                          reference::condition_of_frame(exact_other));
        },
        [&](Discrepancy& d) {
          d.what = std::string(axis) + ", " + what;
          d.symbol = axis;
          d.got = numbers(got);
          d.exact = numbers(expected);
        });
  };
  compare("U", other.U, frame.U);
  compare("V", other.V, frame.V);
  compare("W", other.W, frame.W);
}

void judge_look_at(Trial& trial, Verdict& verdict) {
  const scene::Camera& camera = *trial.scene().camera;
  const auto along =
      exact_sum_of<scene::Vector3>(camera.look_at, camera.eye, 1, -1, trial.precision());
  // A + k (A - E) lies on the view axis where no step rounds.
  for (const double multiple : {-0.5, 1.0, 2.0, 8.0}) {
    if (!along) break;
    const auto moved =
        exact_sum_of<scene::Point3>(camera.look_at, *along, 1, multiple, trial.precision());
    if (!moved) continue;
    scene::Camera other = camera;
    other.look_at = *moved;
    compare_frames(trial, verdict, other, "look-at moved along the view axis");
  }
  if (verdict.compared() == 0) {
    return verdict.leave_out("no point A + k (A - E) tried is of the format");
  }
}

void judge_up(Trial& trial, Verdict& verdict) {
  const scene::Camera& camera = *trial.scene().camera;
  const auto along =
      exact_sum_of<scene::Vector3>(camera.eye, camera.look_at, 1, -1, trial.precision());
  for (const double multiple : {-1.0, 0.5, 1.0, 4.0}) {
    if (!along) break;
    const auto tilted =
        exact_sum_of<scene::Vector3>(camera.up, *along, 1, multiple, trial.precision());
    if (!tilted) continue;
    scene::Camera other = camera;
    other.up = *tilted;
    compare_frames(trial, verdict, other, "up + k (E - A)");
  }
  if (verdict.compared() == 0) {
    return verdict.leave_out("no vector up + k (E - A) tried is of the format");
  }
}

void judge_growing_radius(Trial& trial, Verdict& verdict) {
  if (trial.conventions().root != scene::Root::kNearest) {
    return verdict.leave_out("with root = smaller, a grown sphere may swallow the origin");
  }
  if (!trial.conventions().valid.is_usual()) {
    return verdict.leave_out("with t_min, t_max or culling, a grown sphere's roots may leave them");
  }
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const scene::Sphere& the_sphere = trial.scene().spheres[sphere];
    const scene::Precision precision = trial.precision();
    for (const double radius : {scene::next_after(precision, the_sphere.radius, HUGE_VAL),
                                scene::rounded_to(precision, 1.5 * the_sphere.radius),
                                scene::rounded_to(precision, 4 * the_sphere.radius)}) {
      if (!(radius > the_sphere.radius) || !std::isfinite(radius)) continue;
      const scene::Sphere grown_sphere{the_sphere.centre, radius};
      const auto grown = trial.intersect(trial.rays(), {grown_sphere}, trial.conventions());
      for (const RayHit& before : trial.hits(sphere)) {
        const std::size_t k = before.ray;
        trial.judge(
            verdict,
            {Quantity::kClass, Expected::kHit, trial.place(k, sphere),
             find_hit(grown.front(), k) != nullptr ? Wrong::kNot : Wrong::kMissed},
            [&] {
              const reference::ExactRay& ray = trial.exact_ray(k);
              return trial.excuse(
                  {answer_of(ray, the_sphere, &before.hit), answer_of(ray, grown_sphere, nullptr)});
            },
            [&](Discrepancy& d) {
              d.what = "after the radius grew";
              d.exact = {before.hit.parameter};
            });
      }
    }
  }
  if (verdict.compared() == 0) return verdict.leave_out("the candidate finds no hit to begin with");
}

constexpr Law kMetamorphicLawTable[] = {
    {.name = "scaling",
     .sentence = "scaling every length by 2^k scales every answer",
     .per = Per::kRay,
     .needs = Needs::kRays,
     .quantity = Quantity::kInvariance,
     .judge = judge_scaling},
    {.name = "axes",
     .sentence = "permuting or negating axes does the same to every answer",
     .per = Per::kRay,
     .needs = Needs::kRays,
     .quantity = Quantity::kInvariance,
     .judge = judge_axes},
    {.name = "look-at",
     .sentence = "moving look-at along the view axis leaves the frame alone",
     .per = Per::kScene,
     .needs = Needs::kFrame,
     .quantity = Quantity::kInvariance,
     .judge = judge_look_at},
    {.name = "up",
     .sentence = "adding a multiple of W to up leaves the frame alone",
     .per = Per::kScene,
     .needs = Needs::kFrame,
     .quantity = Quantity::kInvariance,
     .judge = judge_up},
    {.name = "growing-radius",
     .sentence = "growing r never turns a hit into a miss",
     .per = Per::kPair,
     .needs = kOfHits | Needs::kRays,
     .quantity = Quantity::kClass,
     .stage = Stage::kIntersection,
     .judge = judge_growing_radius},
};

}  // namespace

constinit const std::span<const Law> kMetamorphicLaws = kMetamorphicLawTable;

}  // namespace raycheck::properties
