// Enclosures, rounded values, condition numbers and errors of raycheck/batch.h.

#include <raycheck/batch.h>

#include "library/batch_arrays.h"
#include "library/quantity.h"
#include "properties/quantity.h"
#include "reference/account/nearby_answer.h"
#include "reference/ray_error.h"

namespace raycheck::library {
namespace {

/// The number of answers that a thread takes at a time.
constexpr std::size_t kAtATime = 64;

/// Arrays of values: s, Q, D and P.
struct Values {
  Target s;
  Target3 point, direction, pixel_point;

  Values(const Questions& asked, const raycheck_output& its_s, const raycheck_output3& Q,
         const raycheck_output3& D, const raycheck_output3& P)
      : s(numbers(its_s, "s", asked.answers())),
        point(numbers(Q, "point", asked.answers())),
        direction(numbers(D, "direction", asked.rays())),
        pixel_point(numbers(P, "pixel_point", asked.rays())) {}

  void set(Quantity quantity, std::size_t k, const scene::Point3& value, Way way) const {
    if (quantity == Quantity::kParameter) return s.set(k, value.x, way);
    at(quantity).set(k, value, way);
  }
  bool has(Quantity quantity) const {
    return quantity == Quantity::kParameter ? bool(s) : bool(at(quantity));
  }
  scene::Precision precision(Quantity quantity) const {
    const Target& to = quantity == Quantity::kParameter ? s : at(quantity).x;
    return to.is_single() ? scene::Precision::kSingle : scene::Precision::kDouble;
  }

