#include "scene/plan/plan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "scene/interruption.h"
#include "scene/plan/plan_kernel.h"
#include "scene/validate.h"

namespace raycheck::scene {
namespace {

PlanTerms terms_of(const Camera& camera, const ScenePlan& plan) {
  const EyeSpace& eye = plan.eye;
  const auto in_lengths = [&](const Bounds& on_plane) {
    return scaled(on_plane, eye.scaling().plane - eye.scaling().lengths);
  };
  const auto hull = [&](const Bounds& x, const Bounds& y) {
    return in_lengths({std::min(x.low, y.low), std::max(x.high, y.high)});
  };
  const auto width = static_cast<double>(camera.width);
  const auto height = static_cast<double>(camera.height);
  const bool is_forward = camera.near > 0;
  const auto forward = [=](const Bounds& x) { return is_forward ? x : -x; };
  const bool from_pixels = plan.conventions.origin == Origin::kPixel;
  const Bounds near = in_lengths(eye.near());
  return {eye,
          plan.items,
          is_forward,
          from_pixels,
          plan.conventions.root == Root::kNearest,
          width,
          height,
          near,
          hull(eye.alpha(0), eye.alpha(width - 1)),
          hull(eye.beta(0), eye.beta(height - 1)),
          from_pixels ? forward(near) : Bounds::exactly(0),
          forward(eye.near())};
}

/// A sphere that may hide others: every ray from the eye that meets it does so at the near root.
/// `pixels` and `seen` are copies from its plan.
struct Occluder {
  std::size_t index;
  Sphere sphere;
  PixelRectangle pixels;
  EyeSphere seen;
  Bounds touch = sqrt(seen.power);  ///< The distance from the eye to where its cone touches it.
  Bounds distance = sqrt(seen.distance_sq);
};

/// Whether every ray from the eye that meets the planned sphere meets `by` before it. This is so if
/// the sphere's cone is inside the cone of `by` and the sphere is farther away than the circle
/// where the cone of `by` touches it. With t^2 = |C - E|^2 - r^2, the cosine of the difference of
/// the cones' half angles is (t t_by + r r_by) / (|C - E| |C_by - E|).
bool covers(const Occluder& by, const SpherePlan& plan, double nearest_distance) {
  const EyeSphere& sphere = plan.seen;
  if (!(sphere.power.low > 0 && nearest_distance > by.touch.high)) return false;
  const Bounds radii = times_positive(by.seen.radius, sphere.radius);
  const Bounds dot = times_shared(sphere.u, by.seen.u) + times_shared(sphere.v, by.seen.v) +
                     times_shared(sphere.w, by.seen.w);
  return dot.low > (times_positive(by.touch, sqrt(sphere.power)) + radii).high &&
         times_positive(sphere.radius, by.distance).high <
             times_positive(by.seen.radius, sqrt(sphere.distance_sq)).low;
}

bool contains(const Sphere& by, const Sphere& sphere) {
  if (std::abs(sphere.centre.x - by.centre.x) >= by.radius ||
      std::abs(sphere.centre.y - by.centre.y) >= by.radius ||
      std::abs(sphere.centre.z - by.centre.z) >= by.radius) {
    return false;
  }
  const auto apart_sq = [](double to, double from) {
    return square(Bounds::exactly(to) - Bounds::exactly(from));
  };
  const Bounds apart =
      sqrt(apart_sq(sphere.centre.x, by.centre.x) + apart_sq(sphere.centre.y, by.centre.y) +
           apart_sq(sphere.centre.z, by.centre.z));
  return (apart + Bounds::exactly(sphere.radius)).high < by.radius;
}

/// Finds for each sphere the first equal sphere in the file.
class FirstOfEquals {
 public:
  explicit FirstOfEquals(const std::vector<Sphere>& spheres)
      : spheres_(spheres), slots_(std::bit_ceil(2 * spheres.size() + 1)) {
    for (std::size_t k = 0; k < kAhead; ++k) look_ahead_to(k);
  }

