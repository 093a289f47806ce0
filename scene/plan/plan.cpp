#include "scene/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <unordered_set>
#include <utility>

#include "scene/interruption.h"
#include "scene/validate.h"

namespace raycheck::scene {
namespace {

/// The slopes x/z of the directions with z > 0 whose half-lines from 0 meet a disc; empty: none.
/// The disc's tangents from 0 are (x, z) turned by asin(r/rho) to either side, times rho.
std::optional<Bounds> slopes_of_disc(const Bounds& x, const Bounds& z, const Bounds& r) {
  const Bounds q_sq = square(x) + square(z) - square(r);
  Bounds slopes = Bounds::everything();
  if (!(q_sq.low > 0)) return slopes;
  const Bounds q = sqrt(q_sq);
  const Bounds right_z = z * q - x * r;
  const Bounds left_z = z * q + x * r;
  // The half-lines lie between the two tangents, in less than a half-plane.
  if (right_z.high < 0 && left_z.high < 0) return std::nullopt;
  if (right_z.low > 0) slopes.high = ((x * q + z * r) / right_z).high;
  if (left_z.low > 0) slopes.low = ((x * q - z * r) / left_z).low;
  return slopes;
}

/// The integers of [0, count) within a range.
std::pair<std::int64_t, std::int64_t> indices(const Bounds& range, std::int64_t count) {
  const auto most = static_cast<double>(count);
  return {static_cast<std::int64_t>(std::ceil(std::clamp(range.low, 0.0, most))),
          static_cast<std::int64_t>(std::floor(std::clamp(range.high, -1.0, most - 1))) + 1};
}

class Planner {
 public:
  Planner(const Scene& scene, ScenePlan& plan)
      : camera_(*scene.camera),
        plan_(plan),
        forward_(camera_.near < 0 ? -1 : 1),
        near_(in_lengths(plan.eye.near())),
        across_(in_lengths(hull(plan.eye.alpha(0), last(camera_.width, &EyeSpace::alpha)))),
        along_(in_lengths(hull(plan.eye.beta(0), last(camera_.height, &EyeSpace::beta)))) {}

  SpherePlan plan(const Sphere& sphere) const {
    SpherePlan result;
    result.seen = plan_.eye.sphere(sphere);
    const Bounds z = forward_ > 0 ? result.seen.w : -result.seen.w;
    const Bounds& r = result.seen.radius;
    const bool from_pixels = plan_.conventions.origin == Origin::kPixel;
    const Bounds start = !from_pixels ? Bounds::exactly(0) : forward_ > 0 ? near_ : -near_;
    result.nearest_distance = std::max(0.0, (sqrt(result.seen.distance_sq) - r).low);
    if (plan_.items.behind_test) result.reaches_behind = !((z - r).low > start.high);
    if (plan_.items.far_root) {
      result.origin_inside =
          plan_.conventions.root == Root::kNearest &&
          !((from_pixels ? distance_sq_to_plane(result.seen) : result.seen.distance_sq).low >
            square(r).high);
    }
    if (plan_.items.behind && (z + r).high < start.low) {
      result.left_out = LeftOut::kBehind;
      return result;
    }
    result.pixels = rectangle(result.seen, z);
    const PixelRectangle image{0, camera_.width, 0, camera_.height};
    if (plan_.items.view && result.pixels.empty()) {
      result.left_out = LeftOut::kOutsideView;
      result.pixels = {};
    } else if (!plan_.items.rectangles || result.pixels.empty()) {
      result.pixels = image;
    }
    return result;
  }

 private:
  Bounds last(std::int64_t count, Bounds (EyeSpace::*position)(double) const) const {
    return (plan_.eye.*position)(static_cast<double>(count - 1));
  }
  static Bounds hull(const Bounds& x, const Bounds& y) {
    return {std::min(x.low, y.low), std::max(x.high, y.high)};
  }
  Bounds in_lengths(const Bounds& on_plane) const {
    return scaled(on_plane, plan_.eye.scaling().plane - plan_.eye.scaling().lengths);
  }

