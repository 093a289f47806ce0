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
  kSize,     ///< More pixels, as many across as down, an even number: a middle one stays.
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
/// between these: spheres that are clear of the picture's border stay so, or nearly.
inline constexpr double kLeastVariedFactor = 0.75;
inline constexpr double kMostVariedFactor = 1.1;
/// Significant digits of centres and radii that vary, before they are scaled.
inline constexpr int kVariedDigits = 6;
/// For every ray and every sphere (d/r)^2 is at least this far from 1, where possible: code in
/// `float`s, and the lecture's formula on spheres some 10^5 radii away, decide such rays alike.
inline constexpr double kClearOfEdges = 1e-3;
/// At most this many scenes are drawn until one is clear of edges and shows the same spheres.
inline constexpr int kMostVariedDraws = 64;

/// A scene of the same kind, determined by the seed. Spheres that look like mirror images of one
/// another in the camera's axes move alike, those that look equally large remain so, and those in
/// the middle stay there: a symmetric picture stays symmetric. No sphere changes its depth, or its
/// place in the file, so that spheres stay behind the eye, before the image plane or in front of
/// other spheres, and the same ones are seen. On the border, spheres in corners and in the middle
/// of a side stay, and mirror images about the picture's middle move alike; pixels are sampled as
/// "edges" says, and rays start at them.
/// Domain: a valid scene with a camera.
scene::Scene varied_scene(const scene::Scene& scene, std::span<const Variation> what,
                          std::uint64_t seed);

}  // namespace raycheck::properties
