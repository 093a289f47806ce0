#include <cmath>

#include "properties/laws/law_list.h"
#include "reference/account/condition.h"
#include "reference/error_measure.h"
#include "reference/near_error.h"
#include "reference/ray_error.h"

namespace raycheck::properties {

double plain_condition(const Candidate& candidate, const ExactRay& ray, const Sphere& sphere,
                       const Intersection& at) {
  if (candidate.level != Level::kOrdinary) return 0;
  return reference::distance_in_radii(ray, sphere) <= kOrdinaryDistance
             ? reference::textbook_condition(ray, sphere, at)
             : 0;
}

namespace {

/// A ray and a sphere that meet according to the candidate, the truth or both.
struct Encounter {
  Trial& trial;
  std::size_t ray_at, sphere_at;
  const HitAnswer* answer;    ///< Null: a miss.
  const Intersection* exact;  ///< Null: a miss.
  const ExactRay& ray = trial.exact_ray(ray_at);
  const Sphere& sphere = trial.scene().spheres[sphere_at];

  Place place() const { return trial.place(ray_at, sphere_at); }
  /// Whether the exact hit is the start of the ray.
  bool is_at_start() const {
    return exact != nullptr && properties::is_at_start(ray, sphere, trial.candidate());
  }
  /// Whether the exact hit is at s = 0, at a root.
  bool is_at_zero() const {
    return exact != nullptr && exact->hit_class == HitClass::kHit && !is_at_start() &&
           ray.compare_parameter(sphere, *exact, 0, scene::TUnit::kAbsolute) == 0;
  }
  bool is_at_other_root() const {
    return properties::is_at_other_root(answer_of(ray, sphere, answer), *exact, trial.candidate());
  }
  /// Whether the candidate reports a hit outside the interval by which it is judged.
  bool is_excluded() const {
    return answer != nullptr && properties::is_excluded(answer_of(ray, sphere, answer),
                                                        exact != nullptr ? *exact : Intersection{},
                                                        trial.conventions(), trial.candidate());
  }
  Excuse excuse() const { return trial.excuse({answer_of(ray, sphere, answer)}); }
  void describe(Discrepancy& d) const {
    if (answer != nullptr) d.got = {answer->parameter};
    d.got_some_sphere = answer != nullptr && trial.candidate().interface.returns == Returns::kClass;
    if (is_excluded()) d.excluded_by = trial.conventions().valid;
    if (exact != nullptr) d.exact = {rounded_s(ray, sphere, *exact, trial.candidate())};
  }
  /// The backward error of the answer, for exactly the ray that was passed to the candidate; picks
  /// have none.
  scene::Measured backward_error() const {
    if (is_at_start() || trial.picks()) return {};
    return reference::backward_error(trial.rays()[ray_at], sphere, answer->parameter);
  }

  /// The declared tolerance within which the answer lies.
  double tolerance_of_s() const { return trial.tolerance(ray, sphere, answer->parameter); }
  double tolerance_of_point() const { return trial.tolerance(ray, sphere, answer->point); }

