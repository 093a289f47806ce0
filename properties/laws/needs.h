#pragma once

#include <string_view>

#include "properties/trial.h"

namespace raycheck::properties {

/// What a law needs from a scene and a candidate to say anything: any combination of these.
enum class Needs : unsigned {
  // Of a camera:
  kFrame = 1 << 0,
  kPixelPoints = 1 << 1,
  kMadeRays = 1 << 2,     ///< Under the origin convention, not given ones.
  kBothOrigins = 1 << 3,  ///< Rays from the pixel points and rays from the eye.
  kVisible = 1 << 4,      ///< Spheres seen, in an image not too large for the candidate.
  kImage = 1 << 5,        ///< An image, not too large for the candidate.
  kPlan = 1 << 6,
  // Of rays, whether made or given:
  kRays = 1 << 7,
  kIntersect = 1 << 8,
  kNearest = 1 << 9,
  // Of either:
  kSpheres = 1 << 10,
  kSeveralSpheres = 1 << 11,
  kRefusals = 1 << 12,
  // Of what a candidate returns of a hit:
  kParameters = 1 << 13,  ///< s, or a distance.
  kPoints = 1 << 14,      ///< Q
  kEither = 1 << 15       ///< One of the two.
};
constexpr Needs operator|(Needs a, Needs b) {
  return static_cast<Needs>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// Whether one of `some` is among what is needed.
constexpr bool needs_any(Needs needs, Needs some) {
  return (static_cast<unsigned>(needs) & static_cast<unsigned>(some)) != 0;
}

/// The needs that only a scene with a camera meets, and those that only a candidate that intersects
/// rays with spheres meets.
inline constexpr Needs kOfCameras = Needs::kFrame | Needs::kPixelPoints | Needs::kMadeRays |
                                    Needs::kBothOrigins | Needs::kVisible | Needs::kImage |
                                    Needs::kPlan;
inline constexpr Needs kOfIntersections =
    Needs::kIntersect | Needs::kNearest | Needs::kVisible | Needs::kImage | Needs::kPlan;

/// Which need a trial does not meet, as a sentence; empty when it meets all.
std::string_view what_is_missing(Needs needs, const Trial& trial);
/// Whether its scene meets all needs, whatever the candidate lacks.
bool scene_suits(Needs needs, const Trial& trial);

}  // namespace raycheck::properties
