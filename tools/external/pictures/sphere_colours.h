#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// Up to this many spheres have colours whose channels are all or nothing: what dims them, bends
/// them by a gamma or cuts them to whole numbers leaves their hues.
inline constexpr std::size_t kMostSaturated = 6;

/// How a renderer shows colours.
struct ColourHabit {
  Colour background = {};  ///< Where it shows no sphere.
  /// Which channels of the picture show a sphere's red, green and blue.
  std::array<std::size_t, 3> channels = {0, 1, 2};
  bool tells_spheres = true;  ///< The hues of its pictures are those of the spheres.

  friend bool operator==(const ColourHabit&, const ColourHabit&) = default;
};

/// A pixel, by its place in an image, and the colour that it shows.
struct ShownPixel {
  std::size_t at = 0;
  Colour colour = {};
};

/// A colour for each sphere, each with a full channel, so that none is near black even if colours
/// are read as whole numbers, and none is grey, which would look like a lost colour. Of few spheres
/// each has an empty channel, too: white added to one's colour makes no other's.
class SphereColours {
 public:
  explicit SphereColours(std::size_t count);

  const std::vector<Colour>& all() const { return colours_; }
  /// The sphere whose colour a pixel shows, however dimmed; empty if it is near no sphere's:
  /// kSomeSphere.
  std::optional<std::size_t> sphere_of(const Colour& shown, const ColourHabit& habit) const;
  /// With more spheres than have pure colours, white added to one colour can make another: removes
  /// from each sphere's pixels those whose hue differs from the median. They show only a hit.
  /// `pixels`: by sphere.
  void keep_usual(std::vector<std::vector<ShownPixel>>& pixels) const;

 private:
  std::size_t levels_;              ///< Of a channel.
  std::vector<std::size_t> codes_;  ///< Sorted; the digits encode a colour's levels.
  std::vector<Colour> colours_;
};

}  // namespace raycheck::tools