  /// plain_change() if the textbook's roundings may be as large as d^2, so that no condition number
  /// bounds their effect on s; otherwise 0.
  double plain_blur() const {
    const double change = properties::plain_change(trial.candidate(), ray, sphere);
    const double roundings = excused_change(trial.candidate().unit_roundoff) * change;
    return reference::half_chord_share(ray, sphere) <= roundings ? change : 0;
  }
  /// plain_condition() of s; infinite if s is right for inputs that are changed by plain_blur().
  double plain_condition() const {
    const double blur = plain_blur();
    const double bound = trial.bound(Quantity::kBackwardError) * bound_growth(blur);
    if (blur > 0 && backward_error().in(trial.precision()).value <= bound) {
      return std::numeric_limits<double>::infinity();
    }
    const double condition = properties::plain_condition(trial.candidate(), ray, sphere, *exact);
    return std::isinf(condition) ? 0 : condition;
  }
  /// The condition number of s relative to a length. At a tangent, Q slides along the sphere.
  double plain_condition_over(const Enclosure& length) const {
    const double condition = properties::plain_condition(trial.candidate(), ray, sphere, *exact);
    if (std::isinf(condition)) return plain_blur();
    const reference::EnclosedRay enclosed = ray.enclose(256);
    const Enclosure along = norm(enclosed.point(sphere, *exact) - enclosed.origin());
    return condition * (along / length).upper();
  }
};

/// Calls visit(encounter) for all encounters that are judged, sphere by sphere. All other judged
/// pairs are misses for both the candidate and the truth.
template <class Visit>
void for_each_encounter(Trial& trial, Visit visit) {
  const scene::Tangent tangent = trial.conventions().tangent;
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const SphereHits& hits = trial.hits(sphere);
    auto hit = hits.begin();
    const auto visit_false_hits_before = [&](std::size_t ray) {
      for (; hit != hits.end() && hit->ray < ray; ++hit) {
        visit(Encounter{trial, hit->ray, sphere, &hit->hit, nullptr});
      }
    };
    for (const Meeting& meeting : trial.exact_meetings(sphere)) {
      visit_false_hits_before(meeting.ray);
      const bool is_answered = hit != hits.end() && hit->ray == meeting.ray;
      const HitAnswer* const answer = is_answered ? &(hit++)->hit : nullptr;
      const Intersection& at = meeting.intersection;
      if (is_unjudged(at, tangent)) continue;
      const bool is_hit = counts_as_hit(at.hit_class, tangent);
      if (is_hit || is_answered) {
        visit(Encounter{trial, meeting.ray, sphere, answer, is_hit ? &at : nullptr});
      }
    }
    visit_false_hits_before(trial.ray_count());
  }
}

/// Calls visit(encounter) if both the candidate and the truth have a hit, at the same root or both
/// at the start of the ray.
template <class Visit>
void for_each_common_hit(Trial& trial, Visit visit) {
  for_each_encounter(trial, [&](const Encounter& at) {
    if (at.answer != nullptr && at.exact != nullptr && !at.is_at_other_root()) visit(at);
  });
}

/// Counts the answers about exact tangents; returns the number that is not judged.
std::size_t note_tangents(Trial& trial, Verdict& verdict) {
  std::size_t count = 0;
  const scene::Tangent tangent = trial.conventions().tangent;
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    for (const Meeting& meeting : trial.exact_meetings(sphere)) {
      if (meeting.intersection.hit_class != HitClass::kTangent) continue;
      count += tangent == scene::Tangent::kEither ? 1 : 0;
      if (tangent == scene::Tangent::kMiss) continue;
      verdict.note(Fact::kTangent, find_hit(trial.hits(sphere), meeting.ray) != nullptr);
    }
  }
  return count;
}

void judge_class(Trial& trial, Verdict& verdict) {
  const std::size_t unjudged = note_tangents(trial, verdict);
  std::size_t misses = trial.ray_count() * trial.scene().spheres.size() - unjudged;
  for_each_encounter(trial, [&](const Encounter& at) {
    const bool missed = at.answer == nullptr;
    const bool false_hit = at.exact == nullptr;
    if (missed && at.is_at_zero()) verdict.note(Fact::kMissedAtZero, false);
    trial.judge(
        verdict,
        {Quantity::kClass, false_hit ? Expected::kMiss : Expected::kHit, at.place(),
         missed      ? Wrong::kMissed
         : false_hit ? Wrong::kFalseHit
                     : Wrong::kNot},
        [&] { return at.excuse(); }, [&](Discrepancy& d) { at.describe(d); });
    --misses;
  });
  verdict.judged_right(Quantity::kClass, Expected::kMiss, misses);
  if (unjudged > 0) verdict.leave_out("exact tangents are not judged under tangent = either");
}

/// If no hit was compared, leaves the law out with the reason.
void leave_out_without_hits(Trial& trial, Verdict& verdict) {
  if (verdict.compared() > 0) return;
  bool has_exact = false, has_common = false;
  for_each_encounter(trial, [&](const Encounter& at) {
    has_exact = has_exact || at.exact != nullptr;
    has_common = has_common || (at.exact != nullptr && at.answer != nullptr);
  });
  verdict.leave_out(!has_exact   ? "no ray hits a sphere"
                    : has_common ? "the candidate finds no hit at the right root"
                                 : "the candidate finds no hit to compare");
}

