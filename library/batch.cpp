// Decisions, nearest spheres and images of raycheck/batch.h.

#include <raycheck/batch.h>

#include "contract/public_structs.h"
#include "library/batch_block.h"
#include "reference/visibility/visibility.h"
#include "scene/plan/plan.h"

namespace raycheck::library {
namespace {

/// Writes a byte for each answer. `bytes` is scratch.
template <class Value>
void put_bytes(const Target& to, const Block& block, std::uint8_t* bytes, Value value) {
  if (!to) return;
  const bool in_place = to.has_no_gaps(RAYCHECK_UINT8, 1);
  if (in_place) bytes = reinterpret_cast<std::uint8_t*>(to.at(block.first));
  const std::size_t count = block.count;
  const std::uint8_t* __restrict from = block.to.hit;
  std::uint8_t* __restrict values = bytes;
  for (std::size_t k = 0; k < count; ++k) values[k] = value(from[k]);
  if (in_place) return;
  for (std::size_t k = 0; k < count; ++k) to.set_integer(block.first + k, values[k]);
}

/// 1 for a hit, 2 for a tangent, 3 for kOpen.
constexpr auto class_of = [](std::uint8_t code) {
  static_assert(fast::kHit == 1 && fast::kOpen == 2 && fast::kTangentRay == 8);
  return static_cast<std::uint8_t>((code & 1) + (code >> 3 & 1) + 3 * (code >> 1 & 1));
};
constexpr auto root_of = [](std::uint8_t code) {
  static_assert(fast::kLargerRoot == 4);
  return static_cast<std::uint8_t>(code >> 2 & 1);
};

/// Writes certified bounds on errors, with the rounding of values to floats.
void put_bounds(const Target& to, const Block& block, const double* values, bool is_single,
                double* bounds) {
  if (!to) return;
  for (std::size_t k = 0; is_single && k < block.count; ++k) {
    if (!(bounds[k] < kNothing)) continue;
    const double rounding =
        std::abs(static_cast<double>(static_cast<float>(values[k])) - values[k]);
    bounds[k] = (bounds[k] + rounding) * (1 + 0x1p-50) + fast::kLeastDouble;
  }
  to.copy_out(block.first, block.count, bounds, Way::kUp);
}

/// Writes s and Q of a block, and the bounds of their errors.
void put_values(const Block& block, const Target& s, const Target3& point, const Target& s_error,
                const Target3& point_error, Work& work) {
  const auto& [x, y, z] = point;
  double* const s_bound = s_error ? s_error.block(block.first, work.found[4].data()) : nullptr;
  double* bounds[3] = {};
  if (point_error) {
    bounds[0] = point_error.x.block(block.first, work.found[5].data());
    bounds[1] = point_error.y.block(block.first, work.found[6].data());
    bounds[2] = point_error.z.block(block.first, work.found[7].data());
  }
  fast::bound_errors(block.input, block.to, s_bound, bounds);
  put_bounds(s_error, block, block.to.parameter, s.is_single(), s_bound);
  put_bounds(point_error.x, block, block.to.point[0], x.is_single(), bounds[0]);
  put_bounds(point_error.y, block, block.to.point[1], y.is_single(), bounds[1]);
  put_bounds(point_error.z, block, block.to.point[2], z.is_single(), bounds[2]);
  s.copy_out(block.first, block.count, block.to.parameter);
  x.copy_out(block.first, block.count, block.to.point[0]);
  y.copy_out(block.first, block.count, block.to.point[1]);
  z.copy_out(block.first, block.count, block.to.point[2]);
}

void decide(const Questions& asked, const raycheck_decided& to) {
  const std::size_t answers = asked.answers();
  asked.require_spheres(answers);
  const Target hit_class = integers(to.hit_class, "hit_class", answers);
  const Target root = integers(to.root, "root", answers);
  const Target s = numbers(to.s, "s", answers), s_error = numbers(to.s_error, "s_error", answers);
  const Target3 point = numbers(to.point, "point", answers);
  const Target3 point_error = numbers(to.point_error, "point_error", answers);
  asked.for_each_block(kBatchBlock, [&](std::size_t first, std::size_t count) {
    Work& work = work_of_thread();
    const Block block(asked, first, count, s, point, work);
    decide_block(asked, block);
    put_bytes(hit_class, block, work.bytes.data(), class_of);
    put_bytes(root, block, work.bytes.data(), root_of);
    put_values(block, s, point, s_error, point_error, work);
  });
  asked.require_none_invalid();
}

/// Where answers about the nearest sphere are written.
struct Seen {
  Target sphere, ties, s, s_error;
  Target3 point;
  Seen(const raycheck_seen& to, std::size_t count)
      : sphere(indices(to.sphere, "sphere", count)),
        ties(indices(to.ties, "ties", count)),
        s(numbers(to.s, "s", count)),
        s_error(numbers(to.s_error, "s_error", count)),
        point(numbers(to.point, "point", count)) {}
};

/// The nearest spheres of a block of given rays.
class NearestOfBlock {
 public:
  NearestOfBlock(const Questions& asked, const Block& best, Work& work)
      : asked_(asked), best_(best), work_(work) {
    for (std::size_t k = 0; k < best.count; ++k) best.set(k, fast::kMiss, kNothing);
    work.bytes.fill(fast::kMiss);
    work.sphere.fill(-1);
    work.ties.fill(0);
  }

