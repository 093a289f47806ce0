#include "properties/trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "properties/case.h"
#include "reference/account/condition.h"
#include "reference/account/nearby_choice.h"
#include "reference/account/nearby_valid.h"
#include "reference/near_error.h"
#include "reference/ray_error.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

/// A part of a batch has its share of the time limit for a reply, but at least this share of it. A
/// single question has the whole limit.
constexpr double kLeastShare = 0.1;

std::shared_ptr<TrialPart> part_of(const Trial& whole, std::size_t from, std::size_t to) {
  const bool by_ray = whole.ray_count() > 1;
  Case part{whole.scene(), whole.pixels()};
  const auto keep = [&](auto& list) {
    const auto first = list.begin();
    list = {first + static_cast<std::ptrdiff_t>(from), first + static_cast<std::ptrdiff_t>(to)};
  };
  if (!by_ray) {
    keep(part.scene.spheres);
  } else if (part.scene.camera) {
    keep(part.pixels);
  } else {
    keep(part.scene.rays);
  }
  const std::uint64_t all = count_asked(whole, !by_ray);
  TrialOptions options = whole.options();
  options.truth = nullptr;
  const bool is_one = to - from == 1 && (!by_ray || part.scene.spheres.size() <= 1);
  const double share = options.share * static_cast<double>(to - from) / static_cast<double>(all);
  options.share = is_one ? 1 : std::max(kLeastShare, share);
  return std::make_shared<TrialPart>(std::move(part), by_ray ? from : 0, by_ray ? 0 : from,
                                     whole.candidate(), options);
}

/// Whether the hit class of an answer, or its root if it has one, differs from the exact one.
bool is_wrong(const RayAnswer& answer, const Conventions& conventions, const Promises& promises) {
  const Intersection at =
      exact_intersection(answer.ray, answer.sphere, conventions, promises.interface.from_inside);
  const bool is_hit = reference::counts_as_hit(at.hit_class, conventions.tangent);
  if (is_hit != answer.s.has_value()) return true;
  return is_hit && promises.interface.returns != Returns::kClass &&
         (is_at_other_root(answer, at, promises) || is_excluded(answer, at, conventions, promises));
}

/// Whether an answer is right for nearby inputs if every hit is at a root that counts.
reference::NearbyAnswer nearby_root(const RayAnswer& answer, const reference::Neighbourhood& around,
                                    Returns returns) {
  using reference::FirstMet;
  if (returns != Returns::kClass) {
    return right_nearby(answer.ray, answer.sphere, around, answer.s);
  }
  const FirstMet claim{answer.s ? FirstMet::What::kSomething : FirstMet::What::kNothing};
  return right_nearby(answer.ray, {&answer.sphere, 1}, around, claim);
}

/// Whether an answer is right for nearby inputs.
reference::NearbyAnswer nearby(const RayAnswer& answer, const reference::Neighbourhood& around,
                               const contract::Interface& interface) {
  using reference::Nearby, reference::NearbyAnswer;
  NearbyAnswer by_root = nearby_root(answer, around, interface.returns);
  if (interface.from_inside == contract::FromInside::kRoot) return by_root;
  const bool is_inside = starts_inside(answer.ray, answer.sphere);
  const bool may_claim_inside =
      answer.s && (interface.returns == Returns::kClass || !(*answer.s > 0));
  if (!is_inside && !may_claim_inside) return by_root;
  // A ray that starts on the sphere, up to roundings, may start inside or outside.
  NearbyAnswer on_sphere =
      right_nearby(answer.ray, answer.sphere, {.relative_change = around.relative_change}, 0.0);
  const auto rank = [](const NearbyAnswer& one) {
    return one.found == Nearby::kWitness ? 2 : one.found == Nearby::kUndecided ? 1 : 0;
  };
  // From inside, an answer from outside is right only if the ray may start outside.
  const bool takes_root = is_inside == (rank(by_root) < rank(on_sphere));
  return takes_root ? by_root : on_sphere;
}

}  // namespace

std::uint64_t count_asked(const Trial& trial, bool by_sphere) {
  const std::size_t spheres = trial.scene().spheres.size();
  return trial.ray_count() * (by_sphere ? std::max<std::size_t>(1, spheres) : 1);
}

const std::vector<std::shared_ptr<TrialPart>>& Trial::halves() {
  if (halves_.empty()) {
    const std::size_t all = count_asked(*this, ray_count() <= 1);
    halves_ = {part_of(*this, 0, all / 2), part_of(*this, all / 2, all)};
  }
  return halves_;
}

Place TrialPart::place(Place of_part) const {
  if (!of_part.pixel) of_part.ray += first_ray;
  if (of_part.sphere) *of_part.sphere += first_sphere;
  return of_part;
}

bool is_at_start(const ExactRay& ray, const Sphere& sphere, const Promises& promises) {
  return promises.interface.from_inside == contract::FromInside::kStart &&
         starts_inside(ray, sphere);
}

