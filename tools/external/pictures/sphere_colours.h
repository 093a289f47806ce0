#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// Up to this many spheres have colours whose channels are 0 or full: dimming, a gamma correction
/// or rounding to whole numbers keeps their hues.
inline constexpr std::size_t kMostSaturated = 6;

/// How a renderer shows colours.
struct ColourHabit {
  Colour background = {};  ///< Where it shows no sphere.
  /// Which channels of the picture show a sphere's red, green and blue.
  std::array<std::size_t, 3> channels = {0, 1, 2};
  bool tells_spheres = true;  ///< The hues in its pictures identify the spheres.

  friend bool operator==(const ColourHabit&, const ColourHabit&) = default;
};

/// A pixel: its index in the image, and its colour.
struct ShownPixel {
  std::size_t at = 0;
  Colour colour = {};
};

/// A colour for each sphere. Each has a full channel, so that no colour is near black even if
/// colours are read as integers; none is grey, which would look like a lost colour. If there are
/// few spheres, each also has an empty channel: adding white to one colour does not make another.
class SphereColours {
 public:
  explicit SphereColours(std::size_t count);

  const std::vector<Colour>& all() const { return colours_; }
  /// The sphere whose colour a pixel shows, however dimmed; empty (kSomeSphere) if no sphere's
  /// colour is near.
  std::optional<std::size_t> sphere_of(const Colour& shown, const ColourHabit& habit) const;
  /// With many spheres, adding white to one colour can make another: removes from each sphere's
  /// pixels those whose hue differs from the median. These show only a hit.
  void keep_usual(std::vector<std::vector<ShownPixel>>& pixels) const;

 private:
  std::size_t levels_;              ///< Of a channel.
  std::vector<std::size_t> codes_;  ///< Sorted; the digits encode a colour's levels.
  std::vector<Colour> colours_;
};

}  // namespace raycheck::tools
