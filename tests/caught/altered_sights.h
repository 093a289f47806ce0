#ifndef RAYCHECK_TESTS_CAUGHT_ALTERED_SIGHTS_H_
#define RAYCHECK_TESTS_CAUGHT_ALTERED_SIGHTS_H_

#include "tests/caught/injected.h"

namespace raycheck::caught {

// Exact candidates but for wrong decisions, in all that they decide: hits, nearest spheres, pixels.

/// Hit and miss exchanged where |b - r| < size r, b the impact parameter.
properties::Candidate flipped_band(const ExactParts& exact, double size);
/// Hits with s < size dropped.
properties::Candidate epsilon_in_s(const ExactParts& exact, double size);
/// Of spheres whose s differ by less than size s the farthest is taken for the nearest.
properties::Candidate farther_sphere(const ExactParts& exact, double size);

}  // namespace raycheck::caught

#endif  // RAYCHECK_TESTS_CAUGHT_ALTERED_SIGHTS_H_
