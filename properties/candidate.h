#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "properties/case.h"
#include "properties/failures.h"
#include "properties/quantity.h"
#include "properties/returns.h"
#include "scene/plan/plan.h"
#include "scene/precision.h"
#include "scene/scene.h"

namespace raycheck::properties {

/// The domain in which a candidate's promises hold: nonzero lengths lie between these.
struct Domain {
  double smallest_length = 0;
  double largest_length = std::numeric_limits<double>::infinity();
  /// Lengths of scenes with a camera must also lie between these.
  double smallest_camera_length = 0;
  double largest_camera_length = std::numeric_limits<double>::infinity();
};

/// Results for smaller lengths may be subnormal, with too few digits for a bound relative to
/// their size.
inline constexpr double kSmallestJudgedLength = 0x1p-960;

/// Products of four lengths, such as |T x D|^2, stay normal floats for lengths between these:
/// outside, nothing is judged in single precision.
inline constexpr double kSmallestSingleLength = 0x1p-30;
inline constexpr double kLargestSingleLength = 0x1p30;

/// A domain cut to the lengths that are judged in a format.
Domain judged_in(scene::Precision precision, Domain domain);

/// True when every nonzero length of the scene lies in [smallest, largest]; for a sphere of radius
/// 0 its distance counts as one.
bool lengths_are_within(const scene::Scene& scene, double smallest, double largest);

/// True when the scene lies in the domain.
bool is_inside_domain(const Domain& domain, const scene::Scene& scene);

/// The camera axes that a candidate returns.
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

/// The hits of several rays with one sphere, in the order of the rays; a ray not listed is a miss.
using SphereHits = std::vector<RayHit>;

/// The nearest sphere of a pixel, and its s.
struct SeenAnswer {
  std::size_t sphere = 0;
  double parameter = 0;  ///< s
};

/// The sphere that each pixel of an image shows, row after row: its index, kSomeSphere if it is
/// unknown which, or empty without a sphere.
using ImageAnswer = std::vector<std::optional<std::size_t>>;
inline constexpr std::size_t kSomeSphere = std::numeric_limits<std::size_t>::max();

/// The relative change of a scene that may show in an image: the precision that its text and its
/// renderer's `float`s or thresholds may lose.
inline constexpr double kExcusedImageChange = 1e-6;
/// The same for renderers that are judged in single precision: the roundings of floats, in scenes
/// with a condition number of some thousands.
inline constexpr double kExcusedSingleImageChange = 1e-4;
constexpr double excused_image_change(scene::Precision precision) {
  return precision == scene::Precision::kSingle ? kExcusedSingleImageChange : kExcusedImageChange;
}

/// The conventions that a candidate fixes; it takes the others from the scene.
struct DeclaredConventions {
  std::optional<scene::Rows> rows;
  std::optional<scene::Samples> samples;
  std::optional<scene::Origin> origin;
  std::optional<scene::Root> root;
  std::optional<scene::Tangent> tangent;
  std::optional<scene::ValidRoots> valid = {};

  /// The scene's conventions, or another declaration's, overridden by those declared here.
  scene::Conventions over(scene::Conventions conventions) const;
  DeclaredConventions over(DeclaredConventions others) const;
};

/// Whether a case stays valid under the conventions that a candidate fixes: with samples on the
/// edges an image of one column or row is not.
bool is_problem(const Case& the_case, const DeclaredConventions& declared);

/// The functions of a candidate; those that it lacks are empty. Functions refuse invalid
/// input with std::invalid_argument; the what() of any other exception says how they failed.
/// CandidateFunction throws a NoAnswer in place of both. Answers come in the order of the
/// questions; an absent hit is a miss.
struct Functions {
  using Pixels = std::span<const scene::Pixel>;
  using Rays = std::span<const scene::Ray>;
  using Spheres = std::span<const scene::Sphere>;

