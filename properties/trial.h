#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "properties/answers.h"
#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/tolerance.h"
#include "properties/truth.h"
#include "properties/verdict.h"
#include "scene/scene.h"

namespace raycheck::properties {

class Trial;
struct TrialPart;

/// At most this many failures of a candidate are searched for in failed batches; each costs at most
/// two restarts per halving of a batch.
inline constexpr int kMostFailuresSought = 8;

/// A search for failures, shared by successive trials.
struct FailureSearch {
  int batches = 0;     ///< Batches that failed and were asked in parts.
  int found = 0;       ///< Single questions that fail: rays, or pairs of a ray and a sphere.
  int together = 0;    ///< Parts that fail although both of their halves are answered.
  int not_sought = 0;  ///< Batches or parts that failed after the search was over.
  /// Messages of candidates that fail on every question: each is reported once.
  std::set<std::string> whatever_asked = {};
  bool is_over() const { return found + together >= kMostFailuresSought; }
};

/// The number of rays of a trial; with `by_sphere`, the number of pairs of a ray and a sphere.
std::uint64_t count_asked(const Trial& trial, bool by_sphere);

struct TrialOptions {
  std::optional<double> max_error = {};  ///< A bound that replaces the candidate's own.
  bool conditioning = false;             ///< Whether to weigh every error by its condition number.
  /// The truth about the case under the candidate's conventions, if it is shared; if null, it is
  /// computed.
  std::shared_ptr<Truth> truth = nullptr;
  /// If not null, batches that fail are asked in halves, to find the questions to blame and to
  /// judge the other answers.
  FailureSearch* search = nullptr;
  double share = 1;  ///< The part of the time limit for a reply.
  /// The case's number in a campaign, in which each case is asked only some of a law's invalid
  /// questions, in turn; if empty, it is asked all.
  std::optional<std::uint64_t> turn = {};
};

/// How a ray and a sphere meet according to an answer.
struct RayAnswer {
  const ExactRay& ray;
  const Sphere& sphere;
  std::optional<double> s;  ///< Empty: a miss.
};
inline RayAnswer answer_of(const ExactRay& ray, const Sphere& sphere, const HitAnswer* hit) {
  return {ray, sphere, hit == nullptr ? std::nullopt : std::optional(hit->parameter)};
}

/// The relative change of r, in u, that has the effect of rounding errors of u in the terms of the
/// textbook's v^2 - |T|^2 + r^2: at most (2 |T||v| + |T|^2 + r^2)/(2 r^2). It is 0 if the candidate
/// promises more than ordinary cases, if the sphere is beyond kOrdinaryDistance, and, in double
/// precision, if the ray is nearer to a tangent than kOrdinaryTangency.
double plain_change(const Candidate& candidate, const ExactRay& ray, const Sphere& sphere);
/// An upper bound of plain_change() for a centre at this distance, in radii.
constexpr double plain_change_at(double radii) { return (3 * radii * radii + 1) / 2; }
/// The factor by which the change that excuses a decision grows from kExcusedRoundoffs u: the
/// result is 4 u times plain_change(), if that is more. A change of only r can then offset rounding
/// errors of 4 u in the textbook's formula.
constexpr double plain_growth(double plain_change) {
  return plain_change > 4 ? plain_change / 4 : 1;
}

/// Whether the answer is a hit outside the interval by which it is judged. This compares doubles
/// (reference::is_outside), so no change of inputs excuses it. It applies only if the candidate
/// returned s itself, not a distance or a point. The exact root `at`, correctly rounded, is never
/// excluded, even on an open end.
/// Domain: `at` is the exact intersection of the answer's ray and sphere under the conventions.
bool is_excluded(const RayAnswer& answer, const Intersection& at, const Conventions& conventions,
                 const Promises& promises);

/// Whether the exact hit of a ray is its start, at s = 0 (FromInside::kStart).
bool is_at_start(const ExactRay& ray, const Sphere& sphere, const Promises& promises);
/// The exact s of a hit, correctly rounded to the candidate's format; 0 at the start of the ray.
double rounded_s(const ExactRay& ray, const Sphere& sphere, const Intersection& at,
                 const Promises& promises);
/// Whether a hit is at the other root (reference::is_at_other_root) than the exact hit `at`, and is
/// not the correctly rounded one: roots may be closer to each other than numbers of the format. If
/// the exact hit is the start of the ray: whether s is not 0, or, if it was not returned but is the
/// projection of Q, nearer to the far root.
bool is_at_other_root(const RayAnswer& hit, const Intersection& at, const Promises& promises);

/// An error that a law measures. Its bound is in units of the candidate's format.
struct MeasuredError {
  Quantity quantity;
  Place place;
  scene::Measured error;
  std::optional<double> bound = {};  ///< If empty: Trial::bound(quantity).
};

/// A case, the truth about it and a candidate's answers to it. Laws compare these. The truth does
/// not depend on the candidate.
/// Domain: a valid scene (scene/validate.h) with numbers of the
/// candidate's format
///         (rounded_case), pixels inside its image; otherwise the constructor throws
///         std::invalid_argument.
class Trial : public Answers {
 public:
  Trial(const Case& the_case, const Candidate& candidate, TrialOptions options = {});