void judge_root(Trial& trial, Verdict& verdict) {
  for_each_encounter(trial, [&](const Encounter& at) {
    if (at.answer == nullptr || at.exact == nullptr) return;
    trial.judge(
        verdict,
        {Quantity::kRoot, root_expected(*at.exact), at.place(),
         at.is_at_other_root() || at.is_excluded() ? Wrong::kWrongRoot : Wrong::kNot},
        [&] { return at.excuse(); }, [&](Discrepancy& d) { at.describe(d); });
  });
  leave_out_without_hits(trial, verdict);
}

/// Judges s of a hit; `condition` gives its condition number.
void measure_parameter(Trial& trial, Verdict& verdict, const Encounter& at,
                       const std::function<double()>& condition, const char* what) {
  trial.measure(
      verdict,
      {Quantity::kParameter, at.place(),
       at.is_at_start() ? scene::Measured{}
                        : reference::parameter_error(at.ray, at.sphere, *at.exact,
                                                     at.answer->parameter, trial.precision())},
      condition,
      [&](Discrepancy& d) {
        at.describe(d);
        d.what = what;
      },
      [&] { return at.backward_error(); }, [&] { return at.plain_condition(); },
      [&] { return at.tolerance_of_s(); });
}

void judge_parameter(Trial& trial, Verdict& verdict) {
  for_each_common_hit(trial, [&](const Encounter& at) {
    const auto condition = [&] {
      return at.is_at_start() ? 0 : trial.condition_of_parameter(at.ray_at, at.sphere_at);
    };
    measure_parameter(trial, verdict, at, condition, "");
    if (!at.answer->other_root) return;
    const HitAnswer answer = {*at.answer->other_root, {}};
    Intersection exact = *at.exact;
    exact.root = exact.root == WhichRoot::kSmaller ? WhichRoot::kLarger : WhichRoot::kSmaller;
    const Encounter other = {trial, at.ray_at, at.sphere_at, &answer, &exact};
    measure_parameter(
        trial, verdict, other,
        [&] { return reference::condition_of_parameter(at.ray, at.sphere, exact); },
        "the other root");
  });
  leave_out_without_hits(trial, verdict);
}

void judge_backward_error(Trial& trial, Verdict& verdict) {
  for_each_common_hit(trial, [&](const Encounter& at) {
    // A backward error is already a change of the inputs, so it may grow only by the ratio of the
    // formula's condition number to the problem's.
    trial.measure(
        verdict, {Quantity::kBackwardError, at.place(), at.backward_error()}, [] { return 1; },
        [&](Discrepancy& d) { d.got = {at.answer->parameter}; }, {},
        [&] {
          const double blur = at.plain_blur();
          if (blur > 0) return blur;
          return at.plain_condition() / trial.condition_of_parameter(at.ray_at, at.sphere_at);
        },
        [&] { return at.tolerance_of_s(); });
  });
  leave_out_without_hits(trial, verdict);
}

/// Judges the distances of the candidate's point from its sphere, relative to r, and from its ray,
/// relative to s |D|. Both are differences of world coordinates, so their condition numbers are the
/// size of these coordinates over r and over s |D|.
void judge_residuals(Trial& trial, Verdict& verdict, const Encounter& at) {
  const ExactRay& ray = at.ray;
  const Sphere& sphere = at.sphere;
  const Point3& answer = at.answer->point;
  const auto measure = [&](Quantity quantity, const std::optional<scene::Measured>& error,
                           const auto& scale, const std::function<double()>& plain,
                           const std::function<double()>& tolerance) {
    if (!error) return;
    trial.measure(
        verdict, {quantity, at.place(), *error},
        [&] {
          const Enclosure3 point = enclose_exactly(answer);
          const Enclosure3 centre = enclose_exactly(sphere.centre);
          const Enclosure3 origin = ray.enclose(256).origin();
          const Enclosure radius(sphere.radius, 256);
          const Enclosure size = norm(point) + norm(centre) + norm(origin) + radius;
          // At a double root, an error of s moves the point along the surface.
          const double of_point = reference::condition_of_point(ray, sphere, *at.exact);
          return (size / scale(point - origin, radius)).upper() *
                 (std::isinf(of_point) ? 1 : of_point);
        },
        [&](Discrepancy& d) { d.got = numbers(answer); }, {}, plain, tolerance);
  };
  measure(
      Quantity::kSphereResidual, reference::sphere_residual(sphere, answer),
      [](const Enclosure3&, const Enclosure& radius) { return radius; },
      [&] { return at.plain_condition_over(Enclosure(sphere.radius, 256)); },
      [&] { return at.tolerance_of_point(); });
  measure(Quantity::kRayResidual, reference::ray_residual(ray, answer),
          [](const Enclosure3& along, const Enclosure&) { return norm(along); }, {}, {});
}

