// Compares verdicts in single precision with an oracle that shares no code with reference/. The
// environment variable RAYCHECK_FLOAT_PAIRS sets the number of pairs, for example 1000000.

#include <boost/multiprecision/mpfr.hpp>

#include "properties/case.h"
#include "properties/cases/case_source.h"
#include "properties/cases/random.h"
#include "properties/laws/law.h"
#include "properties/trial.h"
#include "tests/reference/random_cases.h"
#include "tests/testing.h"

namespace raycheck::tests {
namespace {

using namespace properties;
using scene::Precision;

/// About 6600 bits, in which products of four sums of floats are exact; so are square roots and
/// quotients that equal a float, or the middle between two.
using Wide = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<2000>,
                                           boost::multiprecision::et_off>;

constexpr int kFloatDigits = 24;
constexpr int kLeastFloat = -149;  ///< The exponent of the least float.

/// The exponent of the gap between the floats around x, which is not 0.
int gap_exponent(const Wide& x) {
  int exponent = 0;
  frexp(x, &exponent);
  return std::max(exponent - kFloatDigits, kLeastFloat);
}

/// x in gaps between floats around `at`. If `at` is 0: 0 if x is 0, otherwise infinite.
double in_gaps(const Wide& x, const Wide& at) {
  if (at == 0) return x == 0 ? 0 : kInfinity;
  return Wide(ldexp(x, -gap_exponent(at))).convert_to<double>();
}

double nearest_float(const Wide& x) {
  if (x == 0) return 0;
  const int gap = gap_exponent(x);
  const Wide count = abs(Wide(ldexp(x, -gap)));
  Wide whole = floor(count);
  const Wide rest = count - whole, half = Wide(1) / 2;
  const bool is_odd = floor(whole / 2) * 2 != whole;
  if (rest > half || (rest == half && is_odd)) whole += 1;
  const double size = std::ldexp(whole.convert_to<double>(), gap);
  const bool overflows = size > static_cast<double>(std::numeric_limits<float>::max());
  return (x < 0 ? -1 : 1) * (overflows ? kInfinity : size);
}

/// Both roots of |L + s d - C|^2 = r^2.
struct RootPair {
  std::array<Wide, 3> L, d;
  Wide a = 0, b = 0, c, discriminant;

