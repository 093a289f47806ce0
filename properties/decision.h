#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <tuple>

#include "properties/quantity.h"
#include "scene/camera.h"
#include "scene/conventions.h"

namespace raycheck::properties {

/// The way in which a decision was wrong.
enum class Wrong {
  kNot,
  kMissed,
  kFalseHit,
  kWrongSphere,
  kWrongRoot,
  kRefused,
  kAnswered,
  kFailed
};
inline constexpr std::size_t kWrongCount = 8;
inline constexpr std::array<std::string_view, kWrongCount> kWrongNames = {
    "",
    "missed",
    "false hit",
    "wrong sphere",
    "wrong root",
    "refused",
    "answered what is not a problem",
    "failed"};
constexpr auto& names_of(Wrong /*of*/) { return kWrongNames; }
using scene::name;

/// The kind of the right answer. Where a kind was expected and never answered right, a law has
/// shown nothing about it.
enum class Expected {
  kHit,
  kMiss,
  kSmallerRoot,
  kLargerRoot,
  kNearestOfSeveral,  ///< Among several spheres that a ray meets.
  kOnlySphere,
  kNoSphere,
  kRefusal,
  kValue,  ///< A number or a vector: right if within its bound.
};
inline constexpr std::size_t kExpectedCount = 9;
inline constexpr std::array<std::string_view, kExpectedCount> kExpectedNames = {
    "hit",         "miss",      "smaller root", "larger root", "nearest of several",
    "only sphere", "no sphere", "refusal",      "value"};
constexpr auto& names_of(Expected /*of*/) { return kExpectedNames; }

/// The part of a case that an answer is about: a ray (a camera's pixel, or a given ray by its
/// index), and a sphere if the quantity has one.
struct Place {
  std::size_t ray = 0;
  std::optional<scene::Pixel> pixel;
  std::optional<std::size_t> sphere;
  void serialize(auto& archive) { archive(ray, pixel, sphere); }
};

/// The order of places by the ray, then the sphere, then the pixel.
inline bool is_earlier(const Place& a, const Place& b) {
  const auto key = [](const Place& place) {
    const scene::Pixel pixel = place.pixel.value_or(scene::Pixel{-1, -1});
    return std::tuple(place.ray, place.sphere.value_or(0), pixel.j, pixel.i);
  };
  return key(a) < key(b);
}

/// An answer that is right or wrong: the place, the expected kind, and how the answer differs.
struct Decision {
  Quantity quantity;
  Expected expected;
  Place place;
  Wrong wrong;
};

}  // namespace raycheck::properties