  PixelRectangle rectangle(const EyeSphere& seen, const Bounds& z) const {
    const auto across = slopes_of_disc(seen.u, z, seen.radius);
    const auto along = slopes_of_disc(seen.v, z, seen.radius);
    if (!across || !along) return {};
    const Bounds n = plan_.eye.near();
    const Bounds ahead = forward_ > 0 ? n : -n;
    const auto [i_begin, i_end] = indices(plan_.eye.column(*across * ahead), camera_.width);
    const auto [j_begin, j_end] = indices(plan_.eye.row(*along * ahead), camera_.height);
    return {i_begin, i_end, j_begin, j_end};
  }

  /// The squared distance of a centre from the image plane's pixels.
  Bounds distance_sq_to_plane(const EyeSphere& seen) const {
    const auto beyond = [](const Bounds& x, const Bounds& range) {
      const Bounds below = Bounds::exactly(range.low) - x;
      const Bounds above = x - Bounds::exactly(range.high);
      return Bounds{std::max({0.0, below.low, above.low}), std::max({0.0, below.high, above.high})};
    };
    return square(beyond(seen.u, across_)) + square(beyond(seen.v, along_)) +
           square(seen.w - near_);
  }

  const Camera& camera_;
  const ScenePlan& plan_;
  int forward_;  ///< The sign along W of the directions of rays.
  // The image plane, in the unit of spheres' lengths.
  Bounds near_, across_, along_;
};

/// Whether every ray from the eye that meets `sphere` meets `by` before it: its cone is inside the
/// other's and all of it beyond where that touches `by`. With t^2 = |C - E|^2 - r^2, the cosine of
/// the difference of the cones' half angles is (t t_by + r r_by) / (|C - E| |C_by - E|).
bool covers(const EyeSphere& by, const EyeSphere& sphere) {
  if (!(sphere.power.low > 0)) return false;
  const Bounds touch = sqrt(by.power);
  const Bounds distance = sqrt(sphere.distance_sq);
  const Bounds dot = sphere.u * by.u + sphere.v * by.v + sphere.w * by.w;
  return (distance - sphere.radius).low > touch.high &&
         (sphere.radius * sqrt(by.distance_sq)).high < (by.radius * distance).low &&
         dot.low > (touch * sqrt(sphere.power) + by.radius * sphere.radius).high;
}

/// All of `sphere` is inside `by`.
bool contains(const Sphere& by, const Sphere& sphere) {
  const auto apart_sq = [](double to, double from) {
    return square(Bounds::exactly(to) - Bounds::exactly(from));
  };
  const Bounds apart =
      sqrt(apart_sq(sphere.centre.x, by.centre.x) + apart_sq(sphere.centre.y, by.centre.y) +
           apart_sq(sphere.centre.z, by.centre.z));
  return (apart + Bounds::exactly(sphere.radius)).high < by.radius;
}

constexpr std::size_t kHashFactor = 0x9e3779b97f4a7c15;

void leave_out_hidden(const std::vector<Sphere>& spheres, std::vector<SpherePlan>& plans) {
  const auto leave_out = [&](std::size_t sphere, std::size_t by) {
    plans[sphere].left_out = LeftOut::kHidden;
    plans[sphere].hidden_by = by;
    plans[sphere].pixels = {};
  };
  // Of equal spheres the first in the file wins.
  const auto hash = [&](std::size_t k) {
    const auto& [centre, radius] = spheres[k];
    std::size_t bits = 0;
    for (const double x : {centre.x, centre.y, centre.z, radius}) {
      bits = bits * kHashFactor + std::hash<double>()(x);
    }
    return bits;
  };
  const auto equal = [&](std::size_t a, std::size_t b) { return spheres[a] == spheres[b]; };
  std::unordered_set<std::size_t, decltype(hash), decltype(equal)> distinct(spheres.size(), hash,
                                                                            equal);
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    if (plans[k].left_out) continue;
    const auto [found, is_new] = distinct.insert(k);
    if (!is_new) leave_out(k, *found);
  }
  // Spheres that every ray meets at the near root, those that look largest.
  std::vector<std::pair<double, std::size_t>> by_size;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const EyeSphere& seen = plans[k].seen;
    if (!plans[k].left_out && !plans[k].reaches_behind && seen.power.low > 0) {
      by_size.emplace_back(-seen.radius.high / std::sqrt(seen.distance_sq.high), k);
    }
  }
  const std::size_t count = std::min(by_size.size(), kMostOccluders);
  std::partial_sort(by_size.begin(), by_size.begin() + static_cast<std::ptrdiff_t>(count),
                    by_size.end());
  std::vector<std::size_t> occluders;
  for (std::size_t o = 0; o < count; ++o) occluders.push_back(by_size[o].second);
  std::vector<PixelRectangle> covered;
  for (const std::size_t by : occluders) covered.push_back(plans[by].pixels);
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    poll();
    for (std::size_t o = 0; o < occluders.size() && !plans[k].left_out; ++o) {
      const std::size_t by = occluders[o];
      if (by != k && covered[o].contains(plans[k].pixels) &&
          (contains(spheres[by], spheres[k]) || covers(plans[by].seen, plans[k].seen))) {
        leave_out(k, by);
      }
    }
  }
}