  const TrialOptions& options() const { return options_; }
  /// The format in which answers are judged.
  Precision precision() const { return candidate().precision; }
  Place place(std::size_t ray, std::optional<std::size_t> sphere = {}) const;
  /// The change of inputs that excuses a decision: kExcusedRoundoffs times the candidate's unit
  /// roundoff.
  double excused_change() const { return properties::excused_change(candidate().unit_roundoff); }
  /// Whether the case lies in the candidate's stated domain.
  bool inside_domain() const { return inside_domain_; }
  /// Whether answers about a quantity are judged: the case lies in the domain, or exact hit classes
  /// are promised for it.
  bool is_judged(Quantity quantity) const { return inside_domain_ || promises_exactly(quantity); }

  // The truth.
  const ExactCamera& exact_camera() { return options_.truth->camera(); }
  const reference::EnclosedFrame& exact_frame() { return options_.truth->frame(); }
  const ExactRay& exact_ray(std::size_t ray) { return options_.truth->ray(ray); }
  std::span<const Meeting> exact_meetings(std::size_t sphere) {
    return options_.truth->meetings(sphere);
  }
  Intersection exact_intersection(std::size_t ray, std::size_t sphere) {
    return options_.truth->intersection(ray, sphere);
  }
  const std::vector<std::optional<NearestSphere>>& exact_nearest() {
    return options_.truth->nearest();
  }
  double condition_of_parameter(std::size_t ray, std::size_t sphere) {
    return options_.truth->condition_of_parameter(ray, sphere);
  }
  bool exact_hit(std::size_t ray, std::size_t sphere) {
    return reference::counts_as_hit(exact_intersection(ray, sphere).hit_class,
                                    conventions().tangent);
  }

  /// The bound on a quantity: the one in the options; if there is none, the candidate's; otherwise
  /// the default. It is always 0 for the origin of a ray from the eye.
  double bound(Quantity quantity) const;

  /// Counts an error, and adds a discrepancy if it is above its bound. Only then are `condition`
  /// and `describe` called; `describe` fills in what, got and exact. With
  /// TrialOptions::conditioning every error is weighed; if kappa is infinite, by `backward`, the
  /// backward error. `plain` returns the term that is added to the condition number for code that
  /// promises only ordinary cases; `tolerance` the declared tolerance that allows the answer, or 0.
  template <class Condition, class Describe>
  void measure(Verdict& verdict, const MeasuredError& measured, const Condition& condition,
               const Describe& describe, const std::function<scene::Measured()>& backward = {},
               const std::function<double()>& plain = {},
               const std::function<double()>& tolerance = {}) const {
    MeasuredError own = measured;
    own.bound = measured.bound ? measured.bound : bound(measured.quantity);
    own.error = measured.error.in(precision());
    verdict.measured(own.quantity, own.place, own.error.value, *own.bound);
    if (own.error.value <= *own.bound && !options_.conditioning) return;
    examine(verdict, own, {condition, describe, backward, plain, tolerance});
  }
  /// An error that is cheap to bound: near() is at most the share reference::kNearErrorShare above
  /// it, or empty. Calls exact() only if a verdict would differ: if the error may be above its
  /// bound, the largest so far, or in another bin of the quantiles, or is weighed.
  template <class Near, class Exact>
  scene::Measured settled(const Verdict& verdict, Quantity quantity, double bound, const Near& near,
                          const Exact& exact) const {
    if (!options_.conditioning) {
      const std::optional<scene::Measured> error = near();
      if (error && keeps_only_bin(verdict, quantity, error->in(precision()).value, bound)) {
        return *error;
      }
    }
    return exact();
  }
  /// The verdict on earlier cases, into which that of a law on this one will be merged, or null.
  void set_earlier(const Verdict* earlier) { earlier_ = earlier; }
  /// Counts a right or wrong answer, and adds a discrepancy if it is wrong. `excuse` is called only
  /// if neither the stated domain nor a promise of exact hit classes decides.
  template <class GiveExcuse, class Describe>
  void judge(Verdict& verdict, const Decision& decision, const GiveExcuse& excuse,
             const Describe& describe) const {
    if (decision.wrong != Wrong::kNot) return convict(verdict, decision, excuse, describe);
    verdict.judged_right(decision.quantity, decision.expected, 1);
  }

