#include "tools/external/pictures/sphere_colours.h"

#include <algorithm>
#include <cmath>

namespace raycheck::tools {
namespace {

constexpr double kFull = 255;

/// A channel counts as a level where it is so near, in steps between levels.
constexpr double kNearLevel = 0.25;
/// Where channels are all or nothing there is room for what a gamma or an offset adds.
constexpr double kNearAllOrNothing = 0.4;

std::size_t power_of_3(std::size_t base) { return base * base * base; }

/// The fewest levels of a channel that give `count` colours with a full channel.
std::size_t levels_for(std::size_t count) {
  std::size_t levels = 2;
  while (power_of_3(levels) - power_of_3(levels - 1) - 1 < count && levels < 256) ++levels;
  return levels;
}

}  // namespace

SphereColours::SphereColours(std::size_t count) : levels_(levels_for(count)) {
  const std::size_t levels = levels_;
  for (std::size_t code = 0; code < power_of_3(levels) && codes_.size() < count; ++code) {
    const auto [least, most] =
        std::minmax({code / levels / levels, code / levels % levels, code % levels});
    if (most == levels - 1 && least < most) codes_.push_back(code);
  }
  const auto channel = [levels](std::size_t level) {
    return static_cast<std::uint8_t>(
        std::lround(kFull * static_cast<double>(level) / static_cast<double>(levels - 1)));
  };
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t code = codes_[k % codes_.size()];  // of more than 195,000 some are alike
    colours_.push_back(
        {channel(code / levels / levels), channel(code / levels % levels), channel(code % levels)});
  }
}

std::optional<std::size_t> SphereColours::sphere_of(const Colour& colour,
                                                    const ColourHabit& habit) const {
  const std::array<std::uint8_t, 3> shown = {colour.red, colour.green, colour.blue};
  const double most = *std::max_element(shown.begin(), shown.end());
  if (!habit.tells_spheres || most == 0) return {};
  const double near = levels_ == 2 ? kNearAllOrNothing : kNearLevel;
  std::size_t code = 0;
  for (const std::size_t channel : habit.channels) {
    const double at = shown[channel] / most * static_cast<double>(levels_ - 1);
    const double nearest = std::round(at);
    // With this many levels every byte is near one.
    if (std::abs(at - nearest) > near && levels_ <= 128) return {};
    code = code * levels_ + static_cast<std::size_t>(nearest);
  }
  const auto found = std::lower_bound(codes_.begin(), codes_.end(), code);
  if (found == codes_.end() || *found != code) return {};
  return static_cast<std::size_t>(found - codes_.begin());
}

}  // namespace raycheck::tools
