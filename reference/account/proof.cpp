#include "reference/account/proof.h"

#include <arf.h>
#include <flint/fmpq.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "reference/internal/ray_impl.h"
#include "scene/scene.h"
#include "scene/validate.h"
// The formulas find first_root(RationalInterval) when they are instantiated in this file.
#include "reference/account/internal/rational_interval.h"

namespace raycheck::reference {
namespace {

namespace mp = boost::multiprecision;

/// The bits of a stated number if the computed number is not a dyadic rational.
constexpr int kStatedBits = 64;
/// The bits of a vector's intervals relative to its length.
constexpr int kVectorBits = 64;

Dyadic dyadic_of(const Rational& x) {
  if (x == 0) return {};
  Integer odd = mp::numerator(x);
  const auto twos = static_cast<std::int64_t>(mp::lsb(mp::abs(odd)));
  odd /= Integer(1) << static_cast<unsigned long>(twos);
  return {odd.str(), twos - static_cast<std::int64_t>(mp::msb(mp::denominator(x)))};
}

bool is_dyadic(const Rational& x) {
  const Integer denominator = mp::denominator(x);
  return mp::lsb(denominator) == mp::msb(denominator);
}

/// The bracket with the ends of x. Domain: they are dyadic.
Bracket exact_bracket(const RationalInterval& x) {
  const Dyadic low = dyadic_of(x.low());
  const Dyadic high = dyadic_of(x.high());
  const std::int64_t exponent = x.low() == 0    ? high.exponent
                                : x.high() == 0 ? low.exponent
                                                : std::min(low.exponent, high.exponent);
  const Rational scale = power_of_two(-exponent);
  return {Rational(x.low() * scale).str(), Rational(x.high() * scale).str(), exponent};
}

/// A dyadic rational below x, about as close as kStatedBits allow.
Rational below(const Rational& x) {
  if (x == 0) return x;
  const std::int64_t shift = kStatedBits - exponent_of(x);
  return Rational(Integer(floor_of(x * power_of_two(shift)) - 1)) * power_of_two(-shift);
}

/// The number itself if it is dyadic; otherwise a wider bracket, which also contains the results of
/// a checker that orders operations differently.
Bracket stated(const RationalInterval& x) {
  if (x.is_exact() && is_dyadic(x.low())) return exact_bracket(x);
  return exact_bracket({below(x.low()), -below(-x.high()), x.bits()});
}

Rational rational_of(arf_srcptr x) {
  fmpq_t fraction;
  fmpq_init(fraction);
  arf_get_fmpq(fraction, x);
  Rational result;
  fmpq_get_mpq(result.backend().data(), fraction);
  fmpq_clear(fraction);
  return result;
}

RationalInterval interval_of(const Enclosure& x) {
  if (arb_is_finite(x.ball()) == 0) throw std::invalid_argument("the ball is not finite");
  arf_t low;
  arf_t high;
  arf_init(low);
  arf_init(high);
  if (arb_is_exact(x.ball()) != 0) {
    arf_set(low, arb_midref(x.ball()));
    arf_set(high, low);
  } else {
    arb_get_interval_arf(low, high, x.ball(), x.bits());
  }
  const RationalInterval result(rational_of(low), rational_of(high), x.bits());
  arf_clear(low);
  arf_clear(high);
  return result;
}

RationalInterval widened(const RationalInterval& x, int relative_bits) {
  const Rational share = power_of_two(-relative_bits);
  return {x.low() - mp::abs(x.low()) * share, x.high() + mp::abs(x.high()) * share, x.bits()};
}

/// a mu^2 - 2 b mu + c
struct Quadratic {
  RationalInterval a, b, c;
};

/// Whether certainly low <= root <= high, for the given root of p. Only up to the smaller root both
/// p >= 0 and b - a mu >= 0 hold.
bool is_root_between(const RationalInterval& low, const RationalInterval& high, WhichRoot root,
                     const Quadratic& p) {
  const auto& [a, b, c] = p;
  if (root == WhichRoot::kLarger) {  // The larger root is minus the smaller root of p(-mu).
    return is_root_between(-high, -low, WhichRoot::kSmaller, {a, -b, c});
  }
  const auto sign_of_p = [&, &a = a, &b = b, &c = c](const RationalInterval& mu) {
    return certain_sign(a * mu * mu - RationalInterval(2) * b * mu + c);
  };
  const auto sign_of_side = [&a = a, &b = b](const RationalInterval& mu) {
    return certain_sign(b - a * mu);
  };
  return sign_of_side(low).value_or(-1) >= 0 && sign_of_p(low).value_or(-1) >= 0 &&
         (sign_of_side(high).value_or(1) <= 0 || sign_of_p(high).value_or(1) <= 0);
}

bool is_narrow(const RationalKernel::Vector_3& v) {
  Rational width(0);
  Rational size(0);
  for (int k = 0; k < 3; ++k) {
    const RationalInterval& x = v[k];
    width = std::max(width, Rational(x.high() - x.low()));
    if (certain_sign(x).value_or(0) == 0) continue;
    size = std::max(size, std::min(Rational(mp::abs(x.low())), Rational(mp::abs(x.high()))));
  }
  return width <= size * power_of_two(-kVectorBits);
}

}  // namespace

Dyadic dyadic(double finite) { return dyadic_of(Rational(finite)); }

Bracket bracket(const Enclosure& x) { return exact_bracket(interval_of(x)); }

/// One attempt at a proof, with square roots to `bits` bits and parameters to `value_bits`.
struct Prover::Attempt {
  const Prover& prover;
  const Proposition& proposition;
  RationalLift lift;
  int value_bits;
  std::optional<CameraNumbers<RationalKernel>> numbers = {};
  std::optional<Line<RationalKernel>> line = {};
  RationalInterval unit{1};  ///< s = unit mu
  std::vector<RationalInterval> parameters = {};

