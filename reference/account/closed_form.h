#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "reference/exact_ray.h"
#include "scene/camera.h"
#include "scene/conventions.h"
#include "scene/geometry.h"

namespace raycheck::reference {

/// An exact number: a sum of terms, in the order of the text; 0 is the empty sum.
struct ClosedForm {
  /// A positive integer.
  struct Natural {
    std::string digits = "1";  ///< In decimal.
    /// If digits = odd * 2^twos with twos >= kFewestTwos and odd <= kLargestOdd; otherwise 0.
    unsigned odd = 0, twos = 0;

    bool is_one() const { return digits == "1"; }
    bool is_short_product() const { return twos != 0; }
  };
  /// numerator/denominator in lowest terms, negated if `negative`, times all `sums`, times the
  /// square roots of all `radicands`.
  struct Term {
    bool negative = false;
    Natural numerator = {}, denominator = {};
    std::vector<ClosedForm> sums = {};
    std::vector<ClosedForm> radicands = {};

    bool is_rational() const { return sums.empty() && radicands.empty(); }
  };
  std::vector<Term> terms = {};

  bool is_zero() const { return terms.empty(); }
  /// As SageMath prints it: "-1/5*sqrt(109) + 28/5", "0".
  std::string text() const;
};

/// Limits for writing an integer as a short odd number times a power of two; see Natural.
inline constexpr unsigned kFewestTwos = 32, kLargestOdd = 999;

/// The coordinates of a point or vector, each as a closed form.
using ClosedForm3 = std::array<ClosedForm, 3>;

std::vector<std::string> texts(std::span<const ClosedForm> forms);

struct ClosedFormFrame {
  ClosedForm3 U, V, W;
};

/// The camera axes as sums of rationals times square roots of integers, larger radicands first, as
/// SageMath orders them. Squares of primes up to kLargestTrialPrime are taken out of every
/// radicand, and also what is left if it is a square. Terms that are 0 are dropped. Domain: that of
/// ExactCamera.
ClosedFormFrame closed_form_frame(const scene::Camera& camera);

/// The largest prime that is tried as a factor of a radicand.
inline constexpr int kLargestTrialPrime = 1 << 16;

/// The values of a ray in closed form, with the names and the domain of EnclosedRay. A value of a
/// hit that is not in the field of the ray's other values keeps one nested root: B*sqrt(C) + A with
/// A, B, C in closed form.
class ClosedFormRay {
 public:
  struct Impl;
  ClosedFormRay(const scene::Camera& camera, const scene::Conventions& conventions,
                const scene::Pixel& pixel);
  explicit ClosedFormRay(const scene::Ray& ray);

  // alpha, beta and pixel_point are only for a camera's ray.
  ClosedForm alpha() const;
  ClosedForm beta() const;
  ClosedForm3 pixel_point() const;
  ClosedForm3 origin() const;
  ClosedForm3 direction() const;
  ClosedForm length() const;

  ClosedForm3 to_centre(const scene::Sphere& sphere) const;      ///< T = C - L
  ClosedForm axial_distance(const scene::Sphere& sphere) const;  ///< v = T.D
  ClosedForm half_chord_sq(const scene::Sphere& sphere) const;   ///< d^2
  ClosedForm parameter(const scene::Sphere& sphere, const Intersection& intersection) const;
  /// v - d or v + d, a length: the parameter if the direction were unit.
  ClosedForm distance(const scene::Sphere& sphere, const Intersection& intersection) const;
  ClosedForm3 point(const scene::Sphere& sphere, const Intersection& intersection) const;

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace raycheck::reference