 private:
  const Target3& at(Quantity quantity) const {
    return quantity == Quantity::kPoint       ? point
           : quantity == Quantity::kDirection ? direction
                                              : pixel_point;
  }
};

/// Calls answer(k, ray, sphere or null, its intersection) for each answer whose ray is valid, and
/// nothing(k, whether it is a miss) for the others. The sphere is null if it is not valid.
template <class Answer, class Nothing>
void for_each_answer(const Questions& asked, const Answer& answer, const Nothing& nothing) {
  const bool has_spheres = asked.spheres() > 0;
  const auto body = [&](std::size_t first, std::size_t count) {
    for (std::size_t k = first; k < first + count; ++k) {
      const auto ray = asked.exact(asked.ray_of(k));
      asked.note_ray(asked.ray_of(k));
      if (!ray) {
        nothing(k);
        continue;
      }
      if (!has_spheres || !asked.is_valid_sphere(asked.sphere_of(k))) {
        if (has_spheres) asked.note_sphere(asked.sphere_of(k));
        answer(k, *ray, static_cast<const scene::Sphere*>(nullptr), reference::Intersection{});
        continue;
      }
      const scene::Sphere sphere = asked.sphere(asked.sphere_of(k));
      answer(k, *ray, &sphere, ray->intersect(sphere, asked.conventions()));
    }
  };
  if (has_spheres) return asked.for_each_block(kAtATime, body);
  asked.for_each_block_of_rays(kAtATime, body);
}

/// Calls put(quantity, k, meeting, or null if there is no value) for each value that `is_wanted`.
template <class IsWanted, class Put>
void for_each_value(const Questions& asked, const IsWanted& is_wanted, const Put& put) {
  const Quantity last = asked.is_of_camera() ? Quantity::kPixelPoint : Quantity::kOrigin;
  for (const Quantity one : {Quantity::kParameter, Quantity::kPoint}) {
    if (is_wanted(one) && asked.spheres() == 0 && asked.rays() > 0) {
      throw wrong_array("centre", "has no spheres; s and Q need some");
    }
  }
  const auto visit = [&](std::size_t k, const Meeting* of, bool is_met) {
    for (const Quantity one : {Quantity::kParameter, Quantity::kPoint}) {
      if (is_wanted(one)) put(one, k, is_met ? of : nullptr);
    }
    if (k >= asked.rays()) return;
    for (const Quantity one : {Quantity::kDirection, last}) {
      if (is_wanted(one)) put(one, k, of);
    }
  };
  for_each_answer(
      asked,
      [&](std::size_t k, const reference::ExactRay& ray, const scene::Sphere* sphere,
          const reference::Intersection& at) {
        const scene::Sphere none;
        const Meeting of{ray, sphere != nullptr ? *sphere : none, at};
        visit(k, &of, sphere != nullptr && at.hit_class != reference::HitClass::kMiss);
      },
      [&](std::size_t k) { visit(k, nullptr, false); });
  asked.require_none_invalid();
}

constexpr scene::Point3 kNoValue = {kInvalidNumber, kInvalidNumber, kInvalidNumber};

void enclose(const Questions& asked, const raycheck_enclosed& to) {
  const Values lower(asked, to.s_lower, to.point_lower, to.direction_lower, to.pixel_point_lower);
  const Values upper(asked, to.s_upper, to.point_upper, to.direction_upper, to.pixel_point_upper);
  for_each_value(
      asked, [&](Quantity one) { return lower.has(one) || upper.has(one); },
      [&](Quantity one, std::size_t k, const Meeting* of) {
        scene::Point3 least = kNoValue, greatest = kNoValue;
        if (of != nullptr) {
          const auto [x, y, z] = enclosed(one, *of);
          least = {x.lower(), y.lower(), z.lower()};
          greatest = {x.upper(), y.upper(), z.upper()};
        }
        lower.set(one, k, least, Way::kDown);
        upper.set(one, k, greatest, Way::kUp);
      });
}

void round(const Questions& asked, const raycheck_values& to) {
  const Values values(asked, to.s, to.point, to.direction, to.pixel_point);
  for_each_value(
      asked, [&](Quantity one) { return values.has(one); },
      [&](Quantity one, std::size_t k, const Meeting* of) {
        values.set(one, k, of == nullptr ? kNoValue : rounded(one, *of, values.precision(one)),
                   Way::kNearest);
      });
}

void condition_numbers(const Questions& asked, const raycheck_values& to) {
  const Values values(asked, to.s, to.point, to.direction, to.pixel_point);
  for_each_value(
      asked, [&](Quantity one) { return values.has(one); },
      [&](Quantity one, std::size_t k, const Meeting* of) {
        const double number = of == nullptr ? kInvalidNumber : condition(one, *of);
        values.set(one, k, {number, number, number}, Way::kUp);
      });
}

scene::Precision precision_of(const Column& column) {
  return column.type == RAYCHECK_FLOAT32 ? scene::Precision::kSingle : scene::Precision::kDouble;
}

/// Judges someone's answers.
class ErrorsOf {
 public:
  ErrorsOf(const Questions& asked, const raycheck_answers& answers, const raycheck_errors& to)
      : asked_(asked),
        is_hit_(integers(answers.is_hit, "is_hit", asked.answers())),
        s_(numbers(answers.s, "s", asked.answers())),
        point_(numbers(answers.point, "point", asked.answers())),
        hit_class_(integers(to.hit_class, "hit_class", asked.answers())),
        root_(integers(to.root, "root", asked.answers())),
        excused_(integers(to.excused, "excused", asked.answers())),
        s_ulp_(numbers(to.s_ulp, "s_ulp", asked.answers())),
        point_u_(numbers(to.point_u, "point_u", asked.answers())) {
    if (is_hit_.first == nullptr && asked.answers() > 0) {
      throw wrong_array("is_hit", "has no data: give 1 for each hit and 0 for each miss");
    }
    if ((root_ || s_ulp_) && s_.first == nullptr) {
      throw wrong_array("s", "has no data, but root or s_ulp are wanted");
    }
    if (point_u_ && point_.x.first == nullptr) {
      throw wrong_array("point", "has no data, but point_u is wanted");
    }
  }

  void judge() const {
    for_each_answer(
        asked_,
        [&](std::size_t k, const reference::ExactRay& ray, const scene::Sphere* sphere,
            const reference::Intersection& at) {
          sphere != nullptr ? judge_one(k, {ray, *sphere, at}) : put_invalid(k);
        },
        [&](std::size_t k) { put_invalid(k); });
    asked_.require_none_invalid();
  }