  void add(std::size_t m) {
    fast::BatchInput input = best_.input;
    input.sphere = asked_.sphere(m);
    fast::decide(input, {work_.codes.data(),
                         work_.found[4].data(),
                         {work_.found[5].data(), work_.found[6].data(), work_.found[7].data()}});
    const bool tangents_count = asked_.conventions().tangent != scene::Tangent::kMiss;
    for (std::size_t k = 0; k < best_.count; ++k) {
      const std::uint8_t code = work_.codes[k];
      if (code == fast::kMiss) continue;
      if (code == fast::kOpen) {
        work_.bytes[k] = fast::kOpen;  // an invalid ray: spheres are valid
        continue;
      }
      if (!tangents_count && (code & fast::kTangentRay) != 0) continue;
      const double s = work_.found[4][k], least = best_.to.parameter[k];
      // Twice kDecidedS, and the roundings here.
      constexpr double kLess = 1 - 0x1p-51, kMore = 1 + 0x1p-51;
      if (work_.sphere[k] >= 0) {
        if (s * kLess - fast::kLeastDouble > least * kMore + fast::kLeastDouble) continue;
        if (!(s * kMore + fast::kLeastDouble < least * kLess - fast::kLeastDouble)) {
          const int order = compare(k, m);
          if (order > 0) continue;
          if (order == 0) {
            ++work_.ties[k];
            continue;
          }
        }
      }
      best_.set(k, code, s, {work_.found[5][k], work_.found[6][k], work_.found[7][k]});
      work_.sphere[k] = static_cast<std::int32_t>(m);
      work_.ties[k] = 1;
    }
  }

 private:
  /// The sign of s of sphere m minus the least s so far.
  int compare(std::size_t k, std::size_t m) const {
    const reference::ExactRay ray(best_.input.ray(k));
    const scene::Root root = asked_.conventions().root;
    const scene::Sphere sphere = asked_.sphere(m);
    const scene::Sphere other = asked_.sphere(static_cast<std::size_t>(work_.sphere[k]));
    return ray.compare(sphere, ray.intersect(sphere, root), other, ray.intersect(other, root));
  }

