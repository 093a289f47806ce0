// Makes a method's answers for one ray and for a batch from its formula for the roots of one ray
// and one sphere, in any number type. Internal to fast/. Compiled once for each of Highway's
// targets (fast/internal/lanes.h).

#if defined(RAYCHECK_FAST_INTERNAL_INTERSECT_BATCH_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYCHECK_FAST_INTERNAL_INTERSECT_BATCH_H_
#undef RAYCHECK_FAST_INTERNAL_INTERSECT_BATCH_H_
#else
#define RAYCHECK_FAST_INTERNAL_INTERSECT_BATCH_H_
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

#include "fast/internal/batch_arrays.h"
#include "fast/internal/between.h"
#include "fast/internal/triple.h"
#include "fast/ray_by_ray.h"

HWY_BEFORE_NAMESPACE();
namespace raycheck::fast::HWY_NAMESPACE {

/// A ray and a sphere, in the number type that a method computes in.
template <class N>
struct RayOf {
  Triple<N> origin, direction;
};
template <class N>
struct SphereOf {
  Triple<N> centre;
  N radius;
};
template <class N>
HWY_INLINE RayOf<N> ray_of(const scene::Ray& ray) {
  return {triple<N>(ray.origin), triple<N>(ray.direction)};
}
template <class N>
HWY_INLINE SphereOf<N> sphere_of(const scene::Sphere& sphere) {
  return {triple<N>(sphere.centre), N(sphere.radius)};
}
HWY_INLINE RayOf<Lanes> load(const RayArrays& from, std::size_t k) {
  return {load(from.origin, k), load(from.direction, k)};
}
/// A radius below 0 is loaded as NaN.
HWY_INLINE SphereOf<Lanes> load(const SphereArrays& from, std::size_t k) {
  const Lanes radius = load(from.radius + k);
  return {load(from.centre, k), select(radius >= Lanes(0.0), radius, Lanes(std::nan("")))};
}

/// Roots, in the number type that a method computes in.
template <class N>
struct RootsOf {
  N axial_distance;
  N half_chord_sq;
  N smaller;
  N larger;
  N discriminant;  ///< A positive multiple of half_chord_sq; only its sign is used.
};

/// The coefficients of a t^2 - 2 b t + c = 0. The roots are the parameters of the points where a
/// ray's line meets a sphere.
template <class N>
struct Quadratic {
  Triple<N> T;  ///< From the origin to the centre.
  N a, b, c;
};

template <class N>
HWY_INLINE Quadratic<N> quadratic(const RayOf<N>& ray, const SphereOf<N>& sphere) {
  const Triple<N> T = sphere.centre - ray.origin;
  return {T, dot(ray.direction, ray.direction), dot(T, ray.direction),
          dot(T, T) - sphere.radius * sphere.radius};
}

/// The roots q/a and c/q of a t^2 - 2 b t + c = 0, where q = b + sign(b) sqrt(disc) does not cancel
/// (Numerical Recipes 5.6). q = 0 only for a double root 0. The sign of b comes from a comparison,
/// since the sign bit would exchange the roots at b = -0.
template <class N>
HWY_INLINE RootsOf<N> roots_by_q(const N& a, const N& b, const N& c, const N& discriminant) {
  const auto forward = b >= N(0);
  const N root = square_root(discriminant);
  const N q = select(forward, b + root, b - root);
  const N one = q / a;
  const N other = select(q == N(0), N(0), c / q);
  return {b / square_root(a), discriminant / a, select(forward, other, one),
          select(forward, one, other), discriminant};
}

/// An answer; parameter and point are valid only for a hit.
template <class N>
struct ChosenOf {
  MaskOf<N> hit;
  N parameter;
  Triple<N> point;
};

/// A method that has Method::roots(ray, sphere) in the type Method::Number.
template <class Method>
struct FromRoots : Method {
  using Number = typename Method::Number;

