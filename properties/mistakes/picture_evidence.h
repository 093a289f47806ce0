#pragma once

// How well faults agree with pictures, and which faults explain them. Internal to picture_causes.

#include <optional>
#include <span>
#include <vector>

#include "properties/mistakes/fault.h"
#include "properties/mistakes/imprecision.h"
#include "properties/mistakes/shown_picture.h"

namespace raycheck::properties {

/// One picture and the right one.
class Evidence {
 public:
  explicit Evidence(const ShownPicture& picture);

  const ShownPicture& picture() const { return *picture_; }
  const ImageAnswer& truth() const { return truth_; }
  /// The number of wrong pixels; errors(): without those that a change of the scene by
  /// kExcusedImageChange excuses.
  std::uint64_t all_errors() const { return all_errors_; }
  std::uint64_t errors() const { return errors_; }
  /// Whether it shows nothing, though it should show a sphere.
  bool is_black() const { return is_black_; }
  bool has_something_to_see() const;
  /// Whether every pixel shows the same sphere.
  bool is_uniform() const;
  /// Whether no pixel is black, and most pixels have a colour of no sphere, or no pixel is wrong.
  bool has_background() const;

  /// Whether each wrong pixel may show what some point of its square does.
  bool may_be_elsewhere_in_pixels() const;

  /// Pixels spread evenly over the picture; all of them if it is small.
  std::vector<Pixel> some_pixels() const;

  /// Some of the pixels, in parts, each spread over the whole picture; the wrong pixels come first.
  /// left_of(): the number of pixels of a part that differ from the fault's picture.
  std::span<const std::vector<Pixel>> sample() const { return sample_; }
  std::uint64_t left_of(const std::vector<Pixel>& part, const FaultyView& view) const;

  /// How well the roundings of a formula, in addition to the fault, agree with the pixels. Excused
  /// pixels count as right if most pixels are certain.
  void tally(const FaultyView& view, Arithmetic arithmetic, DoubtTally& all) const;

  /// The number of pixels that differ from the fault's picture, without those that a change of the
  /// scene by kExcusedImageChange makes agree. Empty if there are more than `most`, or too many for
  /// the fault to be possible.
  std::optional<std::uint64_t> left(const FaultyView& view, std::uint64_t most) const;

 private:
  std::uint64_t count_otherwise(const FaultyView& view, const std::vector<Pixel>& pixels,
                                bool excusing) const;
  const std::optional<std::size_t>& at(const Pixel& pixel) const;

  const ShownPicture* picture_;
  ImageAnswer truth_;
  std::vector<Pixel> pixels_;
  std::vector<std::vector<Pixel>> sample_;
  std::uint64_t all_errors_ = 0, errors_ = 0;
  bool is_black_ = false;
};

/// Whether a pixel that shows `shown` is as expected.
bool is_as(const std::optional<std::size_t>& shown, const std::optional<std::size_t>& expected);

/// The number of pixels of an image that are not as expected.
std::uint64_t count_otherwise(const ImageAnswer& image, const ImageAnswer& expected);

using Pictures = std::vector<Evidence>;

/// The number of pixels that are not exactly as the fault makes them.
std::uint64_t count_otherwise(const Pictures& pictures, const Fault& fault);

/// A fault that the pictures do not refute, and the number of pixels that it does not explain.
struct Suspect {
  Fault fault;
  std::uint64_t left = 0;
};

struct Suspects {
  std::vector<Suspect> all = {};
  bool are_too_many = false;  ///< Then `all` is empty: the pictures show too little.
};

/// The faults that explain the pictures, the best first (see picture_causes()). If all wrong pixels
/// are excused: the faults that make exactly these pictures. Domain: the pictures with most errors
/// come first.
Suspects find_suspects(const Pictures& pictures);

}  // namespace raycheck::properties
