#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/plan/eye_space.h"
#include "scene/scene.h"

namespace raycheck::scene {

/// The results that are wanted for a scene.
enum class Wanted { kClass, kParameter, kPoint, kNearest };
inline constexpr std::array<std::string_view, 4> kWantedNames = {"class", "parameter", "point",
                                                                 "nearest"};
inline constexpr std::array kEveryWanted = {Wanted::kClass, Wanted::kParameter, Wanted::kPoint,
                                            Wanted::kNearest};

/// The optimisations of a plan; each can be switched off.
struct PlanItems {
  bool view = true;        ///< Leave out spheres outside the view volume.
  bool behind = true;      ///< Leave out spheres behind every origin.
  bool hidden = true;      ///< Leave out spheres hidden by a nearer one, if the nearest is wanted.
  bool rectangles = true;  ///< Test a sphere only at the pixels of its rectangle.
  bool constants = true;   ///< Compute once the terms of a sphere that all rays from the eye share.
  bool far_root = true;    ///< Use a sphere's far root only if an origin may be inside.
  bool behind_test = true;  ///< Compare roots with 0 only if a sphere may reach behind an origin.
  bool scaling = true;      ///< Scale by powers of two only if magnitudes require it.
  bool filter = true;       ///< Decide exactly only if the filter in doubles fails.
  bool basis = true;        ///< If the axes are the world's, permute coordinates, do not multiply.
  bool quantities = true;   ///< Compute only the results wanted.
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

/// The work that a sphere needs.
struct SpherePlan {
  std::optional<LeftOut> left_out;
  std::optional<std::size_t> hidden_by;
  PixelRectangle pixels;       ///< Contains all pixels whose rays meet it; empty if left out.
  bool origin_inside = true;   ///< A ray may start inside it, so that its far root may count.
  bool reaches_behind = true;  ///< The line of a ray may meet it behind the ray's origin.
  EyeSphere seen;
  bool operator==(const SpherePlan&) const = default;
};

/// The computations that a scene needs, decided once from its camera and spheres. Bounds are
/// rounded outward, so that leaving out the other computations changes no answer. Scenes of given
/// rays have no plan.
/// Shape:  a scene -> one SpherePlan and one distance per sphere, in their order.
/// Units:  rectangles in pixels (i, j) as the conventions count them; scene lengths.
/// Domain: a valid scene with a camera; otherwise throws std::invalid_argument naming the field.
/// Error:  the ray of a pixel outside a sphere's rectangle certainly misses the sphere. The
///         rectangle exceeds the sphere's exact silhouette bounds by at most kRectangleSlack pixels
///         on each side, if these bounds are well conditioned.
/// Source: silhouette bounds of the cone from the eye over the sphere. In the planes (U, W) and (V,
///         W), its two tangents are the direction of the centre turned by asin(r/rho).
struct ScenePlan {
  Conventions conventions;
  Wanted wanted = Wanted::kParameter;
  PlanItems items;
  EyeSpace eye;
  std::vector<SpherePlan> spheres;
  /// For each sphere, a lower bound on the distance from the eye at which rays meet it, scaled like
  /// SpherePlan::seen; infinite if the sphere is left out.
  std::vector<double> nearest_distance;
};

/// The number of pixels by which a rectangle may be too large on each side.
inline constexpr std::int64_t kRectangleSlack = 1;

/// Each sphere is compared with at most this many spheres, the largest in the image.
inline constexpr std::size_t kMostOccluders = 64;

/// Magnitudes from 2^-kPlainExponent to 2^kPlainExponent need no scaling: products of four neither
/// overflow nor vanish.
inline constexpr int kPlainExponent = 120;

/// Calls body(k) for every k < count, in any order, possibly in parallel.
using ForEach =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& body)>;
void one_by_one(std::size_t count, const std::function<void(std::size_t)>& body);

/// Plans a scene. The plan does not depend on `for_each`.
ScenePlan plan_scene(const Scene& scene, const Conventions& conventions, Wanted wanted,
                     const PlanItems& items = {}, const ForEach& for_each = one_by_one);

}  // namespace raycheck::scene
