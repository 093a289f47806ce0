#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "proofs/bounds.h"
#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tools/report/view.h"

namespace raycheck::tools {

/// A convention of scenes, or a declaration of candidates, whose first value is the default.
struct Choice {
  std::string_view name;
  std::string_view meaning;              ///< Of a declaration.
  std::vector<std::string_view> values;  ///< Empty for numbers.
  std::string usual;                     ///< The default.
};

/// Methods, laws and sources, in the order of reports; what scenes and candidates may declare.
struct Catalogue {
  std::span<const fast::PixelRayMethod* const> ray_methods;
  std::span<const fast::IntersectMethod* const> intersect_methods;
  std::span<const properties::Law> laws;
  std::span<const properties::CaseSource> sources;
  std::vector<Choice> conventions, declarations;
};
Catalogue catalogue();

/// A method's documented bound on a quantity, in u or ulp of the format in which it computes.
struct Promise {
  std::string_view name;  ///< The name of the quantity.
  double max;
  std::string unit;
};
std::vector<Promise> promises_of(const fast::PixelRayMethod& method);
std::vector<Promise> promises_of(const fast::IntersectMethod& method);

std::string list_text(const Catalogue& catalogue, const ViewOptions& options);
std::string list_json(const Catalogue& catalogue, const ViewOptions& options);

/// A proved bound, and the largest error observed on random inputs.
struct ProvedBound {
  const proofs::Bound* bound;
  double observed;  ///< In the bound's unit.
};
/// All bounds on errors: proved bounds, and bounds that methods document and laws test.
struct BoundsReport {
  std::vector<ProvedBound> proved;
  int samples;
  Catalogue catalogue;
};
BoundsReport bounds_report();

std::string bounds_text(const BoundsReport& report, const ViewOptions& options);
std::string bounds_json(const BoundsReport& report, const ViewOptions& options);

inline constexpr View<BoundsReport> kBoundsViews[] = {
    {"text", bounds_text},
    {"json", bounds_json},
};

inline constexpr View<Catalogue> kListViews[] = {
    {"text", list_text},
    {"json", list_json},
};

}  // namespace raycheck::tools