  CandidateFunction<FrameAnswer(const scene::Camera&)> frame;
  CandidateFunction<std::vector<scene::Point3>(const scene::Camera&, const scene::Conventions&,
                                               Pixels)>
      pixel_points;
  using MakeRays = CandidateFunction<std::vector<scene::Ray>(const scene::Camera&,
                                                             const scene::Conventions&, Pixels)>;
  MakeRays pixel_rays;  ///< From P along the unit direction D.
  MakeRays focal_rays;  ///< From E along the same.
  const MakeRays& rays_from(scene::Origin origin) const {
    return origin == scene::Origin::kPixel ? pixel_rays : focal_rays;
  }
  /// Every ray with every sphere: one list of hits per sphere.
  CandidateFunction<std::vector<SphereHits>(Rays, Spheres, const scene::Conventions&)> intersect;
  /// A superset of the hit classes that `intersect` answers on boxes of valid input. Code that
  /// replaces `intersect` must empty or replace this function, too.
  CandidateFunction<scene::PossibleClasses(const scene::Box<scene::Ray>&,
                                           const scene::Box<scene::Sphere>&, scene::HitRule)>
      classes_in;
  CandidateFunction<std::vector<std::optional<std::size_t>>(Rays, Spheres,
                                                            const scene::Conventions&)>
      nearest;
  /// Its plan for a scene with a camera.
  CandidateFunction<scene::ScenePlan(const scene::Scene&, const scene::Conventions&, scene::Wanted)>
      plan;
  /// The sphere seen through each pixel of a scene with a camera; empty without one.
  CandidateFunction<std::vector<std::optional<SeenAnswer>>(const scene::Scene&,
                                                           const scene::Conventions&, Pixels)>
      visible;
  /// The whole image of a scene with a camera.
  CandidateFunction<ImageAnswer(const scene::Scene&, const scene::Conventions&)> image;
  /// The next questions are a part of a batch that failed, and get this share, in (0, 1], of the
  /// time limit for a reply. Empty: it has no such limit.
  std::function<void(double share)> allow;
  /// Resets the count of time-outs after which a candidate is dropped. Empty: it always replies.
  std::function<void()> reset_timeouts;
  /// Starts it anew, so that it loses all state between questions. Empty: it cannot be restarted.
  std::function<void()> restart;

  /// Forgets earlier time-outs, so that answers do not depend on earlier questions.
  void begin_anew() const {
    if (reset_timeouts) reset_timeouts();
  }
};

/// A candidate's promises about its answers.
struct Promises {
  /// The format that it is judged in: cases are rounded to it (rounded_case), and errors and
  /// bounds count its ulp and u.
  scene::Precision precision = scene::Precision::kDouble;
  /// Whether it is given only rays with unit directions.
  bool unit_directions = false;
  InputFormat input_format() const { return {precision, unit_directions}; }
  /// What its functions return for a hit; completed() adds the missing one of s and Q.
  Returns returns = Returns::kHit;
  /// Its documented bound on the error of a quantity, in that quantity's unit; empty without one.
  std::array<std::optional<double>, kQuantityCount> max_error = {};
  /// The same for rays made from a camera, where a hit inherits the error of its ray; empty:
  /// max_error.
  std::array<std::optional<double>, kQuantityCount> max_error_end_to_end = {};
  /// Whether the bound on a quantity holds at every condition number; otherwise it grows
  /// with it (bound_growth).
  std::array<bool, kQuantityCount> is_unconditional = {};
  /// It decides hit or miss exactly for every given ray: neither near-tangency nor the domain
  /// excuses a wrong hit class.
  bool exact_class = false;
  /// The same for a sphere seen through a pixel, and s within reference::kVisibleParameterError.
  bool exact_visible = false;
  /// Whether it also gets invalid input, which it must refuse.
  bool refuses = true;
  /// The level of the cases that it must get right, unless the user chooses another.
  Level level = Level::kDemanding;
  /// u of the arithmetic that it uses; at least that of the format.
  double unit_roundoff = kDoubleRoundoff;
};

/// Whether exact hit classes are promised for every ray of a scene, also outside the domain.
inline bool promises_exact_class(const Promises& promises, const scene::Scene& scene) {
  return promises.exact_class && !scene.camera;
}

/// The bound promised on a quantity of a scene with a camera or of given rays; empty without one.
std::optional<double> documented_bound(const Promises& promises, Quantity quantity,
                                       bool has_camera);

/// The images that a candidate is asked for, and how they are judged.
struct ImagePolicy {
  /// Wrong pixels of `image` are excused where a relative change of the scene by this much may make
  /// them right, or where the exact s is at most image_threshold.
  double excused_image_change = kExcusedImageChange;
  double image_threshold = 0;
  /// Larger images are not given to `image`.
  std::int64_t most_image_pixels = std::int64_t{1} << 22;
  /// Images with more pixels across or down are not given to `visible`.
  std::int64_t most_visible_across = scene::kMostPixelsAcross;
};

/// The code that is judged. Functions that need one part of it take only that base class.
/// It is used by one thread at a time: each thread that judges has its own candidate.
struct Candidate : Functions, Promises, Domain, ImagePolicy {
  std::string name;
  DeclaredConventions declared;
};

/// A hit with the values that the candidate does not return: s is the distance over the direction's
/// length, or the projection of Q; Q is the point at s; with only a hit class both are where the
/// ray comes closest to the centre at s >= 0. Laws judge only what was returned (Needs).
HitAnswer completed(const HitAnswer& hit, Returns returns, const scene::Ray& ray,
                    const scene::Sphere& sphere);
/// The same functions, with the hits of `intersect` completed.
Functions completed(Functions functions, Returns returns);

/// Converts a candidate with bounds in u of doubles to another format: bounds keep their number of
/// u of its arithmetic (those of a method in floats are divided by 2^29), and single precision
/// limits lengths to between kSmallestSingleLength and kLargestSingleLength.
Candidate judged_in(scene::Precision precision, Candidate candidate);

}  // namespace raycheck::properties
