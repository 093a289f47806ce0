#include "tools/external/pictures/sphere_colours.h"

#include <algorithm>
#include <cmath>

namespace raycheck::tools {
namespace {

constexpr double kFull = 255;

/// A channel counts as a level if it is within this distance of it, in steps between levels.
constexpr double kNearLevel = 0.25;
/// With only two levels, more distance is allowed, for a gamma correction or an offset.
constexpr double kNearAllOrNothing = 0.4;

/// Hues of one sphere differ by at most this share of a channel's full value, apart from rounding.
constexpr double kSameHue = 0.02;

/// The channels of a colour divided by the largest.
std::array<double, 3> hue_of(const Colour& colour) {
  const double most = std::max({colour.red, colour.green, colour.blue});
  return {colour.red / most, colour.green / most, colour.blue / most};
}

std::size_t power_of_3(std::size_t base) { return base * base * base; }

/// Up to this many spheres have colours with an empty channel, so that a highlight or reflection,
/// which adds white, does not turn one sphere's colour into another's. For more spheres, this would
/// need more levels, which a gamma correction confuses.
constexpr std::size_t kMostPure = 12;
constexpr std::size_t kPureOfLevel = 6;

/// The smallest number of levels of a channel that gives `count` colours.
std::size_t levels_for(std::size_t count) {
  std::size_t levels = 2;
  if (count <= kMostPure) return std::max(levels, 1 + (count + kPureOfLevel - 1) / kPureOfLevel);
  while (power_of_3(levels) - power_of_3(levels - 1) - 1 < count && levels < 256) ++levels;
  return levels;
}

/// Half the brightness of blue, the darkest saturated colour, in JPEG.
constexpr double kJpegNoise = 0.114 / 2;
/// A pixel that is at least this bright, compared with the brightest one, shows a sphere; edges of
/// spheres may spread light to the background next to them, but less.
constexpr double kJpegBright = 0.875;
/// The brightest pixel counts as this bright at least, because it may be the rest of a small
/// sphere.
constexpr std::uint8_t kJpegFull = 200;

}  // namespace

void restore_colours(ReadPicture& picture, const Colour& background) {
  picture.is_lossy = true;
  const auto brightness = [](const Colour& c) { return std::max({c.red, c.green, c.blue}); };
  std::uint8_t full = kJpegFull;
  for (const Colour& colour : picture.pixels) full = std::max(full, brightness(colour));
  const auto is_near = [noise = kJpegNoise * full](const Colour& a, const Colour& b) {
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green),
                     std::abs(a.blue - b.blue)}) <= noise;
  };
  const auto saturated = [full](std::uint8_t channel) {
    return 2 * channel < full ? std::uint8_t{0} : full;
  };
  for (std::uint32_t at = 0; at < picture.pixels.size(); ++at) {
    Colour& colour = picture.pixels[at];
    const Colour pure = {saturated(colour.red), saturated(colour.green), saturated(colour.blue)};
    if (is_near(colour, background)) {
      colour = background;
    } else if (is_near(colour, pure)) {
      colour = pure;
    } else if (!(background == Colour{}) || brightness(colour) < kJpegBright * full) {
      picture.unclear.push_back(at);
      if (2 * brightness(colour) < full) colour = {};
    } else {
      const auto not_empty = [](std::uint8_t channel) {
        return std::max(channel, std::uint8_t{1});
      };
      colour = {not_empty(colour.red), not_empty(colour.green), not_empty(colour.blue)};
    }
  }
}

SphereColours::SphereColours(std::size_t count) : levels_(levels_for(count)) {
  const std::size_t levels = levels_;
  for (std::size_t code = 0; code < power_of_3(levels) && codes_.size() < count; ++code) {
    const auto [least, most] =
        std::minmax({code / levels / levels, code / levels % levels, code % levels});
    if (most == levels - 1 && least < (count <= kMostPure ? 1 : most)) codes_.push_back(code);
  }
  const auto channel = [levels](std::size_t level) {
    return static_cast<std::uint8_t>(
        std::lround(kFull * static_cast<double>(level) / static_cast<double>(levels - 1)));
  };
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t code = codes_[k % codes_.size()];  // beyond 195,000 spheres colours repeat
    colours_.push_back(
        {channel(code / levels / levels), channel(code / levels % levels), channel(code % levels)});
  }
}

std::optional<std::size_t> SphereColours::sphere_of(const Colour& colour,
                                                    const ColourHabit& habit) const {
  const std::array<std::uint8_t, 3> shown = {colour.red, colour.green, colour.blue};
  const double most = *std::ranges::max_element(shown);
  if (!habit.tells_spheres || most == 0) return {};
  const double near = levels_ == 2 ? kNearAllOrNothing : kNearLevel;
  std::size_t code = 0;
  for (const std::size_t channel : habit.channels) {
    const double at = shown[channel] / most * static_cast<double>(levels_ - 1);
    const double nearest = std::round(at);
    // With more levels every byte is near one.
    if (std::abs(at - nearest) > near && levels_ <= 128) return {};
    code = code * levels_ + static_cast<std::size_t>(nearest);
  }
  const auto found = std::ranges::lower_bound(codes_, code);
  if (found == codes_.end() || *found != code) return {};
  return static_cast<std::size_t>(found - codes_.begin());
}

void SphereColours::keep_usual(std::vector<std::vector<ShownPixel>>& pixels) const {
  if (colours_.size() <= kMostPure) return;
  std::vector<double> shares;
  for (std::vector<ShownPixel>& its : pixels) {
    if (its.empty()) continue;
    std::array<double, 3> usual{};
    for (std::size_t channel = 0; channel < usual.size(); ++channel) {
      shares.clear();
      for (const ShownPixel& one : its) shares.push_back(hue_of(one.colour)[channel]);
      const auto median = shares.begin() + std::ssize(shares) / 2;
      std::nth_element(shares.begin(), median, shares.end());
      usual[channel] = *median;
    }
    std::erase_if(its, [&](const ShownPixel& one) {
      const std::array<double, 3> hue = hue_of(one.colour);
      const double rounding = 1.0 / std::max({one.colour.red, one.colour.green, one.colour.blue});
      return !std::equal(hue.begin(), hue.end(), usual.begin(), [&](double x, double y) {
        return std::abs(x - y) <= kSameHue + rounding;
      });
    });
  }
}

}  // namespace raycheck::tools