  /// The first sphere that equals sphere k. Call it for k = 0, 1, 2, ... in turn.
  std::size_t first(std::size_t k) {
    const std::uint64_t hash = hashes_[k % kAhead], tag = hash << 32;
    look_ahead_to(k + kAhead);
    for (std::size_t at = hash >> 20;; ++at) {
      std::uint64_t& slot = slot_at(at);
      const std::size_t found = (slot & 0xffffffff) - 1;
      if (slot == 0) {
        slot = tag | (k + 1);
        return k;
      }
      if ((slot ^ tag) >> 32 == 0 && spheres_[found] == spheres_[k]) return found;
    }
  }

 private:
  /// Slots are scattered over memory: each is prefetched this many spheres ahead.
  static constexpr std::size_t kAhead = 16;

  std::uint64_t& slot_at(std::size_t at) { return slots_[at & (slots_.size() - 1)]; }
  void look_ahead_to(std::size_t k) {
    if (k >= spheres_.size()) return;
    constexpr std::uint64_t kFactor = 0x9e3779b97f4a7c15;
    const auto& [centre, radius] = spheres_[k];
    std::uint64_t hash = 0;
    for (const double x : {centre.x, centre.y, centre.z, radius}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * kFactor;  // -0 equals 0
      hash ^= hash >> 32;
    }
    hashes_[k % kAhead] = hash;
    __builtin_prefetch(&slot_at(hash >> 20), 1);
  }

  const std::vector<Sphere>& spheres_;
  std::vector<std::uint64_t> slots_;  ///< 32 bits of the hash and the index + 1; 0: empty.
  std::array<std::uint64_t, kAhead> hashes_{};
};

/// Finds which of kMostOccluders rectangles may contain a given one. For each of the four sides and
/// each step of some pixels, a mask has one bit for each rectangle that reaches beyond the step.
class Containing {
 public:
  Containing(const std::vector<Occluder>& occluders, const Camera& camera) {
    const auto most = static_cast<std::uint64_t>(std::max(camera.width, camera.height));
    while (most >> shift_ >= kSteps) ++shift_;
    for (std::size_t o = 0; o < occluders.size(); ++o) {
      const std::array<std::size_t, 4> at = steps(occluders[o].pixels);
      for (std::size_t side = 0; side < 4; ++side) masks_[side][at[side]] |= std::uint64_t{1} << o;
    }
    // A rectangle that begins at a step begins before all later steps; a rectangle that ends at a
    // step ends after all earlier steps.
    for (std::size_t step = 1; step < kSteps; ++step) {
      for (const std::size_t begin : {0U, 2U}) masks_[begin][step] |= masks_[begin][step - 1];
      for (const std::size_t end : {1U, 3U}) {
        masks_[end][kSteps - 1 - step] |= masks_[end][kSteps - step];
      }
    }
  }

  std::uint64_t operator()(const PixelRectangle& pixels) const {
    const auto [i_begin, i_end, j_begin, j_end] = steps(pixels);
    return masks_[0][i_begin] & masks_[1][i_end] & masks_[2][j_begin] & masks_[3][j_end];
  }

 private:
  static constexpr std::size_t kSteps = 256;

  std::array<std::size_t, 4> steps(const PixelRectangle& pixels) const {
    const auto step = [this](std::int64_t x) { return static_cast<std::size_t>(x) >> shift_; };
    return {step(pixels.i_begin), step(pixels.i_end), step(pixels.j_begin), step(pixels.j_end)};
  }

