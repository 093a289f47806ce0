// Metamorphic laws: two cases whose answers must correspond.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "properties/laws/law_list.h"
#include "reference/condition.h"
#include "reference/error_measure.h"
#include "scene/scene_scalars.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

using reference::Enclosure;
using scene::Scene;

std::string nothing_to_intersect(const Trial& trial) {
  if (!trial.candidate().intersect) return "the candidate intersects nothing";
  if (trial.scene().spheres.empty()) return "the scene has no sphere";
  if (!trial.has_rays()) return "the candidate makes no rays from this origin";
  return {};
}

/// Compares the hits of a case and its transformed case; `factor` takes a parameter of the first to
/// the second. The exact answer serves only to tell how well-conditioned a pair is.
void compare_hits(Trial& trial, Trial& transformed, Verdict& verdict, const Law& law,
                  const std::string& what, double factor) {
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const auto& hits = trial.hits(sphere);
    const auto& others = transformed.hits(sphere);
    for (std::size_t k = 0; k < trial.ray_count(); ++k) {
      const Place place = trial.place(k, sphere);
      const HitAnswer* const hit = find_hit(hits, k);
      const HitAnswer* const other = find_hit(others, k);
      const auto describe = [&](Discrepancy& d) {
        d.what = what;
        if (other != nullptr) d.got = {other->parameter};
        if (hit != nullptr) d.exact = {hit->parameter * factor};
      };
      const scene::Sphere& the_sphere = trial.scene().spheres[sphere];
      const Wrong wrong = (hit == nullptr) == (other == nullptr) ? Wrong::kNot
                          : hit != nullptr                       ? Wrong::kMissed
                                                                 : Wrong::kFalseHit;
      const auto may_flip = [&] {
        return trial.exact_ray(k).may_flip_within(the_sphere, trial.conventions().root,
                                                  trial.excused_change());
      };
      trial.judge(verdict, law.name, Quantity::kClass, place, wrong, may_flip, describe);
      if (hit == nullptr || other == nullptr) continue;
      const auto condition = [&] {
        // Where roundings may flip the class, they may also exchange a double root's two halves.
        if (may_flip() || !trial.exact_hit(k, sphere)) {
          return std::numeric_limits<double>::infinity();
        }
        return reference::condition_of_parameter(trial.exact_ray(k), the_sphere,
                                                 trial.exact_intersection(k, sphere));
      };
      trial.measure(verdict, law.name, Quantity::kInvariance, place,
                    reference::ulp_error(other->parameter, Enclosure(hit->parameter * factor, 128)),
                    2 * trial.bound(Quantity::kParameter), condition, describe);
    }
  }
}

/// Compares the directions of a case and its transformed case; `map` takes the first to the second.
void compare_directions(Trial& trial, Trial& transformed, Verdict& verdict, const Law& law,
                        const std::string& what,
                        const std::function<scene::Vector3(const scene::Vector3&)>& map) {
  for (std::size_t k = 0; k < trial.ray_count(); ++k) {
    const scene::Vector3 expected = map(trial.rays()[k].direction);
    const scene::Vector3& got = transformed.rays()[k].direction;
    trial.measure(
        verdict, law.name, Quantity::kInvariance, trial.place(k),
        reference::relative_error(scene::UnitVector3{got.x, got.y, got.z},
                                  reference::enclose_exactly(expected)),
        2 * trial.bound(Quantity::kDirection),
        [&] { return reference::condition_of_direction(trial.exact_ray(k)); },
        [&](Discrepancy& d) {
          d.what = what;
          d.got = numbers(got);
          d.exact = numbers(expected);
        });
  }
}

/// The scene with every length times 2^exponent; directions and `up` as they are. Empty where that
/// would round.
std::optional<Scene> scaled(Scene scene, int exponent) {
  bool exact = true;
  for_each_length(scene, [&](double& x) {
    const double result = std::ldexp(x, exponent);
    exact = exact && std::isfinite(result) && std::ldexp(result, -exponent) == x;
    x = result;
  });
  if (scene.camera) scene.camera->far.reset();
  return exact ? std::optional(scene) : std::nullopt;
}

