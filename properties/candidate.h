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

/// Where a candidate promises anything: nonzero lengths lie between these.
struct Domain {
  double smallest_length = 0;
  double largest_length = std::numeric_limits<double>::infinity();
  /// Lengths of scenes with a camera must also lie between these.
  double smallest_camera_length = 0;
  double largest_camera_length = std::numeric_limits<double>::infinity();
};

/// Results for smaller lengths may be subnormal, with too few digits for any bound relative to
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

/// What each pixel of an image shows, row j after row j: a sphere, kSomeSphere if it is unknown
/// which, or none.
using ImageAnswer = std::vector<std::optional<std::size_t>>;
inline constexpr std::size_t kSomeSphere = std::numeric_limits<std::size_t>::max();

/// The relative change of a scene that may show in an image: the precision that its text and its
/// renderer's `float`s or thresholds may lose.
inline constexpr double kExcusedImageChange = 1e-6;
/// The same for renderers that are judged in single precision: the roundings of floats, in scenes
/// whose condition number is some thousands.
inline constexpr double kExcusedSingleImageChange = 1e-4;
constexpr double excused_image_change(scene::Precision precision) {
  return precision == scene::Precision::kSingle ? kExcusedSingleImageChange : kExcusedImageChange;
}

/// The conventions that an implementation fixes; the others it takes from the scene.
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

/// Whether a case stays valid under the conventions that an implementation fixes: a single sample
/// between two edges does not.
bool is_problem(const Case& the_case, const DeclaredConventions& declared);

/// The functions of an implementation; those that it lacks are empty. Functions refuse invalid
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
  /// A superset of the classes that `intersect`, which this is about, answers on boxes of valid
  /// input. Code that replaces that one must empty or replace this one.
  CandidateFunction<scene::PossibleClasses(const scene::Box<scene::Ray>&,
                                           const scene::Box<scene::Sphere>&, scene::HitRule)>
      classes_in;
  CandidateFunction<std::vector<std::optional<std::size_t>>(Rays, Spheres,
                                                            const scene::Conventions&)>
      nearest;
  /// What it leaves out of a scene with a camera.
  CandidateFunction<scene::ScenePlan(const scene::Scene&, const scene::Conventions&, scene::Wanted)>
      plan;
  /// The sphere seen through each pixel of a scene with a camera; empty: none.
  CandidateFunction<std::vector<std::optional<SeenAnswer>>(const scene::Scene&,
                                                           const scene::Conventions&, Pixels)>
      visible;
  /// The whole image of a scene with a camera.
  CandidateFunction<ImageAnswer(const scene::Scene&, const scene::Conventions&)> image;
  /// What is asked from now on is a part of a batch that failed, and gets this share, in (0, 1], of
  /// the time for an answer. Empty: it has no such limit.
  std::function<void(double share)> allow;
  /// Resets the count of time-outs after which a candidate is dropped. Empty: it always
  /// replies.
  std::function<void()> forget_silence;
  /// What it keeps between questions is lost: it is started anew. Empty: it cannot be.
  std::function<void()> restart;

  /// What it is asked from now on does not depend on what it was asked before.
  void begin_anew() const {
    if (forget_silence) forget_silence();
  }
};

/// What an implementation promises of its answers.
struct Promises {
  /// The format that it is judged in: cases are rounded to it (rounded_case), and errors and
  /// bounds count its ulp and u.
  scene::Precision precision = scene::Precision::kDouble;
  /// Whether it is given only rays with unit directions.
  bool unit_directions = false;
  InputFormat input_format() const { return {precision, unit_directions}; }
  /// What its own functions return of a hit; s and Q are completed (completed()).
  Returns returns = Returns::kHit;
  /// Its documented bound on the error of a quantity, in that quantity's unit; empty: none.
  std::array<std::optional<double>, kQuantityCount> max_error = {};
  /// The same for rays made from a camera, where a hit inherits the error of its ray; empty:
  /// max_error.
  std::array<std::optional<double>, kQuantityCount> max_error_end_to_end = {};
  /// Whether the bound on a quantity holds whatever its condition number is; otherwise it grows
  /// with it (bound_growth).
  std::array<bool, kQuantityCount> is_unconditional = {};
  /// The exact class of every given ray: neither near-tangency nor the domain excuses a wrong one.
  bool exact_class = false;
  /// The same for a sphere seen through a pixel, and s within reference::kVisibleParameterError.
  bool exact_visible = false;
  /// Whether it is also given invalid input, which it must refuse.
  bool refuses = true;
  /// How hard the cases are that it must get right, unless another level is asked for.
  Level level = Level::kDemanding;
  /// Of the arithmetic that it uses; no less than that of the format.
  double unit_roundoff = kDoubleRoundoff;
};

/// Whether the class is promised for every ray of a scene, wherever the scene lies.
inline bool promises_exact_class(const Promises& promises, const scene::Scene& scene) {
  return promises.exact_class && !scene.camera;
}

/// The bound promised on a quantity of a scene with a camera or of given rays; empty: none.
std::optional<double> documented_bound(const Promises& promises, Quantity quantity,
                                       bool has_camera);

/// Which images an implementation is given, and how they are judged.
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

/// An implementation under judgement. Code that needs one part of it takes only that base class.
/// It is used by one thread at a time: where several judge, each has its own candidate.
struct Candidate : Functions, Promises, Domain, ImagePolicy {
  std::string name;
  DeclaredConventions declared;
};

/// A hit with what was not returned: s is the distance over the direction's length, or the
/// projection of Q; Q is the point at s; with only a hit class both are where the ray comes closest
/// to the centre at s >= 0. Laws judge only what was returned (Needs).
HitAnswer completed(const HitAnswer& hit, Returns returns, const scene::Ray& ray,
                    const scene::Sphere& sphere);
/// The same functions, with the hits of `intersect` completed.
Functions completed(Functions functions, Returns returns);

/// A candidate whose bounds count u of doubles, as judged in a format: bounds keep their numbers of
/// u of its arithmetic (those of a method in floats lose 2^29), and single precision limits lengths
/// to between kSmallestSingleLength and kLargestSingleLength.
Candidate judged_in(scene::Precision precision, Candidate candidate);

}  // namespace raycheck::properties