double rounded_s(const ExactRay& ray, const Sphere& sphere, const Intersection& at,
                 const Promises& promises) {
  return is_at_start(ray, sphere, promises) ? 0
                                            : ray.rounded_parameter(sphere, at, promises.precision);
}

bool is_at_other_root(const RayAnswer& hit, const Intersection& at, const Promises& promises) {
  const auto& [ray, sphere, s] = hit;
  if (is_at_start(ray, sphere, promises)) {
    if (gives_parameter(promises.interface.returns)) return *s != 0;
    // The projection of a returned point has roundings.
    constexpr Intersection kFar = {HitClass::kHit, WhichRoot::kLarger};
    return *s > 0.5 * ray.rounded_parameter(sphere, kFar, promises.precision);
  }
  return reference::is_at_other_root(ray, sphere, at, *s) &&
         *s != ray.rounded_parameter(sphere, at, promises.precision);
}

bool is_excluded(const RayAnswer& answer, const Intersection& at, const Conventions& conventions,
                 const Promises& promises) {
  const bool compares = promises.interface.returns == Returns::kHit ||
                        promises.interface.returns == Returns::kParameter;
  if (conventions.valid.is_usual() || !compares) return false;
  if (!answer.s || !std::isfinite(*answer.s)) return false;
  const bool may_be_inside = promises.interface.from_inside != contract::FromInside::kRoot;
  if (may_be_inside && *answer.s <= 0) return false;
  if (!reference::is_outside(conventions.valid, answer.ray, answer.sphere, *answer.s)) return false;
  return !reference::counts_as_hit(at.hit_class, conventions.tangent) ||
         *answer.s != answer.ray.rounded_parameter(answer.sphere, at, promises.precision);
}

Excuse excuse_of(reference::NearbyAnswer nearby, double relative_change) {
  switch (nearby.found) {
    case reference::Nearby::kWitness:
      return {ExcuseKind::kWitness, relative_change, std::move(nearby.witness)};
    case reference::Nearby::kRefuted:
      return {ExcuseKind::kNone, relative_change};
    default:
      return {ExcuseKind::kUndecided, relative_change};
  }
}

Trial::Trial(const Case& the_case, const Candidate& candidate, TrialOptions options)
    : Answers(the_case, candidate, options.share),
      options_(std::move(options)),
      inside_domain_(is_inside_domain(candidate, the_case.scene)) {
  scene::require_valid(the_case.scene);
  if (!is_of_format(the_case.scene, candidate.precision)) {
    throw std::invalid_argument("the scene has a number that is not representable as " +
                                std::string(name(candidate.precision)));
  }
  if (!options_.truth) {
    options_.truth =
        std::make_shared<Truth>(the_case, conventions(), nullptr, candidate.interface.from_inside);
  }
}

Place Trial::place(std::size_t ray, std::optional<std::size_t> sphere) const {
  if (!scene().camera) return {ray, std::nullopt, sphere};
  const Pixel& pixel = pixels()[ray];
  const auto width = static_cast<std::size_t>(scene().camera->width);
  return {static_cast<std::size_t>(pixel.j) * width + static_cast<std::size_t>(pixel.i), pixel,
          sphere};
}

double Trial::bound(Quantity quantity) const {
  // The eye is an input: a ray from the eye must start at exactly these bits.
  if (quantity == Quantity::kRayOrigin && conventions().origin == scene::Origin::kFocal) return 0;
  if (options_.max_error) return *options_.max_error;
  return documented_bound(candidate(), quantity, scene().camera.has_value())
      .value_or(kDefaultMaxError);
}

bool Trial::keeps_only_bin(const Verdict& verdict, Quantity quantity, double error,
                           double bound) const {
  const double largest = std::max(verdict.tally(quantity).worst,
                                  earlier_ == nullptr ? -1 : earlier_->tally(quantity).worst);
  const double above = error * (1 + 0x1p-50);  // exact() rounds up
  return above <= bound && above < largest &&
         QuantileSketch::are_same(above, error * (1 - reference::kNearErrorShare));
}

Stability Trial::weigh(double error, const Particulars& of) const {
  const double unit = candidate().unit_roundoff / scene::unit_roundoff(precision());
  Stability stability;
  stability.condition = of.condition();
  if (!std::isfinite(error)) {
    stability.ratio = error;
  } else if (!std::isinf(stability.condition)) {
    stability.ratio = error / ((1 + stability.condition) * unit);
  } else {
    stability.ratio = of.backward ? of.backward().in(precision()).value / unit : 0;
  }
  stability.outcome = error <= kExactError * unit       ? Outcome::kExact
                      : error <= kAccurateError * unit  ? Outcome::kAccurate
                      : !inside_domain_                 ? Outcome::kOutsideDomain
                      : stability.ratio <= kStableRatio ? Outcome::kIllConditioned
                                                        : Outcome::kUnstable;
  return stability;
}

bool Trial::promises_growth(Quantity quantity) const {
  return !options_.max_error && documented_bound(candidate(), quantity, scene().camera.has_value());
}