 private:
  void put(std::size_t k, bool wrong_class, bool excused, bool wrong_root, double s,
           double point) const {
    hit_class_.set_integer(k, wrong_class ? 1 : 0);
    excused_.set_integer(k, excused ? 1 : 0);
    root_.set_integer(k, wrong_root ? 1 : 0);
    s_ulp_.set(k, s, Way::kUp);
    point_u_.set(k, point, Way::kUp);
  }
  void put_invalid(std::size_t k) const {
    put(k, false, false, false, kInvalidNumber, kInvalidNumber);
  }

  void judge_one(std::size_t k, const Meeting& of) const {
    const scene::Conventions& conventions = asked_.conventions();
    const bool hit = is_hit_.integer(k) != 0;
    const bool truth = counts_as_hit(of.at.hit_class, conventions.tangent);
    const bool is_judged = of.at.hit_class != reference::HitClass::kTangent ||
                           conventions.tangent != scene::Tangent::kEither;
    if (!hit || !truth) {
      const bool is_wrong = hit != truth && is_judged;
      return put(k, is_wrong, is_wrong && excused_ && is_excused(k, of, hit), false, 0, 0);
    }
    const double s = s_.first != nullptr ? s_.number(k) : 0;
    const bool wrong_root = root_ && is_at_other_root(of.ray, of.sphere, of.at, s);
    const double s_error =
        s_ulp_ ? parameter_error(of.ray, of.sphere, of.at, s, precision_of(s_)).value : 0;
    const double point_error =
        point_u_ ? hit_point_error(of.ray, of.sphere, of.at, point_.at<scene::Point3>(k))
                       .in(precision_of(point_.x))
                       .value
                 : 0;
    put(k, false, false, wrong_root, s_error, point_error);
  }

  /// Whether the class is right for inputs within a relative change of a few roundings.
  bool is_excused(std::size_t k, const Meeting& of, bool hit) const {
    const scene::Conventions& conventions = asked_.conventions();
    const double change = properties::excused_change(unit_roundoff(precision_of(s_)));
    const auto s = hit && s_.first != nullptr ? std::optional(s_.number(k)) : std::nullopt;
    if (hit && !s) return false;
    return right_nearby(of.ray, of.sphere,
                        {conventions.root, conventions.tangent, change, conventions.valid}, s)
               .found == reference::Nearby::kWitness;
  }

  const Questions& asked_;
  Column is_hit_, s_;
  Column3 point_;
  Target hit_class_, root_, excused_, s_ulp_, point_u_;
};

}  // namespace
}  // namespace raycheck::library

using namespace raycheck::library;

int32_t raycheck_enclose(const raycheck_rays* rays, const raycheck_spheres* spheres,
                         const raycheck_options* options, const raycheck_enclosed* to,
                         raycheck_error* error) {
  return guarded(error, [&] { enclose({rays, spheres, options}, required(to)); });
}

int32_t raycheck_round(const raycheck_rays* rays, const raycheck_spheres* spheres,
                       const raycheck_options* options, const raycheck_values* to,
                       raycheck_error* error) {
  return guarded(error, [&] { round({rays, spheres, options}, required(to)); });
}

int32_t raycheck_condition(const raycheck_rays* rays, const raycheck_spheres* spheres,
                           const raycheck_options* options, const raycheck_values* to,
                           raycheck_error* error) {
  return guarded(error, [&] { condition_numbers({rays, spheres, options}, required(to)); });
}

int32_t raycheck_error_of(const raycheck_rays* rays, const raycheck_spheres* spheres,
                          const raycheck_options* options, const raycheck_answers* answers,
                          const raycheck_errors* to, raycheck_error* error) {
  return guarded(error, [&] {
    const Questions asked(rays, spheres, options);
    ErrorsOf(asked, required(answers), required(to)).judge();
  });
}
