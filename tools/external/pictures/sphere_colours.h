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
  /// Which channel of the picture has the red, green and blue of a sphere.
  std::array<std::size_t, 3> channels = {0, 1, 2};
  bool tells_spheres = true;  ///< The hues of its pictures are those of the spheres.

  friend bool operator==(const ColourHabit&, const ColourHabit&) = default;
};

/// As many colours as there are spheres, each with a channel that is full, so that none is near
/// black even where colours are read as whole numbers, and none grey, as where they are lost.
class SphereColours {
 public:
  explicit SphereColours(std::size_t count);

  const std::vector<Colour>& all() const { return colours_; }
  /// The sphere whose colour a pixel shows, however dimmed; empty where it is near none's: some
  /// sphere.
  std::optional<std::size_t> sphere_of(const Colour& shown, const ColourHabit& habit) const;

 private:
  std::size_t levels_;              ///< Of a channel.
  std::vector<std::size_t> codes_;  ///< In rising order: the digits of a colour's levels.
  std::vector<Colour> colours_;
};

}  // namespace raycheck::tools
