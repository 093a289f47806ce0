#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/domain.h"
#include "properties/truth.h"
#include "properties/verdict.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// How many failures of a candidate are sought in the batches that failed, in all: each costs at
/// most two new starts for each halving of a batch.
inline constexpr int kMostFailuresSought = 8;

/// A search for them, which trials share one after the other.
struct FailureSearch {
  int batches = 0;     ///< That failed, and were asked in parts.
  int found = 0;       ///< Questions that fail alone.
  int together = 0;    ///< Parts that fail, and are answered when they are halved.
  int not_sought = 0;  ///< Batches, or parts of them, that failed after that.
  /// How the candidate failed whatever it was asked: each of them is said once.
  std::set<std::string> in_vain = {};
  bool is_over() const { return found + together >= kMostFailuresSought; }
};

/// A part of a batch has its share of the time for a reply, and no less than this one; a question
/// alone has all of it.
inline constexpr double kLeastShare = 0.1;

struct TrialOptions {
  std::optional<double> max_error = {};  ///< A bound in place of the candidate's own.
  bool conditioning = false;             ///< Weigh every error by its condition number.
  /// The truth about the same case under the candidate's conventions, where it is shared.
  std::shared_ptr<Truth> truth = nullptr;
  /// Batches that fail are asked in halves, to find the questions to blame and to judge the others;
  /// null: they are not.
  FailureSearch* search = nullptr;
  double share = 1;  ///< Of the time for a reply.
};

struct TrialPart;

/// Once so many searches for a witness ended undecided in a trial, which costs most, the others are
/// short: where inputs are so ill-conditioned, one more seldom ends otherwise.
inline constexpr int kMostLongSearches = 8;

/// How a ray and a sphere are said to meet.
struct RayAnswer {
  const reference::ExactRay& ray;
  const scene::Sphere& sphere;
  std::optional<double> s;  ///< Empty: a miss.
};
inline RayAnswer answer_of(const reference::ExactRay& ray, const scene::Sphere& sphere,
                           const HitAnswer* hit) {
  return {ray, sphere, hit == nullptr ? std::nullopt : std::optional(hit->parameter)};
}

/// Whether a hit is answered where the interval that it is judged by excludes it, which is a
/// comparison of doubles (reference::is_outside) that no change of inputs excuses. The exact root
/// `at`, correctly rounded, may lie on an open end, and is not excluded.
/// Domain: `at` is what the ray and the sphere of the answer have under the conventions.
bool is_excluded(const RayAnswer& answer, const reference::Intersection& at,
                 const scene::Conventions& conventions, scene::Precision precision);

/// A case, the truth about it and a candidate's answers to it, each worked out when a law first
/// asks and kept for the next law. The truth never sees the candidate. What a candidate throws
/// passes through.
/// Domain: a valid scene (scene/validate.h) whose numbers are of the candidate's format
///         (rounded_case.h), pixels inside its image; otherwise the constructor throws
///         std::invalid_argument.
class Trial {
 public:
  Trial(const Case& the_case, const Candidate& candidate, TrialOptions options = {});

  const scene::Scene& scene() const { return case_.scene; }
  const std::vector<scene::Pixel>& pixels() const { return case_.pixels; }
  const Candidate& candidate() const { return candidate_; }
  /// The scene's conventions with the candidate's declared ones in their place.
  const scene::Conventions& conventions() const { return conventions_; }
  /// The format that answers are judged in.
  scene::Precision precision() const { return candidate_.precision; }
  std::size_t ray_count() const;
  Place place(std::size_t ray, std::optional<std::size_t> sphere = {}) const;
  /// In the roundoff of the candidate's arithmetic.
  double excused_change() const { return properties::excused_change(candidate_.unit_roundoff); }
  /// Whether the case lies in the candidate's stated domain.
  bool inside_domain() const { return inside_domain_; }
  /// Whether answers about a quantity are judged: in that domain, or where a promise of the exact
  /// class goes beyond it.
  bool is_judged(Quantity quantity) const { return inside_domain_ || promises_exactly(quantity); }