Verdict judge_scaling(Trial& trial) {
  const bool hits = nothing_to_intersect(trial).empty();
  const bool directions = trial.scene().camera && trial.has_rays();
  if (!hits && !directions) return Verdict::left_out(nothing_to_intersect(trial));
  Verdict verdict;
  for (const int exponent : {-120, -40, 3, 40, 120}) {
    const auto scene = scaled(trial.scene(), exponent);
    if (!scene || !is_inside_domain(trial.candidate(), *scene)) continue;
    const Case transformed_case{*scene, trial.pixels()};
    Trial transformed(transformed_case, trial.candidate());
    const std::string what = "scaled by 2^" + std::to_string(exponent);
    if (directions) {
      compare_directions(trial, transformed, verdict, kScalingLaw, what,
                         [](const scene::Vector3& v) { return v; });
    }
    if (hits) {
      compare_hits(trial, transformed, verdict, kScalingLaw, what, std::ldexp(1.0, exponent));
    }
  }
  if (verdict.compared() == 0) {
    return Verdict::left_out("no scaled scene stays in the method's stated domain");
  }
  return verdict;
}

/// A map of world axes to world axes: coordinates are moved, never rounded.
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

Verdict judge_axes(Trial& trial) {
  const bool hits = nothing_to_intersect(trial).empty();
  const bool directions = trial.scene().camera && trial.has_rays();
  if (!hits && !directions) return Verdict::left_out(nothing_to_intersect(trial));
  Verdict verdict;
  for (const AxesMap& map : kAxesMaps) {
    if (map.is_mirror && trial.scene().camera) continue;
    const Case transformed_case{rotated(trial.scene(), map), trial.pixels()};
    Trial transformed(transformed_case, trial.candidate());
    if (directions) {
      compare_directions(trial, transformed, verdict, kAxesLaw, map.what, map.apply);
    }
    if (hits) compare_hits(trial, transformed, verdict, kAxesLaw, map.what, 1);
  }
  return verdict;
}

/// a + b, where that is a double.
std::optional<double> exact_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double error = (a - (sum - b_part)) + (b - b_part);
  return error == 0 ? std::optional(sum) : std::nullopt;
}

/// p a + q b, where p a and q b do not round and the sum is a double.
template <class To, class A, class B>
std::optional<To> exact_sum_of(const A& a, const B& b, double p, double q) {
  const auto sum = [&](double from_a, double from_b) -> std::optional<double> {
    if (p * from_a / p != from_a || q * from_b / q != from_b) return std::nullopt;
    return exact_sum(p * from_a, q * from_b);
  };
  const auto x = sum(a.x, b.x);
  const auto y = sum(a.y, b.y);
  const auto z = sum(a.z, b.z);
  if (!x || !y || !z) return std::nullopt;
  return To{*x, *y, *z};
}

/// Two cameras with the same axes: the candidate's frames must agree.
Verdict compare_frames(Trial& trial, const Law& law, const scene::Camera& other_camera,
                       const std::string& what) {
  if (!scene::defects(other_camera).empty()) {
    return Verdict::left_out("the changed camera is degenerate");
  }
  Verdict verdict;
  const FrameAnswer other = trial.candidate().frame(other_camera);
  const FrameAnswer& frame = trial.frame();
  const reference::ExactCamera exact_other(other_camera, trial.conventions());
  const auto compare = [&](const char* axis, const scene::UnitVector3& got,
                           const scene::UnitVector3& expected) {
    trial.measure(
        verdict, law.name, Quantity::kInvariance, Place{},
        reference::relative_error(got, reference::enclose_exactly(expected)),
        2 * trial.bound(Quantity::kFrame),
        [&] {
          return std::max(reference::condition_of_frame(trial.exact_camera()),
                          reference::condition_of_frame(exact_other));
        },
        [&](Discrepancy& d) {
          d.what = std::string(axis) + ", " + what;
          d.got = numbers(got);
          d.exact = numbers(expected);
        });
  };
  compare("U", other.U, frame.U);
  compare("V", other.V, frame.V);
  compare("W", other.W, frame.W);
  return verdict;
}

std::string no_frame(const Trial& trial) {
  if (!trial.scene().camera) return "the scene has no camera";
  if (!trial.candidate().frame) return "the candidate gives no frame";
  return {};
}

