#pragma once

// Pictures, how well a fault agrees with them, and the faults that explain them. Internal to
// picture_causes.

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
  /// Wrong pixels, with or without those that a change of the scene by kExcusedImageChange excuses.
  std::uint64_t all_errors() const { return all_errors_; }
  std::uint64_t errors() const { return errors_; }
  /// It shows nothing, though there is something to see.
  bool is_black() const { return is_black_; }
  bool has_something_to_see() const;
  /// Every pixel shows the same sphere.
  bool is_uniform() const;
  /// No pixel is black, and most have a colour of no sphere, or none is wrong.
  bool has_background() const;

  /// Pixels spread evenly over the picture; all of them if it is small.
  std::vector<scene::Pixel> some_pixels() const;

  /// Some of the pixels in parts, each spread over the whole picture, the wrong ones first;
  /// left_of(): the number in a part that differ from the fault's.
  std::span<const std::vector<scene::Pixel>> sample() const { return sample_; }
  std::uint64_t left_of(const std::vector<scene::Pixel>& part, const FaultyView& view) const;

  /// How well the roundings of a formula, on top of the fault, agree with the pixels; excuses count
  /// if most pixels are certain.
  void tally(const FaultyView& view, Arithmetic arithmetic, DoubtTally& all) const;

  /// The number of pixels that differ from the fault's, without those that a change of the scene by
  /// kExcusedImageChange makes agree; empty if more than `most`, or too many for the fault to be
  /// possible.
  std::optional<std::uint64_t> left(const FaultyView& view, std::uint64_t most) const;

 private:
  std::uint64_t count_otherwise(const FaultyView& view, const std::vector<scene::Pixel>& pixels,
                                bool excusing) const;
  const std::optional<std::size_t>& at(const scene::Pixel& pixel) const;

  const ShownPicture* picture_;
  ImageAnswer truth_;
  std::vector<scene::Pixel> pixels_;
  std::vector<std::vector<scene::Pixel>> sample_;
  std::uint64_t all_errors_ = 0, errors_ = 0;
  bool is_black_ = false;
};

/// Whether a pixel that shows `shown` is as expected.
bool is_as(const std::optional<std::size_t>& shown, const std::optional<std::size_t>& expected);

/// The number of pixels of an image that are not as expected.
std::uint64_t count_otherwise(const ImageAnswer& image, const ImageAnswer& expected);

using Pictures = std::vector<Evidence>;

/// The number of pixels of pictures that are not exactly as a fault makes them.
std::uint64_t count_otherwise(const Pictures& pictures, const Fault& fault);

/// A fault that is not refuted, and the number of pixels that it does not explain.
struct Suspect {
  Fault fault;
  std::uint64_t left = 0;
};

struct Suspects {
  std::vector<Suspect> all = {};
  bool are_too_many = false;  ///< Then the list is empty: the pictures show too little.
};

/// The faults that explain pictures with errors, the best first (see picture_causes()); `pictures`
/// with most errors come first. If all are right except for excuses: the faults that make exactly
/// these.
Suspects find_suspects(const Pictures& pictures);

}  // namespace raycheck::properties
