// Metamorphic laws: two cases whose answers must correspond.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>

#include "properties/laws/law_list.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/near_error.h"
#include "reference/ray_error.h"
#include "scene/fields.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

/// The needs of comparing hits, besides rays.
constexpr Needs kOfHits = Needs::kIntersect | Needs::kSpheres;

/// A transformation of a case.
struct Transformation {
  std::string what;
  std::function<Vector3(const Vector3&)> map = {};  ///< Maps directions.
  double factor = 1;                                ///< Multiplies parameters.
};

/// A candidate's answer about a ray and a sphere.
struct PairAnswer {
  Trial& trial;
  std::size_t ray, sphere_index;
  const HitAnswer* hit = find_hit(trial.hits(sphere_index), ray);  ///< Null: a miss.

  const Sphere& sphere() const { return trial.scene().spheres[sphere_index]; }
  RayAnswer answer() const { return answer_of(trial.exact_ray(ray), sphere(), hit); }
  double tolerance() const {
    return trial.tolerance(trial.exact_ray(ray), sphere(), hit->parameter);
  }
  Intersection exact() const { return trial.exact_intersection(ray, sphere_index); }
  bool is_at_other_root() const {
    return properties::is_at_other_root(answer(), exact(), trial.candidate());
  }
};

/// The distance between the parameters of two hits.
scene::Measured error_between(const PairAnswer& first, const PairAnswer& second, double factor,
                              bool is_hit) {
  const Precision precision = first.trial.precision();
  const double s = first.hit->parameter, other = second.hit->parameter;
  // In ulp, so that gradual underflow is not a defect.
  const scene::Measured error = reference::ulp_error(other, s * factor, precision);
  if (!std::isinf(error.value) || !is_hit || !std::isfinite(other)) return error;
  // If one parameter is 0, the error is relative to the exact one.
  const Enclosure apart = Enclosure(other, 128) / Enclosure(factor, 128) - Enclosure(s, 128);
  return in_units_of_u(apart /
                       first.trial.exact_ray(first.ray).parameter(first.sphere(), first.exact()));
}

/// What is wrong with an answer of which another one is right.
void describe_wrong(Discrepancy& d, const PairAnswer& first, const PairAnswer& second,
                    bool is_first_wrong, const std::string& by) {
  const PairAnswer& wrong = is_first_wrong ? first : second;
  Trial& trial = wrong.trial;
  d.what = (is_first_wrong ? "right only with " : "") + by;
  d.symbol = info(Quantity::kParameter).symbol;
  d.got_some_sphere = wrong.hit != nullptr && !gives_parameter(trial.candidate().interface.returns);
  if (wrong.hit != nullptr && !d.got_some_sphere) d.got = {wrong.hit->parameter};
  if (!trial.exact_hit(wrong.ray, wrong.sphere_index)) return;
  d.exact = {
      rounded_s(trial.exact_ray(wrong.ray), wrong.sphere(), wrong.exact(), trial.candidate())};
}

/// Judges the hit classes of two answers for which the exact ones are the same, which show the
/// wrong one if the answers contradict each other. Returns whether both are hits.
bool compare_classes(const PairAnswer& first, const PairAnswer& second, const Place& place,
                     Verdict& verdict, const std::string& by) {
  Trial& trial = first.trial;
  const bool is_hit = trial.exact_hit(first.ray, first.sphere_index);
  const bool unjudged = is_unjudged(first.exact(), trial.conventions().tangent);
  const bool differ = (first.hit == nullptr) != (second.hit == nullptr);
  if (differ && unjudged) return false;
  const Expected expected = is_hit ? Expected::kHit : Expected::kMiss;
  // Two answers that are wrong in the same way agree, but are not right.
  if (!differ && !unjudged && (first.hit != nullptr) != is_hit) {
    verdict.not_right(Quantity::kClass, expected);
    return false;
  }
  const Wrong wrong = !differ ? Wrong::kNot : is_hit ? Wrong::kMissed : Wrong::kFalseHit;
  trial.judge(
      verdict, {Quantity::kClass, expected, place, wrong},
      [&] {
        return trial.excuse({first.answer(), second.answer()});
      },
      [&](Discrepancy& d) {
        describe_wrong(d, first, second, (first.hit != nullptr) != is_hit, by);
      });
  return first.hit != nullptr && second.hit != nullptr;
}

