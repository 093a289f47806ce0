#ifndef RAYCHECK_SCENE_CONVENTIONS_H_
#define RAYCHECK_SCENE_CONVENTIONS_H_

#include <array>
#include <cstddef>
#include <string_view>

namespace raycheck::scene {

/// Which image row is j = 0.
enum class Rows { kBottomFirst, kTopFirst };
/// Where in its cell of the image plane a pixel is sampled: i/(w-1), or (i+1/2)/w.
enum class Samples { kEdges, kCentres };
/// Where a camera ray starts: at the pixel point P, or at the eye E.
enum class Origin { kPixel, kFocal };
/// Which root is the intersection: the smallest >= 0, or always v - d (negative: a miss).
enum class Root { kNearest, kSmaller };
/// What a double root counts as; kEither is not judged.
enum class Tangent { kHit, kMiss, kEither };

/// The choices that the lecture leaves open; the first value of each is the default.
struct Conventions {
  Rows rows = Rows::kBottomFirst;
  Samples samples = Samples::kEdges;
  Origin origin = Origin::kPixel;
  Root root = Root::kNearest;
  Tangent tangent = Tangent::kHit;
  bool operator==(const Conventions&) const = default;
};

/// The names that scene files and reports use, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kRowsNames = {"bottom-first", "top-first"};
inline constexpr std::array<std::string_view, 2> kSamplesNames = {"edges", "centres"};
inline constexpr std::array<std::string_view, 2> kOriginNames = {"pixel", "focal"};
inline constexpr std::array<std::string_view, 2> kRootNames = {"nearest", "smaller"};
inline constexpr std::array<std::string_view, 3> kTangentNames = {"hit", "miss", "either"};

constexpr std::string_view name(Rows value) { return kRowsNames[static_cast<std::size_t>(value)]; }
constexpr std::string_view name(Samples value) {
  return kSamplesNames[static_cast<std::size_t>(value)];
}
constexpr std::string_view name(Origin value) {
  return kOriginNames[static_cast<std::size_t>(value)];
}
constexpr std::string_view name(Root value) { return kRootNames[static_cast<std::size_t>(value)]; }
constexpr std::string_view name(Tangent value) {
  return kTangentNames[static_cast<std::size_t>(value)];
}

}  // namespace raycheck::scene

#endif  // RAYCHECK_SCENE_CONVENTIONS_H_
