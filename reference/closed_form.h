#ifndef RAYCHECK_REFERENCE_CLOSED_FORM_H_
#define RAYCHECK_REFERENCE_CLOSED_FORM_H_

#include <array>
#include <memory>
#include <string>

#include "reference/exact_ray.h"
#include "scene/camera.h"
#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::reference {

/// The coordinates of a point or vector, each as a closed form.
using ClosedForm3 = std::array<std::string, 3>;

struct ClosedFormFrame {
  ClosedForm3 U, V, W;
};

/// The camera axes as SageMath prints them: sums of rationals times square roots, larger radicands
/// first, e.g. "-1/5*sqrt(109) + 28/5". Square factors are taken out of every radicand (those with
/// a prime below kLargestTrialPrime, and a cofactor that is itself a square); terms that are 0 are
/// dropped. Domain: as ExactCamera.
ClosedFormFrame closed_form_frame(const scene::Camera& camera);

/// The largest prime that is tried as a factor of a radicand.
inline constexpr int kLargestTrialPrime = 1 << 16;

/// One ray's values in closed form; same names and domain as EnclosedRay. Values of a hit outside
/// the field keep one nested root: "A + B*sqrt(C)" with A, B, C in closed form.
class ClosedFormRay {
 public:
  struct Impl;
  ClosedFormRay(const scene::Camera& camera, const scene::Conventions& conventions,
                const scene::Pixel& pixel);
  explicit ClosedFormRay(const scene::Ray& ray);

  std::string alpha() const;  ///< Only of a camera's ray, like beta and pixel_point.
  std::string beta() const;
  ClosedForm3 pixel_point() const;
  ClosedForm3 origin() const;
  ClosedForm3 direction() const;
  std::string length() const;

  ClosedForm3 to_centre(const scene::Sphere& sphere) const;       ///< T = C - L
  std::string axial_distance(const scene::Sphere& sphere) const;  ///< v = T.D
  std::string half_chord_sq(const scene::Sphere& sphere) const;   ///< d^2
  std::string parameter(const scene::Sphere& sphere, const Intersection& intersection) const;
  /// v - d or v + d: the parameter for the unit direction, a length.
  std::string distance(const scene::Sphere& sphere, const Intersection& intersection) const;
  ClosedForm3 point(const scene::Sphere& sphere, const Intersection& intersection) const;

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace raycheck::reference

#endif  // RAYCHECK_REFERENCE_CLOSED_FORM_H_
