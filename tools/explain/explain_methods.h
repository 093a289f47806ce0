#pragma once

// The implementations' side of `explain`. Internal to tools/explain/.

#include <memory>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/truth.h"
#include "tools/explain/explain.h"

namespace raycheck::tools {

/// The coordinates as a list.
template <class Triple>
std::vector<double> numbers(const Triple& value) {
  return {value.x, value.y, value.z};
}

/// A candidate's answers about the only ray of a case, and the verdict of the laws: on the ray that
/// it makes at the case's pixel, or on the intersection with the case's only sphere, whose steps
/// are compared with those of exactly the ray that it was given. Domain: a case under the
/// conventions of `truth`, whose parts are shared; `own` is raycheck's
///         method that is asked, which has more steps to show, or null.
MethodReport report_rays(const properties::Candidate& candidate, const properties::Case& the_case,
                         std::shared_ptr<properties::Truth> truth,
                         const fast::PixelRayMethod* own = nullptr);
MethodReport report_intersection(const properties::Candidate& candidate,
                                 const properties::Case& the_case,
                                 std::shared_ptr<properties::Truth> truth,
                                 const fast::IntersectMethod* own = nullptr);

}  // namespace raycheck::tools
