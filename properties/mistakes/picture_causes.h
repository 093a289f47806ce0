#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "properties/mistakes/explanation.h"  // kMostAlternatives, for each of two made at once
#include "properties/mistakes/fault.h"
#include "properties/mistakes/imprecision.h"
#include "properties/mistakes/shown_picture.h"
#include "scene/scene.h"

namespace raycheck::properties {

enum class CauseKind {
  kNothingWrong,
  kBlack,       ///< All pictures with something to see show nothing, or all wrong ones do.
  kUniform,     ///< All pictures with something to see show the same sphere in every pixel.
  kBackground,  ///< No picture with something to see has a black pixel: the background is a colour.
  kExplained,   ///< By `alternatives`, with or without roundings.
  kImprecise,   ///< Only by roundings.
  kUnknown,     ///< Nothing explains everything, or too many things do.
};

/// The formula whose roundings make pixels wrong, and the distance, in radii, of the nearest sphere
/// of a wrong pixel.
struct Imprecision {
  Arithmetic arithmetic = Arithmetic::kDifference;
  double radii = 0;
  std::string sentence() const { return imprecision_sentence(arithmetic, radii); }
};

/// Why one renderer's pictures are wrong.
struct Causes {
  /// The cause for pictures of the right size.
  CauseKind kind = CauseKind::kNothingWrong;
  /// Each explains all wrong pixels; several if they make the same pictures of these scenes. For
  /// scenes that show little, they may include pairs besides single mistakes.
  std::vector<Fault> alternatives = {};
  bool show_too_little = false;             ///< The pictures fit too many mistakes.
  std::uint64_t errors = 0, explained = 0;  ///< Pixels.
  /// Roundings of a formula that, with the first alternative, explain all wrong pixels.
  std::optional<Imprecision> imprecision = {};
  /// The pixels of pictures with width and height exchanged, if all that are not square are so.
  std::uint64_t exchanged = 0;
};

/// The sentence if no mistake is named; `explained` is 0.
inline constexpr std::string_view kTooLittleShown = "the picture shows too little to name a cause";

inline constexpr const char* kSidesExchanged = "width and height of the picture are exchanged";

/// With fewer wrong pixels outside black pictures than kFewestWrongPixels no mistake is named, and
/// with fewer than kFewestWrongPixelsOfTwo no pair: there are 150 mistakes and thousands of pairs.
inline constexpr std::uint64_t kFewestWrongPixels = 3;
inline constexpr std::uint64_t kFewestWrongPixelsOfTwo = 40;

/// The share of the wrong pixels that a full explanation may leave unexplained, besides one pixel
/// per picture: roundings and the renderer's edges change these.
inline constexpr double kMostLeftOfAll = 0.02;

/// The cause that explains the wrong pixels of all pictures together and contradicts no picture,
/// right or wrong: one mistake that explains all, or else two that do, or else one that explains
/// kExplainedShare; the best, or none if another that makes other pictures is about as good. Where
/// few mistakes show at all, pairs that explain as much as one are alternatives. Pixels that a
/// relative change of the scene by kExcusedImageChange makes right are not errors, unless nothing
/// else is wrong: then the mistakes that make exactly these pictures explain them. Wrong pictures
/// that are black need a full explanation. If nothing else explains all, roundings do so if they
/// may have caused every wrong pixel, by themselves or with an explanation of the pictures that
/// they hardly affect. Domain: valid scenes with cameras.
Causes picture_causes(std::span<const ShownPicture> pictures);

/// The number of pixels of a picture that neither a fault nor the roundings of a formula explain.
std::uint64_t pixels_left(const ShownPicture& picture, const Fault& fault, Arithmetic arithmetic);

/// The sentence of the alternatives, or of the kind.
std::vector<Explanation> explanations(const Causes& causes);

/// A scene with a camera, and whether a program failed to draw it.
struct TriedScene {
  const scene::Scene* scene = nullptr;
  bool failed = false;
};

/// The least number of scenes on which it must fail, and on which it must not.
inline constexpr std::size_t kFewestOfEachOutcome = 2;

/// A property of all scenes on which a program fails, and of no other.
struct ShapeCause {
  std::string sentence;
  bool (*is)(const scene::Scene&) = nullptr;
};

/// The property of all scenes on which a program fails, and of no others: "it fails only if the
/// picture is not square". Empty unless there is exactly one such property.
std::optional<ShapeCause> shape_cause(std::span<const TriedScene> tried);

}  // namespace raycheck::properties
