#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contract/declarations.h"
#include "properties/case.h"
#include "properties/failures.h"
#include "properties/quantity.h"
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

/// For smaller lengths, results may be subnormal; these have too few digits for a bound relative to
/// their size.
inline constexpr double kSmallestJudgedLength = 0x1p-960;

/// For lengths between these, products of four lengths, such as |T x D|^2, are normal floats. In
/// single precision, scenes with other lengths are not judged.
inline constexpr double kSmallestSingleLength = 0x1p-30;
inline constexpr double kLargestSingleLength = 0x1p30;

/// True if every nonzero length of the scene lies in [smallest, largest]. The distance of a sphere
/// of radius 0 counts as a length.
bool lengths_are_within(const Scene& scene, double smallest, double largest);

/// True if the scene lies in the domain.
bool is_inside_domain(const Domain& domain, const Scene& scene);

/// The camera axes that a candidate returns.
struct FrameAnswer {
  scene::UnitVector3 U, V, W;
};

/// Where a candidate finds that a ray meets a sphere.
struct HitAnswer {
  double parameter = 0;                   ///< s, in multiples of the ray's direction.
  Point3 point;                           ///< Q
  std::optional<double> other_root = {};  ///< If the candidate returns both roots.
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

/// The sphere that each pixel of an image shows, row after row: its index, kSomeSphere if the index
/// is unknown, kUnclear if it may also show no sphere, or empty if it shows no sphere.
using ImageAnswer = std::vector<std::optional<std::size_t>>;
inline constexpr std::size_t kSomeSphere = std::numeric_limits<std::size_t>::max();
inline constexpr std::size_t kUnclear = kSomeSphere - 1;

/// What the numbers of a depth picture are: s along the unit direction of the ray from its origin;
/// the distance of the hit from the eye; its part along the view axis; or that in multiples of
/// |near|, which is s along P - E.
enum class Depth { kS, kDistance, kZ, kImagePlane };
inline constexpr std::array<std::string_view, 4> kDepthNames = {"s", "distance", "z",
                                                                "image-plane"};

/// The number of each pixel of a depth picture, row after row; without a meaning where the
/// ImageAnswer shows no sphere.
using DepthAnswer = std::vector<float>;

/// The relative change of a scene that a renderer's image may show without a defect: the scene's
/// text and the renderer's `float`s or thresholds may lose this much precision.
inline constexpr double kExcusedImageChange = 1e-6;
/// kExcusedImageChange for renderers that are judged in single precision: roundings of floats, at
/// condition numbers of some thousands.
inline constexpr double kExcusedSingleImageChange = 1e-4;
constexpr double excused_image_change(Precision precision) {
  return precision == Precision::kSingle ? kExcusedSingleImageChange : kExcusedImageChange;
}

using contract::DeclaredConventions;
using contract::gives_parameter;
using contract::gives_point;
using contract::Returns;

/// Whether a case is valid under the conventions that a candidate fixes. With samples on the edges,
/// an image of one column or row is invalid.
bool is_problem(const Case& the_case, const DeclaredConventions& declared);

/// The functions of a candidate; a function that it lacks is empty. Functions refuse invalid input
/// with std::invalid_argument; any other exception is a failure, described by its what().
/// CandidateFunction replaces both by a NoAnswer. Answers are in the order of the questions; an
/// absent hit is a miss.
struct Functions {
  using Pixels = std::span<const Pixel>;
  using Rays = std::span<const Ray>;
  using Spheres = std::span<const Sphere>;

  CandidateFunction<FrameAnswer(const Camera&)> frame;
  CandidateFunction<std::vector<Point3>(const Camera&, const Conventions&, Pixels)> pixel_points;
  using MakeRays = CandidateFunction<std::vector<Ray>(const Camera&, const Conventions&, Pixels)>;
  MakeRays pixel_rays;  ///< From P along the unit direction D.
  MakeRays focal_rays;  ///< From E along D.
  const MakeRays& rays_from(scene::Origin origin) const {
    return origin == scene::Origin::kPixel ? pixel_rays : focal_rays;
  }
  /// Every ray with every sphere: one list of hits per sphere.
  CandidateFunction<std::vector<SphereHits>(Rays, Spheres, const Conventions&)> intersect;
  /// The hits of a camera's pixels with every sphere, without rays: a RayHit has the index of its
  /// pixel. If set, the hits of a camera's pixels are these.
  CandidateFunction<std::vector<SphereHits>(const Camera&, const Conventions&, Pixels, Spheres)>
      pick;
  /// A superset of the hit classes that `intersect` returns for the inputs in these boxes. Code
  /// that replaces `intersect` must empty or replace this function, too.
  CandidateFunction<scene::PossibleClasses(const scene::Box<Ray>&, const scene::Box<Sphere>&,
                                           scene::HitRule)>
      classes_in;
  CandidateFunction<std::vector<std::optional<std::size_t>>(Rays, Spheres, const Conventions&)>
      nearest;
  /// Its plan for a scene with a camera.
  CandidateFunction<scene::ScenePlan(const Scene&, const Conventions&, scene::Wanted)> plan;
  /// The sphere seen through each pixel of a scene with a camera; empty if there is no sphere.
  CandidateFunction<std::vector<std::optional<SeenAnswer>>(const Scene&, const Conventions&,
                                                           Pixels)>
      visible;
  /// The whole image of a scene with a camera.
  CandidateFunction<ImageAnswer(const Scene&, const Conventions&)> image;
  /// The numbers of that image if it is a depth picture (ImagePolicy::depth).
  CandidateFunction<DepthAnswer(const Scene&, const Conventions&)> depths;
  /// Announces that the next questions are a part of a batch that failed, and get this share, in
  /// (0, 1], of the time limit for a reply. Empty if the candidate has no time limit.
  std::function<void(double share)> allow;
  /// Resets the count of time-outs after which a candidate is dropped. Empty if it cannot time out.
  std::function<void()> reset_timeouts;
  /// These functions if the candidate is called, and answers, by another interface than the
  /// declared one. Empty for raycheck's own methods.
  std::function<Functions(const contract::Interface& other)> by_interface;
  /// Restarts the candidate, so that it loses all state. Empty if it cannot be restarted.
  std::function<void()> restart;

