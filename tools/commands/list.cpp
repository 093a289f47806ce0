#include "tools/commands/list.h"

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
  return {fast::pixel_ray_methods(), fast::intersect_methods(), properties::laws(),
          properties::case_sources()};
}

BoundsReport bounds_report() {
  BoundsReport report{{}, kSamples, catalogue()};
  for (const proofs::Bound& bound : proofs::bounds()) {
    report.proved.push_back({&bound, bound.observed(kSamples)});
  }
  return report;
}

}  // namespace raycheck::tools
