#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "reference/enclosure.h"
#include "reference/exact_camera.h"
#include "reference/internal/double_double.h"
#include "reference/internal/kept.h"
#include "scene/conventions.h"
#include "scene/geometry.h"
#include "scene/precision.h"

namespace raycheck::reference {

enum class HitClass { kMiss, kHit, kTangent };
enum class WhichRoot { kSmaller, kLarger };  ///< v - d, v + d

/// How a ray meets a sphere. `root` is valid only for hits and tangents.
struct Intersection {
  HitClass hit_class = HitClass::kMiss;
  WhichRoot root = WhichRoot::kSmaller;
  bool operator==(const Intersection&) const = default;
};

/// Whether a class is a hit under a `tangent` convention. Under kEither a tangent counts as a hit,
/// and is not judged.
constexpr bool counts_as_hit(HitClass hit_class, scene::Tangent tangent) {
  return hit_class == HitClass::kHit ||
         (hit_class == HitClass::kTangent && tangent != scene::Tangent::kMiss);
}

/// The arithmetic that decides: the stages one after the other, or only the exact field, with which
/// tests compare the other stages.
enum class Engine { kFiltered, kFieldOnly };

/// The stages of Engine::kFiltered, the cheapest first. The first stage that is certain decides.
/// kIntervals includes doubles with bounds on their errors, which come before.
enum class FilterStage { kIntervals, kDoubleDoubles, kBalls, kField };

/// How to decide. `highest`, if not null, is raised to the highest stage that a decision needed.
struct Filtering {
  Engine engine = Engine::kFiltered;
  FilterStage* highest = nullptr;
};

/// The sphere that a ray meets first.
struct NearestSphere {
  std::size_t index = 0;  ///< The smallest in `ties`.
  Intersection intersection;
  std::vector<std::size_t>
      ties;  ///< All spheres met at exactly the same parameter, index included.
};

/// Enclosures of one ray's values at one working precision; they may be wide.
class EnclosedRay {
 public:
  struct Impl;
  explicit EnclosedRay(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  Enclosure3 origin() const;       ///< P or E, or a given ray's origin.
  Enclosure3 pixel_point() const;  ///< P; only for a camera's ray.
  Enclosure3 direction() const;    ///< The unit direction D.
  Enclosure length() const;        ///< l = |P - E|; for a given ray |direction|.
  Enclosure parameter(const scene::Sphere& sphere, const Intersection& intersection) const;
  Enclosure3 point(const scene::Sphere& sphere, const Intersection& intersection) const;
  Enclosure half_chord_sq(const scene::Sphere& sphere) const;   ///< d^2 = r^2 - (|T|^2 - v^2)
  Enclosure axial_distance(const scene::Sphere& sphere) const;  ///< v = T.D

 private:
  std::shared_ptr<const Impl> impl_;
};

/// Whether a root is valid (scene::ValidRoots), and if not, why.
enum class RootCounts { kYes, kCulled, kBeforeMin, kOnOpenMin, kOnOpenMax, kBeyondMax };

inline constexpr std::array<std::string_view, 3> kHitClassNames = {"miss", "hit", "tangent"};
inline constexpr std::array<std::string_view, 2> kWhichRootNames = {"smaller", "larger"};
inline constexpr std::array<std::string_view, 6> kRootCountsNames = {
    "yes", "culled", "before t_min", "on an open t_min", "on an open t_max", "beyond t_max"};
constexpr auto& names_of(HitClass /*of*/) { return kHitClassNames; }
constexpr auto& names_of(WhichRoot /*of*/) { return kWhichRootNames; }
constexpr auto& names_of(RootCounts /*of*/) { return kRootCountsNames; }
using scene::name;

/// A ray, known exactly: through a camera's pixel, or given by doubles.
/// Units:  scene lengths. s is a length for a camera's ray, whose direction is unit, and in
///         multiples of the direction for a given ray.
/// Domain: every valid input (scene/validate.h) over the whole range of doubles. Otherwise
///         constructors, and functions with a sphere, throw std::invalid_argument naming the field.
/// Error:  decisions are exact; enclosures contain the true value; rounded_* are correctly rounded
///         to the format (to nearest, ties to even; overflow to infinity as IEEE-754 says; every
///         zero is +0).
/// Thread safety: const functions may be called from several threads. The caller's rounding mode is
///         restored.
/// Source: docs/problem.md; filters before exact arithmetic as in CGAL's Filtered_predicate.
class ExactRay {
 public:
  ExactRay(const ExactCamera& camera, const scene::Pixel& pixel);
  explicit ExactRay(const scene::Ray& ray);

