#include "properties/trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "properties/rounded_case.h"
#include "reference/account/nearby_valid.h"
#include "reference/ray_error.h"
#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::properties {
namespace {

template <class Answers>
const Answers& require_count(const Answers& answers, std::size_t expected, const char* what) {
  if (answers.size() != expected) {
    throw std::runtime_error("candidate gave " + std::to_string(answers.size()) + " " + what +
                             " where " + std::to_string(expected) + " were asked for");
  }
  return answers;
}

/// The rays that are valid, and where they were among all.
struct ValidRays {
  explicit ValidRays(const std::vector<scene::Ray>& all) {
    indices.reserve(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (scene::defects(all[k]).empty()) indices.push_back(k);
    }
    rays = all;
    if (indices.size() == all.size()) return;
    for (const std::size_t k : indices) copies.push_back(all[k]);
    rays = copies;
  }
  ValidRays(const ValidRays&) = delete;
  ValidRays& operator=(const ValidRays&) = delete;

  std::vector<std::size_t> indices;
  std::vector<scene::Ray> copies;  ///< Only where not all are.
  Candidate::Rays rays;
};

/// Whether the class or the root of an answer is not the exact one.
bool is_wrong(const RayAnswer& answer, const scene::Conventions& conventions,
              scene::Precision precision) {
  const reference::Intersection at = answer.ray.intersect(answer.sphere, conventions);
  const bool is_hit = reference::counts_as_hit(at.hit_class, conventions.tangent);
  if (is_hit != answer.s.has_value()) return true;
  return is_hit && (reference::is_at_other_root(answer.ray, answer.sphere, at, *answer.s) ||
                    is_excluded(answer, at, conventions, precision));
}

void require_in_order(const SphereHits& hits, std::size_t rays) {
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (hits[k].ray >= rays || (k > 0 && hits[k].ray <= hits[k - 1].ray)) {
      throw std::runtime_error("candidate gave hits that are not in the order of the rays");
    }
  }
}

}  // namespace

bool is_excluded(const RayAnswer& answer, const reference::Intersection& at,
                 const scene::Conventions& conventions, scene::Precision precision) {
  if (conventions.valid.is_usual() || !answer.s || !std::isfinite(*answer.s)) return false;
  if (!reference::is_outside(conventions.valid, answer.sphere.radius, *answer.s)) return false;
  return !reference::counts_as_hit(at.hit_class, conventions.tangent) ||
         *answer.s != answer.ray.rounded_parameter(answer.sphere, at, precision);
}

Trial::Trial(const Case& the_case, const Candidate& candidate, TrialOptions options)
    : case_(the_case),
      candidate_(candidate),
      conventions_(candidate.declared.over(the_case.scene.conventions)),
      options_(std::move(options)),
      inside_domain_(is_inside_domain(candidate, the_case.scene)),
      u_of_doubles_(kDoubleRoundoff / scene::unit_roundoff(candidate.precision)) {
  scene::require_valid(case_.scene);
  if (!is_of_format(case_.scene, candidate.precision)) {
    throw std::invalid_argument("a number of the scene is no " +
                                std::string(name(candidate.precision)));
  }
  if (!options_.truth) options_.truth = std::make_shared<Truth>(case_, conventions_);
}

std::size_t Trial::ray_count() const { return count_rays(case_); }

Place Trial::place(std::size_t ray, std::optional<std::size_t> sphere) const {
  if (!case_.scene.camera) return {ray, std::nullopt, sphere};
  const scene::Pixel& pixel = case_.pixels[ray];
  const auto width = static_cast<std::size_t>(case_.scene.camera->width);
  return {static_cast<std::size_t>(pixel.j) * width + static_cast<std::size_t>(pixel.i), pixel,
          sphere};
}

bool Trial::exact_hit(std::size_t ray, std::size_t sphere) {
  return reference::counts_as_hit(exact_intersection(ray, sphere).hit_class, conventions_.tangent);
}

template <class Answers, class Ask>
const Answers& Trial::once(Kept<Answers>& kept, const Ask& ask) const {
  if (kept.failure) std::rethrow_exception(kept.failure);
  if (kept.answers) return *kept.answers;
  if (candidate_.allow) candidate_.allow(options_.share);
  try {
    return kept.answers.emplace(ask());
  } catch (const std::runtime_error&) {
    kept.failure = std::current_exception();
    throw;
  }
}

const FrameAnswer& Trial::frame() {
  return once(frame_, [&] { return candidate_.frame(case_.scene.camera.value()); });
}

const std::vector<scene::Point3>& Trial::pixel_points() {
  return once(pixel_points_, [&] {
    auto points = candidate_.pixel_points(case_.scene.camera.value(), conventions_, case_.pixels);
    require_count(points, ray_count(), "pixel points");
    return points;
  });
}

bool Trial::has_rays() const {
  if (!case_.scene.camera) return true;
  return conventions_.origin == scene::Origin::kPixel ? static_cast<bool>(candidate_.pixel_rays)
                                                      : static_cast<bool>(candidate_.focal_rays);
}

