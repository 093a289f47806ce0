#ifndef RAYCHECK_EXACT_H_
#define RAYCHECK_EXACT_H_

// Exact answers about camera rays and spheres. All arithmetic is inside libraycheck: your compiler
// flags change no answer. C++17; link raycheck::raycheck.
//
//     const auto met = raycheck::exact::hit({{0, 0, 0}, {0, 0, 1}}, {{0, 0, 5}, 1});
//     met.hit_class;                  // hit
//     met.parameter->rounded();       // 4, correctly rounded
//     met.parameter->ulp_error(3.9);  // the error of 3.9 in ulp
//
// Domain: finite numbers, and what the structs of scene.h require; otherwise functions throw
//         std::invalid_argument naming the field.
// Accuracy: decisions are exact, rounded values are correctly rounded, enclosures hold the value.
// Thread safety: const members of one object may be called from several threads.

#include <raycheck/api.h>
#include <raycheck/scene.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raycheck {
namespace exact {

/// Two bounds: lower <= the number <= upper.
struct Interval {
  double lower = 0, upper = 0;  ///< In the unit of the number.
};

/// A real number that is known exactly, and computed on demand. Copies share the computed values.
class RAYCHECK_API Number {
 public:
  /// The correctly rounded number: to nearest, ties to even; infinite beyond the largest double.
  [[nodiscard]] double rounded() const;
  /// The neighbouring doubles; or, if the number is within 2^-70 of itself of a double, that
  /// double, perhaps with its neighbours.
  [[nodiscard]] Interval interval() const;
  /// Decimals with a radius: "[2.6180339887498948482 +/- 4.6e-20]". The radius is at most 2^-bits
  /// of the number. Domain: 2 <= bits <= 100,000; otherwise throws std::invalid_argument.
  [[nodiscard]] std::string enclosure(int bits) const;
  /// As SageMath prints it: "-1/5*sqrt(109) + 28/5".
  [[nodiscard]] std::string closed_form() const;
  /// An upper bound, sharp to 5 digits, on |given - number| divided by the spacing of doubles at
  /// the number. Infinite if `given` is not finite, or if the number is 0 and `given` is not.
  [[nodiscard]] double ulp_error(double given) const;
  /// The condition number: the largest (relative change of the number)/(relative change of the
  /// inputs), for small changes of all doubles that it depends on. An upper bound, too large by at
  /// most 0.1%. A coordinate has the condition number of its vector.
  [[nodiscard]] double condition() const;

  struct Impl;
  /// For libraycheck only.
  explicit Number(std::shared_ptr<const Impl> impl);

 private:
  std::shared_ptr<const Impl> impl_;
};

/// The coordinates of a point or a vector.
struct Numbers {
  Number x, y, z;  ///< Scene lengths.
  /// Each coordinate correctly rounded.
  [[nodiscard]] RAYCHECK_API Vector rounded() const;
};

/// Whether a ray misses, crosses or touches a sphere. Roots that the conventions exclude do not
/// count.
enum class HitClass { miss, hit, tangent };
/// A root of the quadratic equation for s.
enum class WhichRoot { smaller, larger };

/// How a ray meets a sphere.
struct Intersection {
  HitClass hit_class = HitClass::miss;  ///< Exact.
  /// Whether hit_class counts as a hit under the `tangent` convention.
  bool is_hit = false;
  WhichRoot root = WhichRoot::smaller;  ///< The root that is s. Without meaning for a miss.
  std::optional<Number> parameter;  ///< s, in multiples of the given direction. Empty for a miss.
  std::optional<Numbers> point;     ///< Q, the point of the ray at s. Empty for a miss.
};

/// The sphere that a ray meets first.
struct Nearest {
  std::size_t index = 0;          ///< The sphere's index: the smallest in `ties`.
  std::vector<std::size_t> ties;  ///< All spheres met at exactly this s, `index` included.
  Intersection intersection;      ///< How the ray meets sphere `index`.
};

/// A ray that is given, or made from a camera's pixel.
class RAYCHECK_API Ray {
 public:
  /// A given ray. Domain: finite, nonzero direction; otherwise throws std::invalid_argument.
  explicit Ray(const raycheck::Ray& ray);

  [[nodiscard]] Numbers origin() const;     ///< The point where it starts.
  [[nodiscard]] Numbers direction() const;  ///< Its direction, of length 1.
  /// How it meets a sphere. Domain: a finite sphere of radius >= 0; otherwise throws
  /// std::invalid_argument naming the field.
  [[nodiscard]] Intersection hit(const Sphere& sphere, const Conventions& conventions = {}) const;
  /// The sphere that it meets first; empty if it misses all. Throws as hit() does.
  [[nodiscard]] std::optional<Nearest> nearest(const std::vector<Sphere>& spheres,
                                               const Conventions& conventions = {}) const;

  struct Impl;
  /// For libraycheck only.
  explicit Ray(std::shared_ptr<const Impl> impl);

 private:
  std::shared_ptr<const Impl> impl_;
};

/// The camera axes.
struct Axes {
  Numbers u, v, w;  ///< Of length 1, at right angles.
};

/// A camera, known exactly.
class RAYCHECK_API Camera {
 public:
  /// Domain: finite numbers, and what raycheck::Camera requires; otherwise throws
  /// std::invalid_argument naming the field.
  explicit Camera(const raycheck::Camera& camera, const Conventions& conventions = {});

  [[nodiscard]] Axes axes() const;  ///< U, V and W.
  /// The pixel's point on the image plane. Domain: a pixel of the image; otherwise throws
  /// std::invalid_argument.
  [[nodiscard]] Numbers pixel_point(Pixel pixel) const;
  /// The pixel's ray, with a direction of length 1. It starts at the pixel's point or at the eye,
  /// as the `origin` convention says. Domain: a pixel of the image; otherwise throws
  /// std::invalid_argument.
  [[nodiscard]] Ray ray(Pixel pixel) const;

  struct Impl;

 private:
  std::shared_ptr<const Impl> impl_;
};

/// How a ray meets a sphere; equal to Ray(ray).hit(sphere, conventions).
[[nodiscard]] RAYCHECK_API Intersection hit(const raycheck::Ray& ray, const Sphere& sphere,
                                            const Conventions& conventions = {});
/// The sphere that a ray meets first; empty if it misses all.
[[nodiscard]] RAYCHECK_API std::optional<Nearest> nearest(const raycheck::Ray& ray,
                                                          const std::vector<Sphere>& spheres,
                                                          const Conventions& conventions = {});

}  // namespace exact
}  // namespace raycheck

#endif  // RAYCHECK_EXACT_H_