  /// The source of the ray's numbers: a camera and a pixel, or a given ray.
  struct Source {
    std::shared_ptr<const ExactCamera::Impl> camera;  ///< Null for a given ray.
    scene::Pixel pixel;
    scene::Ray given;
  };
  const Source& source() const { return source_; }
  /// g and |g|^2 of the line base + lambda g (reference/internal/formulas.h) in double-doubles.
  /// They are computed on demand, since intervals nearly always decide.
  struct Direction {
    Triple<DoubleDouble> g;
    DoubleDouble a;
  };
  Direction direction_in_double_doubles() const;

  /// Hit, miss or tangent, and the root, under a `root` convention.
  Intersection intersect(const scene::Sphere& sphere, scene::Root root = scene::Root::kNearest,
                         Filtering by = {}) const;
  /// Hit, miss or tangent, and the root, under the conventions for the root and for valid roots.
  Intersection intersect(const scene::Sphere& sphere, const scene::Conventions& conventions,
                         Filtering by = {}) const;
  /// Whether the root of a hit or a tangent counts.
  RootCounts counts(const scene::Sphere& sphere, const Intersection& at,
                    const scene::ValidRoots& valid, Filtering by = {}) const;
  /// The sign, for a hit or a tangent, of s - t; of s - t r if t is in radii of the sphere; of
  /// |direction| s - t if t is a scene length.
  /// Domain: t is finite.
  int compare_parameter(const scene::Sphere& sphere, const Intersection& at, double t,
                        scene::TUnit unit, Filtering by = {}) const;
  /// The sign of s(first) - s(second), both of which must be hits.
  int compare(const scene::Sphere& first, const Intersection& at_first, const scene::Sphere& second,
              const Intersection& at_second, Filtering by = {}) const;
  /// If sphere `index`, which is hit, is nearer than `best`, it becomes the best; if it is at the
  /// same s, it is added to the ties.
  void keep_nearest(std::span<const scene::Sphere> spheres, std::size_t index,
                    const Intersection& at, std::optional<NearestSphere>& best,
                    Filtering by = {}) const;
  /// The sphere that is met first, and its ties; empty if all are missed.
  std::optional<NearestSphere> nearest(std::span<const scene::Sphere> spheres,
                                       const scene::Conventions& conventions,
                                       Filtering by = {}) const;

  /// Enclosures. Each coordinate has the relative width 2^-relative_bits; a value of 0 is exact.
  Enclosure3 pixel_point(int relative_bits = kValueBits) const;
  Enclosure3 origin(int relative_bits = kValueBits) const;
  Enclosure3 direction(int relative_bits = kValueBits) const;
  Enclosure parameter(const scene::Sphere& sphere, const Intersection& intersection,
                      int relative_bits = kValueBits) const;
  Enclosure3 point(const scene::Sphere& sphere, const Intersection& intersection,
                   int relative_bits = kValueBits) const;

  scene::Point3 rounded_pixel_point(scene::Precision precision = scene::Precision::kDouble) const;
  scene::Point3 rounded_origin(scene::Precision precision = scene::Precision::kDouble) const;
  scene::UnitVector3 rounded_direction(
      scene::Precision precision = scene::Precision::kDouble) const;
  double rounded_parameter(const scene::Sphere& sphere, const Intersection& intersection,
                           scene::Precision precision = scene::Precision::kDouble) const;
  scene::Point3 rounded_point(const scene::Sphere& sphere, const Intersection& intersection,
                              scene::Precision precision = scene::Precision::kDouble) const;

  /// The values at one working precision, for all inputs within a relative change.
  EnclosedRay enclose(int bits, double relative_change = 0) const;

  /// By default values are 2^-70 of their size wide. This is 17 bits below u, so that an error of 1
  /// ulp has 5 digits.
  static constexpr int kValueBits = 70;

 private:
  struct Filter;
  std::optional<Intersection> intersect_by_doubles(const scene::Sphere& sphere,
                                                   scene::Root root) const;
  std::optional<Intersection> intersect_by_intervals(const scene::Sphere& sphere,
                                                     scene::Root root) const;
  template <class F>
  int decide(const scene::Sphere& first, const scene::Sphere& second, Filtering by, F sign) const;

  Source source_;
  std::array<double, 6> quick_;         ///< A QuickLine.
  Kept<std::array<double, 8>> bounds_;  ///< Lower and upper bounds on g and |g|^2, in intervals.
  Kept<Direction> direction_;
};

}  // namespace raycheck::reference
