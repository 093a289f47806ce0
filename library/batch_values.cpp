// Enclosures, rounded values, condition numbers and errors of raycheck/batch.h.

#include <raycheck/batch.h>

#include "library/batch_block.h"
#include "library/quantity.h"
#include "properties/quantity.h"
#include "reference/account/nearby_answer.h"
#include "reference/account/nearby_choice.h"
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
    if (is_wanted(one)) asked.require_spheres(asked.rays());
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
    asked.require_spheres(asked.answers());
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
    if (asked_.answers() == 0) return;
    if (asked_.is_usual()) {
      asked_.for_each_block(
          kBatchBlock, [this](std::size_t first, std::size_t count) { judge_block(first, count); });
      return asked_.require_none_invalid();
    }
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

  /// The exact ray judges only answers whose errors pairs of doubles do not know.
  void judge_block(std::size_t first, std::size_t count) const {
    Work& work = work_of_thread();
    const Block block(asked_, first, count, {}, {}, work);
    decide_block(asked_, block);
    std::array<std::uint32_t, kBatchBlock> hits;
    std::size_t hit_count = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint8_t code = work.codes[k];
      const bool is_hit = is_hit_.integer(first + k) != 0;
      if (code == fast::kOpen) {
        put_invalid(first + k);
      } else if (code == fast::kMiss && !is_hit) {
        put(first + k, false, false, false, 0, 0);
      } else if ((code | fast::kLargerRoot) == (fast::kHit | fast::kLargerRoot) && is_hit) {
        hits[hit_count++] = static_cast<std::uint32_t>(k);
      } else {
        judge_exactly(first + k);
      }
    }
    std::array<fast::PreciseHit, kBatchBlock> precise;
    fast::precise_hits(block.input, {hits.data(), hit_count}, precise.data());
    for (std::size_t n = 0; n < hit_count; ++n) {
      const std::size_t k = first + hits[n];
      if (!judge_hit(k, block.input.ray(hits[n]), block.input.sphere_of(hits[n]), precise[n])) {
        judge_exactly(k);
      }
    }
  }

  void judge_exactly(std::size_t k) const {
    const reference::ExactRay ray(asked_.given(asked_.ray_of(k)));
    const scene::Sphere sphere = asked_.sphere(asked_.sphere_of(k));
    judge_one(k, {ray, sphere, ray.intersect(sphere, asked_.conventions().root)});
  }

  /// a + b, exactly, as a double and the rounding error.
  static std::pair<double, double> two_sum(double a, double b) {
    const double sum = a + b, of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
  }
  /// The roundings of the few operations below, as a share of their results.
  static constexpr double kRoundings = 1 + 0x1p-48;
  /// Errors are too large by at most this part of an ulp or u.
  static constexpr double kSharp = 0x1p-12;

  /// Judges a hit by its precise values; false if these do not suffice.
  bool judge_hit(std::size_t k, const scene::Ray& ray, const scene::Sphere& sphere,
                 const fast::PreciseHit& at) const {
    if (!(at.share < kSharp * 0x1p-54)) return false;
    double s_error = 0;
    if (root_ || s_ulp_) {
      const double given = s_.number(k);
      const auto [difference, lost] = two_sum(given, -at.s);
      if (!(std::abs(difference) <= 0.5 * std::abs(at.chord)) || !(difference - difference == 0)) {
        return false;
      }
      s_error = (std::abs(difference + (lost - at.rest)) + (at.share + 0x1p-102) * std::abs(at.s)) *
                kRoundings;
      // The gap of the format's numbers below s, if s may be just below a power of two.
      int exponent = 0;
      const double significand = std::frexp(std::abs(at.s), &exponent);
      const bool is_below = significand == 0.5 && at.rest - at.share * at.s < 0;
      const scene::Format format = scene::format_of(precision_of(s_));
      const int ulp =
          std::max(exponent - (is_below ? 1 : 0) - format.digits, format.least_exponent);
      s_error = std::ldexp(s_error, -ulp);
    }
    double Q_error = 0;
    if (point_u_) {
      const scene::Point3 given = point_.at<scene::Point3>(k);
      double error_sq = 0, size_sq = 0, doubt_sq = 0;
      const auto add = [&](double Q, double C, double d, double T, double from, double rest) {
        const auto [apart, lost] = two_sum(Q, -C);
        const double doubt = (at.share + fast::kPreciseStep) * std::abs(at.s * d) +
                             fast::kPreciseStep * (std::abs(T) + std::abs(C) + std::abs(Q));
        const auto [difference, difference_lost] = two_sum(apart, from);
        const double error = std::abs(difference + (difference_lost + (lost + rest))) + doubt;
        const double size = std::max(0.0, std::abs(C - from) * (1 - 0x1p-50) - doubt);
        error_sq += error * error;
        size_sq += size * size;
        doubt_sq += doubt * doubt;
      };
      add(given.x, sphere.centre.x, ray.direction.x, at.T.x, at.from.x, at.from_rest.x);
      add(given.y, sphere.centre.y, ray.direction.y, at.T.y, at.from.y, at.from_rest.y);
      add(given.z, sphere.centre.z, ray.direction.z, at.T.z, at.from.z, at.from_rest.z);
      const double u = unit_roundoff(precision_of(point_.x));
      Q_error = std::sqrt(error_sq / size_sq) / u * kRoundings;
      const double doubt = std::sqrt(doubt_sq / size_sq) / u;
      // The least |Q| is known to be above 2^-250, by its doubt, so that no square underflows.
      if (!(doubt < kSharp && Q_error < 0x1p300 && size_sq < 0x1p1000)) return false;
    }
    put(k, false, false, false, s_error, Q_error);
    return true;
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
    const bool wrong_root = root_ && is_at_other_root(of.ray, of.sphere, of.at, s) &&
                            s != of.ray.rounded_parameter(of.sphere, of.at, precision_of(s_));
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
    const reference::Neighbourhood around{conventions.root, conventions.tangent, change,
                                          conventions.valid};
    const auto nearby = [&] {
      if (!hit) return right_nearby(of.ray, of.sphere, around, std::nullopt);
      if (s_.first != nullptr) return right_nearby(of.ray, of.sphere, around, s_.number(k));
      const reference::FirstMet claim{reference::FirstMet::What::kSomething};
      return right_nearby(of.ray, {&of.sphere, 1}, around, claim);
    };
    return nearby().found == reference::Nearby::kWitness;
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
