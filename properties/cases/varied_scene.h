#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace raycheck::properties {

/// The ways to vary a given scene from picture to picture, so that stored pictures do not pass.
enum class Variation {
  kScale,    ///< All lengths times a power of two: other numbers, the same picture.
  kSize,     ///< The same even number of pixels is added across and down: a middle one stays.
  kSpheres,  ///< Spheres move across the line of sight and get another size.
  kBorder    ///< Spheres on rays of the picture's border move along it to rays of other pixels.
};
inline constexpr std::array<std::string_view, 4> kVariationNames = {"scale", "size", "spheres",
                                                                    "border"};

/// Lengths grow at most by 2^kMostVariedExponent.
inline constexpr int kMostVariedExponent = 6;
/// At most this many pixels are added, across and down.
inline constexpr std::int64_t kMostVariedPixels = 16;
/// A sphere's distances from the middle, across and down, and its radius are multiplied by factors
/// between these. Spheres that are clear of the picture's border stay clear of it, or nearly so.
inline constexpr double kLeastVariedFactor = 0.75;
inline constexpr double kMostVariedFactor = 1.1;
/// Varied centres and radii are rounded to this many significant digits, before they are scaled.
inline constexpr int kVariedDigits = 6;
/// If possible, (d/r)^2 differs from 1 by at least this much for every ray and every sphere. Code
/// in `float`s, and the lecture's formula on spheres some 10^5 radii away, then decide every ray in
/// the same way.
inline constexpr double kClearOfEdges = 1e-3;
/// At most this many scenes are drawn until one is clear of edges and shows the same spheres.
inline constexpr int kMostVariedDraws = 64;

/// A scene of the same kind, determined by the seed. A symmetric picture stays symmetric: spheres
/// that look like mirror images of one another in the camera's axes move alike, spheres that look
/// equally large remain so, and spheres in the middle stay there. No sphere changes its depth or
/// its place in the file; a sphere behind the eye, before the image plane or in front of another
/// stays there, and the same spheres are seen. kBorder leaves spheres in corners and in the middle
/// of a side, and moves mirror images about the picture's middle alike; it assumes that pixels are
/// sampled as "edges" says, and that rays start at them.
/// Domain: a valid scene with a camera.
scene::Scene varied_scene(const scene::Scene& scene, std::span<const Variation> what,
                          std::uint64_t seed);

}  // namespace raycheck::properties
