#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tools/image/image.h"

namespace raycheck::tools {

inline constexpr Colour kBackground = {16, 18, 24};  ///< The colour of pixels without a sphere.
inline constexpr Colour kHitColour = {255, 255, 255};
/// Colours of wrong pixels, by standing: red, purple, pink, grey.
inline constexpr std::array<Colour, properties::kStandingCount> kWrongColours = {{
    {230, 0, 0},
    {140, 0, 160},
    {255, 150, 190},
    {128, 128, 128},
}};

/// The colour for errors of s that are at most `at_most` ulp (of the candidate's format) and above
/// the previous step.
struct ErrorStep {
  double at_most;
  Colour colour;
};
inline constexpr std::array<ErrorStep, 8> kErrorSteps = {{
    {0.5, {48, 40, 128}},
    {1, {40, 96, 168}},
    {2, {32, 144, 152}},
    {4, {56, 176, 112}},
    {16, {144, 204, 72}},
    {256, {244, 228, 64}},
    {65536, {248, 152, 40}},
    {std::numeric_limits<double>::infinity(), {255, 255, 255}},
}};

/// "2b80ff"
std::string hex(const Colour& colour);

/// The colour of a sphere where it faces the eye. Hues of successive spheres are a golden section
/// of the circle apart, so that neighbours in the file differ, and so do any few spheres.
Colour sphere_colour(std::size_t sphere);

/// Reverses the order of lines of this width.
void flip_lines(std::vector<Colour>& pixels, std::int64_t width);

/// The nearest spheres of the pixels of whole rows, row by row.
struct SeenBand {
  std::int64_t j_begin = 0, j_end = 0;
  std::vector<std::int32_t> sphere;
  std::vector<double> x, y, z;  ///< The point Q; empty if the picture does not need it.
  reference::DecidedBy decided_by;
};

/// The pixels first to end - 1 of the rows from j on, counted row by row.
std::vector<scene::Pixel> pixels_of_rows(const scene::Scene& scene, std::int64_t j,
                                         std::size_t first, std::size_t end);

/// Paints the pixels of a band, in their order. If errors are shown, adds counts to `errors`.
/// Several threads may paint bands at once.
using Painter =
    std::function<void(const SeenBand& band, std::span<Colour> pixels, ErrorCounts& errors)>;

/// Paints the spheres' colours, darker where the surface turns away from the eye. Needs points.
Painter sphere_painter(const scene::Scene& scene);
Painter error_painter(const scene::Scene& scene, std::function<properties::Candidate()> candidate);

/// Makes candidates that answer whole pixels. If the implementation makes no rays, these methods
/// do; if it does not return the nearest sphere, that is computed from its hits.
std::function<properties::Candidate()> answering_candidate(const Implementation& implementation,
                                                           const MethodPair& methods);

}  // namespace raycheck::tools
