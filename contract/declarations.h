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
/// or its square; only that it is one; or both roots of the ray's line.
enum class Returns { kHit, kParameter, kPoint, kDistance, kSquaredDistance, kClass, kRoots };
inline constexpr std::array<std::string_view, 7> kReturnsNames = {
    "hit", "parameter", "point", "distance", "squared-distance", "class", "roots"};
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

/// The length of the directions of the rays that a candidate makes: 1; any, or |P - E| (s = 1 on
/// the image plane). Directions that are not unit are made unit before they are judged.
enum class MadeLength { kUnit, kAny, kImagePlane };
inline constexpr std::array<std::string_view, 3> kMadeLengthNames = {"unit", "any", "image-plane"};
constexpr auto& names_of(MadeLength /*of*/) { return kMadeLengthNames; }

/// What comes with the origin of a ray: its direction, or its point at s = 1, the end of a segment.
enum class RayForm { kDirection, kEnd };
inline constexpr std::array<std::string_view, 2> kRayFormNames = {"direction", "end"};
constexpr auto& names_of(RayForm /*of*/) { return kRayFormNames; }

/// The windows of the cameras that a candidate accepts: all, or those of a camera with a field of
/// view, centred on the axis (left = -right < 0, bottom = -top < 0, near < 0), with pixels of any
/// shape or square ones.
enum class Windows { kAny, kSymmetric, kSquarePixels };
inline constexpr std::array<std::string_view, 3> kWindowsNames = {"any", "symmetric",
                                                                  "square-pixels"};
constexpr auto& names_of(Windows /*of*/) { return kWindowsNames; }

/// The spheres that a candidate accepts: all; one about the origin; the unit sphere about the
/// origin, to whose frame its callers transform rays.
enum class Placement { kAnywhere, kOrigin, kUnit };
inline constexpr std::array<std::string_view, 3> kPlacementNames = {"anywhere", "origin", "unit"};
constexpr auto& names_of(Placement /*of*/) { return kPlacementNames; }

/// What comes with the eye of a camera: the point A that it looks at, or the view direction A - E;
/// or A, which is always the centre of the first sphere.
enum class View { kLookAt, kDirection, kCentre };
inline constexpr std::array<std::string_view, 3> kViewNames = {"look-at", "direction", "centre"};
constexpr auto& names_of(View /*of*/) { return kViewNames; }

/// The hit of a ray that starts inside a sphere: a root that counts; the start of the ray, at s =
/// 0, as the ball is solid; or the near root, v - d, although it is negative.
enum class FromInside { kRoot, kStart, kNearRoot };
inline constexpr std::array<std::string_view, 3> kFromInsideNames = {"root", "start", "near-root"};
constexpr auto& names_of(FromInside /*of*/) { return kFromInsideNames; }

/// How a candidate is called, and what it returns.
struct Interface {
  Directions directions = Directions::kAny;
  RayForm rays = RayForm::kDirection;
  SphereSize spheres = SphereSize::kRadius;
  Placement placement = Placement::kAnywhere;
  PixelOrder pixels = PixelOrder::kColumnRow;
  Windows windows = Windows::kAny;
  View view = View::kLookAt;
  MadeLength made = MadeLength::kUnit;
  Returns returns = Returns::kHit;
  FromInside from_inside = FromInside::kRoot;
  bool operator==(const Interface&) const = default;
};
template <scene::Either<Interface> SomeInterface, class Visit>
void for_each_choice(SomeInterface& interface, Visit visit) {
  visit("directions", interface.directions, "the directions that it accepts");
  visit("rays", interface.rays,
        "what comes with a ray's origin: a direction, or the point at s = 1");
  visit("spheres", interface.spheres, "the number that comes with a sphere's centre");
  visit("placement", interface.placement,
        "the spheres that it accepts: anywhere, about the origin, or only the unit sphere there");
  visit("pixels", interface.pixels, "the order of a pixel's two indices");
  visit("windows", interface.windows, "the windows of the cameras that it accepts");
  visit("view", interface.view,
        "what comes with a camera's eye: the point looked at, the view direction, or a sphere's "
        "centre");
  visit("made_directions", interface.made,
        "the length of the directions of the rays that it makes");
  visit("returns", interface.returns, "what it returns for a hit");
  visit("from_inside", interface.from_inside,
        "the hit of a ray that starts inside: a root that counts, its start, or v - d");
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

/// Where a ray nearly touches a sphere, or starts nearly on it, within these either answer is
/// right: a miss, either root, or a point as near to the surface (properties/tolerance.h). 0:
/// exactly there only the exact answer is right.
struct Tolerances {
  double discriminant = 0, d_sq = 0, distance = 0, radii = 0;  ///< Of rays that nearly touch.
  double c = 0, surface = 0, s = 0, s_radii = 0;               ///< Of origins nearly on a sphere.
  bool operator==(const Tolerances&) const = default;
};
template <scene::Either<Tolerances> SomeTolerances, class Visit>
void for_each_tolerance(SomeTolerances& within, Visit visit) {
  visit("tolerance_discriminant", within.discriminant,
        "either answer is right if |b^2 - 4ac| is at most this");
  visit("tolerance_d_sq", within.d_sq,
        "either answer is right if |d^2| = |r^2 - |T x D|^2| is at most this");
  visit("tolerance_distance", within.distance,
        "either answer is right if the line passes the sphere's outline within this distance");
  visit("tolerance_radii", within.radii, "tolerance_distance in multiples of the radius");
  visit("tolerance_c", within.c,
        "either answer is right if |c| = ||T|^2 - r^2| of the origin is at most this");
  visit("tolerance_surface", within.surface,
        "either answer is right if the origin is within this distance of the surface");
  visit("tolerance_s", within.s, "either answer is right if |s| of a root is at most this");
  visit("tolerance_s_radii", within.s_radii, "tolerance_s in multiples of the radius");
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
  Tolerances tolerances;
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
  visit("lengths", declared.lengths,
        "the lengths on which it is judged, within 2^-960 and inf: SMALLEST LARGEST");
  visit("precision", declared.precision, "the format that it computes in");
  for_each_choice(declared.interface, visit);
  for_each_tolerance(declared.tolerances, visit);
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

/// What is invalid: an interval that ends before it begins, lengths that are not a range, a
/// tolerance that is negative or not finite.
std::vector<scene::Defect> defects(const Declarations& declared);

}  // namespace raycheck::contract
