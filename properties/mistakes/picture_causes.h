#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "properties/mistakes/explanation.h"
#include "properties/mistakes/fault.h"
#include "properties/mistakes/imprecision.h"
#include "properties/mistakes/shown_picture.h"

namespace raycheck::properties {

enum class CauseKind {
  kNothingWrong,
  kBlack,       ///< All pictures with something to see show nothing, or all wrong ones do.
  kUniform,     ///< All pictures with something to see show the same sphere in every pixel.
  kBackground,  ///< In none with something to see is a pixel black: behind the spheres is a colour.
  kExplained,   ///< By `alternatives`, with or without roundings.
  kImprecise,   ///< By roundings alone.
  kUnknown,     ///< Nothing explains all, or too much does.
};

/// Roundings that count: of which formula, and the least way, in radii, at which they do.
struct Imprecision {
  Arithmetic arithmetic = Arithmetic::kDifference;
  double radii = 0;
  std::string sentence() const { return imprecision_sentence(arithmetic, radii); }
};

/// Why the pictures of one renderer are wrong.
struct Causes {
  /// Of those with the size that they should have.
  CauseKind kind = CauseKind::kNothingWrong;
  /// Each explains all that is wrong; where there are several they make the same of these scenes.
  std::vector<Fault> alternatives = {};
  std::uint64_t errors = 0, explained = 0;  ///< Pixels.
  /// Roundings of a formula that make, beside the first alternative, all that is wrong.
  std::optional<Imprecision> imprecision = {};
  /// Pixels of pictures with width and height exchanged, where every one that is not square is so.
  std::uint64_t exchanged = 0;
};

inline constexpr const char* kSidesExchanged = "width and height of the picture are exchanged";

/// At most so many mistakes that make the same pictures are named, of each of two at once; of more
/// than these none is.
inline constexpr std::size_t kMostAlternatives = 3;

/// Fewer wrong pixels, but of black pictures, name no mistake, and fewer than the second no two at
/// once: there are 140 mistakes, and thousands of pairs.
inline constexpr std::uint64_t kFewestWrongPixels = 3;
inline constexpr std::uint64_t kFewestWrongPixelsOfTwo = 40;

/// The share of the wrong pixels that what explains all may leave, beside a pixel a picture: what
/// roundings, and the renderer's own edges, make of a mistake.
inline constexpr double kMostLeftOfAll = 0.02;

/// What explains the wrong pixels of all pictures together and contradicts none: neither the right
/// pictures nor any one of the wrong ones. One mistake that explains all, or else two that do, or
/// else one that explains kExplainedShare; the best, and none where another that makes other
/// pictures is about as good. Pixels that a relative change of the scene by kExcusedImageChange
/// makes right are no errors, but where nothing else is wrong: then what makes exactly these
/// pictures explains them. Pictures that are wrong and black are explained only by what explains
/// all. Where nothing else explains all, roundings do that may have made every wrong pixel, alone
/// or with what explains the pictures in which they count for little. Domain: valid scenes with
/// cameras.
Causes picture_causes(std::span<const ShownPicture> pictures);

/// The pixels of a picture that neither a fault nor, beside it, the roundings of a formula make.
std::uint64_t pixels_left(const ShownPicture& picture, const Fault& fault, Arithmetic arithmetic);

/// What there is to say of the causes: of every alternative its sentence, of pairs one, or the
/// kind in words.
std::vector<Explanation> explanations(const Causes& causes);

}  // namespace raycheck::properties
