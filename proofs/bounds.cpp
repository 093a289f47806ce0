#include "proofs/bounds.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "fast/internal/error_free.h"
#include "fast/internal/robust_guess.h"
#include "fast/internal/robust_residual.h"
#include "fast/internal/triple.h"
#include "reference/enclosure.h"
#include "reference/internal/double_double.h"
#include "reference/visibility/visibility_bound.h"
#include "reference/visibility/visibility_formula.h"
#include "scene/plan/bounds.h"
#include "scene/plan/eye_space.h"

namespace raycheck::proofs {
namespace {

using reference::Enclosure;
namespace fast_formula = fast::HWY_NAMESPACE;
namespace filter = reference::HWY_NAMESPACE;

/// A double with the operations of vectors, fused or not.
template <bool kFused>
struct Plain {
  double x;
  explicit Plain(double value) : x(value) {}
  friend Plain operator+(Plain a, Plain b) { return Plain(a.x + b.x); }
  friend Plain operator-(Plain a, Plain b) { return Plain(a.x - b.x); }
  friend Plain operator*(Plain a, Plain b) { return Plain(a.x * b.x); }
  friend Plain operator/(Plain a, Plain b) { return Plain(a.x / b.x); }
  friend Plain operator-(Plain a) { return Plain(-a.x); }
  friend Plain sqrt(Plain a) { return Plain(std::sqrt(a.x)); }
  friend Plain mul_add(Plain a, Plain b, Plain c) {
    return kFused ? Plain(std::fma(a.x, b.x, c.x)) : a * b + c;
  }
  friend Plain mul_sub(Plain a, Plain b, Plain c) { return mul_add(a, b, -c); }
  friend Plain sub_mul(Plain a, Plain b, Plain c) { return mul_add(-a, b, c); }
};

// The formulas. computed() calls the code's formula with any number type. exact() returns the exact
// value, and calls `note` with each magnitude that the bound is relative to. Errors are proved for
// noted magnitudes of at most kMost; this is enough, since the formulas are homogeneous. If a bound
// is relative to the value, noted magnitudes are above 0.

template <class N, std::size_t kCount>
using Inputs = std::array<N, kCount>;
template <class N>
using Values = std::vector<N>;

struct FilterB {
  static constexpr std::array kInputs = {"n", "beta", "alpha", "u", "v", "w"};
  static constexpr bool kIsRelative = false;
  static constexpr double kMost = 1;
  template <class N>
  static Values<N> computed(const Inputs<N, 6>& x) {
    return {filter::b_of(x[2], x[3], filter::row_terms(x[0], x[1], x[3], x[4], x[5]).b)};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 6>& x, const Note& note) {
    const N ahead = note(x[0] * x[5]), up = note(x[1] * x[4]), across = note(x[2] * x[3]);
    return {note(across + note(ahead + up))};
  }
};

struct FilterA {
  static constexpr std::array kInputs = {"n", "beta", "alpha", "u", "v", "w"};
  static constexpr bool kIsRelative = false;
  static constexpr double kMost = 1;
  template <class N>
  static Values<N> computed(const Inputs<N, 6>& x) {
    return {filter::a_of(x[2], filter::row_terms(x[0], x[1], x[3], x[4], x[5]).a)};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 6>& x, const Note& note) {
    const N ahead = note(x[0] * x[0]), up = note(x[1] * x[1]), across = note(x[2] * x[2]);
    return {note(across + note(ahead + up))};
  }
};

struct FilterDiscriminant {
  static constexpr std::array kInputs = {"b", "a", "c"};
  static constexpr bool kIsRelative = false;
  static constexpr double kMost = 1.03;  ///< b^ is at most 1.01 B.
  template <class N>
  static Values<N> computed(const Inputs<N, 3>& x) {
    return {filter::discriminant(x[0], x[1], x[2])};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 3>& x, const Note& note) {
    const N square = note(x[0] * x[0]), product = note(x[2] * x[1]);
    return {note(square + -product)};
  }
};

/// All components of f x g. Their products are noted.
struct FilterMoment {
  static constexpr std::array kInputs = {"n", "beta", "alpha", "u", "v", "w"};
  static constexpr bool kIsRelative = false;
  static constexpr double kMost = 1;
  template <class N>
  static Values<N> computed(const Inputs<N, 6>& x) {
    const auto row = filter::row_terms(x[0], x[1], x[3], x[4], x[5]);
    const filter::Moment<N> moment = filter::moment_of(x[2], x[4], x[5], row);
    return {moment.first, moment.second, moment.third};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 6>& x, const Note& note) {
    const N nv = note(x[0] * x[4]), beta_w = note(x[1] * x[5]);
    const N alpha_w = note(x[2] * x[5]), nu = note(x[0] * x[3]);
    const N alpha_v = note(-x[2] * x[4]), beta_u = note(x[1] * x[3]);
    return {note(nv - beta_w), note(alpha_w + -nu), note(alpha_v + beta_u)};
  }
};

struct FilterByMoment {
  static constexpr std::array kInputs = {"h1", "h2", "h3", "a", "R2"};
  static constexpr bool kIsRelative = false;
  /// |h^|^2 is at most (2 S + e)^2, and e at most S/kLeastMoment.
  static constexpr double kMost =
      (2 + 1 / reference::kLeastMoment) * (2 + 1 / reference::kLeastMoment);
  template <class N>
  static Values<N> computed(const Inputs<N, 5>& x) {
    return {filter::discriminant_by_moment(filter::Moment<N>{x[0], x[1], x[2]}, x[3], x[4])};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 5>& x, const Note& note) {
    const N first = note(x[0] * x[0]), second = note(x[1] * x[1]), third = note(x[2] * x[2]);
    const N all = note(third + note(second + first));
    return {note(note(x[4] * x[3]) + -all)};
  }
};

struct FastDot {
  static constexpr std::array kInputs = {"x", "y", "z"};
  static constexpr bool kIsRelative = true;
  static constexpr double kMost = 1;
  template <class N>
  static Values<N> computed(const Inputs<N, 3>& x) {
    const fast_formula::Triple<N> v = {x[0], x[1], x[2]};
    return {dot(v, v)};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 3>& x, const Note& note) {
    const N first = note(x[0] * x[0]), second = note(x[1] * x[1]), third = note(x[2] * x[2]);
    return {first + (second + third)};
  }
};

/// The length |d|.
struct FastNorm : FastDot {
  template <class N>
  static Values<N> computed(const Inputs<N, 3>& x) {
    return {norm(fast_formula::Triple<N>{x[0], x[1], x[2]})};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 3>& x, const Note& note) {
    return {sqrt(FastDot::exact(x, note).front())};
  }
};

/// d/|d| for positive coordinates, since signs do not matter.
struct FastUnit : FastDot {
  template <class N>
  static Values<N> computed(const Inputs<N, 3>& x) {
    const fast_formula::Triple<N> v = {x[0], x[1], x[2]};
    const fast_formula::Triple<N> unit = v / norm(v);
    return {unit.x, unit.y, unit.z};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 3>& x, const Note& note) {
    const N length = FastNorm::exact(x, note).front();
    return {note(x[0]) / length, note(x[1]) / length, note(x[2]) / length};
  }
};

/// T.D for given T and D, relative to the largest of its products and sums.
struct FastAxialDistance {
  static constexpr std::array kInputs = {"Tx", "Ty", "Tz", "Dx", "Dy", "Dz"};
  static constexpr bool kIsRelative = false;
  static constexpr double kMost = 1;
  template <class N>
  static Values<N> computed(const Inputs<N, 6>& x) {
    return {
        dot(fast_formula::Triple<N>{x[0], x[1], x[2]}, fast_formula::Triple<N>{x[3], x[4], x[5]})};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 6>& x, const Note& note) {
    const N first = note(x[0] * x[3]), second = note(x[1] * x[4]), third = note(x[2] * x[5]);
    return {note(first + note(second + third))};
  }
};

/// T x D, relative to the largest product.
struct FastMoment {
  static constexpr std::array kInputs = {"Tx", "Ty", "Tz", "Dx", "Dy", "Dz"};
  static constexpr bool kIsRelative = false;
  static constexpr double kMost = 1;
  template <class N>
  static Values<N> computed(const Inputs<N, 6>& x) {
    const fast_formula::Triple<N> moment =
        cross(fast_formula::Triple<N>{x[0], x[1], x[2]}, fast_formula::Triple<N>{x[3], x[4], x[5]});
    return {moment.x, moment.y, moment.z};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 6>& x, const Note& note) {
    const auto coordinate = [&](std::size_t j, std::size_t k) {
      const N first = note(x[j] * x[3 + k]), second = note(x[k] * x[3 + j]);
      return first - second;
    };
    return {coordinate(1, 2), coordinate(2, 0), coordinate(0, 1)};
  }
};

/// The first step of robust: a ray and a sphere with a given r^2.
struct RobustStep {
  static constexpr std::array kInputs = {"Cx", "Cy", "Cz", "Ox", "Oy",
                                         "Oz", "dx", "dy", "dz", "R2"};
  static constexpr bool kIsRelative = false;
  static constexpr double kMost = 1;
  template <class N>
  static fast_formula::Triple<N> difference(const Inputs<N, 10>& x) {
    return fast_formula::Triple<N>{x[0], x[1], x[2]} - fast_formula::Triple<N>{x[3], x[4], x[5]};
  }
  template <class N>
  static fast_formula::Triple<N> direction(const Inputs<N, 10>& x) {
    return {x[6], x[7], x[8]};
  }
  template <class N>
  static fast_formula::Coefficients<N> coefficients(const Inputs<N, 10>& x) {
    return fast_formula::coefficients<N>(difference(x), direction(x), x[9]);
  }
  template <class N>
  static std::array<N, 3> to_centre(const Inputs<N, 10>& x) {
    return {x[0] - x[3], x[1] - x[4], x[2] - x[5]};
  }
};

/// The bound is relative to a (f^2 + r^2), which bounds all noted magnitudes.
struct RobustDiscriminant : RobustStep {
  template <class N>
  static N scale(const Inputs<N, 10>& x) {
    const auto T = to_centre(x);
    return (x[6] * x[6] + (x[7] * x[7] + x[8] * x[8])) *
           ((T[0] * T[0] + (T[1] * T[1] + T[2] * T[2])) + abs(x[9]));
  }
};

struct RobustB : RobustStep {
  template <class N>
  static Values<N> computed(const Inputs<N, 10>& x) {
    return {coefficients(x).b};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 10>& x, const Note& note) {
    const auto T = to_centre(x);
    const N first = note(T[0] * x[6]), second = note(T[1] * x[7]), third = note(T[2] * x[8]);
    return {note(first + note(second + third))};
  }
};

struct RobustC : RobustStep {
  template <class N>
  static Values<N> computed(const Inputs<N, 10>& x) {
    return {coefficients(x).c};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 10>& x, const Note& note) {
    const auto T = to_centre(x);
    const N first = note(T[0] * T[0]), second = note(T[1] * T[1]), third = note(T[2] * T[2]);
    const N f_sq = note(first + note(second + third));
    return {note(f_sq - note(x[9]))};
  }
};

struct RobustNear : RobustDiscriminant {
  template <class N>
  static Values<N> computed(const Inputs<N, 10>& x) {
    const auto [a, b, distance_sq, c] = coefficients(x);
    return {fast_formula::near_discriminant<N>(a, b, c)};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 10>& x, const Note& note) {
    const auto T = to_centre(x);
    const N b = note(note(T[0] * x[6]) + note(note(T[1] * x[7]) + note(T[2] * x[8])));
    const N f_sq = note(note(T[0] * T[0]) + note(note(T[1] * T[1]) + note(T[2] * T[2])));
    const N a = note(note(x[6] * x[6]) + note(note(x[7] * x[7]) + note(x[8] * x[8])));
    return {note(note(b * b) + -note(a * note(f_sq - note(x[9]))))};
  }
};
struct RobustFar : RobustDiscriminant {
  template <class N>
  static Values<N> computed(const Inputs<N, 10>& x) {
    const auto T = difference(x), d = direction(x);
    return {fast_formula::far_discriminant<N>(T, d, fused_dot(d, d), x[9])};
  }
  template <class N, class Note>
  static Values<N> exact(const Inputs<N, 10>& x, const Note& note) {
    const auto T = to_centre(x);
    const auto component = [&](std::size_t j, std::size_t k) {
      const N first = note(T[j] * x[6 + k]), second = note(T[k] * x[6 + j]);
      return note(first - second);
    };
    const N mx = component(1, 2), my = component(2, 0), mz = component(0, 1);
    const N moment_sq = note(mx * mx + note(my * my + mz * mz));
    const N xx = note(x[6] * x[6]), yy = note(x[7] * x[7]), zz = note(x[8] * x[8]);
    return {note(note(note(xx + note(yy + zz)) * note(x[9])) + -moment_sq)};
  }
};

template <class N, std::size_t... k>
auto terms(Script& script, const auto& names, std::index_sequence<k...> /*all*/) {
  return Inputs<N, sizeof...(k)>{N(script, names[k])...};
}

constexpr double kUnit = 0x1p-53;

/// The script that compares a formula, fused and not, with the exact value.
template <class F>
Script traced(double bound, std::optional<Mutation> mutation) {
  Script script(Rounding::kRelative, mutation);
  constexpr auto kAll = std::make_index_sequence<F::kInputs.size()>();
  const auto note = [&](const Term<false>& term) {
    script.suppose(F::kIsRelative
                       ? fmt::format("{} in [1b-2000, 1b2000]", term.name())
                       : fmt::format("|{}| <= {}", term.name(), in_hexadecimal(F::kMost)));
    return term;
  };
  const Values<Term<false>> exact = F::exact(terms<Term<false>>(script, F::kInputs, kAll), note);
  const std::string most = in_hexadecimal(bound * kUnit);
  for (const bool is_fused : {true, false}) {
    if (!is_fused && !script.has_fused()) break;
    script.fuse(is_fused);
    const Values<Term<true>> computed = F::computed(terms<Term<true>>(script, F::kInputs, kAll));
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const std::string &got = computed.at(k).name(), &right = exact[k].name();
      script.prove(F::kIsRelative ? fmt::format("{0} -/ {1} in [-{2}, {2}]", got, right, most)
                                  : fmt::format("|{} - {}| <= {}", got, right, most));
    }
  }
  return script;
}

class Random {
 public:
  double number() {
    const double size = std::ldexp(1 + share(), static_cast<int>(bits_() % 7) - 3);
    return bits_() % 2 == 0 ? size : -size;
  }
  std::size_t below(std::size_t count) { return bits_() % count; }
  double share() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 bits_{1};
};

constexpr int kBits = 300;
Enclosure sum(double x, double y) { return Enclosure(x, kBits) + Enclosure(y, kBits); }

/// The largest error found, for random inputs and for the worst input so far with one number
/// replaced. It is in u of the scale, of the largest noted magnitude or of the exact value.
template <class F>
double observed_of(int samples) {
  constexpr std::size_t kCount = F::kInputs.size();
  constexpr auto kAll = std::make_index_sequence<kCount>();
  Random random;
  double largest = 0;
  std::array<double, kCount> worst{};
  for (int sample = 0; sample < samples; ++sample) {
    std::array<double, kCount> x = worst;
    if (sample < samples / 4) {
      for (double& one : x) one = random.number();
    } else {
      x.at(random.below(kCount)) = random.number();
    }
    const auto given = [&]<class N, std::size_t... k>(auto make, N*, std::index_sequence<k...>) {
      return Inputs<N, kCount>{make(x[k])...};
    };
    const auto enclosed = [](double one) { return Enclosure(one, kBits); };
    Enclosure scale(0.0, kBits);
    const auto note = [&](const Enclosure& term) {
      if (abs(term).upper() > scale.upper()) scale = abs(term);
      return term;
    };
    const Values<Enclosure> exact =
        F::exact(given(enclosed, static_cast<Enclosure*>(nullptr), kAll), note);
    if constexpr (requires { F::template scale<Enclosure>; })
      scale = abs(F::scale(given(enclosed, static_cast<Enclosure*>(nullptr), kAll)));
    const auto compare = [&]<bool kFused>(std::bool_constant<kFused>) {
      using N = Plain<kFused>;
      const auto plain = [](double one) { return N(one); };
      const Values<N> got = F::computed(given(plain, static_cast<N*>(nullptr), kAll));
      for (std::size_t at = 0; at < exact.size(); ++at) {
        const Enclosure unit =
            (F::kIsRelative ? abs(exact[at]) : scale) * Enclosure(kUnit / F::kMost, kBits);
        const Enclosure error = abs(Enclosure(got.at(at).x, kBits) - exact[at]);
        const double found = (error / unit).lower();
        if (found <= largest) continue;
        largest = found;
        worst = x;
      }
    };
    compare(std::true_type());
    compare(std::false_type());
  }
  return largest;
}

using Rounded = Term<true>;

/// The script for widening: the ends around x, the double to which a real z rounds.
Script traced_widening(double bound, std::optional<Mutation> mutation) {
  Script script(Rounding::kToDouble, mutation);
  for (const auto& [x, z, magnitude, range] :
       {std::array{"x", "z", "x", "[1, 2]"}, {"y", "w", "(-y)", "[-2, -1]"}}) {
    script.define(x, fmt::format("rnd({})", z));
    script.suppose(fmt::format("{} in {}", z, range));
    const std::string low =
        scene::lowered(Rounded(script, x), Rounded(script, magnitude), bound * kUnit).name();
    const std::string by = (Rounded(script, magnitude) * Rounded(bound * kUnit)).name();
    // Beyond -2 the ulp is twice as large, and so is the last rounding.
    const int most = scene::kBoundsMaxUlp + (range[1] == '-' ? 1 : 0);
    script.prove(fmt::format("{} - {} in [-{}b-52, 0]", low, z, most));
    script.rewrite(
        fmt::format("{0} - {1} -> ({0} - ({2} - {3})) + ({2} - {1}) - {3}", low, z, x, by));
  }
  return script;
}

double observed_widening(int samples) {
  Random random;
  double largest = 0;
  for (int sample = 0; sample < samples; ++sample) {
    // A real halfway between two doubles is farthest from the double to which it rounds.
    const double x = random.number();
    const double gap = std::nextafter(std::abs(x), HUGE_VAL) - std::abs(x);
    largest = std::max(largest, gap / 2 / (std::abs(x) * kUnit));
  }
  return largest;
}

/// The script for coarse() with scale 1. Its results are multiples of 2^-53, and within the bound
/// from x if |x| <= 1/2. Sums of results that are below 0.55 are exact.
Script traced_coarse(double bound, std::optional<Mutation> mutation) {
  Script script(Rounding::kToDouble, mutation);
  for (const auto& [x, z, range, most] :
       {std::array<std::string, 4>{"x", "z", "[0, 0.5]", in_hexadecimal(bound * kUnit)},
        {"y", "w", "[0.5, 65536]", "1b-36"}}) {
    script.define(x, fmt::format("rnd({})", z));
    script.suppose(fmt::format("|{}| in {}", x, range));
    const std::string high = fast_formula::coarse(Rounded(script, x), Rounded(1.0)).name();
    const std::string sum = (Rounded(script, x) + Rounded(1.0)).name();
    script.rewrite(fmt::format("{0} - {1} -> ({0} - ({2} - 1)) + ({2} - ({1} + 1))", high, x, sum));
    script.prove(fmt::format("@FIX({}, -53)", high));
    script.prove(fmt::format("|{} - {}| <= {}", high, x, most));
  }
  for (const char* part : {"p", "q"}) script.suppose(fmt::format("@FIX({}, -53)", part));
  script.suppose("|p + q| <= 0.55");
  const std::string sum = (Rounded(script, "p") + Rounded(script, "q")).name();
  script.prove(fmt::format("{} - (p + q) in [0, 0]", sum));
  return script;
}

double observed_coarse(int samples) {
  Random random;
  double largest = 0;
  for (int sample = 0; sample < samples; ++sample) {
    const double x = random.share() - 0.5;
    largest = std::max(largest, std::abs(fast_formula::coarse(x, 1.0) - x) / kUnit);
  }
  return largest;
}

/// The largest V. The low part of the residual is proved for given w, v and rests, r = 1 and this
/// V, since its terms shrink at least in proportion to V.
constexpr double kLargestV = 0x1p-17;
constexpr double most_of_low(std::size_t input) {
  return input < 3 ? 1.01 : input < 6 ? kLargestV : 0.32 * kLargestV;
}
constexpr std::array kLowInputs = {"wx", "wy", "wz", "vx", "vy", "vz", "px", "py", "pz", "pr"};
template <class N>
N computed_low(const Inputs<N, 10>& x) {
  return fast_formula::low_of_residual<N>({x[0], x[1], x[2]}, {x[3], x[4], x[5]},
                                          {x[6], x[7], x[8]}, x[9]);
}
template <class N>
N exact_low(const Inputs<N, 10>& x) {
  const auto coordinate = [&](std::size_t k) {
    return (N(2) * x[k] + x[3 + k]) * x[3 + k] + x[6 + k];
  };
  return (coordinate(0) + coordinate(1)) + (coordinate(2) - x[9]);
}

Script traced_low(double bound, std::optional<Mutation> mutation) {
  Script script(Rounding::kRelative, mutation);
  constexpr auto kAll = std::make_index_sequence<kLowInputs.size()>();
  for (std::size_t k = 0; k < kLowInputs.size(); ++k) {
    script.suppose(fmt::format("|{}| <= {}", kLowInputs.at(k), in_hexadecimal(most_of_low(k))));
  }
  const std::string exact = exact_low(terms<Term<false>>(script, kLowInputs, kAll)).name();
  for (const bool is_fused : {true, false}) {
    script.fuse(is_fused);
    const std::string got = computed_low(terms<Rounded>(script, kLowInputs, kAll)).name();
    script.prove(
        fmt::format("|{} - {}| <= {}", got, exact, in_hexadecimal(bound * kUnit * kLargestV)));
  }
  return script;
}

double observed_low(int samples) {
  Random random;
  double largest = 0;
  for (int sample = 0; sample < samples; ++sample) {
    std::array<double, 10> x;
    for (std::size_t k = 0; k < x.size(); ++k) {
      x[k] = (2 * random.share() - 1) * most_of_low(k);
    }
    const auto given = [&]<class N, std::size_t... k>(auto make, N*, std::index_sequence<k...>) {
      return Inputs<N, 10>{make(x[k])...};
    };
    constexpr auto kAll = std::make_index_sequence<10>();
    const auto enclosed = [](double one) { return Enclosure(one, kBits); };
    const auto plain = [](double one) { return Plain<false>(one); };
    const double got = computed_low(given(plain, static_cast<Plain<false>*>(nullptr), kAll)).x;
    const Enclosure exact = exact_low(given(enclosed, static_cast<Enclosure*>(nullptr), kAll));
    const Enclosure error = abs(Enclosure(got, kBits) - exact);
    largest = std::max(largest, (error / Enclosure(kUnit * kLargestV, kBits)).lower());
  }
  return largest;
}

/// The script for the low part of a x - b y, with x and y in two parts, by exact products whose
/// sizes add up to 1.
Script traced_determinant(double bound, std::optional<Mutation> mutation) {
  Script script(Rounding::kRelative, mutation);
  const auto name = [&](const char* of) { return Rounded(script, of); };
  script.define("first", "mul(a, x)");
  script.define("second", "mul(b, y)");
  script.define("leading", "sub(first, second)");
  script.define("of_first", "a * x - first");  // exact: fma
  script.define("of_second", "b * y - second");
  script.define("of_difference", "(first - second) - leading");  // exact: two_difference
  for (const char* one : {"a * x", "b * y", "a * x - b * y"}) {
    script.suppose(fmt::format("|{}| <= 1", one));
  }
  for (const char* one : {"a * x_rest", "b * y_rest"}) {
    script.suppose(fmt::format("|{}| <= 1b-53", one));
  }
  const std::string rest =
      scene::rest_of_determinant(name("of_difference"), name("of_first"), name("of_second"),
                                 name("a"), name("x_rest"), name("b"), name("y_rest"))
          .name();
  script.define("all", "of_difference + ((of_first - of_second) + (a * x_rest - b * y_rest))");
  script.prove(fmt::format("|{} - all| <= {}", rest,
                           in_hexadecimal(bound * reference::kSlack * kUnit * kUnit)));
  script.rewrite("first - second -> (a * x - b * y) - (of_first - of_second)");
  return script;
}

double observed_determinant(int samples) {
  Random random;
  double largest = 0;
  for (int sample = 0; sample < samples; ++sample) {
    // Near 1, roundings are a large share, and so are the parts of two differences.
    const auto near_one = [&] { return 1 + random.share() / 16; };
    const double a = near_one(), b = near_one(), x = near_one();
    const double y = sample % 2 == 0 ? -near_one() : -near_one() / 2;
    const double x_rest = (random.share() - 0.5) * 0x1p-52;
    const double y_rest = y * (random.share() - 0.5) * 0x1p-52;
    const double first = a * x, second = b * y, leading = first - second;
    const double of_y = first - leading;
    const double of_difference = (first - (leading + of_y)) + (of_y - second);
    const double rest = scene::rest_of_determinant(of_difference, std::fma(a, x, -first),
                                                   std::fma(b, y, -second), a, x_rest, b, y_rest);
    const Enclosure exact =
        Enclosure(a, kBits) * sum(x, x_rest) - Enclosure(b, kBits) * sum(y, y_rest);
    const Enclosure error = sum(leading, rest) - exact;
    const double unit = kUnit * kUnit * (std::abs(first) + std::abs(second));
    largest = std::max(largest, (abs(error) / Enclosure(unit, kBits)).lower());
  }
  return largest;
}

/// Defines two numbers with high and low parts, |high| from 1 to 2.
void define_pairs(Script& script) {
  for (const char* high : {"ah", "bh"}) script.suppose(fmt::format("{} in [1, 2]", high));
  for (const char* low : {"al", "bl"}) script.suppose(fmt::format("|{}| <= 1b-53", low));
}

Script traced_product(double bound, std::optional<Mutation> mutation) {
  Script script(Rounding::kToDouble, mutation);
  const auto name = [&](const char* of) { return Rounded(script, of); };
  script.define("p", "rnd(ah * bh)");
  script.define("error", "ah * bh - p");  // exact: fma
  define_pairs(script);
  const std::string rest =
      reference::rest_of_product(name("error"), name("ah"), name("al"), name("bh"), name("bl"))
          .name();
  script.define("left", "(ah * bl + al * bh) + al * bl");
  script.prove(fmt::format("|((error + left) - {}) / p| <= {}", rest,
                           in_hexadecimal(bound * kUnit * kUnit)));
  script.rewrite(
      fmt::format("(error + left) - {0} -> ((error + (ah * bl + al * bh)) - {0}) + al * bl", rest));
  return script;
}

Script traced_quotient(double bound, std::optional<Mutation> mutation) {
  Script script(Rounding::kToDouble, mutation);
  const auto name = [&](const char* of) { return Rounded(script, of); };
  script.define("q", "rnd(ah / bh)");
  script.define("of_high", "ah - q * bh");  // exact: fma
  define_pairs(script);
  const Rounded remainder =
      reference::remainder_of_quotient(name("of_high"), name("al"), name("q"), name("bl"));
  const std::string r = remainder.name(), rest = (remainder / name("bh")).name();
  script.define("X", "(of_high + al) - q * bl");
  script.define("M", "X / (bh + bl)");
  script.prove(fmt::format("|({} - M) / q| <= {}", rest, in_hexadecimal(bound * kUnit * kUnit)));
  script.rewrite("of_high -> bh * (ah / bh - q) { bh <> 0 }");
  script.rewrite(
      fmt::format("{0} - M -> ({0} - {1} / bh) + (({1} - X) / bh + X * bl / (bh * (bh + "
                  "bl))) {{ bh <> 0, bh + bl <> 0 }}",
                  rest, r));
  script.rewrite("$ q in (1)");
  return script;
}

/// The script for the root S, from 1 to 2, of a number whose high part is Q^2.
Script traced_root(double bound, std::optional<Mutation> mutation) {
  Script script(Rounding::kToDouble, mutation);
  const auto name = [&](const char* of) { return Rounded(script, of); };
  script.define("h", "rnd(Q)");
  script.define("of_high", "Q * Q - h * h");  // exact: fma
  script.define("al", "S * S - Q * Q");
  script.suppose("S in [1, 2]");
  script.suppose("Q in [1, 2]");
  script.suppose("|al / (Q * Q)| <= 1b-53");
  const Rounded remainder = reference::remainder_of_root(name("of_high"), name("al"));
  const std::string r = remainder.name(),
                    rest = reference::rest_of_root(remainder, name("h")).name();
  script.prove(
      fmt::format("|(h + {} - S) / h| <= {}", rest, in_hexadecimal(bound * kUnit * kUnit)));
  script.rewrite(
      fmt::format("h + {0} - S -> ({0} - {1} / (2 * h)) + (({1} - (of_high + al)) / (2 * h) + "
                  "(h - S) * (h - S) / (2 * h)) {{ h <> 0 }}",
                  rest, r));
  script.rewrite("h - S -> (h - Q) - al / (Q * Q) * (Q * Q) / (S + Q) { Q * Q <> 0, S + Q <> 0 }");
  script.rewrite("of_high -> (Q - h) * (Q + h)");
  script.rewrite("$ S in 4");
  return script;
}

/// The largest error of an operation on random numbers of two parts, in u^2 of its leading part.
template <class Operate>
double observed_pairs(int samples, const Operate& operate) {
  Random random;
  double largest = 0;
  for (int sample = 0; sample < samples; ++sample) {
    double high[2], low[2];
    for (int k = 0; k < 2; ++k) {
      high[k] = 1 + random.share();
      low[k] = (random.share() - 0.5) * 0x1p-52;
    }
    const auto [leading, rest, exact] = operate(high, low);
    const Enclosure error = Enclosure(leading, kBits) + Enclosure(rest, kBits) - exact;
    const double unit = kUnit * kUnit * leading;
    largest = std::max(largest, (abs(error) / Enclosure(unit, kBits)).lower());
  }
  return largest;
}
struct PairResult {
  double leading, rest;
  Enclosure exact;
};

double observed_product(int samples) {
  return observed_pairs(samples, [](const double* high, const double* low) {
    const double p = high[0] * high[1];
    const double rest = reference::rest_of_product(std::fma(high[0], high[1], -p), high[0], low[0],
                                                   high[1], low[1]);
    return PairResult{p, rest, sum(high[0], low[0]) * sum(high[1], low[1])};
  });
}

double observed_quotient(int samples) {
  return observed_pairs(samples, [](const double* high, const double* low) {
    const double q = high[0] / high[1];
    const double remainder =
        reference::remainder_of_quotient(std::fma(-q, high[1], high[0]), low[0], q, low[1]);
    return PairResult{q, remainder / high[1], sum(high[0], low[0]) / sum(high[1], low[1])};
  });
}

double observed_root(int samples) {
  return observed_pairs(samples, [](const double* high, const double* low) {
    const double a = high[0] * high[1], h = std::sqrt(a), a_low = low[0];
    const double rest =
        reference::rest_of_root(reference::remainder_of_root(std::fma(-h, h, a), a_low), h);
    return PairResult{h, rest, sqrt(sum(a, a_low))};
  });
}

template <class F>
Bound stage(std::string_view name, std::string_view what, std::string_view where, double value) {
  // kSlack covers terms of second order.
  return {name,
          what,
          where,
          value,
          "u",
          [](double bound, std::optional<Mutation> mutation) {
            return traced<F>(bound * reference::kSlack, mutation);
          },
          observed_of<F>};
}

constexpr std::string_view kFormula = "reference/visibility/visibility_formula.h";
constexpr std::string_view kPairs = "reference/internal/double_double.h";
constexpr std::string_view kRobust = "fast/internal/robust_guess.h";
constexpr std::string_view kTriple = "fast/internal/triple.h";

}  // namespace

