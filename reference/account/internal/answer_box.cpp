#include "reference/account/internal/answer_box.h"

#include <cmath>
#include <utility>

#include "reference/account/internal/condition_impl.h"
#include "reference/internal/classify.h"

namespace raycheck::reference {
namespace {

/// The number of inputs of a ray and a sphere, plus 1 for the answer's s.
constexpr int kMostInputs = kCameraInputs + 1;

constexpr EnclosureLift kUnchanged{kVariationBits};

}  // namespace

template <class Lift, class Use>
auto AnswerBox::with_pair(const Lift& lift, Use use) const {
  const auto line = line_of(lift, ray_.source());
  return use(line_and_sphere(line, lift_sphere(lift, sphere_)));
}

AnswerBox::AnswerBox(const ExactRay& ray, const scene::Sphere& sphere, const Neighbourhood& around,
                     const std::optional<double>& answer)
    : ray_(ray), sphere_(sphere), around_(around), answer_(answer) {
  if (!answer_) return;
  const Enclosure s(*answer_, kVariationBits);
  slack_ = slack_of_answer();
  const Enclosure least = (s - slack_).certain_sign().value_or(-1) > 0 ? s - slack_ : Enclosure(0);
  middle_ = (least + s + slack_) * Enclosure(0.5, kVariationBits);
  half_width_ = s + slack_ - middle_;
  std::vector<Enclosure> reach = reach_of(Decider::kAtAnswer, kUnchanged, s, Enclosure(0));
  reach.pop_back();
  reach_ = sum_of_sizes(reach);
}

std::vector<double> AnswerBox::middle() const {
  const int inputs = ray_.source().camera ? kCameraInputs : kGivenInputs;
  return std::vector<double>(static_cast<std::size_t>(inputs) + 1);
}

std::vector<double> AnswerBox::sizes() const {
  std::vector<double> result = inputs_of(ray_, {&sphere_, 1});
  for (double& x : result) x = std::abs(x);
  return result;
}

/// The error of s that is allowed.
Enclosure AnswerBox::slack_of_answer() const {
  const auto largest = [](const auto& v) {
    Enclosure most(0);
    for (int axis = 0; axis < 3; ++axis) {
      const Enclosure size = abs(v[axis]);
      if ((size - most).certain_sign().value_or(0) > 0) most = size;
    }
    return most;
  };
  Enclosure scale = with_pair(kUnchanged, [&](const auto& pair) {
    const Enclosure size = largest(to_centre(pair));
    return pair.line.is_unit ? size : size / largest(pair.line.g);
  });
  return (Enclosure(*answer_, kVariationBits) + scale) *
         Enclosure(around_.relative_change, kVariationBits);
}

/// How far each input and s can move the values, from the slopes at lifted inputs and within `off`
/// of s.
template <std::size_t N, class BaseLift, class Values>
std::array<std::vector<Enclosure>, N> AnswerBox::reaches_of(const Values& values,
                                                            const BaseLift& base,
                                                            const Enclosure& s,
                                                            const Enclosure& off) const {
  const DualLift<BaseLift, kMostInputs> lift{base};
  Enclosure around_s = s;
  arb_add_error(around_s.ball(), off.ball());
  const auto varied =
      with_pair(lift, [&](const auto& pair) { return values(pair, lift.input(around_s)); });
  const int inputs = lift.count() - 1;
  const Enclosure change(around_.relative_change, kVariationBits);
  std::array<std::vector<Enclosure>, N> reaches;
  for (std::size_t i = 0; i < N; ++i) {
    for (int k = 0; k <= inputs; ++k) {
      reaches[i].push_back(!varied[i].depends_on(k) ? Enclosure(0)
                           : k < inputs ? varied[i].derivative(k) * lift.input_value(k) * change
                                        : varied[i].derivative(k) * half_width_);
    }
  }
  return reaches;
}

template <class BaseLift>
std::vector<Enclosure> AnswerBox::reach_of(Decider decider, const BaseLift& base,
                                           const Enclosure& s, const Enclosure& off) const {
  const auto value = [&](const auto& pair, const auto& at) {
    return std::array{value_of(decider, pair, at)};
  };
  std::vector<Enclosure> reach = std::move(reaches_of<1>(value, base, s, off)[0]);
  if (!moves_answer(decider)) reach.back() = Enclosure(0);
  return reach;
}

template <class Vector, class Length>
VectorAndLength AnswerBox::over_box(const Vector& vector, const Length& length) const {
  const auto values = [&](const auto& pair, const auto& s) {
    const auto v = vector(pair, s);
    return std::array{v.x(), v.y(), v.z(), length(pair)};
  };
  auto middle = with_pair(kUnchanged, [&](const auto& pair) { return values(pair, middle_); });
  auto reaches = reaches_of<4>(values, EnclosureLift{kVariationBits, around_.relative_change},
                               middle_, half_width_);
  const auto variation = [&](std::size_t i) {
    Variation result{std::move(middle[i]), std::move(reaches[i])};
    result.most = sum_of_sizes(result.reach);
    return result;
  };
  return {{variation(0), variation(1), variation(2)}, variation(3)};
}

VectorAndLength AnswerBox::moment() const {
  return over_box(
      [](const auto& pair, const auto& /*s*/) { return CGAL::cross_product(pair.f, pair.line.g); },
      [](const auto& pair) { return pair.radius * ray_length(pair.line); });
}

VectorAndLength AnswerBox::from_answer() const {
  return over_box([](const auto& pair, const auto& s) { return from_point_at(pair, s); },
                  [](const auto& pair) { return pair.radius; });
}

std::array<double, 3> AnswerBox::direction() const {
  const auto g = line_of(kUnchanged, ray_.source()).g;
  return {g.x().lower(), g.y().lower(), g.z().lower()};
}

const Variation& AnswerBox::variation(Decider decider) {
  auto& known = variations_[static_cast<std::size_t>(decider)];
  if (!known) {
    const EnclosureLift whole{kVariationBits, around_.relative_change};
    const bool moves = moves_answer(decider);
    known = Variation{value_at(decider, middle()),
                      reach_of(decider, whole, moves ? middle_ : at_answer(),
                               moves ? half_width_ : Enclosure(0))};
    known->most = sum_of_sizes(known->reach);
  }
  return *known;
}

Variation AnswerBox::variation_at(Decider decider, const std::vector<double>& t) const {
  const InputChange change = change_at(t);
  Variation result{value_at(decider, t),
                   reach_of(decider, ChangedLift(kVariationBits, change),
                            moves_answer(decider) ? parameter_at(t) : at_answer(), Enclosure(0))};
  result.most = sum_of_sizes(result.reach);
  result.at = t;
  return result;
}

Enclosure AnswerBox::value_at(Decider decider, const std::vector<double>& t) const {
  const InputChange change = change_at(t);
  return with_pair(ChangedLift(kFirstWitnessBits, change), [&](const auto& pair) {
    return value_of(decider, pair, moves_answer(decider) ? parameter_at(t) : at_answer());
  });
}

Enclosure AnswerBox::at_answer() const { return Enclosure(*answer_, kFirstWitnessBits); }

Enclosure AnswerBox::most_near_double_root() {
  const EnclosureLift whole{kVariationBits, around_.relative_change};
  return sqrt(reach_ * line_of(whole, ray_.source()).a);
}

Enclosure AnswerBox::parameter_at(const std::vector<double>& t) const {
  return middle_ + Enclosure(t.back(), kFirstWitnessBits) * half_width_;
}

InputChange AnswerBox::change_at(const std::vector<double>& t) const {
  InputChange change(t.begin(), t.end() - 1);
  for (double& share : change) share *= around_.relative_change;
  return change;
}

/// How the ray and the sphere meet with changed inputs; empty if balls cannot decide.
std::optional<Intersection> AnswerBox::intersect_changed(const InputChange& change) const {
  for (int bits = kFirstWitnessBits; bits <= kLastWitnessBits; bits *= 4) {
    const auto at = with_pair(ChangedLift(bits, change), [&](const auto& pair) {
      return classify([&](Coefficient coefficient) { return sign_of(coefficient, pair); },
                      around_.root);
    });
    if (at) return at;
  }
  return std::nullopt;
}

bool AnswerBox::is_right(const InputChange& change) const {
  const auto at = intersect_changed(change);
  if (!at || counts_as_hit(at->hit_class, around_.tangent) != answer_.has_value()) return false;
  if (!answer_) return true;
  return with_pair(ChangedLift(kFirstWitnessBits, change), [&](const auto& pair) {
    const Line<EnclosureKernel>& line = pair.line;
    const Enclosure length = line.is_unit ? ray_length(line) : Enclosure(1);
    const Enclosure mu = ray_parameter(pair, root_sign(*at)) / length;
    const Enclosure off = abs(mu - Enclosure(*answer_, kFirstWitnessBits) / length);
    if ((off - slack_ / length).certain_sign().value_or(1) <= 0) return true;
    const Enclosure to_middle = abs(linear_coefficient(pair) - line.a * mu);
    const Enclosure apart = line.a * off + to_middle + to_middle;  // a (|s - s'| + |s' - s''|)
    return (apart * apart - reach_ * line.a).certain_sign().value_or(1) <= 0;
  });
}

}  // namespace raycheck::reference