  // The truth.
  const reference::ExactCamera& exact_camera() { return options_.truth->camera(); }
  const reference::ExactRay& exact_ray(std::size_t ray) { return options_.truth->ray(ray); }
  std::span<const Meeting> exact_meetings(std::size_t sphere) {
    return options_.truth->meetings(sphere);
  }
  reference::Intersection exact_intersection(std::size_t ray, std::size_t sphere) {
    return options_.truth->intersection(ray, sphere);
  }
  const std::vector<std::optional<reference::NearestSphere>>& exact_nearest() {
    return options_.truth->nearest();
  }
  double condition_of_parameter(std::size_t ray, std::size_t sphere) {
    return options_.truth->condition_of_parameter(ray, sphere);
  }
  bool exact_hit(std::size_t ray, std::size_t sphere);

  // The candidate's answers; empty where it has no such thing.
  const FrameAnswer& frame();
  const std::vector<scene::Point3>& pixel_points();
  /// The rays of the case: the candidate's own under the origin convention, or the given ones.
  const std::vector<scene::Ray>& rays();
  bool has_rays() const;
  const SphereHits& hits(std::size_t sphere);
  const std::vector<std::optional<std::size_t>>& nearest();
  /// The candidate asked about other rays or spheres. A ray of its own making that is not finite or
  /// has no direction is not asked about: it counts as a miss.
  std::vector<SphereHits> intersect(const std::vector<scene::Ray>& rays,
                                    const std::vector<scene::Sphere>& spheres,
                                    const scene::Conventions& conventions) const;
  std::vector<std::optional<std::size_t>> rank(const std::vector<scene::Ray>& rays,
                                               const std::vector<scene::Sphere>& spheres) const;

  /// The bound on a quantity: the one asked for, or the candidate's, or the default; always 0 for
  /// the origin of a ray that starts at the eye.
  double bound(Quantity quantity) const;

  /// Counts an error, and adds a discrepancy when it is above `bound`. `condition` and `describe`
  /// are called only then; `describe` fills in what, got and exact. Under `conditioning` every
  /// error is weighed, by `backward` (a backward error) where kappa is infinite.
  /// Units: an error that counts u, and a backward one, in u of doubles, as reference/ measures
  ///        them; they are counted in u of the candidate's format. One that counts ulp, and every
  ///        bound, in the format's own.
  template <class Condition, class Describe>
  void measure(Verdict& verdict, Quantity quantity, const Place& place, double error, double bound,
               const Condition& condition, const Describe& describe,
               const std::function<double()>& backward = {}) const {
    const double own = in_own_unit(quantity, error);
    verdict.measured(quantity, place, own, bound);
    if (own <= bound && !options_.conditioning) return;
    examine(verdict, quantity, place, own, bound, condition, describe, backward);
  }
  template <class Condition, class Describe>
  void measure(Verdict& verdict, Quantity quantity, const Place& place, double error,
               const Condition& condition, const Describe& describe) const {
    measure(verdict, quantity, place, error, bound(quantity), condition, describe);
  }
  /// Counts a right or wrong answer, and adds a discrepancy when it is wrong. `excuse` gives its
  /// Excuse; it is called only where neither the stated domain nor a promise of the exact class
  /// settles that.
  template <class GiveExcuse, class Describe>
  void judge(Verdict& verdict, Quantity quantity, Question question, const Place& place,
             Wrong wrong, const GiveExcuse& excuse, const Describe& describe) const {
    if (wrong == Wrong::kNot) return verdict.judged_right(quantity, question, 1);
    convict(verdict, quantity, question, place, wrong, excuse, describe);
  }
  // What failed as a whole, in parts.
  FailureSearch* search() const { return options_.search; }
  /// Whether there is more than one question: a ray, or `by_sphere` a ray and a sphere.
  bool is_several(bool by_sphere) const {
    return ray_count() > 1 || (by_sphere && case_.scene.spheres.size() > 1);
  }
  std::uint64_t count_questions(bool by_sphere) const {
    return ray_count() * (by_sphere ? std::max<std::size_t>(1, case_.scene.spheres.size()) : 1);
  }
  /// The two halves of its rays, or of one ray's spheres, as trials of their own that are kept.
  /// Domain: is_several.
  const std::vector<std::shared_ptr<TrialPart>>& halves();
  bool is_halved() const { return !halves_.empty(); }
  /// Whether all of this is one failure more: no law has met one in the same words.
  bool is_new(const std::string& failure) { return failures_.insert(failure).second; }
  /// Whether it was asked for rays, and failed to make them.
  bool lacks_rays() const { return rays_.failure != nullptr; }
  /// What is asked of an intersection where it is one ray: that ray, as the candidate was given it,
  /// and the spheres; otherwise the scene.
  scene::Scene question() const;

