#pragma once

// The conditions under which a ray meets one of several spheres first, over parts of a
// neighbourhood. Internal to reference/.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "reference/account/internal/answer_decider.h"
#include "reference/account/internal/condition_impl.h"

namespace raycheck::reference {

/// The number of inputs of a ray and two spheres.
inline constexpr int kTwoSpheresInputs = kCameraInputs + kSphereInputs;

/// A condition on a ray and a sphere: `sign` times `what` is not negative, or is positive. Let s be
/// the sphere's `root` (-1: the smaller, 1: the larger) and s' the root of the favourite.
struct ChoiceCondition {
  enum class What {
    kDiscriminant,
    kConstant,
    kLinear,
    kAfter,  ///< s - s', times a positive number.
    // If s - s' is not negative, these two are not either; they need no root of the sphere.
    kOutside,      ///< The sphere's quadratic at s', times -root and a positive number.
    kBeforeMiddle  ///< The middle of the sphere's roots minus s', times a positive number.
  };
  What what;
  std::size_t sphere;
  int sign = 1;
  bool is_strict = false;  ///< Positive, not only not negative.
  std::size_t favourite = 0;
  int root = 0;
  int favourite_root = 0;
};

/// A part of the box [-1, 1]^n: a box about a middle, or only the middle. A point t of the box
/// changes input k by t_k times the relative change of the neighbourhood.
struct Part {
  std::vector<double> middle;
  std::vector<double> half_width;  ///< Empty: only the middle.
};

/// Lifts doubles to balls of their values in a part of the neighbourhood. It starts with the inputs
/// of the ray, and goes on at the index given to move_to().
class PartLift {
 public:
  using Kernel = EnclosureKernel;

  PartLift(int bits, double relative_change, const Part& part)
      : bits_(bits), change_(relative_change, bits), part_(&part) {}

  Enclosure operator()(double value) const;
  Enclosure constant(double value) const { return Enclosure(value, bits_); }
  void move_to(std::size_t next) const { next_ = next; }

 private:
  int bits_;
  Enclosure change_;
  const Part* part_;
  mutable std::size_t next_ = 0;
};

/// A ray and the spheres whose inputs span the box, in this order.
struct ChoiceNumbers {
  ChoiceNumbers(const ExactRay& its_ray, std::span<const scene::Sphere> its_spheres,
                double its_relative_change);

  std::size_t dimension() const { return values.size(); }
  std::size_t of_ray() const { return first_of(0); }
  std::size_t first_of(std::size_t sphere) const {
    return values.size() - kSphereInputs * (spheres.size() - sphere);
  }

  const ExactRay& ray;
  std::vector<scene::Sphere> spheres;
  double relative_change;
  std::vector<double> values;  ///< The unchanged inputs.
};

/// How conditions vary over a part.
class ChoiceForms {
 public:
  ChoiceForms(const ChoiceNumbers& inputs, const Part& part);
  ChoiceForms(const ChoiceForms&) = delete;
  ChoiceForms& operator=(const ChoiceForms&) = delete;

  Variation of(const ChoiceCondition& condition) const;

 private:
  using Lift = DualLift<PartLift, kTwoSpheresInputs>;

  std::optional<Enclosure> some_off(const ChoiceCondition& condition) const;

  const ChoiceNumbers& inputs_;
  Part part_;
  Part middle_;
  Lift lift_;
  Line<Lift::Kernel> line_;
  PartLift middle_lift_;
  std::optional<Line<EnclosureKernel>> middle_line_;  ///< Empty: the part is a point.
};

}  // namespace raycheck::reference
