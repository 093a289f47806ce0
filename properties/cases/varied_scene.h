#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace raycheck::properties {

/// In what a scene that is given may differ from picture to picture, so that none can be stored.
enum class Variation {
  kScale,    ///< All lengths times a power of two: other numbers, the same picture.
  kSize,     ///< More pixels, as many across as down, an even number: a middle one stays.
  kSpheres,  ///< Spheres move across the line of sight and get another size.
  kBorder    ///< Spheres on rays of the picture's border move along it to rays of other pixels.
};
inline constexpr std::array<std::string_view, 4> kVariationNames = {"scale", "size", "spheres",
                                                                    "border"};

/// Lengths times up to 2^kMostVariedExponent.
inline constexpr int kMostVariedExponent = 6;
/// Up to so many pixels more, across and down.
inline constexpr std::int64_t kMostVariedPixels = 16;
/// A sphere's distances from the middle, across and down, and its radius are multiplied by factors
/// between these: what keeps away from a picture's border does so still, or nearly.
inline constexpr double kLeastVariedFactor = 0.75;
inline constexpr double kMostVariedFactor = 1.1;
/// Centres and radii that vary have so many significant digits, before they are scaled.
inline constexpr int kVariedDigits = 6;
/// Of every ray and every sphere, (d/r)^2 is at least so far from 1 where that can be had: code in
/// `float`s, and the lecture's formula on spheres some 10^5 radii away, decide such rays alike.
inline constexpr double kClearOfEdges = 1e-3;
/// Scenes are drawn so many times at most until they are so, and show the spheres that they showed.
inline constexpr int kMostVariedDraws = 64;

/// A scene of the same kind, which follows from the seed. Spheres that look like mirror images of
/// one another in the camera's axes move alike, those that look equally large remain so, and what
/// lies in the middle stays there: a picture that is the same when it is mirrored or turned upside
/// down is so still. No sphere changes its depth, or its place in the file, so that what is behind
/// the eye, before the image plane or in front of others still is, and those that are seen remain
/// the same. On the border those in corners and in the middle of a side stay, and mirror images in
/// the picture's own middle move alike; pixels are sampled as "edges" says, and rays start at them.
/// Domain: a valid scene with a camera.
scene::Scene varied_scene(const scene::Scene& scene, std::span<const Variation> what,
                          std::uint64_t seed);

}  // namespace raycheck::properties
