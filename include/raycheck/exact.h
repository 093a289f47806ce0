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
// Domain: finite doubles, nonzero directions, radii not negative, cameras with axes and pixels;
//         otherwise functions throw std::invalid_argument naming the field.
// Errors: none: decisions are exact, rounded values are correctly rounded, enclosures enclose.
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

/// lower <= some number <= upper.
struct Interval {
  double lower = 0, upper = 0;  ///< In the number's units.
};

/// A real number that is known exactly. Copies share it. It is computed on demand.
class RAYCHECK_API Number {
 public:
  /// Correctly rounded: to nearest, ties to even; infinite beyond the doubles.
  [[nodiscard]] double rounded() const;
  /// The neighbouring doubles; both equal the number if it is a double.
  [[nodiscard]] Interval interval() const;
  /// Decimals with a radius, "[2.6180339887498948482 +/- 4.6e-20]", the radius at most 2^-bits of
  /// the number. Domain: 2 <= bits <= 100,000; otherwise throws std::invalid_argument.
  [[nodiscard]] std::string enclosure(int bits) const;
  /// As SageMath prints it: "-1/5*sqrt(109) + 28/5".
  [[nodiscard]] std::string closed_form() const;
  /// |given - this| in units of the spacing of doubles around this: an upper bound, sharp to 5
  /// digits. Infinite if `given` is not finite, or is not 0 while this is 0.
  [[nodiscard]] double ulp_error(double given) const;
  /// Its largest relative change, per unit of change, when all doubles that it depends on undergo a
  /// small relative change. An upper bound, too large by at most 0.1%. A coordinate has the
  /// condition number of its vector.
  [[nodiscard]] double condition() const;

  struct Impl;
  /// For libraycheck only.
  explicit Number(std::shared_ptr<const Impl> impl);

 private:
  std::shared_ptr<const Impl> impl_;
};

/// A point or a vector, by coordinates.
struct Numbers {
  Number x, y, z;  ///< Scene lengths.
  /// Each coordinate correctly rounded.
  [[nodiscard]] RAYCHECK_API Vector rounded() const;
};

/// Whether a ray misses, crosses or touches a sphere, at an s that the `root` convention allows.
enum class HitClass { miss, hit, tangent };
/// A root of the quadratic equation for s.
enum class WhichRoot { smaller, larger };

/// How a ray meets a sphere.
struct Intersection {
  HitClass hit_class = HitClass::miss;  ///< Exact.
  /// Whether that counts as a hit under the `tangent` convention.
  bool is_hit = false;
  WhichRoot root = WhichRoot::smaller;  ///< For a hit or a tangent, like the next two.
  std::optional<Number> parameter;      ///< s, in multiples of the direction as given.
  std::optional<Numbers> point;         ///< Q, the point of the ray at s.
};

/// The sphere that a ray meets first.
struct Nearest {
  std::size_t index = 0;          ///< The first in the list of those in `ties`.
  std::vector<std::size_t> ties;  ///< All spheres met at exactly this s, `index` included.
  Intersection intersection;      ///< With that sphere.
};

/// A ray, given or made from a camera's pixel.
class RAYCHECK_API Ray {
 public:
  /// A given ray. Domain: finite, nonzero direction; otherwise throws std::invalid_argument.
  explicit Ray(const raycheck::Ray& ray);

  [[nodiscard]] Numbers origin() const;     ///< Where it starts.
  [[nodiscard]] Numbers direction() const;  ///< Of length 1.
  /// How it meets a sphere. Domain: a finite sphere of radius >= 0; otherwise throws
  /// std::invalid_argument naming the field.
  [[nodiscard]] Intersection hit(const Sphere& sphere, const Conventions& conventions = {}) const;
  /// The sphere that it meets first; empty if it meets none. Errors: as hit().
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
  /// Domain: finite numbers, axes, an image plane and pixels; otherwise throws
  /// std::invalid_argument naming the field.
  explicit Camera(const raycheck::Camera& camera, const Conventions& conventions = {});

  [[nodiscard]] Axes axes() const;  ///< U, V and W.
  /// The pixel's point on the image plane. Domain: a pixel of the image; otherwise throws
  /// std::invalid_argument.
  [[nodiscard]] Numbers pixel_point(Pixel pixel) const;
  /// With a direction of length 1, from the pixel's point or the eye as the `origin` convention
  /// says. Domain: a pixel of the image; otherwise throws std::invalid_argument.
  [[nodiscard]] Ray ray(Pixel pixel) const;

  struct Impl;

 private:
  std::shared_ptr<const Impl> impl_;
};

/// How a ray meets a sphere, as Ray::hit() says.
[[nodiscard]] RAYCHECK_API Intersection hit(const raycheck::Ray& ray, const Sphere& sphere,
                                            const Conventions& conventions = {});
/// The sphere that a ray meets first; empty if it meets none.
[[nodiscard]] RAYCHECK_API std::optional<Nearest> nearest(const raycheck::Ray& ray,
                                                          const std::vector<Sphere>& spheres,
                                                          const Conventions& conventions = {});

}  // namespace exact
}  // namespace raycheck

#endif  // RAYCHECK_EXACT_H_