  RootPair(const scene::Ray& ray, const scene::Sphere& sphere)
      : L{ray.origin.x, ray.origin.y, ray.origin.z},
        d{ray.direction.x, ray.direction.y, ray.direction.z},
        c(-Wide(sphere.radius) * sphere.radius) {
    const std::array<Wide, 3> C{sphere.centre.x, sphere.centre.y, sphere.centre.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const Wide T = C[k] - L[k];
      a += d[k] * d[k];
      b += T * d[k];
      c += T * T;
    }
    discriminant = b * b - a * c;
  }
  /// A root by the quotient that does not cancel, with exact signs.
  Wide root(int which) const {
    const Wide root = sqrt(discriminant);
    if (c == 0) return (b > 0) == (which > 0) && b != 0 ? Wide(2 * b / a) : Wide(0);
    return (b > 0) == (which > 0) ? Wide((b + which * root) / a) : Wide(c / (b - which * root));
  }
  Wide point(int which, std::size_t k) const { return L[k] + root(which) * d[k]; }
  /// The root that counts, -1 or 1; 0 for a miss.
  int chosen(scene::Root convention) const {
    if (discriminant < 0) return 0;
    if (root(-1) >= 0) return -1;
    return convention == scene::Root::kNearest && root(1) >= 0 ? 1 : 0;
  }
};

/// x, or 0 if x is only the rounding error of coordinates that cancel exactly.
Wide cleaned(const Wide& x, const Wide& of) {
  return abs(x) < abs(of) * Wide(ldexp(Wide(1), -5000)) ? Wide(0) : x;
}

/// The truth about a ray and a sphere whose numbers are floats. It shares no code with reference/:
/// it uses the literal formulas in MPFR, at a precision without roundings.
struct FloatTruth {
  bool is_line_hit = false;   ///< Whether the line meets the sphere.
  bool is_tangent = false;    ///< Whether it meets the sphere in a double root.
  bool is_hit = false;        ///< Whether it is a hit under the `root` convention; tangents count.
  double s = 0;               ///< Correctly rounded to float, for a hit.
  std::array<double, 3> Q{};  ///< Correctly rounded to float, for a hit.
};

/// An answer's errors, to a relative 2^-40 and an absolute 2^-30.
struct FloatErrors {
  bool is_at_other_root = false;
  /// In ulp of float of the exact s; infinite where that is 0 and the answer is not.
  double s = 0;
  double Q = 0;  ///< In u = 2^-24 of |Q|; infinite if that is 0 and the answer is not.
};

/// Domain: floats between 2^-126 and 2^126 in size, or 0; a direction that is not 0; radius >= 0.
FloatTruth float_truth(const scene::Ray& ray, const scene::Sphere& sphere, scene::Root root) {
  const RootPair pair(ray, sphere);
  FloatTruth truth;
  truth.is_line_hit = pair.discriminant >= 0;
  truth.is_tangent = pair.discriminant == 0;
  const int which = pair.chosen(root);
  truth.is_hit = which != 0;
  if (!truth.is_hit) return truth;
  truth.s = nearest_float(pair.root(which));
  for (std::size_t k = 0; k < 3; ++k) {
    truth.Q[k] = nearest_float(cleaned(pair.point(which, k), pair.L[k]));
  }
  return truth;
}

/// Domain: the same, for a hit; finite answers.
FloatErrors float_errors(const scene::Ray& ray, const scene::Sphere& sphere, scene::Root root,
                         double s, const scene::Point3& Q) {
  const RootPair pair(ray, sphere);
  const int which = pair.chosen(root);
  FloatErrors errors;
  const Wide exact = pair.root(which);
  if (pair.discriminant != 0) {
    const Wide other = pair.root(-which);
    errors.is_at_other_root = 4 * abs(Wide(s) - other) < abs(Wide(other - exact));
  }
  errors.s = in_gaps(abs(Wide(s) - exact), exact);
  const double given[] = {Q.x, Q.y, Q.z};
  Wide size_sq = 0, off_sq = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Wide at = cleaned(pair.point(which, k), pair.L[k]), apart = Wide(given[k]) - at;
    size_sq += at * at;
    off_sq += apart * apart;
  }
  if (size_sq == 0) {
    errors.Q = off_sq == 0 ? 0 : kInfinity;
  } else {
    errors.Q = std::ldexp(Wide(sqrt(Wide(off_sq / size_sq))).convert_to<double>(), kFloatDigits);
  }
  return errors;
}

constexpr Precision kSingle = Precision::kSingle;
constexpr std::size_t kUsualPairs = 5000;
/// Bounds of reference/ are upper bounds, too large by at most this.
constexpr double kWidth = 1e-8;
/// Errors of fewer ulps than this may vanish in the width of doubles.
constexpr double kLeastError = 0x1p-28;

double as_float(double x) { return scene::rounded_to(kSingle, x); }

/// The deliberate error in an answer.
enum class Fault { kNone, kUlps, kOtherRoot, kMiss, kFalseHit };

/// An answer in floats: right, off by a few ulps, at the other root, missing or false.
std::optional<properties::HitAnswer> answer_to(const scene::Ray& ray, const scene::Sphere& sphere,
                                               properties::Random& random) {
  const auto dot = [](const scene::Vector3& a, const scene::Vector3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  };
  const scene::Vector3 T = sphere.centre - ray.origin;
  const double a = dot(ray.direction, ray.direction), b = dot(T, ray.direction);
  const double c = dot(T, T) - sphere.radius * sphere.radius;
  const double discriminant = b * b - a * c;
  const auto fault = static_cast<Fault>(random.bits() % 8 < 3 ? 0 : random.bits() % 5);
  const bool says_hit =
      fault == Fault::kMiss ? false : fault == Fault::kFalseHit || discriminant >= 0;
  if (!says_hit) return std::nullopt;
  const double root = std::sqrt(std::abs(discriminant));
  double s = (b - root) / a;
  if (s < 0) s = (b + root) / a;
  if (fault == Fault::kOtherRoot) s = 2 * b / a - s;
  s = as_float(s);
  for (int k = static_cast<int>(random.bits() % 6); fault == Fault::kUlps && k > 0; --k) {
    s = scene::next_after(kSingle, s, HUGE_VAL);
  }
  if (!std::isfinite(s)) return std::nullopt;
  const auto at = [&](double from, double step) { return as_float(as_float(s * step) + from); };
  const scene::Point3 Q = {at(ray.origin.x, ray.direction.x), at(ray.origin.y, ray.direction.y),
                           at(ray.origin.z, ray.direction.z)};
  if (!std::isfinite(Q.x) || !std::isfinite(Q.y) || !std::isfinite(Q.z)) return std::nullopt;
  return properties::HitAnswer{s, Q};
}

/// The verdict on one pair.
struct Verdicts {
  bool missed = false, false_hit = false, wrong_root = false;
  double s_error = 0, Q_error = 0;  ///< 0 if exact, or if not measured.
  std::vector<double> s, Q;         ///< The exact values; empty if there is no verdict.
};

/// A candidate that repeats given answers. Its domain is empty, so that nothing is excused and no
/// witness is searched for.
properties::Candidate that_answers(
    const std::vector<std::vector<std::optional<properties::HitAnswer>>>& by_sphere,
    Precision precision) {
  properties::Candidate candidate;
  candidate.precision = precision;
  candidate.unit_roundoff = scene::unit_roundoff(precision);
  candidate.smallest_length = candidate.largest_length = HUGE_VAL;
  candidate.intersect = [&by_sphere](const auto&...) {
    std::vector<properties::SphereHits> all;
    for (const auto& answers : by_sphere) {
      properties::SphereHits& hits = all.emplace_back();
      for (std::size_t k = 0; k < answers.size(); ++k) {
        if (answers[k]) hits.push_back({k, *answers[k]});
      }
    }
    return all;
  };
  return candidate;
}

struct Counts {
  std::size_t pairs = 0, hits = 0, misses = 0, tangents = 0, wrong = 0, errors = 0, zeros = 0;
  std::size_t differ = 0;
  std::string first;  ///< The first difference.
};

bool is_close(double bound, double error) {
  if (std::isinf(bound) || std::isinf(error)) return bound == error;
  return bound >= error * (1 - kWidth) - kLeastError && bound <= error * (1 + kWidth) + kLeastError;
}

/// Judges the pairs of a case, and compares the verdicts with the oracle's.
void compare(const Case& the_case, scene::Root root, properties::Random& random,
             Precision judged_in, Counts& counts) {
  std::vector<std::vector<std::optional<properties::HitAnswer>>> answers;
  for (const scene::Sphere& sphere : the_case.scene.spheres) {
    auto& of_sphere = answers.emplace_back();
    for (const scene::Ray& ray : the_case.scene.rays) {
      of_sphere.push_back(answer_to(ray, sphere, random));
    }
  }
  const properties::Candidate candidate = that_answers(answers, judged_in);
  properties::Trial trial(the_case, candidate, {.max_error = 0});
  std::map<std::pair<std::size_t, std::size_t>, Verdicts> said;
  for (const char* law : {"class", "nearest-root", "parameter", "hit-point"}) {
    const properties::Verdict verdict = apply(*properties::find_law(law), trial);
    ASSERT_LT(verdict.discrepancies(), properties::kKeptDiscrepancies);
    for (const Discrepancy& d : verdict.worst(properties::kKeptDiscrepancies)) {
      Verdicts& here = said[{d.place.ray, *d.place.sphere}];
      here.missed |= d.wrong == Wrong::kMissed;
      here.false_hit |= d.wrong == Wrong::kFalseHit;
      here.wrong_root |= d.wrong == Wrong::kWrongRoot;
      if (d.quantity == Quantity::kParameter) here.s_error = d.error;
      if (d.quantity == Quantity::kHitPoint) here.Q_error = d.error;
      if (d.quantity == Quantity::kHitPoint) here.Q = d.exact;
      if (d.quantity == Quantity::kParameter || d.wrong != Wrong::kNot) here.s = d.exact;
    }
  }
  for (std::size_t sphere = 0; sphere < answers.size(); ++sphere) {
    for (std::size_t ray = 0; ray < answers[sphere].size(); ++ray) {
      const scene::Ray& L = the_case.scene.rays[ray];
      const scene::Sphere& C = the_case.scene.spheres[sphere];
      const FloatTruth truth = float_truth(L, C, root);
      const auto& answer = answers[sphere][ray];
      const Verdicts& here = said[{ray, sphere}];
      bool agrees = here.missed == (truth.is_hit && !answer) &&
                    here.false_hit == (!truth.is_hit && answer.has_value());
      if (!here.s.empty()) agrees = agrees && truth.is_hit && here.s[0] == truth.s;
      if (!here.Q.empty()) {
        for (std::size_t k = 0; k < 3; ++k) agrees = agrees && here.Q[k] == truth.Q[k];
      }
      if (truth.is_hit && answer) {
        const FloatErrors errors = float_errors(L, C, root, answer->parameter, answer->point);
        agrees = agrees && here.wrong_root == errors.is_at_other_root;
        if (!errors.is_at_other_root) {
          agrees = agrees && is_close(here.s_error, errors.s) && is_close(here.Q_error, errors.Q);
          counts.errors += errors.s > 0 ? 1 : 0;
        }
        counts.wrong += here.wrong_root ? 1 : 0;
        counts.zeros += truth.s == 0 ? 1 : 0;
      }
      ++counts.pairs;
      counts.hits += truth.is_hit ? 1 : 0;
      counts.misses += truth.is_hit ? 0 : 1;
      counts.tangents += truth.is_tangent ? 1 : 0;
      counts.wrong += here.missed || here.false_hit ? 1 : 0;
      if (agrees) continue;
      if (counts.differ++ == 0) counts.first = reference::spelled(L) + reference::spelled(C);
    }
  }
}

/// Compares on rays and spheres of every source, rounded to floats; the rays of cameras become
/// given rays.
Counts compare_on_all_sources(std::size_t pairs, Precision judged_in) {
  Counts counts;
  properties::Random random(1);
  const auto sources = properties::case_sources();
  for (std::uint64_t k = 0; counts.pairs < pairs; ++k) {
    const auto& source = sources[k % sources.size()];
    properties::ChosenSource chosen{&source};
    if (source.severities) {
      chosen.severity = static_cast<int>(
          random.bits() % static_cast<std::uint64_t>(source.severities->highest + 1));
    }
    auto rounded = properties::rounded_case(chosen.make(random.bits()), kSingle).the_case;
    if (!rounded) continue;
    if (rounded->scene.camera) {
      auto given = properties::given_rays(*rounded, rounded->scene.conventions, kSingle);
      if (!given) continue;
      *rounded = std::move(given->the_case);
    }
    const scene::Root root = k % 3 == 0 ? scene::Root::kSmaller : scene::Root::kNearest;
    rounded->scene.conventions.root = root;
    rounded->scene.conventions.tangent = scene::Tangent::kHit;
    if (rounded->scene.rays.size() * rounded->scene.spheres.size() > 400) continue;
    compare(*rounded, root, random, judged_in, counts);
  }
  return counts;
}

std::size_t pairs_asked() {
  const char* const asked = std::getenv("RAYCHECK_FLOAT_PAIRS");
  return asked == nullptr ? kUsualPairs
                          : static_cast<std::size_t>(std::strtoull(asked, nullptr, 10));
}

TEST(FloatOracle, AgreesWithEveryVerdictOnFloats) {
  const std::size_t pairs = pairs_asked();
  const Counts counts = compare_on_all_sources(pairs, kSingle);
  EXPECT_EQ(counts.differ, 0u) << "of " << counts.pairs << ", first " << counts.first;
  EXPECT_GE(counts.pairs, pairs);
  EXPECT_GE(counts.hits, pairs / 10);
  EXPECT_GE(counts.misses, pairs / 10);
  EXPECT_GE(counts.errors, pairs / 20);
  EXPECT_GE(counts.wrong, pairs / 20);
  EXPECT_GE(counts.tangents, pairs / 1000);
}

TEST(FloatOracle, DistinguishesVerdictsInDoublesAndInFloats) {
  const Counts counts = compare_on_all_sources(500, Precision::kDouble);
  EXPECT_GE(counts.differ, 100u);
}

}  // namespace
}  // namespace raycheck::tests