  /// What excuses answers that are wrong or contradict each other: of each that is wrong, inputs
  /// within excused_change() of its own for which it is right. Where one has none, nothing does.
  Excuse excuse(std::initializer_list<RayAnswer> answers) const;
  /// Where a witness is searched, and whether at length.
  reference::Neighbourhood neighbourhood(double relative_change) const;
  /// The excuse of what was found there.
  Excuse excuse_of(reference::NearbyAnswer nearby, double relative_change) const;

 private:
  bool promises_exactly(Quantity quantity) const;
  double in_own_unit(Quantity quantity, double error) const {
    return quantity == Quantity::kParameter ? error : error * u_of_doubles_;
  }
  Stability weigh(double error, double condition, const std::function<double()>& backward) const;
  /// Whether the bound on a quantity is a documented one, which grows with the condition number: an
  /// error that it then allows is no discrepancy. The user's does not grow; what it would allow is
  /// excused.
  bool promises_growth(Quantity quantity) const;
  /// Whether an error above a bound is within what the bound grows to: without end where the
  /// condition number is infinite, unless there is a backward error to go by.
  bool grown_bound_allows(Quantity quantity, double error, double bound, double condition,
                          const std::function<double()>& backward) const;
  /// measure() of an error that is weighed, or above its bound.
  void examine(Verdict& verdict, Quantity quantity, const Place& place, double error, double bound,
               const std::function<double()>& condition,
               const std::function<void(Discrepancy&)>& describe,
               const std::function<double()>& backward) const;
  /// judge() of a wrong answer.
  void convict(Verdict& verdict, Quantity quantity, Question question, const Place& place,
               Wrong wrong, const std::function<Excuse()>& excuse,
               const std::function<void(Discrepancy&)>& describe) const;

  const Case& case_;
  const Candidate& candidate_;
  scene::Conventions conventions_;
  TrialOptions options_;
  bool inside_domain_;
  double u_of_doubles_;  ///< In u of the candidate's format.

  mutable int undecided_ = 0;  ///< Searches that ended so.

  /// What a candidate answered, or how it failed: it is not asked twice.
  template <class Answers>
  struct Kept {
    std::optional<Answers> answers;
    std::exception_ptr failure;
  };
  template <class Answers, class Ask>
  const Answers& once(Kept<Answers>& kept, const Ask& ask) const;

  Kept<FrameAnswer> frame_;
  Kept<std::vector<scene::Point3>> pixel_points_;
  Kept<std::vector<scene::Ray>> rays_;
  Kept<std::vector<SphereHits>> hits_;
  Kept<std::vector<std::optional<std::size_t>>> nearest_;

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

  /// Where a place of the part is in the whole.
  Place place(Place of_part) const;

  Case the_case;
  std::size_t first_ray, first_sphere;
  Trial trial;
};

/// A tangent that the convention leaves open.
constexpr bool is_unjudged(const reference::Intersection& intersection, scene::Tangent tangent) {
  return tangent == scene::Tangent::kEither &&
         intersection.hit_class == reference::HitClass::kTangent;
}

/// Which root a hit asks for.
constexpr Question root_asked(const reference::Intersection& at) {
  return at.root == reference::WhichRoot::kSmaller ? Question::kSmallerRoot : Question::kLargerRoot;
}

/// The hit of a ray among a sphere's; null where it misses.
const HitAnswer* find_hit(const SphereHits& hits, std::size_t ray);

}  // namespace raycheck::properties
