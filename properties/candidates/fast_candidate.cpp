#include "properties/candidates/fast_candidate.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "fast/camera_frame.h"
#include "fast/visible.h"
#include "scene/interruption.h"

namespace raycheck::properties {
namespace {

/// Memory that is reused, so that a refusal has nothing to clean up.
struct Room {
  fast::Vectors points;
  fast::Rays rays;
  fast::Hits hits;
  std::vector<SphereHits> answers;
};
Room& room() {
  static thread_local Room room;
  return room;
}

auto make_rays(fast::PixelRayMethod::MakeRays make) {
  return [make](const Camera& camera, const Conventions& conventions, Candidate::Pixels pixels) {
    fast::Rays& batch = room().rays;
    make(camera, conventions, pixels, batch);
    return rays_of(batch);
  };
}

/// Also renders this number of pixels on each side of the requested one, so that the plan covers
/// more than one pixel, as in a renderer.
constexpr std::int64_t kAround = 2;

std::vector<std::optional<SeenAnswer>> seen_through(const Scene& scene,
                                                    const scene::ScenePlan& plan,
                                                    const fast::PixelRayMethod& rays,
                                                    const fast::IntersectMethod& intersect,
                                                    Candidate::Pixels pixels) {
  std::vector<std::optional<SeenAnswer>> answers;
  for (const auto& [i, j] : pixels) {
    scene::poll();
    const scene::PixelRectangle around = {
        std::max<std::int64_t>(0, i - kAround), std::min(scene.camera->width, i + kAround + 1),
        std::max<std::int64_t>(0, j - kAround), std::min(scene.camera->height, j + kAround + 1)};
    const auto seen = fast::see(scene, plan, rays, intersect, around);
    const auto at = static_cast<std::size_t>(
        (j - around.j_begin) * (around.i_end - around.i_begin) + i - around.i_begin);
    answers.emplace_back();
    if (seen[at]) answers.back() = {seen[at]->sphere, seen[at]->parameter};
  }
  return answers;
}

/// The bound on a residual is the point's plus this. Rounding a point to doubles moves it by up to
/// u |Q|. In u of r, or of s |D|, that is at most half the residual's condition number, which is
/// (|Q| + |C| + |L| + r) over r, or over s |D|.
constexpr double kRoundedPointResidual = kModerateCondition / 2;

void promise_bounds(const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect,
                    Promises& candidate) {
  const auto promise = [&candidate](Quantity quantity, double bound) {
    candidate.max_error[static_cast<std::size_t>(quantity)] = bound;
  };
  promise(Quantity::kFrame, fast::kFrameMaxUlp);
  promise(Quantity::kOrthonormality, fast::kFrameMaxDefectUlp);
  candidate.is_unconditional[static_cast<std::size_t>(Quantity::kOrthonormality)] = true;
  promise(Quantity::kPixelPoint, rays.max_point_ulp);
  promise(Quantity::kRayOrigin, rays.max_point_ulp);
  promise(Quantity::kDirection, rays.max_direction_ulp);
  promise(Quantity::kUnitDefect, rays.max_unit_defect_ulp);
  // A ray's origin and direction are each off by at most their bounds. This changes s and Q in
  // proportion to their condition numbers. Campaigns audit these bounds.
  const double inherited = std::max(rays.max_point_ulp, rays.max_direction_ulp);
  const auto promise_hit = [&](Quantity quantity, double bound) {
    promise(quantity, bound);
    candidate.max_error_end_to_end[static_cast<std::size_t>(quantity)] = bound + inherited;
  };
  promise_hit(Quantity::kParameter, intersect.max_ulp);
  promise_hit(Quantity::kHitPoint, intersect.max_point_ulp);
  promise_hit(Quantity::kSphereResidual, intersect.max_point_ulp + kRoundedPointResidual);
  promise_hit(Quantity::kRayResidual, intersect.max_point_ulp + kRoundedPointResidual);
  // An error of x ulp in s is at most 2x u. kappa is at least 1, because scaling all lengths scales
  // s.
  promise(Quantity::kBackwardError, 2 * intersect.max_ulp);
}

}  // namespace

fast::Rays batch_of(std::span<const Ray> rays) {
  fast::Rays batch;
  batch.resize(rays.size());
  for (std::size_t k = 0; k < rays.size(); ++k) batch.set(k, rays[k]);
  return batch;
}

std::vector<Ray> rays_of(const fast::Rays& batch) {
  std::vector<Ray> rays(batch.size());
  for (std::size_t k = 0; k < rays.size(); ++k) rays[k] = batch.at(k);
  return rays;
}

// Skips several misses at a time.
SphereHits list_of(const fast::Hits& hits) {
  SphereHits list;
  const std::uint8_t* const begin = hits.hit.data();
  const std::uint8_t* const end = begin + hits.size();
  const auto next_from = [end](const std::uint8_t* from) {
    const void* found = from == end ? nullptr : std::memchr(from, 1, std::size_t(end - from));
    return static_cast<const std::uint8_t*>(found);
  };
  for (const std::uint8_t* at = next_from(begin); at != nullptr; at = next_from(at + 1)) {
    const auto k = static_cast<std::size_t>(at - begin);
    list.push_back({k, {hits.parameter[k], hits.point.at<Point3>(k)}});
  }
  return list;
}

Candidate fast_candidate(const fast::PixelRayMethod& rays, const fast::IntersectMethod& intersect,
                         const scene::PlanItems& items) {
  Candidate candidate;
  candidate.name = std::string(rays.name) + "/" + std::string(intersect.name);
  candidate.frame = [](const Camera& camera) {
    const fast::CameraFrame frame = fast::camera_frame(camera);
    return FrameAnswer{frame.U, frame.V, frame.W};
  };
  if (rays.pixel_points != nullptr) {
    candidate.pixel_points = [make = rays.pixel_points](const Camera& camera,
                                                        const Conventions& conventions,
                                                        Candidate::Pixels pixels) {
      fast::Vectors& batch = room().points;
      make(camera, conventions, pixels, batch);
      std::vector<Point3> points(pixels.size());
      for (std::size_t k = 0; k < points.size(); ++k) points[k] = batch.at<Point3>(k);
      return points;
    };
  }
  if (rays.pixel_rays != nullptr) {
    candidate.pixel_rays = make_rays(rays.pixel_rays);
  } else {
    candidate.declared.origin = scene::Origin::kFocal;
  }
  candidate.focal_rays = make_rays(rays.focal_rays);
  candidate.intersect = [&intersect](Candidate::Rays given, Candidate::Spheres spheres,
                                     const Conventions& conventions) {
    auto& [points, batch, hits, answers] = room();
    batch = batch_of(given);
    answers.resize(spheres.size());
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      scene::poll();
      intersect.intersect(batch, spheres[k], conventions.hit_rule(), hits);
      answers[k] = list_of(hits);
    }
    return std::exchange(answers, {});
  };
  candidate.classes_in = intersect.classes_in;
  candidate.nearest = [&intersect](Candidate::Rays given, Candidate::Spheres spheres,
                                   const Conventions& conventions) {
    std::vector<std::optional<std::size_t>> nearest;
    for (const auto& first :
         fast::nearest_spheres(intersect, batch_of(given), spheres, conventions.hit_rule())) {
      nearest.push_back(first ? std::optional(first->sphere) : std::nullopt);
    }
    return nearest;
  };
  candidate.plan = [items](const Scene& scene, const Conventions& conventions,
                           scene::Wanted wanted) {
    return scene::plan_scene(scene, conventions, wanted, items);
  };
  candidate.visible = [&rays, &intersect, plan = candidate.plan](const Scene& scene,
                                                                 const Conventions& conventions,
                                                                 Candidate::Pixels pixels) {
    return seen_through(scene, plan(scene, conventions, scene::Wanted::kNearest), rays, intersect,
                        pixels);
  };
  promise_bounds(rays, intersect, candidate);
  candidate.exact_class = intersect.exact_class;
  const bool is_stable = rays.not_kept.empty() && intersect.not_kept.empty();
  candidate.level = is_stable ? Level::kDemanding : Level::kOrdinary;
  candidate.unit_roundoff = std::max(rays.unit_roundoff, intersect.unit_roundoff);
  // Methods choose among all roots >= 0.
  candidate.declared.valid = scene::ValidRoots{};
  candidate.smallest_length = intersect.domain.smallest_length;
  candidate.largest_length = intersect.domain.largest_length;
  candidate.smallest_camera_length = rays.domain.smallest_length;
  candidate.largest_camera_length = rays.domain.largest_length;
  return candidate;
}

}  // namespace raycheck::properties