/// The least and the largest nonzero magnitude; {0, 0} if there is none.
struct Magnitudes {
  double smallest = 0, largest = 0;

  void add(double x) {
    const double size = std::min(std::abs(x), std::numeric_limits<double>::max());
    if (size == 0) return;
    smallest = smallest == 0 ? size : std::min(smallest, size);
    largest = std::max(largest, size);
  }
  /// The exponent of the largest; 0 if all are in the plain range.
  int exponent(bool only_if_needed) const {
    if (largest == 0) return 0;
    const bool plain =
        std::ilogb(largest) < kPlainExponent && std::ilogb(smallest) >= -kPlainExponent;
    return plain && only_if_needed ? 0 : std::ilogb(largest);
  }
};

Scaling scaling_of(const Scene& scene, bool only_if_needed) {
  const Camera& camera = *scene.camera;
  Magnitudes plane, lengths;
  for (const double x : {camera.near, camera.left, camera.right, camera.bottom, camera.top}) {
    plane.add(x);
  }
  for (const Sphere& sphere : scene.spheres) {
    const Vector3 f = sphere.centre - camera.eye;
    lengths.add(std::max({std::abs(f.x), std::abs(f.y), std::abs(f.z)}));
    lengths.add(sphere.radius);
  }
  return {plane.exponent(only_if_needed), lengths.exponent(only_if_needed)};
}

}  // namespace

ScenePlan plan_scene(const Scene& scene, const Conventions& conventions, Wanted wanted,
                     const PlanItems& items) {
  Scene under_conventions = scene;
  under_conventions.conventions = conventions;
  require_valid(under_conventions);
  if (!scene.camera) {
    throw std::invalid_argument("camera: absent; a scene of given rays has no plan");
  }
  const Camera& camera = *scene.camera;
  ScenePlan plan{conventions,
                 wanted,
                 items,
                 EyeSpace(camera, conventions, scaling_of(scene, items.scaling), !items.basis),
                 {}};
  const Planner planner(scene, plan);
  std::vector<SpherePlan> spheres(scene.spheres.size());
  std::transform(scene.spheres.begin(), scene.spheres.end(), spheres.begin(),
                 [&](const Sphere& sphere) {
                   poll();
                   return planner.plan(sphere);
                 });
  // A sphere whose near root does not count hides nothing.
  const bool all_count = conventions.valid.is_usual();
  if (items.hidden && wanted == Wanted::kNearest && all_count)
    leave_out_hidden(scene.spheres, spheres);
  plan.spheres = std::move(spheres);
  return plan;
}

}  // namespace raycheck::scene