  /// The excuse for answers of which at least one is wrong. For each wrong answer there must be
  /// inputs for which it is right, within excused_change() of the given inputs, enlarged by
  /// plain_growth(); or it must lie within a declared tolerance. If one wrong answer does neither,
  /// there is no excuse.
  Excuse excuse(std::initializer_list<RayAnswer> answers) const;
  /// The declared tolerance within which a ray and a sphere lie (properties/tolerance.h), and a hit
  /// at s or at a point, if given; 0 if there is none.
  template <class... At>
  double tolerance(const ExactRay& ray, const Sphere& sphere, const At&... at) const {
    return tolerance_of(candidate().tolerances, {ray, sphere, change_about(ray, sphere)}, at...);
  }
  /// Where to search for a witness: inputs for which an answer is right.
  reference::Neighbourhood neighbourhood(double relative_change) const;

  // If this trial fails as a batch:
  /// The two halves of its rays, or of one ray's spheres, as separate trials, in which it is asked
  /// again. They are made once and kept. Domain: more than one ray or sphere.
  const std::vector<std::shared_ptr<TrialPart>>& halves();
  bool is_halved() const { return !halves_.empty(); }
  /// Whether no law has recorded a failure of the whole with this message yet; records it.
  bool is_new(const std::string& failure) { return failures_.insert(failure).second; }

 private:
  /// The functions that measure() calls for an error that is weighed or above its bound.
  struct Particulars {
    std::function<double()> condition;
    std::function<void(Discrepancy&)> describe;
    std::function<scene::Measured()> backward;
    std::function<double()> plain, tolerance;
  };

  bool promises_exactly(Quantity quantity) const;
  /// See settled().
  bool keeps_only_bin(const Verdict& verdict, Quantity quantity, double error, double bound) const;
  /// excused_change(), enlarged by plain_growth().
  double change_about(const ExactRay& ray, const Sphere& sphere) const;
  Stability weigh(double error, const Particulars& of) const;
  /// Whether the bound on a quantity is a documented one. Such a bound grows with the condition
  /// number, and errors within the grown bound are not discrepancies. Other bounds (the user's, the
  /// default) do not grow: errors that growth would allow are discrepancies with an excuse.
  bool promises_growth(Quantity quantity) const;
  /// Whether an error above its bound is within the grown bound. If the condition number is
  /// infinite, the backward error decides; without one, the grown bound is infinite.
  bool grown_bound_allows(const MeasuredError& own, double condition, const Particulars& of) const;
  /// The part of measure() for an error that is weighed or above its bound.
  void examine(Verdict& verdict, const MeasuredError& own, const Particulars& of) const;
  /// The part of judge() for a wrong answer.
  void convict(Verdict& verdict, const Decision& decision, const std::function<Excuse()>& excuse,
               const std::function<void(Discrepancy&)>& describe) const;
  Discrepancy discrepancy_of(Quantity quantity, const Place& place) const;

  TrialOptions options_;
  bool inside_domain_;
  const Verdict* earlier_ = nullptr;
  std::vector<std::shared_ptr<TrialPart>> halves_;
  std::set<std::string> failures_;
};

/// Some of a trial's rays, or some spheres of its one ray.
struct TrialPart {
  TrialPart(Case some, std::size_t ray, std::size_t sphere, const Candidate& candidate,
            const TrialOptions& options)
      : the_case(std::move(some)),
        first_ray(ray),
        first_sphere(sphere),
        trial(the_case, candidate, options) {}
  TrialPart(const TrialPart&) = delete;
  TrialPart& operator=(const TrialPart&) = delete;

  /// Converts a place in the part to one in the whole.
  Place place(Place of_part) const;

  Case the_case;
  std::size_t first_ray, first_sphere;
  Trial trial;
};

/// The excuse that a search for inputs within this relative change found.
Excuse excuse_of(reference::NearbyAnswer nearby, double relative_change);

/// Whether the intersection is a tangent that the convention does not judge.
constexpr bool is_unjudged(const Intersection& intersection, scene::Tangent tangent) {
  return tangent == scene::Tangent::kEither && intersection.hit_class == HitClass::kTangent;
}

/// The root that is right for a hit.
constexpr Expected root_expected(const Intersection& at) {
  return at.root == WhichRoot::kSmaller ? Expected::kSmallerRoot : Expected::kLargerRoot;
}

}  // namespace raycheck::properties
