#include <algorithm>
#include <cmath>
#include <utility>

#include "fast/camera_frame.h"
#include "fast/intersect.h"
#include "properties/mistakes/answer_examination.h"
#include "properties/mistakes/mistake_list.h"

namespace raycheck::properties {
namespace {

/// The sentence of lost digits. For single-precision candidates it does not mention that they
/// compute in floats.
std::string sentence_of(const Examination& examination, Arithmetic arithmetic, double radii) {
  if (!examination.is_single()) return imprecision_sentence(arithmetic, radii);
  const bool is_expanded =
      arithmetic == Arithmetic::kExpanded || arithmetic == Arithmetic::kSingleExpanded;
  return "in floats " +
         imprecision_sentence(is_expanded ? Arithmetic::kExpanded : Arithmetic::kDifference, radii);
}

/// Only relative errors of s above this many u of the candidate's format are examined.
constexpr double kNoticed = 512;

/// The errors of s that point to one formula.
struct SmallErrors {
  std::uint64_t wrong = 0;
  double radii = 0;  ///< The least distance of a sphere with such an error.
};
/// The errors at kIntersect that point to a formula. Empty if the formula does not allow one of the
/// hit classes or errors, or if too few errors point to it.
template <class AllowsClass, class Allows, class IsTelling>
std::optional<SmallErrors> small_errors(Examination& examination, const AllowsClass& allows_class,
                                        const Allows& allows, const IsTelling& is_telling) {
  SmallErrors found;
  for (const Comparison& comparison : examination.at(Step::kIntersect)) {
    const AskedCase& asked = *comparison.asked;
    if (asked.returns == Returns::kClass) return {};
    for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
      const Answer &answer = comparison.answers[k], &right = comparison.right[k];
      const Ray& ray = asked.rays[k % asked.rays.size()];
      const Sphere& sphere = asked.the_case.scene.spheres[k / asked.rays.size()];
      if (answer.choice != right.choice) {
        const auto given = answer.choice ? std::optional(answer.vectors[0].x) : std::nullopt;
        if (!allows_class(asked, ray, sphere, given)) return {};
        continue;
      }
      if (!right.choice) continue;
      const double s = answer.vectors[0].x, exact = right.vectors[0].x;
      const double off = std::abs(s - exact) / exact;
      if (off <= kNoticed * examination.roundoff()) continue;
      if (examination.is_of_input(ray, sphere, s - exact)) continue;
      if (!allows(asked, ray, sphere, s, off)) return {};
      if (!is_telling(asked, ray, sphere, s)) continue;
      const double radii = norm(sphere.centre - ray.origin) / sphere.radius;
      found.radii = found.wrong == 0 ? radii : std::min(found.radii, radii);
      ++found.wrong;
    }
  }
  if (found.wrong < kFewestWrongByRoundings) return {};
  return found;
}

AnswerCause small_cause(std::string sentence, const SmallErrors& errors) {
  return {Step::kIntersect,
          {{std::move(sentence), errors.wrong, errors.wrong}},
          {},
          kAnswerTolerances.front()};
}

/// The cause that q cancels: the roots q/a and c/q lose the digits that q = v + d or v - d loses,
/// and the larger root does, too, if q is the cancelling one; if q loses all, the ray may miss.
/// From inside a sphere, roundings of d^2 do not change the larger root.
std::optional<AnswerCause> cancelling_q(Examination& examination) {
  const auto lost = [u = examination.roundoff()](const Ray& ray, const Sphere& sphere) {
    const auto roots = fast::kCross.roots(ray, sphere);
    const double v = std::abs(roots.axial_distance);
    const double d = std::sqrt(std::max(0.0, roots.half_chord_sq));
    return kRoundings * u * (v + d) / std::abs(v - d);
  };
  const auto found = small_errors(
      examination,
      [&](const AskedCase&, const Ray& ray, const Sphere& sphere, const auto&) {
        return lost(ray, sphere) >= 1;
      },
      [&](const AskedCase&, const Ray& ray, const Sphere& sphere, double, double off) {
        return off <= lost(ray, sphere);
      },
      [](const AskedCase&, const Ray& ray, const Sphere& sphere, double s) {
        const auto roots = fast::kCross.roots(ray, sphere);
        return roots.smaller < 0 && s * norm(ray.direction) > std::abs(roots.axial_distance);
      });
  if (!found) return {};
  return small_cause("q = b + sgn(b) sqrt(b^2 - ac) has the wrong inner sign: it cancels", *found);
}

/// The cause that d^2 is a difference that cancels: s loses digits that r^2 - |T x D|^2 keeps.
/// Found also if too many hit classes are in doubt to be evidence.
std::optional<AnswerCause> cancelling_difference(Examination& examination) {
  const bool is_single = examination.is_single();
  const auto within = [](Arithmetic arithmetic) {
    return [arithmetic](const AskedCase& asked, const Ray& ray, const Sphere& sphere,
                        std::optional<double> s, auto...) {
      return possible_hit(arithmetic, ray, sphere, asked.the_case.scene.conventions).allows(s);
    };
  };
  const auto stable = within(is_single ? Arithmetic::kSingle : Arithmetic::kProduct);
  for (const Arithmetic difference :
       is_single ? std::vector{Arithmetic::kSingleDifference, Arithmetic::kSingleExpanded}
                 : std::vector{Arithmetic::kDifference, Arithmetic::kExpanded}) {
    const auto cancels = within(difference);
    const auto found = small_errors(examination, cancels, cancels,
                                    [&](const auto&... of) { return !stable(of...); });
    if (!found) continue;
    AnswerCause cause = small_cause(sentence_of(examination, difference, found->radii), *found);
    cause.roundings = difference;
    return cause;
  }
  return {};
}

}  // namespace

