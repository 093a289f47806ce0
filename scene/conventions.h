#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace raycheck::scene {

/// Which image row is j = 0.
enum class Rows { kBottomFirst, kTopFirst };
/// Where a pixel's point lies on the image plane: i/(w-1), (i+1/2)/w or i/w of the way across; rows
/// likewise, from the side of row 0.
enum class Samples { kEdges, kCentres, kCorners };
/// Where a camera ray starts: at the pixel point P, or at the eye E.
enum class Origin { kPixel, kFocal };
/// Which root is the hit: the smallest >= 0, or always v - d (if it is negative, the ray misses).
enum class Root { kNearest, kSmaller };
/// Whether a double root is a hit. With kEither, tangents are not judged.
enum class Tangent { kHit, kMiss, kEither };

/// Which of t_min and t_max themselves count.
enum class Ends { kClosed, kOpenMax, kOpenMin, kOpen };
/// The unit of t_min and t_max: s itself, radii of the sphere that is met, or scene lengths along
/// the ray, |direction| s.
enum class TUnit { kAbsolute, kRadius, kLength };
/// Which root never counts: v + d, where a ray leaves a sphere (a back face), or v - d, where it
/// enters a sphere (a front face).
enum class Culling { kNone, kBackFaces, kFrontFaces };

/// The roots that count: those from t_min to t_max that are not culled. `root` chooses among them.
/// If t_min is -infinity, lines are intersected instead of rays.
struct ValidRoots {
  double t_min = 0;
  double t_max = std::numeric_limits<double>::infinity();
  Ends ends = Ends::kClosed;
  TUnit unit = TUnit::kAbsolute;
  Culling culling = Culling::kNone;
  bool operator==(const ValidRoots&) const = default;

  bool includes_min() const { return ends == Ends::kClosed || ends == Ends::kOpenMax; }
  bool includes_max() const { return ends == Ends::kClosed || ends == Ends::kOpenMin; }
  /// The default: every root >= 0.
  bool is_usual() const { return *this == ValidRoots{}; }
};

/// Which root is the hit, and whether a ray that touches a sphere hits it.
struct HitRule {
  Root root = Root::kNearest;
  Tangent tangent = Tangent::kHit;
};

/// A side of the image in equal steps. Pixel k is k + offset steps from the side of pixel 0, and
/// `turned` - k + offset steps from the opposite side.
struct PixelSteps {
  double offset;  ///< 0 or 1/2
  double steps;
  double turned() const { return steps - 2 * offset; }
};

/// The steps of a row or column of this many pixels, which are exact.
constexpr PixelSteps pixel_steps(Samples samples, std::int64_t count) {
  return {samples == Samples::kCentres ? 0.5 : 0.0,
          static_cast<double>(samples == Samples::kEdges ? count - 1 : count)};
}

/// The choices that the lecture leaves open; the first value of each is the default.
struct Conventions {
  Rows rows = Rows::kBottomFirst;
  Samples samples = Samples::kEdges;
  Origin origin = Origin::kPixel;
  Root root = Root::kNearest;
  Tangent tangent = Tangent::kHit;
  ValidRoots valid = {};
  bool operator==(const Conventions&) const = default;

  HitRule hit_rule() const { return {root, tangent}; }
};

/// The names that scene files and reports use, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kRowsNames = {"bottom-first", "top-first"};
inline constexpr std::array<std::string_view, 3> kSamplesNames = {"edges", "centres", "corners"};
inline constexpr std::array<std::string_view, 2> kOriginNames = {"pixel", "focal"};
inline constexpr std::array<std::string_view, 2> kRootNames = {"nearest", "smaller"};
inline constexpr std::array<std::string_view, 3> kTangentNames = {"hit", "miss", "either"};

inline constexpr std::array<std::string_view, 4> kEndsNames = {"[t_min, t_max]", "[t_min, t_max)",
                                                               "(t_min, t_max]", "(t_min, t_max)"};
inline constexpr std::array<std::string_view, 3> kTUnitNames = {"absolute", "radius", "length"};
inline constexpr std::array<std::string_view, 3> kCullingNames = {"none", "back-faces",
                                                                  "front-faces"};

constexpr auto& names_of(Rows /*of*/) { return kRowsNames; }
constexpr auto& names_of(Samples /*of*/) { return kSamplesNames; }
constexpr auto& names_of(Origin /*of*/) { return kOriginNames; }
constexpr auto& names_of(Root /*of*/) { return kRootNames; }
constexpr auto& names_of(Tangent /*of*/) { return kTangentNames; }
constexpr auto& names_of(Ends /*of*/) { return kEndsNames; }
constexpr auto& names_of(TUnit /*of*/) { return kTUnitNames; }
constexpr auto& names_of(Culling /*of*/) { return kCullingNames; }

/// The name of an enumerator, for any enumeration with names_of().
template <class Enum>
constexpr auto name(Enum value) -> decltype(names_of(value)[0]) {
  return names_of(value)[static_cast<std::size_t>(value)];
}

}  // namespace raycheck::scene
