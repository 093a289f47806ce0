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

/// A colour for each sphere, each with a full channel, so that none is near black even if colours
/// are read as whole numbers, and none is grey, which would look like a lost colour.
class SphereColours {
 public:
  explicit SphereColours(std::size_t count);

  const std::vector<Colour>& all() const { return colours_; }
  /// The sphere whose colour a pixel shows, however dimmed; empty if it is near no sphere's:
  /// kSomeSphere.
  std::optional<std::size_t> sphere_of(const Colour& shown, const ColourHabit& habit) const;

 private:
  std::size_t levels_;              ///< Of a channel.
  std::vector<std::size_t> codes_;  ///< Sorted; the digits encode a colour's levels.
  std::vector<Colour> colours_;
};

}  // namespace raycheck::tools
