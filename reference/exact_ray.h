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

/// How a ray meets a sphere; `root` is valid only for hits and tangents.
struct Intersection {
  HitClass hit_class = HitClass::kMiss;
  WhichRoot root = WhichRoot::kSmaller;
  bool operator==(const Intersection&) const = default;
};

/// Whether a class is a hit under a `tangent` convention (kEither counts it, and is not judged).
constexpr bool counts_as_hit(HitClass hit_class, scene::Tangent tangent) {
  return hit_class == HitClass::kHit ||
         (hit_class == HitClass::kTangent && tangent != scene::Tangent::kMiss);
}

/// Which arithmetic decides: the stages one after the other, or only the exact field, by which
/// tests check the other stages.
enum class Engine { kFiltered, kFieldOnly };

/// The stages of Engine::kFiltered, the cheapest first; a decision takes the first that is certain.
enum class FilterStage { kIntervals, kDoubleDoubles, kBalls, kField };

/// How to decide; `highest`, if given, is raised to the highest stage that a decision needed.
struct Filtering {
  Engine engine = Engine::kFiltered;
  FilterStage* highest = nullptr;
};

/// The sphere that a ray meets first.
struct NearestSphere {
  std::size_t index = 0;  ///< The first of `ties` in the file.
  Intersection intersection;
  std::vector<std::size_t>
      ties;  ///< All spheres met at exactly the same parameter, index included.
};

/// Enclosures of one ray's values at one working precision; they may be wide.
class EnclosedRay {
 public:
  struct Impl;
  explicit EnclosedRay(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  Enclosure3 origin() const;       ///< P, or E, or a given ray's own origin.
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

/// One ray, known exactly: through a camera's pixel, or given by doubles.
/// Units:  scene lengths; the parameter s of a camera's ray is a length (its direction is unit),
///         that of a given ray counts multiples of its direction.
/// Domain: every valid input (scene/validate.h) over the whole double range; otherwise constructors
///         and functions that take a sphere throw std::invalid_argument naming the field.
/// Error:  decisions are exact; enclosures hold the true value; rounded_* are correctly rounded to
///         the format asked for (to nearest, ties to even; overflow to infinity as IEEE-754; every
///         zero is +0).
/// Thread safety: const functions may be called from several threads; the rounding mode is left as
///         it was found.
/// Source: docs/problem.md; filters before exact arithmetic as in CGAL's Filtered_predicate.
class ExactRay {
 public:
  ExactRay(const ExactCamera& camera, const scene::Pixel& pixel);
  explicit ExactRay(const scene::Ray& ray);

  /// The origin of the ray's numbers: a camera and a pixel, or a given ray.
  struct Source {
    std::shared_ptr<const ExactCamera::Impl> camera;  ///< Null for a given ray.
    scene::Pixel pixel;
    scene::Ray given;
  };
  const Source& source() const { return source_; }
  /// g and |g|^2 of the line base + lambda g (reference/internal/formulas.h) in double-doubles:
  /// computed on demand, since intervals decide nearly everything.
  struct Direction {
    Triple<DoubleDouble> g;
    DoubleDouble a;
  };
  Direction direction_in_double_doubles() const;

  /// Hit, miss or tangent, and at which root, under a `root` convention.
  Intersection intersect(const scene::Sphere& sphere, scene::Root root = scene::Root::kNearest,
                         Filtering by = {}) const;
  /// The same under all conventions about roots: which are valid, and which of these is taken.
  Intersection intersect(const scene::Sphere& sphere, const scene::Conventions& conventions,
                         Filtering by = {}) const;
  /// Whether a root of a hit or a tangent counts.
  RootCounts counts(const scene::Sphere& sphere, const Intersection& at,
                    const scene::ValidRoots& valid, Filtering by = {}) const;
  /// The sign of s - t for a hit or a tangent; if t is in radii of the sphere, of s - t r; if it is
  /// a scene length, of |direction| s - t.
  /// Domain: t is finite.
  int compare_parameter(const scene::Sphere& sphere, const Intersection& at, double t,
                        scene::TUnit unit, Filtering by = {}) const;
  /// The sign of s(first) - s(second), both of which must be hits.
  int compare(const scene::Sphere& first, const Intersection& at_first, const scene::Sphere& second,
              const Intersection& at_second, Filtering by = {}) const;
  /// Makes sphere `index`, which is hit, the nearest when it is nearer than `best`, or one of its
  /// ties.
  void keep_nearest(std::span<const scene::Sphere> spheres, std::size_t index,
                    const Intersection& at, std::optional<NearestSphere>& best,
                    Filtering by = {}) const;
  /// The sphere met first, ties included; empty when all are missed.
  std::optional<NearestSphere> nearest(std::span<const scene::Sphere> spheres,
                                       const scene::Conventions& conventions,
                                       Filtering by = {}) const;

  /// Enclosures of relative width 2^-relative_bits per coordinate; exact where the value is 0.
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

  /// Values at one working precision, when every input is known only up to a relative change.
  EnclosedRay enclose(int bits, double relative_change = 0) const;

  /// The default width of values, 2^-70 of their size: 17 bits below u, which leaves 5 digits of an
  /// error of 1 ulp.
  static constexpr int kValueBits = 70;

 private:
  struct Filter;
  std::optional<Intersection> intersect_by_intervals(const scene::Sphere& sphere,
                                                     scene::Root root) const;
  template <class F>
  int decide(const scene::Sphere& first, const scene::Sphere& second, Filtering by, F sign) const;

  Source source_;
  std::array<double, 8> bounds_;  ///< Lower and upper bounds of g and |g|^2: the filter's line.
  Kept<Direction> direction_;
};

}  // namespace raycheck::reference
