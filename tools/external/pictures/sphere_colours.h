#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "tools/report/picture_file.h"

namespace raycheck::tools {

/// Up to this many spheres get colours whose channels are 0 or full. Dimming, a gamma correction or
/// rounding to whole numbers does not change the hues of these.
inline constexpr std::size_t kMostSaturated = 6;

/// How a renderer shows colours.
struct ColourHabit {
  Colour background = {};  ///< The colour of pixels without a sphere.
  /// The channels of the picture that show a sphere's red, green and blue.
  std::array<std::size_t, 3> channels = {0, 1, 2};
  bool tells_spheres = true;  ///< Whether the hues in its pictures identify the spheres.

  friend bool operator==(const ColourHabit&, const ColourHabit&) = default;
};

/// Undoes what JPEG does to the colours of a picture whose spheres have saturated colours, and
/// lists the pixels where that fails as unclear. JPEG blurs hues, but keeps every pixel's
/// brightness, up to noise: a pixel is clear if it is nearer to the background or to a saturated
/// colour than the darkest sphere is to black or, on a black background, nearly as bright as the
/// brightest sphere; if its hue is not near a saturated one, it then has no empty channel. Pictures
/// of quality 50 and more were tried, with each subsampling of colours.
void restore_colours(ReadPicture& picture, const Colour& background);

/// A pixel: its index in the image, and its colour.
struct ShownPixel {
  std::size_t at = 0;
  Colour colour = {};
};

/// A colour for each sphere. Each colour has a full channel, so that it is not near black even if
/// colours are read as integers. No colour is grey, which would look like a lost colour. If there
/// are few spheres, each colour also has an empty channel, so that adding white to one does not
/// make another.
class SphereColours {
 public:
  explicit SphereColours(std::size_t count);

  const std::vector<Colour>& all() const { return colours_; }
  /// The sphere whose colour, dimmed or not, a pixel shows; empty (kSomeSphere) if no sphere's
  /// colour is near.
  std::optional<std::size_t> sphere_of(const Colour& shown, const ColourHabit& habit) const;
  /// Removes from each sphere's pixels those whose hue differs from the median, since with many
  /// spheres, adding white to one colour can make another. These pixels show only a hit.
  void keep_usual(std::vector<std::vector<ShownPixel>>& pixels) const;

 private:
  std::size_t levels_;  ///< The number of levels of a channel.
  /// The levels of each colour, as the digits of a number; sorted.
  std::vector<std::size_t> codes_;
  std::vector<Colour> colours_;
};

}  // namespace raycheck::tools
