#pragma once

// What `explain` reports about implementations. Internal to tools/explain/.

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

/// A candidate's answers about the one ray of a case, and the verdict of the laws. report_rays() is
/// about the ray that it makes for the case's pixel; report_intersection() is about the ray's
/// intersection with the case's one sphere. Its steps are compared with those of exactly the ray
/// that it got.
/// Domain: a case under the conventions of `truth`, whose parts are shared; `own` is
///         raycheck's method if the candidate is one, which has more steps to show; or null.
MethodReport report_rays(const properties::Candidate& candidate, const properties::Case& the_case,
                         std::shared_ptr<properties::Truth> truth,
                         const fast::PixelRayMethod* own = nullptr);
MethodReport report_intersection(const properties::Candidate& candidate,
                                 const properties::Case& the_case,
                                 std::shared_ptr<properties::Truth> truth,
                                 const fast::IntersectMethod* own = nullptr);

}  // namespace raycheck::tools