  const Questions& asked_;
  const Block& best_;
  Work& work_;
};
static_assert(2 * fast::kDecidedS + 0x1p-53 < 0x1p-51);

/// The spheres that are valid, by their indices; notes the others.
std::vector<std::size_t> valid_spheres(const Questions& asked) {
  std::vector<std::size_t> valid;
  for (std::size_t m = 0; m < asked.spheres(); ++m) {
    asked.is_valid_sphere(m) ? valid.push_back(m) : asked.note_sphere(m);
  }
  return valid;
}

void nearest(const Questions& asked, const raycheck_seen& to) {
  const Seen seen(to, asked.rays());
  const std::vector<std::size_t> valid = valid_spheres(asked);
  std::vector<scene::Sphere> spheres;
  if (!asked.is_usual()) {
    for (const std::size_t m : valid) spheres.push_back(asked.sphere(m));
  }
  asked.for_each_block_of_rays(kBatchBlock, [&](std::size_t first, std::size_t count) {
    Work& work = work_of_thread();
    const Block block(asked, first, count, seen.s, seen.point, work);
    NearestOfBlock best(asked, block, work);
    if (asked.is_usual()) {
      for (const std::size_t m : valid) best.add(m);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto ray = asked.is_usual() ? std::nullopt : asked.exact(first + k);
      const bool is_invalid = asked.is_usual() ? !asked.is_valid_ray(first + k) : !ray;
      if (is_invalid) {
        block.set(k, fast::kOpen, kInvalidNumber);
        asked.note_ray(first + k);
      } else if (ray) {
        const auto found = ray->nearest(spheres, asked.conventions());
        if (!found) continue;
        put_exact(block, k, *ray, spheres[found->index], found->intersection);
        work.sphere[k] = static_cast<std::int32_t>(valid[found->index]);
        work.ties[k] = static_cast<std::int32_t>(found->ties.size());
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      seen.sphere.set_integer(first + k, work.sphere[k]);
      seen.ties.set_integer(first + k, work.ties[k]);
    }
    put_values(block, seen.s, seen.point, seen.s_error, {}, work);
  });
  asked.require_none_invalid();
}

/// The number of spheres that equal sphere k, itself included, by the plan.
std::vector<std::int32_t> equal_spheres(const scene::ScenePlan& plan,
                                        const std::vector<scene::Sphere>& spheres) {
  std::vector<std::int32_t> equals(spheres.size(), 1);
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const auto by = plan.spheres[k].hidden_by;
    if (by && spheres[*by] == spheres[k]) ++equals[*by];
  }
  return equals;
}

/// The largest |P - E|.
double most_length(const scene::Camera& camera) {
  return (std::abs(camera.near) + std::max(std::abs(camera.left), std::abs(camera.right)) +
          std::max(std::abs(camera.bottom), std::abs(camera.top))) *
         (1 + 0x1p-50);
}

/// The rows of an image that a thread takes at a time: few calls, and work for all threads.
std::int64_t rows_of_task(std::int64_t height, std::size_t threads) {
  if (threads == 1) return height;
  constexpr std::int64_t kBand = reference::Visibility::kBandRows, kTasksOfThread = 8;
  const std::int64_t bands = height / (kBand * kTasksOfThread * static_cast<std::int64_t>(threads));
  return kBand * std::max<std::int64_t>(1, bands);
}

class Image {
 public:
  Image(const Questions& asked, const raycheck_seen& to)
      : asked_(asked),
        seen_(to, asked.rays()),
        valid_(valid_spheres(asked)),
        width_(static_cast<std::size_t>(asked.camera().width)) {
    scene::Scene scene;
    scene.camera = asked.camera();
    scene.conventions = asked.conventions();
    for (const std::size_t m : valid_) scene.spheres.push_back(asked.sphere(m));
    auto plan =
        scene::plan_scene(scene, scene.conventions, scene::Wanted::kNearest, {},
                          [&](std::size_t count, const std::function<void(std::size_t)>& body) {
                            on_threads(asked.threads(), count, body);
                          });
    equals_ = equal_spheres(plan, scene.spheres);
    visibility_.emplace(std::move(scene), std::move(plan));
  }

  void draw() const {
    const std::int64_t height = asked_.camera().height;
    const std::int64_t rows = rows_of_task(height, asked_.threads());
    const auto tasks = static_cast<std::size_t>((height + rows - 1) / rows);
    on_threads(asked_.threads(), tasks, [&](std::size_t task) {
      const std::int64_t from = static_cast<std::int64_t>(task) * rows;
      draw_rows(from, std::min(height, from + rows));
    });
  }

 private:
  void draw_rows(std::int64_t from, std::int64_t to) const {
    const std::size_t first = static_cast<std::size_t>(from) * width_;
    const std::size_t count = static_cast<std::size_t>(to - from) * width_;
    Copy<double> s(seen_.s, first, count, bool(seen_.s_error)), x(seen_.point.x, first, count),
        y(seen_.point.y, first, count), z(seen_.point.z, first, count);
    const bool renamed = valid_.size() != asked_.spheres();
    Copy<std::int32_t> sphere(seen_.sphere, first, count, bool(seen_.ties)),
        ties(seen_.ties, first, count);
    visibility_->nearest(from, to, {sphere.all, s.all, x.all, y.all, z.all, ties.all});
    for (std::size_t k = 0; k < ties.all.size(); ++k) {
      if (ties.all[k] == 1) ties.all[k] = equals_[static_cast<std::size_t>(sphere.all[k])];
      if (ties.all[k] > 1) ties.all[k] = all_ties(first + k);
    }
    for (std::size_t k = 0; renamed && k < sphere.all.size(); ++k) {
      std::int32_t& one = sphere.all[k];
      if (one >= 0) one = static_cast<std::int32_t>(valid_[static_cast<std::size_t>(one)]);
    }
    put_errors(first, s);
    s.out(first);
    x.out(first);
    y.out(first);
    z.out(first);
    sphere.out(first);
    ties.out(first);
  }

