#ifndef RAYCHECK_TOOLS_METHODS_H_
#define RAYCHECK_TOOLS_METHODS_H_

#include <string>
#include <vector>

#include "fast/intersect.h"
#include "fast/pixel_ray.h"

namespace raycheck::tools {

/// A ray method and an intersection method that together make a candidate.
struct MethodPair {
  const fast::PixelRayMethod* rays;
  const fast::IntersectMethod* intersect;
  bool operator==(const MethodPair&) const = default;
};

/// What is judged when nothing is asked for: the most accurate of each kind.
inline constexpr MethodPair kDefaultMethods = {&fast::kDirectRays, &fast::kCross};

/// The method of that name; throws std::invalid_argument naming the option and the known names.
const fast::PixelRayMethod& find_rays(const std::string& name);
const fast::IntersectMethod& find_intersect(const std::string& name);

/// Every pair, in the order of reports.
std::vector<MethodPair> all_pairs();
/// Each method once, the others at their default.
std::vector<MethodPair> each_method_once();

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_METHODS_H_
