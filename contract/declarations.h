#pragma once

// What a candidate declares about itself, each declaration listed once. Made from this list: the
// statements of the protocol and of <raycheck/candidate.h>, their checks, and `raycheck list`.

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contract/words.h"
#include "scene/conventions.h"
#include "scene/fields.h"
#include "scene/precision.h"
#include "scene/validate.h"

namespace raycheck::contract {

/// How good code must be to be right on a case, as measured for the severities of
/// properties/cases/. A level includes all levels before it.
enum class Level {
  kOrdinary,   ///< Any plain, careful code in doubles.
  kDemanding,  ///< A stable method: far, grazing, nearly tied; no square over- or underflows.
  kExtreme     ///< All that doubles can express.
};
inline constexpr std::array<std::string_view, 3> kLevelNames = {"ordinary", "demanding", "extreme"};
constexpr auto& names_of(Level /*of*/) { return kLevelNames; }

/// Which directions a candidate accepts.
enum class Directions { kAny, kUnit };
inline constexpr std::array<std::string_view, 2> kDirectionsNames = {"any", "unit"};
constexpr auto& names_of(Directions /*of*/) { return kDirectionsNames; }

/// The values that a candidate returns for a hit: s and Q; s; Q; the distance of Q along the ray,
/// or its square; or only that it is one.
enum class Returns { kHit, kParameter, kPoint, kDistance, kSquaredDistance, kClass };
inline constexpr std::array<std::string_view, 6> kReturnsNames = {
    "hit", "parameter", "point", "distance", "squared-distance", "class"};
constexpr auto& names_of(Returns /*of*/) { return kReturnsNames; }
constexpr bool gives_point(Returns returns) {
  return returns == Returns::kHit || returns == Returns::kPoint;
}
constexpr bool gives_parameter(Returns returns) {
  return returns != Returns::kPoint && returns != Returns::kClass;
}

/// The number that comes with a sphere's centre.
enum class SphereSize { kRadius, kDiameter };
inline constexpr std::array<std::string_view, 2> kSphereSizeNames = {"radius", "diameter"};
constexpr auto& names_of(SphereSize /*of*/) { return kSphereSizeNames; }

/// The order of a pixel's two indices.
enum class PixelOrder { kColumnRow, kRowColumn };
inline constexpr std::array<std::string_view, 2> kPixelOrderNames = {"column-row", "row-column"};
constexpr auto& names_of(PixelOrder /*of*/) { return kPixelOrderNames; }

/// The length of the directions of the rays that a candidate makes. Directions of any length are
/// made unit before they are judged.
enum class MadeLength { kUnit, kAny };
inline constexpr std::array<std::string_view, 2> kMadeLengthNames = {"unit", "any"};
constexpr auto& names_of(MadeLength /*of*/) { return kMadeLengthNames; }

/// What comes with the origin of a ray: its direction, or its point at s = 1, the end of a segment.
enum class RayForm { kDirection, kEnd };
inline constexpr std::array<std::string_view, 2> kRayFormNames = {"direction", "end"};
constexpr auto& names_of(RayForm /*of*/) { return kRayFormNames; }

/// How a candidate is called, and what it returns.
struct Interface {
  Directions directions = Directions::kAny;
  RayForm rays = RayForm::kDirection;
  SphereSize spheres = SphereSize::kRadius;
  PixelOrder pixels = PixelOrder::kColumnRow;
  MadeLength made = MadeLength::kUnit;
  Returns returns = Returns::kHit;
  bool operator==(const Interface&) const = default;
};
template <scene::Either<Interface> SomeInterface, class Visit>
void for_each_choice(SomeInterface& interface, Visit visit) {
  visit("directions", interface.directions, "the directions that it accepts");
  visit("rays", interface.rays,
        "what comes with a ray's origin: a direction, or the point at s = 1");
  visit("spheres", interface.spheres, "the number that comes with a sphere's centre");
  visit("pixels", interface.pixels, "the order of a pixel's two indices");
  visit("made_directions", interface.made,
        "the length of the directions of the rays that it makes");
  visit("returns", interface.returns, "what it returns for a hit");
}

/// Whether random cases ask for corners if `samples` is left to the scene. Code from before there
/// were corners follows edges and centres only.
enum class Corners { kUnasked, kAsAsked };
inline constexpr std::array<std::string_view, 2> kCornersNames = {"unasked", "as-asked"};
constexpr auto& names_of(Corners /*of*/) { return kCornersNames; }

/// Which roots count, as public structs declare it: every one >= 0, those declared beside it, or
/// those of the scene.
enum class RootsOf { kUsual, kDeclared, kScene };
inline constexpr std::array<std::string_view, 3> kRootsOfNames = {"usual", "declared", "as-asked"};
constexpr auto& names_of(RootsOf /*of*/) { return kRootsOfNames; }

using scene::name;

/// The conventions that a candidate fixes; it takes the others from the scene.
struct DeclaredConventions {
  std::optional<scene::Rows> rows;
  std::optional<scene::Samples> samples;
  std::optional<scene::Origin> origin;
  std::optional<scene::Root> root;
  std::optional<scene::Tangent> tangent;
  std::optional<scene::ValidRoots> valid = {};