/// Judges Q, which must be the origin of the ray as the candidate got it.
void judge_start(Trial& trial, Verdict& verdict, const Encounter& at) {
  const Point3& origin = trial.rays()[at.ray_at].origin;
  const Enclosure3 exact = enclose_exactly(origin);
  const Enclosure off = norm(enclose_exactly(at.answer->point) - exact);
  const Enclosure size = norm(exact) + norm(enclose_exactly(at.sphere.centre));
  trial.measure(
      verdict,
      {Quantity::kHitPoint, at.place(),
       in_units_of_u(off / (size + Enclosure(at.sphere.radius, 256)))},
      [] { return 1; }, shown(at.answer->point, [&] { return origin; }));
}

void judge_hit_point(Trial& trial, Verdict& verdict) {
  for_each_common_hit(trial, [&](const Encounter& at) {
    if (at.is_at_start()) return judge_start(trial, verdict, at);
    trial.measure(
        verdict,
        {Quantity::kHitPoint, at.place(),
         reference::hit_point_error(at.ray, at.sphere, *at.exact, at.answer->point)},
        [&] { return reference::condition_of_computed_point(at.ray, at.sphere, *at.exact); },
        shown(at.answer->point,
              [&] { return at.ray.rounded_point(at.sphere, *at.exact, trial.precision()); }),
        [&] { return at.backward_error(); },
        [&] {
          const double of_s = at.plain_condition();
          // Then only the residuals limit the error of Q.
          if (std::isinf(of_s)) return of_s;
          return at.plain_condition_over(norm(at.ray.enclose(256).point(at.sphere, *at.exact)));
        },
        [&] { return at.tolerance_of_point(); });
    judge_residuals(trial, verdict, at);
  });
  leave_out_without_hits(trial, verdict);
}

/// The answers about one pixel from both origins.
struct BothOrigins {
  const ExactRay& eye_ray;
  const ExactRay& pixel_ray;
  const HitAnswer& eye_hit;
  const HitAnswer& pixel_hit;
  Precision precision;
};

void describe_origins(Discrepancy& d, const BothOrigins& both, const Sphere& sphere,
                      const Intersection& at) {
  d.what = "s from the eye, s from the pixel";
  d.symbol.clear();
  d.got = {both.eye_hit.parameter, both.pixel_hit.parameter};
  d.exact = {both.eye_ray.rounded_parameter(sphere, at, both.precision),
             both.pixel_ray.rounded_parameter(sphere, at, both.precision)};
}

/// Judges whether each answer is at the root that is exact for both rays, and returns whether one
/// is not. The two parameters then differ by a chord, not by l, even if both are accurate: if a ray
/// starts within a rounding of the surface, that rounding decides whether its near root is before
/// or behind its origin. As in the laws `class` and `nearest-root`, a wrong root is excused only if
/// nearby inputs have it.
bool judge_other_root(Trial& trial, Verdict& verdict, const Place& place, const BothOrigins& both,
                      const Intersection& at) {
  const Sphere& sphere = trial.scene().spheres[*place.sphere];
  const auto is_wrong = [&](const ExactRay& ray, const HitAnswer& hit) {
    return reference::is_at_other_root(ray, sphere, at, hit.parameter);
  };
  const bool is_other_root =
      is_wrong(both.eye_ray, both.eye_hit) || is_wrong(both.pixel_ray, both.pixel_hit);
  trial.judge(
      verdict,
      {Quantity::kRoot, root_expected(at), place, is_other_root ? Wrong::kWrongRoot : Wrong::kNot},
      [&] {
        return trial.excuse({answer_of(both.eye_ray, sphere, &both.eye_hit),
                             answer_of(both.pixel_ray, sphere, &both.pixel_hit)});
      },
      [&](Discrepancy& d) { describe_origins(d, both, sphere, at); });
  return is_other_root;
}

