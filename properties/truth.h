#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contract/declarations.h"
#include "properties/case.h"
#include "reference/exact_camera.h"
#include "reference/exact_ray.h"
#include "scene/plan/plan.h"
#include "scene/scene.h"

namespace raycheck::properties {

using reference::ExactCamera;
using reference::ExactRay;
using reference::HitClass;
using reference::Intersection;
using reference::NearestSphere;
using reference::WhichRoot;

/// The element of a ray in a list sorted by ray; null if it is absent.
template <class List>
auto* find_ray(List& list, std::size_t ray) {
  const auto at = std::lower_bound(list.begin(), list.end(), ray,
                                   [](const auto& one, std::size_t it) { return one.ray < it; });
  return at == list.end() || at->ray != ray ? nullptr : &*at;
}

/// The rays of these pixels, correctly rounded to what a candidate accepts.
std::vector<Ray> rounded_rays(const ExactCamera& camera, std::span<const Pixel> pixels,
                              InputFormat format);

/// Whether a ray starts inside a sphere, or on it and leaves it.
bool starts_inside(const ExactRay& ray, const Sphere& sphere);

/// How a ray and a sphere meet under the conventions. A ray that starts inside has a hit at the
/// near root, unless its hit is a root that counts; with FromInside::kStart, s is 0 in place of
/// this root (trial.h: rounded_s).
Intersection exact_intersection(const ExactRay& ray, const Sphere& sphere,
                                const Conventions& conventions, contract::FromInside from_inside);

/// A hit or tangent of a ray of a case with a sphere.
struct Meeting {
  std::size_t ray = 0;
  Intersection intersection;
  std::optional<double> condition_of_parameter = {};  ///< Computed on demand.
};

/// The truth about a case under some conventions. Each part is computed on demand and kept. It does
/// not depend on a candidate; candidates that are judged under the same conventions, and have the
/// same hits from inside, share it. With a plan of the case's scene under these conventions, each
/// sphere is intersected only with the rays of pixels in its rectangle. Laws that judge plans use a
/// truth without a plan.
class Truth {
 public:
  Truth(const Case& the_case, const Conventions& conventions,
        const scene::ScenePlan* plan = nullptr,
        contract::FromInside from_inside = contract::FromInside::kRoot);

  const Conventions& conventions() const { return conventions_; }
  contract::FromInside from_inside() const { return from_inside_; }
  const ExactCamera& camera();
  /// Enclosures of the camera's axes, narrow enough for positions in its image plane.
  const reference::EnclosedFrame& frame();
  const ExactRay& ray(std::size_t ray);
  /// The rays that meet a sphere, in their order; every other ray misses it.
  std::span<const Meeting> meetings(std::size_t sphere) { return known_meetings(sphere); }
  Intersection intersection(std::size_t ray, std::size_t sphere);
  /// kappa of the parameter of a hit or a tangent.
  double condition_of_parameter(std::size_t ray, std::size_t sphere);
  /// The sphere that each ray meets first.
  const std::vector<std::optional<NearestSphere>>& nearest();

 private:
  std::vector<Meeting>& known_meetings(std::size_t sphere);
  Meeting* find(std::size_t ray, std::size_t sphere);

  const Case& case_;
  Conventions conventions_;
  const scene::ScenePlan* plan_;
  contract::FromInside from_inside_;
  std::optional<ExactCamera> camera_;
  std::optional<reference::EnclosedFrame> frame_;
  std::vector<std::optional<ExactRay>> rays_;
  std::vector<std::optional<std::vector<Meeting>>> meetings_;  ///< By sphere.
  std::optional<std::vector<std::optional<NearestSphere>>> nearest_;
};

/// These conventions with every root >= 0, or every root if lines are intersected. Plans are made
/// under them, so that they include all roots that may count.
inline Conventions planned(Conventions conventions) {
  conventions.valid = {.t_min = std::min(0.0, conventions.valid.t_min)};
  return conventions;
}

/// The truths about one case, one for each set of conventions under which candidates are judged.
/// Each uses the plan for its conventions, if there is one and rays from inside hit at roots.
class SharedTruths {
 public:
  explicit SharedTruths(const Case& the_case, std::span<const scene::ScenePlan> plans = {})
      : case_(the_case), plans_(plans) {}
  std::shared_ptr<Truth> under(const Conventions& conventions,
                               contract::FromInside from_inside = contract::FromInside::kRoot);

 private:
  const Case& case_;
  std::span<const scene::ScenePlan> plans_;
  std::vector<std::shared_ptr<Truth>> truths_;
};

}  // namespace raycheck::properties