std::span<const Bound> bounds() {
  static const std::array all = {
      stage<FilterB>("filter-b", "the image filter's b, relative to B", kFormula,
                     reference::kSumRoundings),
      stage<FilterA>("filter-a", "the image filter's a, relative to A", kFormula,
                     reference::kSumRoundings),
      stage<FilterDiscriminant>("filter-discriminant",
                                "b^2 - c a for given b, c, a, relative to B^2 + |c| A", kFormula,
                                reference::kDiscRoundings),
      stage<FilterMoment>("filter-moment",
                          "the components of f x g, relative to their largest product or sum",
                          kFormula, reference::kMomentRoundings),
      stage<FilterByMoment>("filter-by-moment",
                            "r^2 a - |h|^2 for given r^2, a, h, relative to S^2", kFormula,
                            reference::kByMomentRoundings),
      Bound{"bounds-widening", "the widening of a double to a bound of the real that rounds to it",
            "scene/plan/bounds_formula.h", scene::kBoundsWiden / kUnit, "u", traced_widening,
            observed_widening},
      Bound{"determinant", "the low part of a x - b y by exact products, relative to |a x| + |b y|",
            "scene/plan/eye_space.h", scene::kDeterminantRoundings, "u^2", traced_determinant,
            observed_determinant},
      Bound{"double-double-product", "a product of double-doubles, relative to it", kPairs,
            reference::kDoubleDoubleProductError / (kUnit * kUnit), "u^2", traced_product,
            observed_product},
      Bound{"double-double-quotient", "a quotient of double-doubles, relative to it", kPairs,
            reference::kDoubleDoubleQuotientError / (kUnit * kUnit), "u^2", traced_quotient,
            observed_quotient},
      Bound{"double-double-root", "a square root of a double-double, relative to it", kPairs,
            reference::kDoubleDoubleRootError / (kUnit * kUnit), "u^2", traced_root, observed_root},
      stage<RobustB>("robust-b", "b of robust's first step, relative to f |d|", kRobust,
                     fast_formula::kRobustB),
      stage<RobustC>("robust-c", "robust's c for given r^2, relative to f^2 + r^2", kRobust,
                     fast_formula::kRobustC),
      stage<RobustNear>("robust-near", "robust's b^2 - a c, relative to a (f^2 + r^2)", kRobust,
                        fast_formula::kRobustNear),
      stage<RobustFar>("robust-far", "robust's a r^2 - |m|^2, relative to a (f^2 + r^2)", kRobust,
                       fast_formula::kRobustFar),
      Bound{"robust-coarse", "the parts of robust's residual, relative to the scale",
            "fast/internal/error_free.h", 1, "u", traced_coarse, observed_coarse},
      Bound{"robust-low", "the low part of robust's residual, relative to V r",
            "fast/internal/robust_residual.h", fast_formula::kRobustLow, "u", traced_low,
            observed_low},
      stage<FastDot>("a", "a = |d|^2", kTriple, 3),
      stage<FastNorm>("norm", "|d|", kTriple, 2.5),
      stage<FastUnit>("unit-direction", "the coordinates of d/|d|", kTriple, 3.5),
      stage<FastAxialDistance>("axial-distance", "v = T.D, relative to its largest product or sum",
                               kTriple, 5),
      stage<FastMoment>("moment", "the coordinates of T x D, relative to their largest product",
                        kTriple, 4),
  };
  return all;
}

}  // namespace raycheck::proofs