bool Trial::grown_bound_allows(const MeasuredError& own, double condition,
                               const Particulars& of) const {
  if (candidate().is_unconditional[static_cast<std::size_t>(own.quantity)]) return false;
  if (std::isinf(condition) && of.backward) {
    return *own.bound > 0 &&
           (of.backward().in(precision()).value <= bound(Quantity::kBackwardError) ||
            (of.plain && std::isinf(of.plain())));
  }
  // Errors are infinite if the exact value is 0 or the answer is not finite.
  if (!std::isfinite(own.error.value)) return *own.bound > 0 && std::isinf(condition);
  return own.error.value <= *own.bound * bound_growth(condition) ||
         (of.plain && own.error.value <= *own.bound * bound_growth(condition + of.plain()));
}

Discrepancy Trial::discrepancy_of(Quantity quantity, const Place& place) const {
  Discrepancy discrepancy;
  discrepancy.quantity = quantity;
  discrepancy.place = place;
  discrepancy.symbol = info(quantity).symbol;
  discrepancy.precision = precision();
  return discrepancy;
}

void Trial::examine(Verdict& verdict, const MeasuredError& own, const Particulars& of) const {
  Discrepancy discrepancy = discrepancy_of(own.quantity, own.place);
  if (options_.conditioning) {
    const Stability stability = weigh(own.error.value, of);
    verdict.weighed(own.quantity, own.place, own.error.value, stability);
    discrepancy.condition = stability.condition;
  }
  if (own.error.value <= *own.bound) return;
  if (!discrepancy.condition) discrepancy.condition = of.condition();
  const bool is_allowed = grown_bound_allows(own, *discrepancy.condition, of);
  if (is_allowed && inside_domain_ && promises_growth(own.quantity) &&
      std::isfinite(own.error.value)) {
    verdict.count_ill_conditioned(own.quantity);
    return;
  }
  discrepancy.error = own.error.value;
  of.describe(discrepancy);
  const bool is_number = std::all_of(discrepancy.got.begin(), discrepancy.got.end(),
                                     [](double x) { return std::isfinite(x); });
  if (!inside_domain_) {
    discrepancy.excuse = {ExcuseKind::kOutsideDomain};
  } else if (is_allowed && is_number) {
    discrepancy.excuse = {ExcuseKind::kIllConditioned, *discrepancy.condition};
  } else if (const double size = of.tolerance && is_number ? of.tolerance() : 0; size > 0) {
    discrepancy.excuse = {ExcuseKind::kTolerance, size};
  }
  verdict.add(std::move(discrepancy));
}

double plain_change(const Candidate& candidate, const ExactRay& ray, const Sphere& sphere) {
  if (candidate.level != Level::kOrdinary) return 0;
  const double distance = reference::distance_in_radii(ray, sphere);
  const bool is_near_tangent = candidate.unit_roundoff == kDoubleRoundoff &&
                               reference::half_chord_share(ray, sphere) < kOrdinaryTangency;
  return distance <= kOrdinaryDistance && !is_near_tangent ? plain_change_at(distance) : 0;
}

reference::Neighbourhood Trial::neighbourhood(double relative_change) const {
  return {conventions().root, conventions().tangent, relative_change, conventions().valid};
}

double Trial::change_about(const ExactRay& ray, const Sphere& sphere) const {
  return excused_change() * plain_growth(plain_change(candidate(), ray, sphere));
}

Excuse Trial::excuse(std::initializer_list<RayAnswer> answers) const {
  std::optional<Excuse> weakest;
  for (const RayAnswer& answer : answers) {
    scene::poll();
    if (!is_wrong(answer, conventions(), candidate())) continue;
    const reference::Neighbourhood around = neighbourhood(change_about(answer.ray, answer.sphere));
    Excuse one = excuse_of(nearby(answer, around, candidate().interface), around.relative_change);
    if (one.standing() != Standing::kExcused) {
      if (const double size = tolerance(answer.ray, answer.sphere); size > 0) {
        one = {ExcuseKind::kTolerance, size};
      }
    }
    if (!weakest || one.standing() < weakest->standing()) weakest = std::move(one);
    if (weakest->standing() == Standing::kDefect) break;
  }
  return weakest.value_or(Excuse{});
}

bool Trial::promises_exactly(Quantity quantity) const {
  return quantity == Quantity::kClass && promises_exact_class(candidate(), scene());
}

void Trial::convict(Verdict& verdict, const Decision& decision,
                    const std::function<Excuse()>& excuse,
                    const std::function<void(Discrepancy&)>& describe) const {
  Discrepancy discrepancy = discrepancy_of(decision.quantity, decision.place);
  discrepancy.error = std::numeric_limits<double>::infinity();
  discrepancy.wrong = decision.wrong;
  if (!is_judged(decision.quantity)) {
    discrepancy.excuse = {ExcuseKind::kOutsideDomain};
  } else if (!promises_exactly(decision.quantity)) {
    discrepancy.excuse = excuse();
  }
  verdict.judged_wrong(decision, discrepancy.excuse.standing());
  describe(discrepancy);
  verdict.add(std::move(discrepancy));
}

}  // namespace raycheck::properties