/// Both rays find the same point: s from the eye is s from the pixel point plus l.
void judge_focal_and_pixel(Trial& trial, Verdict& verdict) {
  if (!trial.conventions().valid.is_usual()) {
    return verdict.leave_out("t_min and t_max count from the origin of the ray, which differs");
  }
  const Candidate& candidate = trial.candidate();
  Conventions from_pixel = trial.conventions();
  from_pixel.origin = scene::Origin::kPixel;
  Conventions from_eye = from_pixel;
  from_eye.origin = scene::Origin::kFocal;
  const Camera& camera = *trial.scene().camera;
  const auto exact_camera = [&](const Conventions& by) {
    return by == trial.conventions() ? trial.exact_camera() : ExactCamera(camera, by);
  };
  const ExactCamera pixel_camera = exact_camera(from_pixel);
  const ExactCamera eye_camera = exact_camera(from_eye);
  const auto pixel_rays = candidate.pixel_rays(camera, from_pixel, trial.pixels());
  const auto eye_rays = candidate.focal_rays(camera, from_eye, trial.pixels());
  const auto all_pixel_hits = trial.intersect(pixel_rays, trial.scene().spheres, from_pixel);
  const auto all_eye_hits = trial.intersect(eye_rays, trial.scene().spheres, from_eye);
  for (std::size_t sphere = 0; sphere < trial.scene().spheres.size(); ++sphere) {
    const Sphere& the_sphere = trial.scene().spheres[sphere];
    for (const RayHit& eye : all_eye_hits[sphere]) {
      const std::size_t k = eye.ray;
      const HitAnswer* const pixel_hit = find_hit(all_pixel_hits[sphere], k);
      if (pixel_hit == nullptr) continue;  // the class law judges this
      const ExactRay pixel_ray(pixel_camera, trial.pixels()[k]);
      const ExactRay eye_ray(eye_camera, trial.pixels()[k]);
      const auto met_by = [&](const ExactRay& ray) {
        return exact_intersection(ray, the_sphere, from_eye, candidate.interface.from_inside);
      };
      const Intersection at = met_by(eye_ray);
      // The exact root or hit class from the pixel differs, because the sphere reaches behind the
      // pixel; or the hit is the start of a ray.
      if (at.hit_class != HitClass::kHit || !(at == met_by(pixel_ray)) ||
          is_at_start(eye_ray, the_sphere, candidate) ||
          is_at_start(pixel_ray, the_sphere, candidate)) {
        continue;
      }
      const Place place = trial.place(k, sphere);
      const BothOrigins both{eye_ray, pixel_ray, eye.hit, *pixel_hit, trial.precision()};
      if (judge_other_root(trial, verdict, place, both, at)) continue;
      const auto condition = [&] {
        return reference::condition_of_parameter(eye_ray, the_sphere, at) +
               reference::condition_of_point(eye_ray, the_sphere, at);
      };
      const auto describe = [&](Discrepancy& d) { describe_origins(d, both, the_sphere, at); };
      const auto plain = [&] {
        const double from_both = plain_condition(candidate, eye_ray, the_sphere, at) +
                                 plain_condition(candidate, pixel_ray, the_sphere, at);
        return std::isinf(from_both) ? 0 : from_both;
      };
      const auto tolerance = [&] {
        return std::max(trial.tolerance(eye_ray, the_sphere, eye.hit.parameter),
                        trial.tolerance(pixel_ray, the_sphere, pixel_hit->parameter));
      };
      const auto near = reference::hit_in_double_doubles(eye_ray, the_sphere, at);
      std::optional<reference::EnclosedRay> enclosed;
      const auto in_balls = [&] {
        if (!enclosed) enclosed = eye_ray.enclose(256);
        return *enclosed;
      };
      const auto measure = [&](Quantity bounded, const auto& in_double_doubles,
                               const auto& in_enclosures) {
        const double bound = 2 * trial.bound(bounded);
        const scene::Measured error = trial.settled(
            verdict, Quantity::kInvariance, bound,
            [&] {
              return reference::by_double_doubles(
                  [&] { return reference::narrow_error_in_u(abs(in_double_doubles())); });
            },
            [&] { return in_units_of_u(in_enclosures()); });
        trial.measure(verdict, {Quantity::kInvariance, place, error, bound}, condition, describe,
                      {}, plain, tolerance);
      };
      // The difference of the parameters, without l; then that of the points.
      const auto off = [](const auto& eye_s, const auto& pixel_s, const auto& l, const auto& s) {
        return (eye_s - pixel_s - l) / s;
      };
      const auto apart = [](const auto& one, const auto& other, const auto& point,
                            const auto& origin) {
        return norm(one - other) / (norm(point) + norm(origin));
      };
      const double eye_s = eye.hit.parameter, pixel_s = pixel_hit->parameter;
      measure(
          Quantity::kParameter,
          [&] {
            return off(reference::DoubleDouble(eye_s), reference::DoubleDouble(pixel_s),
                       near.length, near.parameter);
          },
          [&] {
            return off(Enclosure(eye_s, 256), Enclosure(pixel_s, 256), in_balls().length(),
                       in_balls().parameter(the_sphere, at));
          });
      measure(
          Quantity::kHitPoint,
          [&] {
            return apart(reference::in_double_doubles(eye.hit.point),
                         reference::in_double_doubles(pixel_hit->point), near.point, near.origin);
          },
          [&] {
            return apart(enclose_exactly(eye.hit.point), enclose_exactly(pixel_hit->point),
                         in_balls().point(the_sphere, at), in_balls().origin());
          });
    }
  }
  if (verdict.compared() == 0) {
    return verdict.leave_out("no sphere is hit at the same root from both origins");
  }
}