const std::vector<scene::Ray>& Trial::rays() {
  if (!case_.scene.camera) return case_.scene.rays;
  return once(rays_, [&] {
    const auto& make = conventions_.origin == scene::Origin::kPixel ? candidate_.pixel_rays
                                                                    : candidate_.focal_rays;
    auto made = make(*case_.scene.camera, conventions_, case_.pixels);
    require_count(made, ray_count(), "rays");
    return made;
  });
}

const SphereHits& Trial::hits(std::size_t sphere) {
  const std::vector<scene::Ray>& asked = rays();
  return once(hits_, [&] { return intersect(asked, case_.scene.spheres, conventions_); })[sphere];
}

const std::vector<std::optional<std::size_t>>& Trial::nearest() {
  const std::vector<scene::Ray>& asked = rays();
  return once(nearest_, [&] { return rank(asked, case_.scene.spheres); });
}

std::vector<SphereHits> Trial::intersect(const std::vector<scene::Ray>& rays,
                                         const std::vector<scene::Sphere>& spheres,
                                         const scene::Conventions& conventions) const {
  const ValidRays valid(rays);
  std::vector<SphereHits> answers = candidate_.intersect(valid.rays, spheres, conventions);
  require_count(answers, spheres.size(), "lists of hits");
  for (SphereHits& hits : answers) {
    require_in_order(hits, valid.rays.size());
    for (RayHit& hit : hits) hit.ray = valid.indices[hit.ray];
  }
  return answers;
}

std::vector<std::optional<std::size_t>> Trial::rank(
    const std::vector<scene::Ray>& rays, const std::vector<scene::Sphere>& spheres) const {
  const ValidRays valid(rays);
  const auto answers = candidate_.nearest(valid.rays, spheres, conventions_);
  require_count(answers, valid.rays.size(), "nearest spheres");
  std::vector<std::optional<std::size_t>> result(rays.size());
  for (std::size_t k = 0; k < answers.size(); ++k) result[valid.indices[k]] = answers[k];
  return result;
}

const std::vector<std::shared_ptr<TrialPart>>& Trial::halves() {
  if (!halves_.empty()) return halves_;
  const bool by_ray = ray_count() > 1;
  const std::size_t all = by_ray ? ray_count() : case_.scene.spheres.size();
  const auto add = [&](std::size_t from, std::size_t to) {
    Case part = case_;
    const auto keep = [&](auto& list) {
      const auto first = list.begin();
      list = {first + static_cast<std::ptrdiff_t>(from), first + static_cast<std::ptrdiff_t>(to)};
    };
    if (!by_ray) {
      keep(part.scene.spheres);
    } else if (case_.scene.camera) {
      keep(part.pixels);
    } else {
      keep(part.scene.rays);
    }
    TrialOptions options = options_;
    options.truth = nullptr;
    const bool is_one = to - from == 1 && (!by_ray || case_.scene.spheres.size() <= 1);
    const double share = options_.share * static_cast<double>(to - from) / static_cast<double>(all);
    options.share = is_one ? 1 : std::max(kLeastShare, share);
    halves_.push_back(std::make_shared<TrialPart>(std::move(part), by_ray ? from : 0,
                                                  by_ray ? 0 : from, candidate_, options));
  };
  add(0, all / 2);
  add(all / 2, all);
  return halves_;
}

scene::Scene Trial::question() const {
  scene::Scene scene = case_.scene;
  scene.conventions = conventions_;
  if (rays_.answers && rays_.answers->size() == 1) {
    scene.camera.reset();
    scene.rays = *rays_.answers;
  }
  return scene;
}

Place TrialPart::place(Place of_part) const {
  if (!of_part.pixel) of_part.ray += first_ray;
  if (of_part.sphere) *of_part.sphere += first_sphere;
  return of_part;
}

const HitAnswer* find_hit(const SphereHits& hits, std::size_t ray) {
  const RayHit* found = find_ray(hits, ray);
  return found == nullptr ? nullptr : &found->hit;
}

double Trial::bound(Quantity quantity) const {
  // The eye is an input: a ray that starts there starts at its very bits.
  if (quantity == Quantity::kRayOrigin && conventions_.origin == scene::Origin::kFocal) return 0;
  if (options_.max_error) return *options_.max_error;
  return documented_bound(candidate_, quantity, case_.scene.camera.has_value())
      .value_or(kDefaultMaxError);
}

Stability Trial::weigh(double error, double condition,
                       const std::function<double()>& backward) const {
  const double unit = candidate_.unit_roundoff / scene::unit_roundoff(candidate_.precision);
  Stability stability;
  stability.condition = condition;
  if (!std::isfinite(error)) {
    stability.ratio = error;
  } else if (!std::isinf(condition)) {
    stability.ratio = error / ((1 + condition) * unit);
  } else {
    stability.ratio = backward ? backward() * u_of_doubles_ / unit : 0;
  }
  stability.outcome = error <= kExactError * unit       ? Outcome::kExact
                      : error <= kAccurateError * unit  ? Outcome::kAccurate
                      : !inside_domain_                 ? Outcome::kOutsideDomain
                      : stability.ratio <= kStableRatio ? Outcome::kIllConditioned
                                                        : Outcome::kUnstable;
  return stability;
}

