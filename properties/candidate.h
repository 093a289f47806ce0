#ifndef RAYCHECK_PROPERTIES_CANDIDATE_H_
#define RAYCHECK_PROPERTIES_CANDIDATE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "properties/quantity.h"
#include "scene/plan/plan.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// The camera axes that a candidate answers with.
struct FrameAnswer {
  scene::UnitVector3 U, V, W;
};

/// Where a candidate finds that a ray meets a sphere.
struct HitAnswer {
  double parameter = 0;  ///< s, in multiples of the ray's direction.
  scene::Point3 point;   ///< Q
};

/// A hit of one ray of several, by its index.
struct RayHit {
  std::size_t ray = 0;
  HitAnswer hit;
};

/// The hits of several rays with one sphere, in the order of the rays; a ray without one misses it.
using SphereHits = std::vector<RayHit>;

/// What a candidate sees through a pixel.
struct SeenAnswer {
  std::size_t sphere = 0;
  double parameter = 0;  ///< s
};

/// What each pixel of an image shows, row j after row j: a sphere, kSomeSphere where it cannot be
/// told which, or none.
using ImageAnswer = std::vector<std::optional<std::size_t>>;
inline constexpr std::size_t kSomeSphere = std::numeric_limits<std::size_t>::max();

/// Relative changes of a scene that may show in an image: what its text and its renderer's `float`s
/// or thresholds may lose.
inline constexpr double kExcusedImageChange = 1e-6;

/// The conventions that an implementation fixes; the others it takes from the scene.
struct DeclaredConventions {
  std::optional<scene::Rows> rows;
  std::optional<scene::Samples> samples;
  std::optional<scene::Origin> origin;
  std::optional<scene::Root> root;
  std::optional<scene::Tangent> tangent;

  /// The scene's conventions, with what is declared in their place.
  scene::Conventions over(scene::Conventions conventions) const;
};

/// An implementation under judgement: what it can be asked (an empty function: it has no such
/// thing), under which conventions, and what it promises. A candidate is asked from one thread at a
/// time: where several judge, each has a candidate of its own. Functions refuse input that is not a
/// problem with std::invalid_argument; of what they throw otherwise, what() says how they failed.
/// Answers come in the order of the questions; an absent hit is a miss.
struct Candidate {
  using Pixels = std::span<const scene::Pixel>;
  using Rays = std::span<const scene::Ray>;
  using Spheres = std::span<const scene::Sphere>;

  std::string name;

  std::function<FrameAnswer(const scene::Camera&)> frame;
  std::function<std::vector<scene::Point3>(const scene::Camera&, const scene::Conventions&, Pixels)>
      pixel_points;
  /// From P along the unit direction D.
  std::function<std::vector<scene::Ray>(const scene::Camera&, const scene::Conventions&, Pixels)>
      pixel_rays;
  /// From E along the unit direction D.
  std::function<std::vector<scene::Ray>(const scene::Camera&, const scene::Conventions&, Pixels)>
      focal_rays;
  /// Every ray with every sphere: one list of hits a sphere.
  std::function<std::vector<SphereHits>(Rays, Spheres, const scene::Conventions&)> intersect;
  std::function<std::vector<std::optional<std::size_t>>(Rays, Spheres, const scene::Conventions&)>
      nearest;
  /// What it leaves out of a scene with a camera.
  std::function<scene::ScenePlan(const scene::Scene&, const scene::Conventions&, scene::Wanted)>
      plan;
  /// The sphere seen through each pixel of a scene with a camera; empty: none.
  std::function<std::vector<std::optional<SeenAnswer>>(const scene::Scene&,
                                                       const scene::Conventions&, Pixels)>
      visible;

  /// The whole image of a scene with a camera.
  std::function<ImageAnswer(const scene::Scene&, const scene::Conventions&)> image;

  DeclaredConventions declared;
  /// Wrong pixels of `image` are excused where a relative change of the scene by so much may make
  /// them right, or where the exact s is at most image_threshold.
  double excused_image_change = kExcusedImageChange;
  double image_threshold = 0;
  /// Larger images are not for `image`.
  std::int64_t most_image_pixels = std::int64_t{1} << 22;
  /// Its documented bound on the error of a quantity, in that quantity's unit; empty: none.
  std::array<std::optional<double>, kQuantityCount> max_error = {};
  /// The same where the rays come from a camera, so that a hit inherits the error of its ray;
  /// empty: max_error.
  std::array<std::optional<double>, kQuantityCount> max_error_end_to_end = {};
  /// It promises the exact class of every given ray: no closeness to tangency and no domain excuses
  /// a wrong one.
  bool exact_class = false;
  /// It promises the same of every sphere seen through a pixel, and s within
  /// reference::kVisibleParameterError.
  bool exact_visible = false;
  /// Images with more pixels across or down are not for `visible`.
  std::int64_t most_visible_across = scene::kMostPixelsAcross;
  /// It is asked what is not a problem, too, which it is to refuse.
  bool refuses = true;
  /// Of the arithmetic that it computes in.
  double unit_roundoff = kDoubleRoundoff;
  /// Its stated domain: rays of these kinds only, and nonzero lengths between these.
  bool needs_unit_direction = false;
  bool needs_origin_outside = false;
  double smallest_length = 0;
  double largest_length = std::numeric_limits<double>::infinity();
  /// The lengths of scenes with a camera lie between these too.
  double smallest_camera_length = 0;
  double largest_camera_length = std::numeric_limits<double>::infinity();
};

/// The candidate's own bound on a quantity of a scene with a camera or of given rays; empty: none.
std::optional<double> documented_bound(const Candidate& candidate, Quantity quantity,
                                       bool has_camera);

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_CANDIDATE_H_
