#include "tools/image/image_paint.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "properties/sphere_choice.h"

namespace raycheck::tools {
namespace {

/// A colour by hue, saturation and brightness, each from 0 to 1.
Colour colour_of(double hue, double saturation, double brightness) {
  const auto channel = [&](double shift) {
    const double along = std::fmod(hue * 6 + shift, 6.0);
    const double share = std::clamp(std::min(along, 4 - along), 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255 * brightness * (1 - saturation * share)));
  };
  return {channel(5), channel(3), channel(1)};
}

Colour scaled(const Colour& colour, double factor) {
  const auto scale = [&](std::uint8_t channel) {
    return static_cast<std::uint8_t>(std::lround(factor * channel));
  };
  return {scale(colour.red), scale(colour.green), scale(colour.blue)};
}

/// The cosine between the surface's normal and the line of sight; 1 if there is no normal.
double facing_eye(const scene::Sphere& sphere, const scene::Point3& point,
                  const scene::Point3& eye) {
  const auto unit_of = [](const scene::Vector3& v) {
    const double length = std::hypot(v.x, v.y, v.z);
    return scene::Vector3{v.x / length, v.y / length, v.z / length};
  };
  const scene::Vector3 normal = unit_of(point - sphere.centre);
  const scene::Vector3 sight = unit_of(point - eye);
  const double cosine = std::abs(normal.x * sight.x + normal.y * sight.y + normal.z * sight.z);
  return std::isfinite(cosine) ? std::min(cosine, 1.0) : 1;
}

/// The errors of a chunk. If the candidate fails on some pixels, these are found, and the others
/// are shown.
std::vector<properties::NearestHitError> errors_of(properties::Trial& trial,
                                                   std::span<const std::int32_t> seen,
                                                   properties::FailureSearch& search,
                                                   ErrorCounts& counts) {
  const auto failed = [&](const std::string& how) {
    if (counts.failed == 0) counts.first_failure = how;
    counts.failed += seen.size();
    properties::NearestHitError error;
    error.wrong = properties::Wrong::kFailed;
    error.standing = properties::Standing::kDefect;
    return std::vector(seen.size(), error);
  };
  try {
    return properties::nearest_hit_errors(trial, seen);
  } catch (const properties::CandidateUnavailable& error) {
    return failed(error.what());
  } catch (const properties::NoAnswer& error) {
    if (trial.ray_count() <= 1 || search.is_over()) {
      ++search.found;
      return failed(error.what());
    }
  }
  std::vector<properties::NearestHitError> found;
  for (const auto& half : trial.halves()) {
    const auto some = errors_of(
        half->trial, seen.subspan(found.size(), half->the_case.pixels.size()), search, counts);
    found.insert(found.end(), some.begin(), some.end());
  }
  return found;
}

Colour colour_counted(const properties::NearestHitError& error, ErrorCounts& errors) {
  if (error.wrong != properties::Wrong::kNot) {
    const auto standing = static_cast<std::size_t>(error.standing);
    ++errors.wrong[standing];
    return kWrongColours[standing];
  }
  if (!error.ulp) return kBackground;
  std::size_t step = 0;
  while (*error.ulp > kErrorSteps[step].at_most) ++step;
  ++errors.pixels[step];
  return kErrorSteps[step].colour;
}

}  // namespace

std::string hex(const Colour& colour) {
  return fmt::format("{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

Colour sphere_colour(std::size_t sphere) {
  constexpr double kGoldenSection = 0.6180339887498949;
  constexpr double kFirstHue = 0.58;
  constexpr std::array<double, 3> kSaturations = {0.6, 0.8, 0.45};
  const double turns = kFirstHue + kGoldenSection * static_cast<double>(sphere);
  return colour_of(turns - std::floor(turns), kSaturations[sphere % kSaturations.size()], 1);
}

std::vector<scene::Pixel> pixels_of_rows(const scene::Scene& scene, std::int64_t j,
                                         std::size_t first, std::size_t end) {
  std::vector<scene::Pixel> pixels;
  for (auto k = static_cast<std::int64_t>(first); k < static_cast<std::int64_t>(end); ++k) {
    pixels.push_back({k % scene.camera->width, j + k / scene.camera->width});
  }
  return pixels;
}

void flip_lines(std::vector<Colour>& pixels, std::int64_t width) {
  for (auto low = pixels.begin(), high = pixels.end() - width; low < high;
       low += width, high -= width) {
    std::swap_ranges(low, low + width, high);
  }
}

Painter sphere_painter(const scene::Scene& scene) {
  constexpr double kDarkest = 0.35;
  return [&scene](const SeenBand& band, std::span<Colour> pixels, ErrorCounts&) {
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      pixels[k] = kBackground;
      if (band.sphere[k] == reference::kNoSphere) continue;
      const auto sphere = static_cast<std::size_t>(band.sphere[k]);
      const double facing =
          facing_eye(scene.spheres[sphere], {band.x[k], band.y[k], band.z[k]}, scene.camera->eye);
      pixels[k] = scaled(sphere_colour(sphere), kDarkest + (1 - kDarkest) * facing);
    }
  };
}

Painter error_painter(const scene::Scene& scene, std::function<properties::Candidate()> candidate) {
  constexpr std::size_t kAtOnce = 512;
  return [&scene, make = std::move(candidate)](const SeenBand& band, std::span<Colour> pixels,
                                               ErrorCounts& errors) {
    const properties::Candidate made = make();
    properties::FailureSearch search;
    errors.pixels.resize(kErrorSteps.size());
    const std::span<const std::int32_t> seen = band.sphere;
    for (std::size_t first = 0; first < seen.size(); first += kAtOnce) {
      const std::size_t end = std::min(first + kAtOnce, seen.size());
      const properties::Case chunk = {scene, pixels_of_rows(scene, band.j_begin, first, end)};
      properties::Trial trial(chunk, made, {.search = &search});
      const auto found = errors_of(trial, seen.subspan(first, end - first), search, errors);
      std::ranges::transform(found, pixels.begin() + static_cast<std::ptrdiff_t>(first),
                             [&](const auto& error) { return colour_counted(error, errors); });
    }
  };
}

}  // namespace raycheck::tools