std::optional<AnswerCause> roundings_at(Examination& examination, Step step, double tolerance) {
  for (const Arithmetic arithmetic : {Arithmetic::kDifference, Arithmetic::kExpanded,
                                      Arithmetic::kSingle, Arithmetic::kSingleDifference}) {
    const DoubtTally tally = examination.tally(step, arithmetic, tolerance);
    if (!tally.tells()) continue;
    // Right answers with more digits than floats have were not computed in floats.
    if (arithmetic != Arithmetic::kDifference && 2 * tally.precise > tally.hits) continue;
    // A wrong radius errs to one side.
    const bool is_of_floats =
        arithmetic == Arithmetic::kSingle || arithmetic == Arithmetic::kSingleDifference;
    if (is_of_floats && tally.is_one_sided()) continue;
    // In single-precision candidates, floats are not a mistake.
    if (arithmetic == Arithmetic::kSingle && examination.is_single()) continue;
    return AnswerCause{
        step,
        {{sentence_of(examination, arithmetic, tally.radii), tally.wrong, tally.wrong}},
        arithmetic,
        tolerance};
  }
  return {};
}

std::optional<AnswerCause> lost_digits(Examination& examination) {
  if (auto cause = cancelling_q(examination)) return cause;
  return cancelling_difference(examination);
}

std::optional<AnswerCause> lost_digits_of_rays(Examination& examination) {
  const double u = examination.roundoff();
  std::uint64_t wrong = 0;
  for (const Comparison& comparison : examination.at(Step::kRay)) {
    const Camera& camera = *comparison.asked->the_case.scene.camera;
    const Vector3 W = vector(fast::camera_frame(camera).W), E = vector(camera.eye);
    for (std::size_t k = 0; k < comparison.answers.size(); ++k) {
      const Vector3 &D = comparison.answers[k].vectors[1], &right = comparison.right[k].vectors[1];
      const double off = norm(Vector3{D.x - right.x, D.y - right.y, D.z - right.z});
      if (off <= kNoticed * u) continue;
      // |P - E|, from D . W, the cosine of its angle to the view.
      const double g = std::abs(camera.near / (right.x * W.x + right.y * W.y + right.z * W.z));
      if (!(off <= kRoundings * u * (norm(E) / g + 1))) return {};
      ++wrong;
    }
  }
  if (wrong < kFewestWrongByRoundings) return {};
  return AnswerCause{
      Step::kRay,
      {{"E is added to P and subtracted again: far from the world's origin D loses its digits; "
        "nW + alpha U + beta V keeps them",
        wrong, wrong}},
      {},
      kAnswerTolerances.front()};
}

}  // namespace raycheck::properties
