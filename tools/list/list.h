#pragma once

#include <span>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tools/report/view.h"

namespace raycheck::tools {

/// What can be chosen, in the order of reports; the conventions are in scene/conventions.h.
struct Catalogue {
  std::span<const fast::PixelRayMethod* const> ray_methods;
  std::span<const fast::IntersectMethod* const> intersect_methods;
  std::span<const properties::Law> laws;
  std::span<const properties::CaseSource> sources;
};
Catalogue catalogue();

/// The format whose u and ulp a method's bounds count, given its unit roundoff.
constexpr scene::Precision precision_of(double roundoff) {
  return roundoff >= scene::unit_roundoff(scene::Precision::kSingle) ? scene::Precision::kSingle
                                                                     : scene::Precision::kDouble;
}
/// Converts a bound in u or ulp of doubles to those of a format.
constexpr double in_own_unit(double bound, scene::Precision precision) {
  return bound * (properties::kDoubleRoundoff / scene::unit_roundoff(precision));
}

std::string list_text(const Catalogue& catalogue, const ViewOptions& options);
std::string list_json(const Catalogue& catalogue, const ViewOptions& options);

inline constexpr View<Catalogue> kListViews[] = {
    {"text", list_text},
    {"json", list_json},
};

}  // namespace raycheck::tools