/// The exact answers have the same hit class and root for both cases. They show which of two
/// contradicting answers is wrong, and give the condition number.
void compare_hits(const PairAnswer& first, const PairAnswer& second, Verdict& verdict,
                  const Transformation& by) {
  Trial& trial = first.trial;
  const Intersection at = first.exact();
  const bool is_hit = trial.exact_hit(first.ray, first.sphere_index);
  const Place place = trial.place(first.ray, first.sphere_index);
  if (!compare_classes(first, second, place, verdict, by.what)) return;
  if (!gives_parameter(trial.candidate().interface.returns)) return;
  const scene::Measured error = error_between(first, second, by.factor, is_hit);
  const double bound = 2 * trial.bound(Quantity::kParameter);
  if (is_hit) {
    // Parameters at different roots differ by a chord, even if both are accurate. Two at the wrong
    // root agree, but are not right; the condition number is that of the right root.
    const bool is_above = error.in(trial.precision()).value > bound;
    const bool is_at_other = is_above && first.is_at_other_root();
    const bool is_other_root = is_above && is_at_other != second.is_at_other_root();
    if (is_at_other && !is_other_root) {
      return verdict.not_right(Quantity::kRoot, root_expected(at));
    }
    trial.judge(
        verdict,
        {Quantity::kRoot, root_expected(at), place,
         is_other_root ? Wrong::kWrongRoot : Wrong::kNot},
        [&] {
          return trial.excuse({first.answer(), second.answer()});
        },
        [&](Discrepancy& d) { describe_wrong(d, first, second, is_at_other, by.what); });
    if (is_other_root) return;
  }
  trial.measure(
      verdict, {Quantity::kInvariance, place, error, bound},
      [&] {
        return is_hit ? reference::condition_of_parameter(trial.exact_ray(first.ray),
                                                          first.sphere(), at)
                      : std::numeric_limits<double>::infinity();
      },
      [&](Discrepancy& d) {
        d.what = by.what;
        d.symbol = info(Quantity::kParameter).symbol;
        d.got = {second.hit->parameter};
        d.exact = {first.hit->parameter * by.factor};
      },
      {},
      [&] {
        return is_hit ? plain_condition(trial.candidate(), trial.exact_ray(first.ray),
                                        first.sphere(), at)
                      : 0;
      },
      [&] { return std::max(first.tolerance(), second.tolerance()); });
}

/// The distance of a unit vector from another one, as far as a verdict needs it.
scene::Measured distance(const Trial& trial, const Verdict& verdict, double bound,
                         const scene::UnitVector3& got, const scene::UnitVector3& expected) {
  return trial.settled(
      verdict, Quantity::kInvariance, bound,
      [&] { return reference::near_relative_error(got, reference::in_double_doubles(expected)); },
      [&] { return reference::relative_error(got, expected); });
}

void compare_directions(Trial& trial, Trial& transformed, Verdict& verdict,
                        const Transformation& by) {
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const Vector3 expected = by.map(trial.rays()[k].direction);
    const Vector3& got = transformed.rays()[k].direction;
    const double bound = 2 * trial.bound(Quantity::kDirection);
    trial.measure(
        verdict,
        {Quantity::kInvariance, trial.place(k),
         distance(trial, verdict, bound, {got.x, got.y, got.z},
                  {expected.x, expected.y, expected.z}),
         bound},
        [&] { return reference::condition_of_direction(trial.exact_ray(k)); },
        [&](Discrepancy& d) {
          d.what = by.what;
          d.symbol = info(Quantity::kDirection).symbol;
          d.got = numbers(got);
          d.exact = numbers(expected);
        },
        {}, [&] { return plain_condition(trial.candidate(), trial.exact_ray(k)); });
  }
}

/// The reason why neither directions nor hits can be compared; empty if directions or hits can.
std::string_view why_nothing_to_compare(const Trial& trial) {
  return trial.scene().camera ? std::string_view() : what_is_missing(kOfHits, trial);
}

/// Compares the answers about a case with those about the transformed scene.
void compare(Trial& trial, Verdict& verdict, const Scene& scene, const Transformation& by) {
  const Case transformed_case{scene, trial.pixels()};
  Trial transformed(transformed_case, trial.candidate());
  if (scene.camera && trial.has_rays()) compare_directions(trial, transformed, verdict, by);
  if (!what_is_missing(kOfHits, trial).empty()) return;
  for (std::size_t sphere = 0; sphere < scene.spheres.size(); ++sphere) {
    for (std::size_t ray = 0; ray < trial.ray_count(); ++ray) {
      compare_hits({trial, ray, sphere}, {transformed, ray, sphere}, verdict, by);
    }
  }
}