  /// Forgets earlier time-outs, so that answers do not depend on earlier questions.
  void begin_anew() const {
    if (reset_timeouts) reset_timeouts();
  }
};

/// A candidate's promises about its answers.
struct Promises {
  /// The format in which it is judged: cases are rounded to it (rounded_case), and errors and
  /// bounds are in its ulp and u.
  Precision precision = Precision::kDouble;
  /// How it is called, and what it returns; adapted() converts between that and what laws need.
  contract::Interface interface = {};
  contract::Tolerances tolerances = {};  ///< Within these either answer is right.
  contract::Corners corners = contract::Corners::kAsAsked;
  bool is_in_random_cases = false;
  InputFormat input_format() const {
    return {precision, interface, !is_in_random_cases || corners == contract::Corners::kAsAsked};
  }
  /// Its documented bound on the error of a quantity, in that quantity's unit; empty without one.
  std::array<std::optional<double>, kQuantityCount> max_error = {};
  /// Its documented bound on rays made from a camera, where a hit inherits the error of its ray; if
  /// empty, max_error holds there, too.
  std::array<std::optional<double>, kQuantityCount> max_error_end_to_end = {};
  /// Whether the bound on a quantity holds at every condition number. Otherwise it grows with the
  /// condition number (bound_growth).
  std::array<bool, kQuantityCount> is_unconditional = {};
  /// It decides hit or miss exactly for every given ray. A wrong hit class is a defect near a
  /// tangent and outside the domain, too.
  bool exact_class = false;
  /// It decides exactly which sphere is seen through a pixel, and its s is within
  /// reference::kVisibleParameterError.
  bool exact_visible = false;
  /// Whether it must refuse invalid input, and is tried on it.
  bool refuses = true;
  /// It must be right on cases up to this level, unless the user chooses another.
  Level level = Level::kDemanding;
  /// u of the arithmetic that it uses; not smaller than u of `precision`.
  double unit_roundoff = kDoubleRoundoff;
};

/// Whether exact hit classes are promised for every ray of the scene, even outside the domain.
inline bool promises_exact_class(const Promises& promises, const Scene& scene) {
  return promises.exact_class && !scene.camera;
}

/// The bound promised on a quantity, for scenes with a camera or for given rays; empty if there is
/// none.
std::optional<double> documented_bound(const Promises& promises, Quantity quantity,
                                       bool has_camera);

/// The images that a candidate is asked for, and how they are judged.
struct ImagePolicy {
  /// A wrong pixel of `image` is excused if a relative change of the scene by this much may make it
  /// right, or if the exact s is at most image_threshold.
  double excused_image_change = kExcusedImageChange;
  double image_threshold = 0;
  /// Whether a pixel is right, too, if some point of its square shows what it shows.
  bool any_sample = false;
  Depth depth = Depth::kDistance;  ///< What `depths` returns.
  /// Larger images are not given to `image`.
  std::int64_t most_image_pixels = std::int64_t{1} << 22;
  /// Images with more pixels across or down are not given to `visible`.
  std::int64_t most_visible_across = scene::kMostPixelsAcross;
};

/// The code that is judged. Functions that need only a part of it take that base class. Only one
/// thread at a time may use a candidate: each thread that judges has its own.
struct Candidate : Functions, Promises, Domain, ImagePolicy {
  InputFormat input_format() const {
    InputFormat format = Promises::input_format();
    format.middle_pixel = is_in_random_cases && pick;
    return format;
  }
  std::string name;
  DeclaredConventions declared;
};

/// A candidate without functions that declares this, judged by the bounds of another.
Candidate declaring(const contract::Declarations& declared, std::string name,
                    const Candidate& bounds);

/// The candidate as random cases ask it: about corners only if it follows them.
inline Candidate in_random_cases(Candidate candidate) {
  candidate.is_in_random_cases = true;
  return candidate;
}

/// Converts a candidate with bounds in u of doubles to another format. Bounds are converted to u of
/// that format: those of a method that computes in floats are divided by 2^29. In single precision,
/// lengths are limited to [kSmallestSingleLength, kLargestSingleLength].
Candidate judged_in(Precision precision, Candidate candidate);

}  // namespace raycheck::properties