  /// The scene's conventions, or another declaration's, overridden by those declared here.
  scene::Conventions over(scene::Conventions conventions) const;
  DeclaredConventions over(DeclaredConventions others) const;
};

/// The value of a declaration that leaves the choice to the scene.
inline constexpr std::string_view kAsAsked = "as-asked";

/// The range of nonzero lengths of the scenes that a candidate is meant for.
struct Lengths {
  double smallest = 0;
  double largest = std::numeric_limits<double>::infinity();
  bool operator==(const Lengths&) const = default;
};

template <scene::Either<Lengths> SomeLengths, class Visit>
void for_each_word(SomeLengths& lengths, Visit visit) {
  visit(lengths.smallest);
  visit(lengths.largest);
}

/// All that a candidate declares. Unless it declares other roots, every root >= 0 counts.
struct Declarations {
  DeclaredConventions conventions = {.rows = {},
                                     .samples = {},
                                     .origin = {},
                                     .root = {},
                                     .tangent = {},
                                     .valid = scene::ValidRoots{}};
  Corners corners = Corners::kUnasked;
  Level level = Level::kOrdinary;  ///< The level that it must reach.
  Lengths lengths;
  scene::Precision precision = scene::Precision::kDouble;  ///< The format that it computes in.
  Interface interface;
};

/// Calls visit(name, field, meaning) for every declaration. The single fields of valid roots can be
/// declared, too (scene::for_each_field).
template <scene::Either<Declarations> SomeDeclarations, class Visit>
void for_each_declaration(SomeDeclarations& declared, Visit visit) {
  auto& conventions = declared.conventions;
  visit("rows", conventions.rows, "which image row is j = 0");
  visit("samples", conventions.samples, "where a pixel is sampled: i/(w-1), (i+1/2)/w, or i/w");
  visit("corners", declared.corners, "whether random cases ask for corners (samples as-asked)");
  visit("origin", conventions.origin, "where camera rays start: the pixel's point, or the eye");
  visit("root", conventions.root, "the hit: the smallest root that counts, or always v - d");
  visit("tangent", conventions.tangent, "whether a double root is a hit");
  visit("roots", conventions.valid, "which roots count: ENDS T_MIN T_MAX UNIT CULLING");
  visit("level", declared.level, "how hard the cases are that it must get right");
  visit("lengths", declared.lengths, "the nonzero lengths on which it is judged: SMALLEST LARGEST");
  visit("precision", declared.precision, "the format that it computes in");
  for_each_choice(declared.interface, visit);
}

/// Sets what a statement declares: "rows top-first", "t_min 1e-4", "lengths 1e-30 1e30".
/// Errors: std::invalid_argument naming what is wrong, and what is expected.
void declare(Words& statement, Declarations& declared);

/// The same for several, separated by semicolons.
void declare_all(std::string_view contract, Declarations& declared);

/// The statements that declare what differs from the defaults, in alphabetical order.
std::vector<std::string> statements(const Declarations& declared);

/// "roots ENDS T_MIN T_MAX UNIT CULLING", a line.
std::string roots_line(const scene::ValidRoots& valid);

/// What is invalid: an interval that ends before it begins, lengths that are not a range.
std::vector<scene::Defect> defects(const Declarations& declared);

}  // namespace raycheck::contract