  /// The root that the rule chooses, and the point there.
  HWY_INLINE static ChosenOf<Number> answer(const RayOf<Number>& ray,
                                            const SphereOf<Number>& sphere, scene::HitRule rule) {
    const RootsOf<Number> found = Method::roots(ray, sphere);
    const Number zero(0);
    const auto meets = rule.tangent == scene::Tangent::kMiss ? found.discriminant > zero
                                                             : found.discriminant >= zero;
    const Number s = rule.root == scene::Root::kNearest
                         ? select(found.smaller >= zero, found.smaller, found.larger)
                         : found.smaller;
    const MaskOf<Number> hit = meets & (s >= zero);
    return {hit, s, ray.origin + s * ray.direction};
  }
};

// The functions of an IntersectMethod, made from an Answerer: a type with answer(), like FromRoots.
// They are flattened, since a call would pass vectors through memory and compute unneeded values.

template <class N>
HWY_INLINE Chosen plain(const ChosenOf<N>& chosen) {
  return {chosen.hit,
          {static_cast<double>(chosen.parameter),
           {static_cast<double>(chosen.point.x), static_cast<double>(chosen.point.y),
            static_cast<double>(chosen.point.z)}}};
}

template <class Answerer>
[[gnu::flatten]] std::optional<Hit> intersect_one(const scene::Ray& ray,
                                                  const scene::Sphere& sphere,
                                                  scene::HitRule rule) {
  using N = typename Answerer::Number;
  return plain(Answerer::answer(ray_of<N>(ray), sphere_of<N>(sphere), rule)).if_hit();
}

template <class Method>
Roots roots_of(const scene::Ray& ray, const scene::Sphere& sphere) {
  using N = typename Method::Number;
  const RootsOf<N> found = Method::roots(ray_of<N>(ray), sphere_of<N>(sphere));
  return {static_cast<double>(found.axial_distance), static_cast<double>(found.half_chord_sq),
          static_cast<double>(found.smaller), static_cast<double>(found.larger)};
}

/// IntersectMethod::classes_in of a Formula (see below) that uses no errors of sums or products.
template <template <class> class Formula, class F = double>
scene::PossibleClasses classes_in(const scene::Box<scene::Ray>& rays,
                                  const scene::Box<scene::Sphere>& spheres, scene::HitRule rule) {
  using N = Between<F>;
  const auto between = [](const auto& from, const auto& to) {
    return Triple<N>{N(from.x, to.x), N(from.y, to.y), N(from.z, to.z)};
  };
  const auto& [ray, last_ray] = rays;
  const auto& [sphere, last] = spheres;
  const Possible hit =
      FromRoots<Formula<N>>::answer(
          {between(ray.origin, last_ray.origin), between(ray.direction, last_ray.direction)},
          {between(sphere.centre, last.centre), N(sphere.radius, last.radius)}, rule)
          .hit;
  return {hit.can_be_true, hit.can_be_false};
}

/// IntersectMethod::intersect, one ray after the other.
template <class Answerer>
[[gnu::flatten]] void intersect_batch(const Rays& rays, const scene::Sphere& sphere,
                                      scene::HitRule rule, Hits& hits) {
  using N = typename Answerer::Number;
  require_valid(rays, sphere);
  hits.resize(rays.size());
  const SphereOf<N> asked = sphere_of<N>(sphere);
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const Chosen chosen = plain(Answerer::answer(ray_of<N>(rays.at(k)), asked, rule));
    hits.set(k, chosen.hit, chosen.at);
  }
}

/// Whether all rays given to see() are valid. A valid ray may be taken for invalid if the square of
/// its direction is out of range, or its origin is near the end of the range.
class Validity {
 public:
  Validity() : sum_(0.0), directionless_(sum_ < sum_) {}
  HWY_INLINE void see(const RayOf<Lanes>& ray) {
    const Lanes length_sq = dot(ray.direction, ray.direction);
    sum_ = sum_ + ((ray.origin.x + ray.origin.y + ray.origin.z) + length_sq);
    directionless_ = directionless_ | (length_sq == Lanes(0.0));
  }
  HWY_INLINE bool holds() const { return !any(directionless_ | !(sum_ - sum_ == Lanes(0.0))); }

 private:
  Lanes sum_;  // not finite once a coordinate is not
  LaneMask directionless_;
};

static_assert(kLaneCount <= sizeof(std::uint64_t));

/// One byte per lane: 1 or 0.
HWY_INLINE std::uint64_t bytes(LaneMask mask) { return kBytesOfBits[bits(mask)]; }
HWY_INLINE void store(std::uint64_t bytes, std::uint8_t* to) {
  std::memcpy(to, &bytes, kLaneCount);
}

/// A BatchKernel for counts divisible by kLaneCount.
template <class Answerer>
[[gnu::flatten]] HWY_NOINLINE bool answer_whole_vectors(const BatchInput& input,
                                                        const HitArrays& answers) {
  const BatchInput asked = input;
  const HitArrays to = answers;
  const SphereOf<Lanes> sphere = sphere_of<Lanes>(asked.sphere);
  Validity valid;
  for (std::size_t k = 0; k < asked.count; k += kLaneCount) {
    const RayOf<Lanes> ray = load(asked.rays, k);
    valid.see(ray);
    const ChosenOf<Lanes> chosen = Answerer::answer(ray, sphere, asked.rule);
    store(bytes(chosen.hit), to.hit + k);
    store(chosen.parameter, to.parameter + k);
    store(chosen.point, to.point, k);
  }
  return valid.holds();
}