  /// Ties of different spheres are few, and counted by the exact ray.
  std::int32_t all_ties(std::size_t pixel) const {
    const auto found = asked_.exact(pixel)->nearest(visibility_->scene().spheres,
                                                    visibility_->scene().conventions);
    return static_cast<std::int32_t>(found->ties.size());
  }

  /// An array in place, or a copy that out() writes.
  template <class T>
  struct Copy {
    std::span<T> all;
    std::vector<T> copy;
    const Target& target;

    Copy(const Target& to, std::size_t first, std::size_t count, bool is_needed = false)
        : target(to) {
      constexpr std::int32_t kType = std::is_same_v<T, double> ? RAYCHECK_FLOAT64 : RAYCHECK_INT32;
      if (to.has_no_gaps(kType, alignof(T))) {
        all = {reinterpret_cast<T*>(to.at(first)), count};
      } else if (to || is_needed) {
        copy.resize(count);
        all = copy;
      }
    }
    void out(std::size_t first) const {
      for (std::size_t k = 0; target && k < copy.size(); ++k) {
        if constexpr (std::is_same_v<T, double>) {
          target.set(first + k, copy[k]);
        } else {
          target.set_integer(first + k, copy[k]);
        }
      }
    }
  };

  void put_errors(std::size_t first, const Copy<double>& s) const {
    if (!seen_.s_error) return;
    const bool from_pixel = asked_.conventions().origin == scene::Origin::kPixel;
    const double start = from_pixel ? most_length(asked_.camera()) : 0;
    for (std::size_t k = 0; k < s.all.size(); ++k) {
      const double value = s.all[k];
      const double rounding = seen_.s.is_single() && value < kNothing
                                  ? std::abs(static_cast<double>(static_cast<float>(value)) - value)
                                  : 0;
      const double bound =
          (reference::kVisibleParameterError * (value + start) + rounding) * (1 + 0x1p-18) +
          2 * fast::kLeastDouble;
      seen_.s_error.set(first + k, bound, Way::kUp);
    }
  }

  const Questions& asked_;
  Seen seen_;
  std::vector<std::size_t> valid_;
  std::vector<std::int32_t> equals_;
  std::size_t width_;
  std::optional<reference::Visibility> visibility_;
};

/// The options of functions whose answers are of rays, whatever their pairing is.
std::optional<raycheck_options> with_every(const raycheck_options* options) {
  if (options == nullptr) return {};
  raycheck_options made = *options;
  made.pairing = RAYCHECK_EACH_WITH_EVERY;
  return made;
}

}  // namespace
}  // namespace raycheck::library

using namespace raycheck::library;

int32_t raycheck_decide(const raycheck_rays* rays, const raycheck_spheres* spheres,
                        const raycheck_options* options, const raycheck_decided* to,
                        raycheck_error* error) {
  return guarded(error, [&] { decide({rays, spheres, options}, required(to)); });
}

int32_t raycheck_nearest(const raycheck_rays* rays, const raycheck_spheres* spheres,
                         const raycheck_options* options, const raycheck_seen* to,
                         raycheck_error* error) {
  return guarded(error, [&] {
    const auto with = with_every(options);
    nearest({rays, spheres, with ? &*with : nullptr}, required(to));
  });
}

int32_t raycheck_image(const raycheck_camera* camera, const raycheck_spheres* spheres,
                       const raycheck_options* options, const raycheck_seen* to,
                       raycheck_error* error) {
  return guarded(error, [&] {
    const auto with = with_every(options);
    if (camera == nullptr) throw wrong_array("camera", "is null");
    raycheck_rays rays = {};
    rays.camera = camera;
    const Questions asked(&rays, spheres, with ? &*with : nullptr);
    Image(asked, required(to)).draw();
    asked.require_none_invalid();
  });
}
