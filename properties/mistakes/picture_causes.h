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
  kBlack,    ///< All pictures that should show a sphere show nothing, or all wrong ones do.
  kUniform,  ///< All pictures that should show a sphere show the same sphere in every pixel.
  /// No picture that should show a sphere has a black pixel: the background is a colour.
  kBackground,
  kExplained,  ///< By `alternatives`, with or without roundings.
  kImprecise,  ///< Only by roundings.
  /// All wrong pixels may show what other points of their squares do.
  kElsewhereInPixels,
  kOtherDepth,  ///< No pixel is wrong, but the numbers of depth pictures are of another kind.
  kUnknown,     ///< No explanation explains everything, or too many do.
};

/// A formula whose roundings cause wrong pixels, and the least distance, in radii, of these.
struct Imprecision {
  Arithmetic arithmetic = Arithmetic::kDifference;
  double radii = 0;
  std::string sentence() const { return imprecision_sentence(arithmetic, radii); }
};

/// Why one renderer's pictures are wrong.
struct Causes {
  /// The cause for the pictures of the right size.
  CauseKind kind = CauseKind::kNothingWrong;
  /// Each explains all wrong pixels. There are several if they make the same pictures of these
  /// scenes. If the scenes show little, pairs may be among them besides single mistakes.
  std::vector<Fault> alternatives = {};
  bool show_too_little = false;             ///< The pictures fit too many mistakes.
  std::uint64_t errors = 0, explained = 0;  ///< Pixels.
  /// Roundings of a formula that, with the first alternative, explain all wrong pixels.
  std::optional<Imprecision> imprecision = {};
  /// The pixels of pictures with width and height exchanged, if all that are not square are so.
  std::uint64_t exchanged = 0;
  bool of_depths = false;           ///< Whether these are depth pictures.
  Depth declared = {}, depth = {};  ///< For kOtherDepth: the kinds of numbers.
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
/// right or wrong. One mistake that explains all wrong pixels comes first, then two that do, then
/// one that explains kExplainedShare of them. The best is the cause; if another one that makes
/// other pictures is about as good, there is no cause. If only few mistakes show in the pictures,
/// pairs that explain as much as a single mistake are alternatives to it. Pixels that a relative
/// change of the scene by kExcusedImageChange makes right are not errors. If all wrong pixels are
/// of this kind, the mistakes that make exactly these pictures explain them. Wrong pictures that
/// are black need a full explanation. If no mistakes explain all wrong pixels, roundings do if they
/// may have caused each of them, without mistakes or with an explanation of the pictures that
/// roundings hardly affect. Domain: valid scenes with cameras.
Causes picture_causes(std::span<const ShownPicture> pictures);

/// The number of pixels of a picture that neither a fault nor the roundings of a formula explain.
std::uint64_t pixels_left(const ShownPicture& picture, const Fault& fault, Arithmetic arithmetic);

/// The causes as sentences: that of the alternatives, or of the kind.
std::vector<Explanation> explanations(const Causes& causes);

/// A scene with a camera, and whether a program failed to draw it.
struct TriedScene {
  const Scene* scene = nullptr;
  bool failed = false;
};

/// A program must fail on at least this many scenes, and not fail on at least this many.
inline constexpr std::size_t kFewestOfEachOutcome = 2;

/// A property that all scenes on which a program fails have, and no other scene.
struct ShapeCause {
  std::string sentence;
  bool (*is)(const Scene&) = nullptr;
};

/// The property of all scenes on which a program fails, and of no others: "it fails only where the
/// picture is not square". Empty if there is no such property, or more than one.
std::optional<ShapeCause> shape_cause(std::span<const TriedScene> tried);

}  // namespace raycheck::properties