/// The scene with every length multiplied by 2^exponent; directions and `up` stay. Empty if a
/// number would be rounded in the format.
std::optional<Scene> scaled(Scene scene, int exponent, Precision precision) {
  bool exact = true;
  for_each_length(scene, [&](double& x) {
    const double result = scene::rounded_to(precision, std::ldexp(x, exponent));
    exact = exact && std::isfinite(result) && std::ldexp(result, -exponent) == x;
    x = result;
  });
  // Ends are lengths or multiples of directions. Directions are not scaled, so both scale with
  // lengths.
  scene::ValidRoots& valid = scene.conventions.valid;
  if (valid.unit != scene::TUnit::kRadius) {
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

void judge_scaling(Trial& trial, Verdict& verdict) {
  const std::string_view nothing = why_nothing_to_compare(trial);
  if (!nothing.empty()) return verdict.leave_out(std::string(nothing));
  // Absolute ends and tolerances that the candidate declares do not scale.
  const auto& own = trial.candidate().declared.valid;
  const bool is_scale_free =
      !own || own->unit == scene::TUnit::kRadius || (own->t_min == 0 && std::isinf(own->t_max));
  contract::Tolerances absolute = trial.candidate().tolerances;
  absolute.radii = absolute.s_radii = 0;
  if (!is_scale_free || !(absolute == contract::Tolerances{})) {
    return verdict.leave_out(
        "the candidate's own t_min, t_max or tolerance does not scale with the scene");
  }
  bool is_tried = false;
  for (const int exponent : {-120, -40, 3, 40, 120}) {
    const auto scene = scaled(trial.scene(), exponent, trial.precision());
    if (!scene || !is_inside_domain(trial.candidate(), *scene)) continue;
    is_tried = true;
    compare(trial, verdict, *scene,
            {"lengths scaled by 2^" + std::to_string(exponent), [](const Vector3& v) { return v; },
             std::ldexp(1.0, exponent)});
  }
  if (!is_tried) verdict.leave_out("every scaled scene lies outside the candidate's domain");
}

/// A permutation of the world axes with signs: coordinates are never rounded.
struct AxesMap {
  const char* what;
  std::array<int, 3> axes;  ///< Which axis, counted from 1, becomes the first, second and third.
  bool is_mirror = false;   ///< It makes right-handed frames left-handed: not used for cameras.

  Vector3 operator()(const Vector3& v) const {
    const auto along = [&](int axis) {
      const double x = std::array{v.x, v.y, v.z}[static_cast<std::size_t>(std::abs(axis) - 1)];
      return axis < 0 ? -x : x;
    };
    return {along(axes[0]), along(axes[1]), along(axes[2])};
  }
};
constexpr AxesMap kAxesMaps[] = {
    {"axes permuted to (y, z, x)", {2, 3, 1}},
    {"axes negated to (-x, -y, z)", {-1, -2, 3}},
    {"axes negated to (x, -y, -z)", {1, -2, -3}},
    {"axes swapped to (y, x, z)", {2, 1, 3}, true},
    {"axes negated to (x, y, -z)", {1, 2, -3}, true},
};

Scene rotated(Scene scene, const AxesMap& map) {
  const auto rotate_point = [&](Point3& p) {
    const Vector3 v = map({p.x, p.y, p.z});
    p = {v.x, v.y, v.z};
  };
  if (scene.camera) {
    rotate_point(scene.camera->eye);
    rotate_point(scene.camera->look_at);
    scene.camera->up = map(scene.camera->up);
  }
  for (Ray& ray : scene.rays) {
    rotate_point(ray.origin);
    ray.direction = map(ray.direction);
  }
  for (Sphere& sphere : scene.spheres) rotate_point(sphere.centre);
  return scene;
}

void judge_axes(Trial& trial, Verdict& verdict) {
  const std::string_view nothing = why_nothing_to_compare(trial);
  if (!nothing.empty()) return verdict.leave_out(std::string(nothing));
  for (const AxesMap& map : kAxesMaps) {
    if (map.is_mirror && trial.scene().camera) continue;
    compare(trial, verdict, rotated(trial.scene(), map), {map.what, map});
  }
}

/// a + b, if the sum is a number of the format.
std::optional<double> exact_sum(double a, double b, Precision precision) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double error = (a - (sum - b_part)) + (b - b_part);
  const bool is_exact = error == 0 && scene::rounded_to(precision, sum) == sum;
  return is_exact ? std::optional(sum) : std::nullopt;
}

/// a + k b, if k b does not round and the sum is a number of the format.
template <class To, class A, class B>
std::optional<To> exact_sum_of(const A& a, const B& b, double k, Precision precision) {
  const auto sum = [&](double from_a, double from_b) {
    return k * from_b / k == from_b ? exact_sum(from_a, k * from_b, precision) : std::nullopt;
  };
  const auto x = sum(a.x, b.x), y = sum(a.y, b.y), z = sum(a.z, b.z);
  return x && y && z ? std::optional(To{*x, *y, *z}) : std::nullopt;
}

/// Compares the candidate's frames of two cameras with the same axes.
void compare_frames(Trial& trial, Verdict& verdict, const Camera& other_camera,
                    const std::string& what) {
  if (!scene::defects(other_camera).empty()) return;
  const FrameAnswer other = trial.candidate().frame(other_camera);
  const FrameAnswer& frame = trial.frame();
  const auto compare = [&](const char* axis, const scene::UnitVector3& got,
                           const scene::UnitVector3& expected) {
    const double bound = 2 * trial.bound(Quantity::kFrame);
    trial.measure(
        verdict,
        {Quantity::kInvariance, Place{}, distance(trial, verdict, bound, got, expected), bound},
        [&] {
          const ExactCamera exact_other(other_camera, trial.conventions());
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

/// Adds multiples of E - A to look-at or `up`, if that needs no rounding. The axes do not change.
template <class Moved>
void judge_moved(Trial& trial, Verdict& verdict, Moved Camera::*member,
                 std::initializer_list<double> multiples, const char* what) {
  const Camera& camera = *trial.scene().camera;
  const auto along = exact_sum_of<Vector3>(camera.eye, camera.look_at, -1, trial.precision());
  for (const double multiple : multiples) {
    if (!along) return;
    const auto moved = exact_sum_of<Moved>(camera.*member, *along, multiple, trial.precision());
    if (!moved) continue;
    Camera other = camera;
    other.*member = *moved;
    compare_frames(trial, verdict, other, what);
  }
}

void judge_look_at(Trial& trial, Verdict& verdict) {
  judge_moved(trial, verdict, &Camera::look_at, {0.5, -1, -2, -8},
              "look-at moved along the view axis");
  if (verdict.compared() == 0)
    verdict.leave_out("each point A + k (A - E) that was tried would be rounded");
}

void judge_up(Trial& trial, Verdict& verdict) {
  judge_moved(trial, verdict, &Camera::up, {-1, 0.5, 1, 4}, "up + k (E - A)");
  if (verdict.compared() == 0)
    verdict.leave_out("each vector up + k (E - A) that was tried would be rounded");
}

void judge_growing_radius(Trial& trial, Verdict& verdict) {
  if (trial.conventions().root != scene::Root::kNearest) {
    return verdict.leave_out(
        "with root = smaller, a hit may become a miss: a grown sphere may contain the origin");
  }
  if (!trial.conventions().valid.is_usual()) {
    return verdict.leave_out(
        "with t_min, t_max or culling, the roots of a grown sphere may no longer count");
  }
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const Sphere& the_sphere = trial.scene().spheres[sphere];
    const Precision precision = trial.precision();
    for (const double radius : {scene::next_after(precision, the_sphere.radius, HUGE_VAL),
                                scene::rounded_to(precision, 1.5 * the_sphere.radius),
                                scene::rounded_to(precision, 4 * the_sphere.radius)}) {
      if (!(radius > the_sphere.radius) || !std::isfinite(radius)) continue;
      const Sphere grown_sphere{the_sphere.centre, radius};
      const auto grown = trial.intersect(trial.rays(), {grown_sphere}, trial.conventions());
      for (const RayHit& before : trial.hits(sphere)) {
        const std::size_t k = before.ray;
        trial.judge(
            verdict,
            {Quantity::kClass, Expected::kHit, trial.place(k, sphere),
             find_hit(grown.front(), k) != nullptr ? Wrong::kNot : Wrong::kMissed},
            [&] {
              const ExactRay& ray = trial.exact_ray(k);
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
  if (verdict.compared() == 0)
    return verdict.leave_out("the candidate finds no hit before the radius grows");
}

/// The segment from the origin of a ray, along it, to a point that is about as near to the sphere.
/// Its direction is rounded, so that its end is a number of the format. Empty if there is none.
std::optional<scene::Ray> segment_of(scene::Ray ray, const scene::Sphere& sphere,
                                     scene::Precision precision) {
  const auto length = [](const auto& v) { return std::hypot(v.x, v.y, v.z); };
  const auto& [O, D] = ray;
  const double near = std::max(length(O - sphere.centre), sphere.radius);
  const int exponent = std::ilogb(near) - std::ilogb(length(D)) + 1;
  for (double* x : {&ray.direction.x, &ray.direction.y, &ray.direction.z}) {
    *x = std::scalbn(*x, exponent);
  }
  contract::Interface segments;
  segments.rays = contract::RayForm::kEnd;
  ray = rounded_ray(ray, {precision, segments});
  const scene::Point3 end = {O.x + D.x, O.y + D.y, O.z + D.z};
  const bool is_near = length(end - sphere.centre) <= std::max(near, 2 * sphere.radius);
  return is_near && scene::defects(ray).empty() ? std::optional(ray) : std::nullopt;
}

/// A sphere, a segment along each ray, each followed by the same segment from its other end, and
/// the numbers of the rays. Roots count from s = 0 to s = 1, unless the candidate declares others.
struct Exchanged {
  Case the_case;
  std::vector<std::size_t> rays;
};
Exchanged exchanged(Trial& trial, const scene::Sphere& sphere) {
  Exchanged result;
  Scene& scene = result.the_case.scene;
  scene.spheres = {sphere};
  scene.conventions = trial.conventions();
  if (!trial.candidate().declared.valid) scene.conventions.valid = {.t_max = 1};
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const auto segment = segment_of(trial.rays()[k], sphere, trial.precision());
    if (!segment) continue;
    const auto& [O, D] = *segment;
    scene.rays.push_back(*segment);
    scene.rays.push_back({{O.x + D.x, O.y + D.y, O.z + D.z}, {-D.x, -D.y, -D.z}});
    result.rays.push_back(k);
  }
  return result;
}

void judge_exchange(Trial& trial, Verdict& verdict) {
  if (trial.candidate().interface.directions == contract::Directions::kUnit) {
    return verdict.leave_out("the directions of segments are not unit, as the candidate needs");
  }
  const auto& own = trial.candidate().declared.valid;
  if (own && !own->is_usual() && *own != scene::ValidRoots{.t_max = 1}) {
    return verdict.leave_out("the candidate declares roots other than those of rays or segments");
  }
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const auto [the_case, rays] = exchanged(trial, trial.scene().spheres[sphere]);
    if (rays.empty() || !is_inside_domain(trial.candidate(), the_case.scene)) continue;
    Trial segments(the_case, trial.candidate());
    for (std::size_t k = 0; k < rays.size(); ++k) {
      // If roots beyond the ends count, a sphere may be in front of one end only.
      if (segments.exact_hit(2 * k, 0) != segments.exact_hit(2 * k + 1, 0)) continue;
      compare_classes({segments, 2 * k, 0}, {segments, 2 * k + 1, 0}, trial.place(rays[k], sphere),
                      verdict, "the ends of the segment exchanged");
    }
  }
  if (verdict.compared() > 0) return;
  verdict.leave_out("no segment near a sphere, along a ray, has the same answer from both ends");
}

constexpr Law kMetamorphicLawTable[] = {
    {"scaling", "scaling every length by 2^k scales every answer", Per::kRay, Needs::kRays,
     Quantity::kInvariance, judge_scaling},
    {"axes", "permuting or negating the axes permutes or negates every answer", Per::kRay,
     Needs::kRays, Quantity::kInvariance, judge_axes},
    {"look-at", "moving look-at along the view axis does not change the frame", Per::kScene,
     Needs::kFrame, Quantity::kInvariance, judge_look_at},
    {"up", "adding a multiple of W to up does not change the frame", Per::kScene, Needs::kFrame,
     Quantity::kInvariance, judge_up},
    {"growing-radius", "growing r never turns a hit into a miss", Per::kPair,
     kOfHits | Needs::kRays | Needs::kAnyRay, Quantity::kClass, judge_growing_radius, kRelations,
     Stage::kIntersection},
    {"exchange", "exchanging the ends of a segment turns no hit into a miss", Per::kPair,
     kOfHits | Needs::kRays | Needs::kAnyRay, Quantity::kClass, judge_exchange, kRelations,
     Stage::kIntersection},
};

}  // namespace

constinit const std::span<const Law> kMetamorphicLaws = kMetamorphicLawTable;

}  // namespace raycheck::properties