  RationalKernel::Vector_3 start() const {
    return line->starts_at_g ? RationalKernel::Vector_3(line->base + line->g) : line->base;
  }

  ProvenRoots follow_camera() {
    const scene::Camera& camera = *prover.camera_;
    numbers = camera_numbers(lift, camera);
    const RationalKernel::Vector_3 w = numbers->inputs.eye - numbers->inputs.look_at;
    const RationalKernel::Vector_3 u = CGAL::cross_product(numbers->inputs.up, w);
    ProvenRoots roots{exact_bracket(first_root(w * w)), exact_bracket(second_root(u * u)), {}};
    if (prover.pixel_) {
      line = camera_line(lift, *numbers, camera, prover.conventions_, *prover.pixel_);
      unit = first_root(line->a);
      roots.length = exact_bracket(unit);
    }
    return roots;
  }

  std::optional<RationalInterval> parameter(const LineAndSphere<RationalKernel>& pair,
                                            const scene::Sphere& sphere,
                                            const Intersection& at) const {
    const RationalInterval s = interval_of(prover.exact_->parameter(sphere, at, value_bits));
    const Quadratic p{line->a, linear_coefficient(pair), constant_coefficient(pair)};
    // Enclosed square roots never show that a parameter is a dyadic number, only that it is near
    // one.
    for (const RationalInterval& ends : {s, widened(s, value_bits)}) {
      const auto mu = [&](const Rational& end) { return RationalInterval(end, lift.bits) / unit; };
      if (is_root_between(mu(ends.low()), mu(ends.high()), at.root, p)) return ends;
    }
    return std::nullopt;
  }

  std::optional<ProvenMeeting> meeting(const scene::Sphere& sphere) {
    const auto pair = line_and_sphere(*line, lift_sphere(lift, sphere));
    ProvenMeeting result;
    result.intersection = prover.exact_->intersect(sphere, prover.conventions_.root);
    const HitClass hit_class = result.intersection.hit_class;
    const scene::Tangent tangent = prover.conventions_.tangent;
    result.met = counts_as_hit(hit_class, tangent);
    parameters.emplace_back();

    const RationalInterval discriminant = reference::discriminant(pair);
    const std::optional<int> sign = certain_sign(discriminant);
    if (!sign) return std::nullopt;
    result.discriminant = stated(discriminant);
    if (*sign < 0 || (*sign == 0 && tangent == scene::Tangent::kMiss)) return result;
    const RationalInterval c = constant_coefficient(pair);
    if (!certain_sign(c)) return std::nullopt;
    result.c = stated(c);
    if (*certain_sign(c) >= 0) {
      const RationalInterval b = linear_coefficient(pair);
      if (!certain_sign(b)) return std::nullopt;
      result.b = stated(b);
    }
    if (!result.met) return result;

    const auto s = parameter(pair, sphere, result.intersection);
    if (!s) return std::nullopt;
    result.s = exact_bracket(*s);
    parameters.back() = *s;
    if (!proposition.other_roots || hit_class == HitClass::kTangent) return result;
    Intersection other = result.intersection;
    other.root = other.root == WhichRoot::kSmaller ? WhichRoot::kLarger : WhichRoot::kSmaller;
    const auto other_s = parameter(pair, sphere, other);
    if (!other_s) return std::nullopt;
    result.other_s = exact_bracket(*other_s);
    return result;
  }