  unsigned shift_ = 0;
  std::array<std::array<std::uint64_t, kSteps>, 4> masks_{};
};
static_assert(kMostOccluders <= 64);

/// Calls body(begin, end) for consecutive parts of [0, count).
void for_each_part(const ForEach& for_each, std::size_t count,
                   const std::function<void(std::size_t, std::size_t)>& body) {
  constexpr std::size_t kPart = 4096;
  for_each((count + kPart - 1) / kPart, [&](std::size_t part) {
    poll();
    body(part * kPart, std::min(count, (part + 1) * kPart));
  });
}

void leave_out_hidden(const Scene& scene, const ForEach& for_each, ScenePlan& plan) {
  std::vector<SpherePlan>& plans = plan.spheres;
  const std::vector<Sphere>& spheres = scene.spheres;
  const auto leave_out = [&](std::size_t sphere, std::size_t by) {
    plans[sphere].left_out = LeftOut::kHidden;
    plans[sphere].hidden_by = by;
    plans[sphere].pixels = {};
    plan.nearest_distance[sphere] = std::numeric_limits<double>::infinity();
  };
  FirstOfEquals equals(spheres);
  double least_size_sq = 0;
  // The spheres that are largest in the image.
  std::vector<std::pair<double, std::size_t>> by_size;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const std::size_t first = equals.first(k);
    if (plans[k].left_out) continue;
    if (first != k) leave_out(k, first);
    const EyeSphere& seen = plans[k].seen;
    if (first != k || plans[k].reaches_behind || !(seen.power.low > 0)) continue;
    // A quick test leaves out most spheres: those that are smaller by more than rounding errors.
    if (seen.radius.high * seen.radius.high < least_size_sq * seen.distance_sq.high) continue;
    by_size.emplace_back(-seen.radius.high / std::sqrt(seen.distance_sq.high), k);
    std::push_heap(by_size.begin(), by_size.end());
    if (by_size.size() <= kMostOccluders) continue;
    std::pop_heap(by_size.begin(), by_size.end());
    by_size.pop_back();
    least_size_sq = by_size.front().first * by_size.front().first * (1 - 0x1p-40);
  }
  std::sort_heap(by_size.begin(), by_size.end());
  std::vector<Occluder> occluders;
  for (const auto& [size, k] : by_size) {
    occluders.push_back({k, spheres[k], plans[k].pixels, plans[k].seen});
  }
  const Containing containing(occluders, *scene.camera);
  const auto leave_out_if_hidden = [&](std::size_t k) {
    for (std::uint64_t left = containing(plans[k].pixels); left != 0; left &= left - 1) {
      const Occluder& by = occluders[static_cast<std::size_t>(std::countr_zero(left))];
      if (by.index != k && by.pixels.contains(plans[k].pixels) &&
          (covers(by, plans[k], plan.nearest_distance[k]) || contains(by.sphere, spheres[k]))) {
        return leave_out(k, by.index);
      }
    }
  };
  for_each_part(for_each, spheres.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (!plans[k].left_out) leave_out_if_hidden(k);
    }
  });
}

/// The smallest and the largest nonzero magnitude; both are 0 if all magnitudes are.
struct Magnitudes {
  double smallest = 0, largest = 0;

  void add(double x) {
    const double size = std::min(std::abs(x), std::numeric_limits<double>::max());
    if (size == 0) return;
    smallest = smallest == 0 ? size : std::min(smallest, size);
    largest = std::max(largest, size);
  }
  /// The exponent of the largest magnitude. With `only_if_needed`, 0 if all are in the plain range.
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

void one_by_one(std::size_t count, const std::function<void(std::size_t)>& body) {
  for (std::size_t k = 0; k < count; ++k) body(k);
}

ScenePlan plan_scene(const Scene& scene, const Conventions& conventions, Wanted wanted,
                     const PlanItems& items, const ForEach& for_each) {
  require_valid(scene, conventions);
  if (!scene.camera) {
    throw std::invalid_argument("camera: absent; a scene of given rays has no plan");
  }
  const Camera& camera = *scene.camera;
  // Pixels and distances are bounded in front of the origins; here roots behind them count, too.
  const bool counts_behind = conventions.valid.t_min < 0;
  PlanItems used = items;
  if (counts_behind) used.view = used.behind = used.rectangles = false;
  ScenePlan plan{
      conventions, wanted,
      used,        EyeSpace(camera, conventions, scaling_of(scene, items.scaling), !items.basis),
      {},          {}};
  const PlanTerms terms = terms_of(camera, plan);
  std::vector<SpherePlan>& spheres = plan.spheres;
  spheres.resize(scene.spheres.size());
  plan.nearest_distance.resize(spheres.size());
  for_each_part(for_each, spheres.size(), [&](std::size_t begin, std::size_t end) {
    plan_each(terms, std::span(scene.spheres).subspan(begin, end - begin),
              std::span(spheres).subspan(begin, end - begin),
              std::span(plan.nearest_distance).subspan(begin, end - begin));
  });
  if (counts_behind) std::ranges::fill(plan.nearest_distance, 0);
  // A sphere whose near root does not count hides nothing.
  const bool all_count = conventions.valid.is_usual();
  if (items.hidden && wanted == Wanted::kNearest && all_count) {
    leave_out_hidden(scene, for_each, plan);
  }
  return plan;
}

}  // namespace raycheck::scene
