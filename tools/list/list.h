#ifndef RAYCHECK_TOOLS_LIST_LIST_H_
#define RAYCHECK_TOOLS_LIST_LIST_H_

#include <span>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"
#include "properties/cases/case_source.h"
#include "properties/laws/law.h"

namespace raycheck::tools {

/// What may be chosen, each in the order of reports; the conventions are in scene/conventions.h.
struct Catalogue {
  std::span<const fast::PixelRayMethod* const> ray_methods;
  std::span<const fast::IntersectMethod* const> intersect_methods;
  std::span<const properties::Law> laws;
  std::span<const properties::CaseSource> sources;
};
Catalogue catalogue();

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_LIST_LIST_H_