  bool shows_order(const std::vector<ProvenMeeting>& meetings) const {
    const auto nearest = prover.exact_->nearest(proposition.spheres, prover.conventions_);
    if (!nearest) return true;
    const RationalInterval& first = parameters[nearest->index];
    for (std::size_t k = 0; k < meetings.size(); ++k) {
      if (k == nearest->index || !meetings[k].met) continue;
      const bool is_tie =
          std::find(nearest->ties.begin(), nearest->ties.end(), k) != nearest->ties.end();
      const RationalInterval& s = parameters[k];
      const bool is_shown = is_tie
                                ? s.low() >= first.high() ||
                                      proposition.spheres[k] == proposition.spheres[nearest->index]
                                : s.low() > first.high();
      if (!is_shown) return false;
    }
    return true;
  }

  bool shows_vectors(const std::vector<ProvenMeeting>& meetings) const {
    const Proposition& wanted = proposition;
    if (wanted.axes &&
        !(is_narrow(numbers->axes.U) && is_narrow(numbers->axes.V) && is_narrow(numbers->axes.W))) {
      return false;
    }
    if (wanted.pixel_point && !is_narrow(line->base + line->g)) return false;
    if (wanted.origin && !is_narrow(start())) return false;
    if (wanted.direction && !is_narrow(line->g / unit)) return false;
    if (wanted.from_origin) {
      const auto along = lift_vector(lift, *wanted.from_origin) - start();
      if (!is_narrow(along) || !is_narrow(line->g)) return false;
    }
    for (std::size_t k = 0; wanted.hit_points && k < meetings.size(); ++k) {
      if (!meetings[k].met) continue;
      const RationalInterval mu = parameters[k] / unit;
      if (!is_narrow(start() + mu * line->g)) return false;
    }
    return true;
  }

  std::optional<Proof> run() {
    Proof proof;
    if (prover.camera_) {
      proof.roots = follow_camera();
    } else {
      line = given_line<RationalKernel>(lift_ray(lift, prover.given_));
    }
    for (const scene::Sphere& sphere : proposition.spheres) {
      auto met = meeting(sphere);
      if (!met) return std::nullopt;
      proof.meetings.push_back(std::move(*met));
    }
    if (proposition.order && !shows_order(proof.meetings)) return std::nullopt;
    if (!shows_vectors(proof.meetings)) return std::nullopt;
    return proof;
  }
};

Prover::Prover(const scene::Camera& camera, const scene::Conventions& conventions,
               const std::optional<scene::Pixel>& pixel)
    : camera_(camera), pixel_(pixel), conventions_(conventions) {
  const ExactCamera exact(camera, conventions);
  if (pixel) exact_.emplace(exact, *pixel);
}

Prover::Prover(const scene::Ray& ray, const scene::Conventions& conventions)
    : given_(ray), conventions_(conventions), exact_(ray) {}

std::optional<Proof> Prover::prove(const Proposition& proposition) const {
  for (int bits = kFirstProofBits; bits <= kMostProofBits; bits *= 2) {
    const int value_bits = ExactRay::kValueBits * (bits / kFirstProofBits);
    if (!Attempt{*this, proposition, RationalLift{bits}, value_bits}.run()) continue;
    // Twice the bits that were enough, to spare some for other orders of operations.
    return Attempt{*this, proposition, RationalLift{2 * bits}, value_bits}.run();
  }
  return std::nullopt;
}

}  // namespace raycheck::reference
