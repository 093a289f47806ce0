#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "scene/precision.h"

namespace raycheck::properties {

/// The quantities that are judged.
enum class Quantity {
  kFrame,           ///< an axis against the exact one
  kOrthonormality,  ///< the axes among themselves
  kPixelPoint,
  kDirection,
  kUnitDefect,
  kRayOrigin,
  kClass,  ///< hit or miss
  kRoot,   ///< which root
  kParameter,
  kHitPoint,
  kSphereResidual,  ///< distance of a hit point from the sphere, over r
  kRayResidual,     ///< distance of a hit point from the ray, over s |D|
  kBackwardError,   ///< the relative change of the inputs that makes s an exact root
  kNearestSphere,
  kInvariance,  ///< two answers of the candidate that should agree
  kRefusal,     ///< refuses invalid input, accepts valid input
  kDepth,       ///< the number of a pixel in a depth picture
};
inline constexpr std::size_t kQuantityCount = 17;

/// A quantity's name in reports, the unit of its errors (ulp of the exact value, u of its size, or
/// empty for decisions), and the symbol of the answered numbers (docs/problem.md; empty if there
/// are several).
struct QuantityInfo {
  std::string_view name;
  std::string_view unit;  ///< Its name in reports on doubles.
  std::string_view symbol = {};
};

inline constexpr std::array<QuantityInfo, kQuantityCount> kQuantities = {{
    {"frame", "u"},
    {"orthonormality", "u"},
    {"pixel point", "u", "P"},
    {"direction", "u", "D"},
    {"unit defect", "u", "D"},
    {"ray origin", "u", "L"},
    {"class", "", "s"},
    {"root", "", "s"},
    {"parameter", "ulp", "s"},
    {"hit point", "u", "Q"},
    {"sphere residual", "u", "Q"},
    {"ray residual", "u", "Q"},
    {"backward error", "u", "s"},
    {"nearest sphere", "", "sphere"},
    {"invariance", "u"},
    {"refusal", ""},
    {"depth", "ulp of float", "s"},
}};

constexpr const QuantityInfo& info(Quantity quantity) {
  return kQuantities[static_cast<std::size_t>(quantity)];
}

/// Whether its answers are only right or wrong, so that there is no size of an error.
constexpr bool is_decision(Quantity quantity) { return info(quantity).unit.empty(); }

/// The unit of a quantity's errors if answers are judged in this format: "u", "ulp of float", or
/// empty for decisions.
constexpr std::string_view unit_name(Quantity quantity, scene::Precision precision) {
  const std::string_view unit = info(quantity).unit;
  const bool is_of_floats = quantity == Quantity::kDepth;
  if (precision == scene::Precision::kDouble || unit.empty() || is_of_floats) return unit;
  return unit == "ulp" ? "ulp of float" : "u of float";
}

/// u of doubles, in which reference/ measures errors. For answers that are judged in another
/// format, errors are converted to that format's u (scene::unit_roundoff).
inline constexpr double kDoubleRoundoff = scene::unit_roundoff(scene::Precision::kDouble);

/// The bound on an error if the candidate documents none.
inline constexpr double kDefaultMaxError = 16;

/// Documented bounds hold unchanged up to this condition number; above, they grow in proportion to
/// it.
inline constexpr double kModerateCondition = 16;
constexpr double bound_growth(double condition) {
  return condition > kModerateCondition ? condition / kModerateCondition : 1;
}

/// If code promises no more than ordinary cases, and a sphere's centre is within this number of
/// radii of the ray's origin, errors may also grow with the condition number of the textbook's
/// formula (reference::textbook_condition). Farther away, the errors of that formula are defects.
/// Errors of a direction may grow with the condition number of (P - E)/|P - E|, with P and E as
/// inputs, if that is at most this number.
inline constexpr double kOrdinaryDistance = 0x1p10;
/// In doubles, the errors of the textbook's formula are allowed only if |d^2| is at least this
/// share of r^2; nearer to a tangent they are defects. (Rays and spheres in floats come no nearer,
/// except exact tangents.)
inline constexpr double kOrdinaryTangency = 0x1p-29;

/// A wrong hit class is excused if a relative change of the inputs by 16 u, about the roundings of
/// a few operations, may change the exact class. u is that of the candidate's precision.
inline constexpr double kExcusedRoundoffs = 16;
inline constexpr double kExcusedChange = kExcusedRoundoffs * kDoubleRoundoff;
constexpr double excused_change(double unit_roundoff) { return kExcusedRoundoffs * unit_roundoff; }

/// The two halves of a candidate, which can be judged separately: the rays that it makes, and its
/// answers about given rays.
enum class Stage { kRays, kIntersection };
constexpr std::string_view name(Stage stage) {
  return stage == Stage::kRays ? "rays" : "intersections";
}

/// The quantity that measures the accuracy of a stage.
constexpr Quantity main_quantity(Stage stage) {
  return stage == Stage::kRays ? Quantity::kDirection : Quantity::kParameter;
}

}  // namespace raycheck::properties
