#include "reference/account/internal/choice_forms.h"

#include <utility>

namespace raycheck::reference {
namespace {

/// The value of `what` in a condition. `sphere` and `favourite` return two lifted spheres;
/// `favourite` is called only if needed. The signed distance of the favourite's root from the
/// middle of its two roots, times a, is `off` if that is set, and is computed otherwise.
template <class K, class Sphere, class Favourite>
typename K::FT value_of(const ChoiceCondition& condition, const Line<K>& line, Sphere sphere,
                        Favourite favourite, const std::optional<Enclosure>& off) {
  using FT = typename K::FT;
  const SphereInputs<K> inputs = sphere();
  const auto pair = line_and_sphere(line, inputs);
  const auto with_sign = [](int sign, const FT& value) { return sign < 0 ? FT(-value) : value; };
  switch (condition.what) {
    case ChoiceCondition::What::kDiscriminant:
      return with_sign(condition.sign, discriminant(pair));
    case ChoiceCondition::What::kConstant:
      return with_sign(condition.sign, constant_coefficient(pair));
    case ChoiceCondition::What::kLinear:
      return with_sign(condition.sign, linear_coefficient(pair));
    default:
      break;
  }
  const SphereInputs<K> other = favourite();
  const auto first = line_and_sphere(line, other);
  const typename K::Vector_3 apart = inputs.centre - other.centre;
  const FT middles_apart = apart * line.g;
  const FT first_off =
      off ? FT(*off) : root_of(FT(0), discriminant(first), condition.favourite_root);
  if (condition.what == ChoiceCondition::What::kAfter) {
    return middles_apart + root_of(FT(0), discriminant(pair), condition.root) - first_off;
  }
  if (condition.what == ChoiceCondition::What::kBeforeMiddle) return middles_apart - first_off;
  const FT at_first = linear_coefficient(first) + first_off;
  return with_sign(-condition.root,
                   line.a * (constant_coefficient(pair) - constant_coefficient(first)) -
                       FT(2) * middles_apart * at_first);
}

}  // namespace

Enclosure PartLift::operator()(double value) const {
  const std::size_t k = next_++;
  const Enclosure x(value, bits_);
  if (value == 0) return x;
  Enclosure share(part_->middle[k], bits_);
  if (!part_->half_width.empty()) {
    arb_add_error(share.ball(), Enclosure(part_->half_width[k], bits_).ball());
  }
  return x * (Enclosure(1) + share * change_);
}

ChoiceNumbers::ChoiceNumbers(const ExactRay& its_ray, std::span<const scene::Sphere> its_spheres,
                             double its_relative_change)
    : ray(its_ray),
      spheres(its_spheres.begin(), its_spheres.end()),
      relative_change(its_relative_change),
      values(inputs_of(its_ray, its_spheres)) {}

ChoiceForms::ChoiceForms(const ChoiceNumbers& inputs, const Part& part)
    : inputs_(inputs),
      part_(part),
      middle_{part.middle, {}},
      lift_(PartLift(kVariationBits, inputs.relative_change, part_)),
      line_(line_of(lift_, inputs.ray.source())),
      middle_lift_(kVariationBits, inputs.relative_change, middle_) {
  if (!part_.half_width.empty()) {
    middle_line_ = line_of(middle_lift_, inputs.ray.source());
  }
}

/// An enclosure of `off` (see value_of) over the part. It is empty if `off` can be computed: only
/// if the favourite's discriminant may be 0 in the part, its root has no derivative.
std::optional<Enclosure> ChoiceForms::some_off(const ChoiceCondition& condition) const {
  if (condition.what != ChoiceCondition::What::kOutside &&
      condition.what != ChoiceCondition::What::kBeforeMiddle) {
    return std::nullopt;
  }
  const Variation varied = of({ChoiceCondition::What::kDiscriminant, condition.favourite});
  if (varied.range && varied.range->certain_sign() == 1) return std::nullopt;
  Enclosure squared_root = varied.value;
  arb_add_error(squared_root.ball(), varied.most.ball());
  return root_of(Enclosure(0), squared_root, condition.favourite_root);
}

Variation ChoiceForms::of(const ChoiceCondition& condition) const {
  const auto lift_by = [&]<class AnyLift>(const AnyLift& by, const PartLift& base,
                                          std::size_t sphere) {
    base.move_to(inputs_.first_of(sphere));
    return lift_sphere(by, inputs_.spheres[sphere]);
  };
  const std::optional<Enclosure> off = some_off(condition);
  const Lift lift = lift_;
  const auto varied = value_of(
      condition, line_, [&] { return lift_by(lift, lift.base(), condition.sphere); },
      [&] { return lift_by(lift, lift.base(), condition.favourite); }, off);
  Variation result{varied.value(), std::vector<Enclosure>(inputs_.dimension())};
  if (middle_line_) {
    result.range = varied.value();
    result.value = value_of(
        condition, *middle_line_,
        [&] { return lift_by(middle_lift_, middle_lift_, condition.sphere); },
        [&] { return lift_by(middle_lift_, middle_lift_, condition.favourite); }, off);
  }
  const Enclosure change(inputs_.relative_change, kVariationBits);
  const std::size_t of_ray = inputs_.of_ray();
  for (int local = 0; local < lift.count(); ++local) {
    const auto k = static_cast<std::size_t>(local);
    if (!varied.depends_on(local)) continue;
    const std::size_t sphere = k < of_ray + kSphereInputs ? condition.sphere : condition.favourite;
    const std::size_t place =
        k < of_ray ? k : inputs_.first_of(sphere) + (k - of_ray) % kSphereInputs;
    const double x = inputs_.values[place];
    if (x == 0) continue;
    Enclosure reach = varied.derivative(local) * Enclosure(x, kVariationBits) * change;
    if (!part_.half_width.empty()) {
      reach *= Enclosure(part_.half_width[place], kVariationBits);
    }
    result.reach[place] = std::move(reach);
  }
  result.most = sum_of_sizes(result.reach);
  if (part_.half_width.empty()) result.at = part_.middle;
  return result;
}

}  // namespace raycheck::reference
