#include "tools/image/image_paint.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
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

class ClassPainter : public Painter {
 public:
  void paint(const SeenBand& band, std::span<Colour> pixels, ErrorCounts&) const override {
    std::transform(band.sphere.begin(), band.sphere.end(), pixels.begin(), [](std::int32_t sphere) {
      return sphere == reference::kNoSphere ? kBackground : kHitColour;
    });
  }
};

class SpherePainter : public Painter {
 public:
  explicit SpherePainter(const scene::Scene& scene) : scene_(scene) {}
  bool needs_points() const override { return true; }
  void paint(const SeenBand& band, std::span<Colour> pixels, ErrorCounts&) const override {
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      if (band.sphere[k] == reference::kNoSphere) {
        pixels[k] = kBackground;
        continue;
      }
      const auto sphere = static_cast<std::size_t>(band.sphere[k]);
      const double facing = facing_eye(scene_.spheres[sphere], {band.x[k], band.y[k], band.z[k]});
      pixels[k] = scaled(sphere_colour(sphere), kDarkest + (1 - kDarkest) * facing);
    }
  }

 private:
  static constexpr double kDarkest = 0.35;

  /// The cosine between the surface's normal and the line of sight; 1 if there is no normal.
  double facing_eye(const scene::Sphere& sphere, const scene::Point3& point) const {
    const scene::Vector3 normal = unit(point - sphere.centre);
    const scene::Vector3 sight = unit(point - scene_.camera->eye);
    const double cosine = std::abs(normal.x * sight.x + normal.y * sight.y + normal.z * sight.z);
    return std::isfinite(cosine) ? std::min(cosine, 1.0) : 1;
  }
  static scene::Vector3 unit(const scene::Vector3& v) {
    const double length = std::hypot(v.x, v.y, v.z);
    return {v.x / length, v.y / length, v.z / length};
  }

  const scene::Scene& scene_;
};

class DepthPainter : public Painter {
 public:
  explicit DepthPainter(const DepthRange& range) : range_(range) {}
  bool needs_parameters() const override { return true; }
  void paint(const SeenBand& band, std::span<Colour> pixels, ErrorCounts&) const override {
    // Halved against overflow.
    const double near = range_.nearest / 2;
    const double span = range_.farthest / 2 - near;
    for (std::size_t k = 0; k < pixels.size(); ++k) {
      const double ahead = band.parameter[k] / 2 - near;
      // Parameters out of range may make some or all of these infinite.
      const double share = span > 0 && ahead < span ? ahead / span : span > 0 ? 1 : 0;
      pixels[k] = band.sphere[k] == reference::kNoSphere
                      ? Colour{}
                      : scaled({255, 255, 255}, 1 - (1 - kDarkest) * std::clamp(share, 0.0, 1.0));
    }
  }

 private:
  static constexpr double kDarkest = 0.2;
  DepthRange range_;
};

class ErrorPainter : public Painter {
 public:
  ErrorPainter(const scene::Scene& scene, std::function<properties::Candidate()> candidate)
      : scene_(scene), candidate_(std::move(candidate)) {}

  void paint(const SeenBand& band, std::span<Colour> pixels, ErrorCounts& errors) const override {
    const properties::Candidate candidate = candidate_();
    properties::FailureSearch search;
    errors.pixels.resize(kErrorSteps.size());
    const std::span<const std::int32_t> seen = band.sphere;
    properties::Case chunk = {scene_, {}};
    for (std::size_t first = 0; first < seen.size(); first += chunk.pixels.size()) {
      chunk.pixels = pixels_from(band, first, std::min(first + kChunk, seen.size()));
      properties::Trial trial(chunk, candidate, {.search = &search});
      const auto found = errors_of(trial, seen.subspan(first, chunk.pixels.size()), search, errors);
      std::transform(found.begin(), found.end(),
                     pixels.begin() + static_cast<std::ptrdiff_t>(first),
                     [&](const auto& error) { return colour_counted(error, errors); });
    }
  }

 private:
  static constexpr std::size_t kChunk = 512;

  /// If the candidate fails on some pixels, finds these, and shows the others.
  static std::vector<properties::NearestHitError> errors_of(properties::Trial& trial,
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
    } catch (const std::runtime_error& error) {
      if (trial.ray_count() <= 1 || search.is_over()) {
        ++search.found;
        return failed(error.what());
      }
    }
    std::vector<properties::NearestHitError> found;
    for (const auto& half : trial.failed_parts().halves(trial)) {
      const auto some = errors_of(
          half->trial, seen.subspan(found.size(), half->the_case.pixels.size()), search, counts);
      found.insert(found.end(), some.begin(), some.end());
    }
    return found;
  }

  std::vector<scene::Pixel> pixels_from(const SeenBand& band, std::size_t first,
                                        std::size_t end) const {
    std::vector<scene::Pixel> pixels;
    const auto width = static_cast<std::size_t>(scene_.camera->width);
    for (std::size_t k = first; k < end; ++k) {
      pixels.push_back({static_cast<std::int64_t>(k % width),
                        band.j_begin + static_cast<std::int64_t>(k / width)});
    }
    return pixels;
  }

  static Colour colour_counted(const properties::NearestHitError& error, ErrorCounts& errors) {
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

  const scene::Scene& scene_;
  std::function<properties::Candidate()> candidate_;
};

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

std::unique_ptr<Painter> class_painter() { return std::make_unique<ClassPainter>(); }

std::unique_ptr<Painter> sphere_painter(const scene::Scene& scene) {
  return std::make_unique<SpherePainter>(scene);
}

std::unique_ptr<Painter> depth_painter(const DepthRange& range) {
  return std::make_unique<DepthPainter>(range);
}

std::unique_ptr<Painter> error_painter(const scene::Scene& scene,
                                       std::function<properties::Candidate()> candidate) {
  return std::make_unique<ErrorPainter>(scene, std::move(candidate));
}

}  // namespace raycheck::tools
