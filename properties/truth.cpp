#include "properties/truth.h"

#include <utility>

#include "reference/account/condition.h"
#include "scene/interruption.h"

namespace raycheck::properties {

std::vector<Ray> rounded_rays(const ExactCamera& camera, std::span<const Pixel> pixels,
                              InputFormat format) {
  std::vector<Ray> rays;
  for (const Pixel& pixel : pixels) {
    const ExactRay exact(camera, pixel);
    const auto [x, y, z] = exact.rounded_direction(format.precision);
    rays.push_back(rounded_ray({exact.rounded_origin(format.precision), {x, y, z}}, format));
  }
  return rays;
}

bool starts_inside(const ExactRay& ray, const Sphere& sphere) {
  const Intersection at = ray.intersect(sphere);
  return at.hit_class != HitClass::kMiss && at.root == WhichRoot::kLarger;
}

Intersection exact_intersection(const ExactRay& ray, const Sphere& sphere,
                                const Conventions& conventions, contract::FromInside from_inside) {
  if (from_inside != contract::FromInside::kRoot && starts_inside(ray, sphere)) {
    return {HitClass::kHit, WhichRoot::kSmaller};
  }
  return ray.intersect(sphere, conventions);
}

Truth::Truth(const Case& the_case, const Conventions& conventions, const scene::ScenePlan* plan,
             contract::FromInside from_inside)
    : case_(the_case),
      conventions_(conventions),
      plan_(plan),
      from_inside_(from_inside),
      rays_(count_rays(the_case)),
      meetings_(the_case.scene.spheres.size()) {}

const ExactCamera& Truth::camera() {
  if (!camera_) camera_.emplace(case_.scene.camera.value(), conventions_);
  return *camera_;
}

const reference::EnclosedFrame& Truth::frame() {
  constexpr int kRelativeBits = 200;
  if (!frame_) frame_ = camera().frame(kRelativeBits);
  return *frame_;
}

const ExactRay& Truth::ray(std::size_t ray) {
  auto& kept = rays_[ray];
  if (!kept) {
    if (case_.scene.camera) {
      kept.emplace(camera(), case_.pixels[ray]);
    } else {
      kept.emplace(case_.scene.rays[ray]);
    }
  }
  return *kept;
}

std::vector<Meeting>& Truth::known_meetings(std::size_t sphere) {
  auto& kept = meetings_[sphere];
  if (!kept) {
    scene::poll();
    std::vector<Meeting> found;
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      if (plan_ && !plan_->spheres[sphere].pixels.contains(case_.pixels[k])) continue;
      const auto at =
          exact_intersection(ray(k), case_.scene.spheres[sphere], conventions_, from_inside_);
      if (at.hit_class != HitClass::kMiss) found.push_back({k, at});
    }
    kept = std::move(found);
  }
  return *kept;
}

Meeting* Truth::find(std::size_t ray, std::size_t sphere) {
  return find_ray(known_meetings(sphere), ray);
}

Intersection Truth::intersection(std::size_t ray, std::size_t sphere) {
  const Meeting* meeting = find(ray, sphere);
  return meeting == nullptr ? Intersection{} : meeting->intersection;
}

double Truth::condition_of_parameter(std::size_t ray_index, std::size_t sphere) {
  Meeting& meeting = *find(ray_index, sphere);
  auto& kept = meeting.condition_of_parameter;
  if (!kept) {
    scene::poll();
    kept = reference::condition_of_parameter(ray(ray_index), case_.scene.spheres[sphere],
                                             meeting.intersection);
  }
  return *kept;
}

const std::vector<std::optional<NearestSphere>>& Truth::nearest() {
  if (!nearest_) {
    nearest_.emplace(rays_.size());
    const auto& spheres = case_.scene.spheres;
    for (std::size_t sphere = 0; sphere < spheres.size(); ++sphere) {
      for (const Meeting& meeting : meetings(sphere)) {
        if (!reference::counts_as_hit(meeting.intersection.hit_class, conventions_.tangent)) {
          continue;
        }
        ray(meeting.ray)
            .keep_nearest(spheres, sphere, meeting.intersection, (*nearest_)[meeting.ray]);
      }
    }
  }
  return *nearest_;
}

std::shared_ptr<Truth> SharedTruths::under(const Conventions& conventions,
                                           contract::FromInside from_inside) {
  for (const auto& truth : truths_) {
    if (truth->conventions() == conventions && truth->from_inside() == from_inside) return truth;
  }
  const auto plan = std::find_if(plans_.begin(), plans_.end(), [&](const scene::ScenePlan& one) {
    return one.conventions == planned(conventions) && from_inside == contract::FromInside::kRoot;
  });
  truths_.push_back(std::make_shared<Truth>(case_, conventions,
                                            plan == plans_.end() ? nullptr : &*plan, from_inside));
  return truths_.back();
}

}  // namespace raycheck::properties