constexpr Law kIntersectLawTable[] = {
    {"class", "rays hit and miss as in exact arithmetic", Per::kPair,
     Needs::kIntersect | Needs::kSpheres | Needs::kRays, Quantity::kClass, judge_class, kValues,
     Stage::kIntersection, kStability},
    {"nearest-root",
     "the root is the right one: the one that the conventions choose in exact arithmetic",
     Per::kPair, Needs::kIntersect | Needs::kSpheres | Needs::kRays | Needs::kEither,
     Quantity::kRoot, judge_root, kValues, Stage::kIntersection, kStability},
    {"parameter", "the parameter s is the exact root, within its bound", Per::kPair,
     Needs::kIntersect | Needs::kSpheres | Needs::kRays | Needs::kParameters, Quantity::kParameter,
     judge_parameter, kValues, Stage::kIntersection, kStability},
    {"backward-error", "the parameter s is the exact root for inputs changed by a few roundings",
     Per::kPair,
     Needs::kIntersect | Needs::kSpheres | Needs::kRays | Needs::kParameters | Needs::kAnyRay,
     Quantity::kBackwardError, judge_backward_error, kRelations, Stage::kIntersection, kStability},
    {"hit-point", "the hit point is exact, lies on the sphere and on the ray", Per::kPair,
     Needs::kIntersect | Needs::kSpheres | Needs::kRays | Needs::kPoints, Quantity::kHitPoint,
     judge_hit_point, kValues, Stage::kIntersection},
    {"focal-and-pixel",
     "rays from E and from P hit the same point, and their s differ by the length of P - E",
     Per::kPair,
     Needs::kBothOrigins | Needs::kIntersect | Needs::kSpheres | Needs::kParameters |
         Needs::kPoints | Needs::kAnyRay,
     Quantity::kInvariance, judge_focal_and_pixel},
};

}  // namespace

constinit const std::span<const Law> kIntersectLaws = kIntersectLawTable;

}  // namespace raycheck::properties
