#include "tools/commands/list.h"

#include <type_traits>

#include "contract/declarations.h"
#include "contract/words.h"
#include "scene/fields.h"

namespace raycheck::tools {
namespace {

using properties::Quantity;

/// The number of random inputs for each proved bound.
constexpr int kSamples = 2000;

/// Converts a bound in u or ulp of doubles to u or ulp of the format in which the method computes.
Promise promise(Quantity quantity, double bound, double roundoff) {
  const scene::Precision precision = roundoff >= scene::unit_roundoff(scene::Precision::kSingle)
                                         ? scene::Precision::kSingle
                                         : scene::Precision::kDouble;
  return {info(quantity).name,
          bound * (properties::kDoubleRoundoff / scene::unit_roundoff(precision)),
          std::string(unit_name(quantity, precision))};
}

template <class Value>
Choice choice(std::string_view name, const Value& usual, std::string_view meaning) {
  Choice one = {name, meaning, {}, {}};
  if constexpr (std::is_enum_v<Value>) {
    one.values.assign(names_of(usual).begin(), names_of(usual).end());
  }
  contract::append(one.usual, usual);
  return one;
}

/// The conventions of scenes, each of which a candidate may fix.
std::vector<Choice> conventions() {
  std::vector<Choice> all;
  const auto add = [&](const char* name, const auto& usual) {
    all.push_back(choice(name, usual, ""));
  };
  const scene::Conventions usual;
  scene::for_each_choice(usual, add);
  scene::for_each_field(usual.valid, add);
  return all;
}

/// What candidates declare besides.
std::vector<Choice> declarations() {
  std::vector<Choice> all;
  const contract::Declarations usual;
  contract::for_each_declaration(usual, [&](const char* name, auto& field, const char* meaning) {
    if constexpr (
        requires { contract::words_of(field); } || requires { field.smallest; } ||
        std::is_same_v<decltype(field), const double&>) {
      all.push_back(choice(name, field, meaning));
    }
  });
  return all;
}

}  // namespace

std::vector<Promise> promises_of(const fast::PixelRayMethod& method) {
  std::vector<Promise> all;
  const auto add = [&](Quantity quantity, double bound) {
    all.push_back(promise(quantity, bound, method.unit_roundoff));
  };
  if (method.pixel_points) add(Quantity::kPixelPoint, method.max_point_ulp);
  add(Quantity::kDirection, method.max_direction_ulp);
  add(Quantity::kUnitDefect, method.max_unit_defect_ulp);
  return all;
}

std::vector<Promise> promises_of(const fast::IntersectMethod& method) {
  return {promise(Quantity::kParameter, method.max_ulp, method.unit_roundoff),
          promise(Quantity::kHitPoint, method.max_point_ulp, method.unit_roundoff)};
}

Catalogue catalogue() {
  return {fast::pixel_ray_methods(),
          fast::intersect_methods(),
          properties::laws(),
          properties::case_sources(),
          conventions(),
          declarations()};
}

BoundsReport bounds_report() {
  BoundsReport report{{}, kSamples, catalogue()};
  for (const proofs::Bound& bound : proofs::bounds()) {
    report.proved.push_back({&bound, bound.observed(kSamples)});
  }
  return report;
}

}  // namespace raycheck::tools
