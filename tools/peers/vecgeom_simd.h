#pragma once

#include <span>

#include "fast/batch.h"
#include "scene/geometry.h"

namespace raycheck::peers {

/// VecGeom's kernel DistanceToIn of an orb, in the vectors of four doubles of its Vc backend: s for
/// origins outside the sphere, VecGeom's infinite length without a hit; no point.
/// Domain: unit directions; as many parameters as rays, a multiple of 4; a machine with AVX2.
void distances_by_vecgeom(const fast::Rays& rays, const scene::Sphere& sphere,
                          std::span<double> parameters);

}  // namespace raycheck::peers