/// A BatchKernel for any count, made from one for multiples of kLaneCount.
inline bool answer_batch(BatchKernel whole_vectors, const BatchInput& input,
                         const HitArrays& answers) {
  constexpr std::size_t kLanes = kLaneCount;
  const std::size_t rest = input.count % kLanes;
  BatchInput part = input;
  part.count -= rest;
  const bool valid = whole_vectors(part, answers);
  if (rest == 0) return valid;
  // The last vector is filled up with copies of the last ray.
  const std::size_t first = part.count;
  double given[10][kLanes];
  double found[4][kLanes];
  std::uint8_t hit[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) {
    const std::size_t ray = first + (k < rest ? k : rest - 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      given[axis][k] = input.rays.origin[axis][ray];
      given[3 + axis][k] = input.rays.direction[axis][ray];
      if (input.spheres != nullptr) given[6 + axis][k] = input.spheres->centre[axis][ray];
    }
    if (input.spheres != nullptr) given[9][k] = input.spheres->radius[ray];
  }
  part.count = kLanes;
  part.rays = {{given[0], given[1], given[2]}, {given[3], given[4], given[5]}};
  const SphereArrays spheres = {{given[6], given[7], given[8]}, given[9]};
  if (input.spheres != nullptr) part.spheres = &spheres;
  const bool rest_is_valid = whole_vectors(part, {hit, found[0], {found[1], found[2], found[3]}});
  for (std::size_t k = 0; k < rest; ++k) {
    answers.hit[first + k] = hit[k];
    answers.parameter[first + k] = found[0][k];
    for (std::size_t axis = 0; axis < 3; ++axis)
      answers.point[axis][first + k] = found[1 + axis][k];
  }
  return valid && rest_is_valid;
}

}  // namespace raycheck::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

// These macros make a method from its formula, a `template <class N> struct Formula` with the
// roots() that FromRoots calls. The names of the functions contain that of the formula, since one
// unit may compile several methods.
//
// In the target's namespace: the batch, by lanes.
#define RAYCHECK_BATCH_OF(Formula)                                                        \
  namespace {                                                                             \
  bool batch_of_##Formula(const BatchInput& input, const HitArrays& answers) {            \
    return answer_batch(answer_whole_vectors<FromRoots<Formula<Lanes>>>, input, answers); \
  }                                                                                       \
  }
// In raycheck::fast, if HWY_ONCE is set: intersect(), by the batch of the best target;
#define RAYCHECK_INTERSECT_BY(Formula)                                                            \
  namespace {                                                                                     \
  HWY_EXPORT(batch_of_##Formula);                                                                 \
  void intersect_by_##Formula(const Rays& rays, const scene::Sphere& sphere, scene::HitRule rule, \
                              Hits& hits) {                                                       \
    intersect_by(HWY_DYNAMIC_DISPATCH(batch_of_##Formula), rays, sphere, rule, hits);             \
  }                                                                                               \
  }
// and the functions of its IntersectMethod.
#define RAYCHECK_FUNCTIONS(Formula)                                                           \
  .intersect = intersect_by_##Formula,                                                        \
  .intersect_one =                                                                            \
      HWY_NAMESPACE::intersect_one<HWY_NAMESPACE::FromRoots<HWY_NAMESPACE::Formula<double>>>, \
  .roots = HWY_NAMESPACE::roots_of<HWY_NAMESPACE::Formula<double>>
//
// A formula that uses errors of products answers single rays by the best target, too: fused
// operations are instructions there, and calls or many operations on other targets. The first macro
// is for the target's namespace, the second for raycheck::fast if HWY_ONCE is set.
#define RAYCHECK_ONE_OF(Formula)                                                          \
  namespace {                                                                             \
  std::optional<Hit> one_of_##Formula(const scene::Ray& ray, const scene::Sphere& sphere, \
                                      scene::HitRule rule) {                              \
    return intersect_one<FromRoots<Formula<double>>>(ray, sphere, rule);                  \
  }                                                                                       \
  }
#define RAYCHECK_ONE_BY_BEST(Formula)                                                     \
  namespace {                                                                             \
  HWY_EXPORT(one_of_##Formula);                                                           \
  std::optional<Hit> one_by_##Formula(const scene::Ray& ray, const scene::Sphere& sphere, \
                                      scene::HitRule rule) {                              \
    return HWY_DYNAMIC_DISPATCH(one_of_##Formula)(ray, sphere, rule);                     \
  }                                                                                       \
  }
#define RAYCHECK_FUNCTIONS_BY_BEST(Formula)                               \
  .intersect = intersect_by_##Formula, .intersect_one = one_by_##Formula, \
  .roots = HWY_NAMESPACE::roots_of<HWY_NAMESPACE::Formula<double>>
//
// For a formula with its number type, ray by ray:
#define RAYCHECK_FUNCTIONS_RAY_BY_RAY(Formula)                                                     \
  .intersect = HWY_NAMESPACE::intersect_batch<HWY_NAMESPACE::FromRoots<HWY_NAMESPACE::Formula>>,   \
  .intersect_one = HWY_NAMESPACE::intersect_one<HWY_NAMESPACE::FromRoots<HWY_NAMESPACE::Formula>>, \
  .roots = HWY_NAMESPACE::roots_of<HWY_NAMESPACE::Formula>

#endif  // RAYCHECK_FAST_INTERNAL_INTERSECT_BATCH_H_