bool Trial::promises_growth(Quantity quantity) const {
  return !options_.max_error &&
         documented_bound(candidate_, quantity, case_.scene.camera.has_value());
}

bool Trial::grown_bound_allows(Quantity quantity, double error, double bound, double condition,
                               const std::function<double()>& backward) const {
  if (candidate_.is_unconditional[static_cast<std::size_t>(quantity)]) return false;
  if (std::isinf(condition) && backward) {
    return bound > 0 && backward() * u_of_doubles_ <= this->bound(Quantity::kBackwardError);
  }
  // An infinite error is one of a value whose exact one is 0, or that is not finite.
  return std::isfinite(error) ? error <= bound * bound_growth(condition)
                              : bound > 0 && std::isinf(condition);
}

void Trial::examine(Verdict& verdict, Quantity quantity, const Place& place, double error,
                    double bound, const std::function<double()>& condition,
                    const std::function<void(Discrepancy&)>& describe,
                    const std::function<double()>& backward) const {
  Discrepancy discrepancy;
  if (options_.conditioning) {
    const Stability stability = weigh(error, condition(), backward);
    verdict.weighed(quantity, place, error, stability);
    discrepancy.condition = stability.condition;
  }
  if (error <= bound) return;
  if (!discrepancy.condition) discrepancy.condition = condition();
  const bool is_allowed =
      grown_bound_allows(quantity, error, bound, *discrepancy.condition, backward);
  if (is_allowed && inside_domain_ && promises_growth(quantity) && std::isfinite(error)) {
    verdict.count_ill_conditioned(quantity);
    return;
  }
  discrepancy.quantity = quantity;
  discrepancy.place = place;
  discrepancy.symbol = info(quantity).symbol;
  discrepancy.precision = candidate_.precision;
  discrepancy.error = error;
  describe(discrepancy);
  const bool is_number = std::all_of(discrepancy.got.begin(), discrepancy.got.end(),
                                     [](double x) { return std::isfinite(x); });
  if (!inside_domain_) {
    discrepancy.excuse = {ExcuseKind::kOutsideDomain};
  } else if (is_allowed && is_number) {
    discrepancy.excuse = {ExcuseKind::kIllConditioned, *discrepancy.condition};
  }
  verdict.add(std::move(discrepancy));
}

reference::Neighbourhood Trial::neighbourhood(double relative_change) const {
  return {conventions_.root, conventions_.tangent, relative_change, undecided_ < kMostLongSearches,
          conventions_.valid};
}

Excuse Trial::excuse_of(reference::NearbyAnswer nearby, double relative_change) const {
  switch (standing_of(nearby.found)) {
    case Standing::kExcused:
      return {ExcuseKind::kWitness, relative_change, std::move(nearby.witness)};
    case Standing::kDefect:
      return {ExcuseKind::kNone, relative_change};
    default:
      ++undecided_;
      return {ExcuseKind::kUndecided, relative_change};
  }
}

Excuse Trial::excuse(std::initializer_list<RayAnswer> answers) const {
  const reference::Neighbourhood around = neighbourhood(excused_change());
  std::optional<Excuse> weakest;
  for (const RayAnswer& answer : answers) {
    scene::poll();
    if (!is_wrong(answer, conventions_, precision())) continue;
    Excuse one = excuse_of(right_nearby(answer.ray, answer.sphere, around, answer.s),
                           around.relative_change);
    if (!weakest || one.standing() < weakest->standing()) weakest = std::move(one);
    if (weakest->standing() == Standing::kDefect) break;
  }
  return weakest.value_or(Excuse{});
}

bool Trial::promises_exactly(Quantity quantity) const {
  return quantity == Quantity::kClass && promises_exact_class(candidate_, case_.scene);
}

void Trial::convict(Verdict& verdict, Quantity quantity, Question question, const Place& place,
                    Wrong wrong, const std::function<Excuse()>& excuse,
                    const std::function<void(Discrepancy&)>& describe) const {
  Discrepancy discrepancy;
  discrepancy.quantity = quantity;
  discrepancy.place = place;
  discrepancy.symbol = info(quantity).symbol;
  discrepancy.precision = candidate_.precision;
  discrepancy.error = std::numeric_limits<double>::infinity();
  discrepancy.wrong = wrong;
  if (!is_judged(quantity)) {
    discrepancy.excuse = {ExcuseKind::kOutsideDomain};
  } else if (!promises_exactly(quantity)) {
    discrepancy.excuse = excuse();
  }
  verdict.judged_wrong(quantity, question, place, wrong, discrepancy.excuse.standing());
  describe(discrepancy);
  verdict.add(std::move(discrepancy));
}

}  // namespace raycheck::properties
