#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/plan/eye_space.h"
#include "scene/scene.h"

namespace raycheck::scene {

/// What is asked of a scene.
enum class Wanted { kClass, kParameter, kPoint, kNearest };
inline constexpr std::array<std::string_view, 4> kWantedNames = {"class", "parameter", "point",
                                                                 "nearest"};

/// What a plan may do, each of which it can be told to leave alone.
struct PlanItems {
  bool view = true;    ///< Leave out spheres outside the view volume.
  bool behind = true;  ///< Leave out spheres behind every origin.
  bool hidden = true;  ///< Leave out spheres hidden by a nearer one, where the nearest is wanted.
  bool rectangles = true;  ///< Ask only the pixels of a sphere's rectangle about it.
  bool constants = true;   ///< Compute once what a sphere has in common with all rays from the eye.
  bool far_root = true;    ///< The far root only where an origin may be inside.
  bool behind_test = true;  ///< Compare roots with the origin only where a sphere may reach behind.
  bool scaling = true;      ///< Scale by powers of two only where magnitudes call for it.
  bool filter = true;       ///< The exact fallback only where the filter of doubles fails.
  bool basis = true;  ///< Exchange coordinates instead of products where the axes are the world's.
  bool quantities = true;  ///< Only what is wanted.
};

/// Pixels i_begin <= i < i_end, j_begin <= j < j_end.
struct PixelRectangle {
  std::int64_t i_begin = 0, i_end = 0, j_begin = 0, j_end = 0;

  bool empty() const { return i_begin >= i_end || j_begin >= j_end; }
  bool contains(const Pixel& pixel) const {
    return i_begin <= pixel.i && pixel.i < i_end && j_begin <= pixel.j && pixel.j < j_end;
  }
  bool contains(const PixelRectangle& other) const {
    return i_begin <= other.i_begin && other.i_end <= i_end && j_begin <= other.j_begin &&
           other.j_end <= j_end;
  }
  std::int64_t count() const { return empty() ? 0 : (i_end - i_begin) * (j_end - j_begin); }
  bool operator==(const PixelRectangle&) const = default;
};

/// Why a sphere is left out.
enum class LeftOut { kOutsideView, kBehind, kHidden };
inline constexpr std::array<std::string_view, 3> kLeftOutNames = {"outside the view",
                                                                  "behind the rays", "hidden"};

/// What a sphere needs.
struct SpherePlan {
  std::optional<LeftOut> left_out;
  std::optional<std::size_t> hidden_by;
  PixelRectangle pixels;        ///< Every pixel whose ray meets it; empty where it is left out.
  bool origin_inside = true;    ///< A ray may start inside: its far root may count.
  bool reaches_behind = true;   ///< A ray's line may meet it behind the origin.
  double nearest_distance = 0;  ///< No ray meets it nearer to the eye; scaled as `seen`.
  EyeSphere seen;
};

/// What a scene needs, decided once from its camera and spheres, outward-rounded, so that leaving
/// out the rest changes no answer. Scenes of given rays have no plan: each ray is on its own.
/// Shape:  a scene -> one SpherePlan a sphere, in their order.
/// Units:  rectangles in pixels (i, j) as the conventions count them; scene lengths.
/// Domain: a valid scene with a camera; otherwise throws std::invalid_argument naming the field.
/// Error:  a pixel outside a sphere's rectangle certainly misses it; the rectangle is at most
///         kRectangleSlack pixels a side larger than the pixels inside the sphere's silhouette
///         bounds call for, while those bounds are well conditioned.
/// Source: silhouette bounds of the cone from the eye over the sphere, in the planes (U, W) and (V,
///         W): its two tangent directions are the direction of the centre turned by asin(r/rho).
struct ScenePlan {
  Conventions conventions;
  Wanted wanted = Wanted::kParameter;
  PlanItems items;
  EyeSpace eye;
  std::vector<SpherePlan> spheres;
};

/// By how many pixels a side a rectangle may be too large.
inline constexpr std::int64_t kRectangleSlack = 1;

/// How many of the spheres that look largest each sphere is compared with.
inline constexpr std::size_t kMostOccluders = 64;

/// Magnitudes within 2^-kPlainExponent and 2^kPlainExponent need no scaling: products of four of
/// them neither overflow nor vanish.
inline constexpr int kPlainExponent = 120;

ScenePlan plan_scene(const Scene& scene, const Conventions& conventions, Wanted wanted,
                     const PlanItems& items = {});

}  // namespace raycheck::scene
