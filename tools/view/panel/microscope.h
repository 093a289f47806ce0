#pragma once

#include "reference/exact_ray.h"
#include "tools/view/document.h"

namespace raycheck::tools {

/// Where the answers of the report's intersection methods lie around the exact one. Empty where no
/// precision up to kMostMicroscopeBits tells the distances.
/// Domain: a report about that ray and that sphere.
std::optional<Microscope> microscope_of(const ExplainReport& report, const reference::ExactRay& ray,
                                        const scene::Sphere& sphere);

/// Whose ulp is counted in: the double's, or of someone else's single-precision candidate the
/// float's.
scene::Precision microscope_precision(const ExplainReport& report);

/// Lengths from 2^-1074 to 2^1024 in one scene need some 2,100 bits, and as many again cancel.
inline constexpr int kMostMicroscopeBits = 6144;

}  // namespace raycheck::tools