Verdict judge_look_at(Trial& trial) {
  if (auto reason = no_frame(trial); !reason.empty()) return Verdict::left_out(reason);
  const scene::Camera& camera = *trial.scene().camera;
  const auto along = exact_sum_of<scene::Vector3>(camera.look_at, camera.eye, 1, -1);
  Verdict verdict;
  // A + k (A - E) lies on the view axis where no step rounds.
  for (const double multiple : {-0.5, 1.0, 2.0, 8.0}) {
    if (!along) break;
    const auto moved = exact_sum_of<scene::Point3>(camera.look_at, *along, 1, multiple);
    if (!moved) continue;
    scene::Camera other = camera;
    other.look_at = *moved;
    verdict.merge(compare_frames(trial, kLookAtLaw, other, "look-at moved along the view axis"));
  }
  if (verdict.compared() == 0) {
    return Verdict::left_out("no point A + k (A - E) tried is a double");
  }
  return verdict;
}

Verdict judge_up(Trial& trial) {
  if (auto reason = no_frame(trial); !reason.empty()) return Verdict::left_out(reason);
  const scene::Camera& camera = *trial.scene().camera;
  const auto along = exact_sum_of<scene::Vector3>(camera.eye, camera.look_at, 1, -1);
  Verdict verdict;
  for (const double multiple : {-1.0, 0.5, 1.0, 4.0}) {
    if (!along) break;
    const auto tilted = exact_sum_of<scene::Vector3>(camera.up, *along, 1, multiple);
    if (!tilted) continue;
    scene::Camera other = camera;
    other.up = *tilted;
    verdict.merge(compare_frames(trial, kUpLaw, other, "up + k (E - A)"));
  }
  if (verdict.compared() == 0) {
    return Verdict::left_out("no vector up + k (E - A) tried is a double");
  }
  return verdict;
}

Verdict judge_growing_radius(Trial& trial) {
  if (auto reason = nothing_to_intersect(trial); !reason.empty()) return Verdict::left_out(reason);
  if (trial.conventions().root != scene::Root::kNearest) {
    return Verdict::left_out("with root = smaller, a grown sphere may swallow the origin");
  }
  Verdict verdict;
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const scene::Sphere& the_sphere = trial.scene().spheres[sphere];
    for (const double radius : {std::nextafter(the_sphere.radius, HUGE_VAL),
                                1.5 * the_sphere.radius, 4 * the_sphere.radius}) {
      if (!(radius > the_sphere.radius) || !std::isfinite(radius)) continue;
      const auto grown = trial.intersect(trial.rays(), {scene::Sphere{the_sphere.centre, radius}},
                                         trial.conventions());
      for (const RayHit& before : trial.hits(sphere)) {
        const std::size_t k = before.ray;
        trial.judge(
            verdict, kGrowingRadiusLaw.name, Quantity::kClass, trial.place(k, sphere),
            find_hit(grown.front(), k) != nullptr ? Wrong::kNot : Wrong::kMissed,
            [&] {
              return trial.exact_ray(k).may_flip_within(the_sphere, trial.conventions().root,
                                                        trial.excused_change());
            },
            [&](Discrepancy& d) {
              d.what = "after the radius grew";
              d.exact = {before.hit.parameter};
            });
      }
    }
  }
  if (verdict.compared() == 0) return Verdict::left_out("the candidate finds no hit to begin with");
  return verdict;
}

}  // namespace

constinit const Law kScalingLaw = {"scaling", "scaling every length by 2^k scales every answer",
                                   Law::Subject::kAny, false, judge_scaling};
constinit const Law kAxesLaw = {"axes", "permuting or negating axes does the same to every answer",
                                Law::Subject::kAny, false, judge_axes};
constinit const Law kLookAtLaw = {"look-at",
                                  "moving look-at along the view axis leaves the frame alone",
                                  Law::Subject::kCamera, false, judge_look_at};
constinit const Law kUpLaw = {"up", "adding a multiple of W to up leaves the frame alone",
                              Law::Subject::kCamera, false, judge_up};
constinit const Law kGrowingRadiusLaw = {"growing-radius",
                                         "growing r never turns a hit into a miss",
                                         Law::Subject::kIntersection, false, judge_growing_radius};

}  // namespace raycheck::properties
