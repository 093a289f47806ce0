#pragma once

// Maps the neighbourhood of a ray, a sphere and an answer to the box [-1, 1]^n. Internal to
// reference/.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "reference/account/internal/answer_decider.h"
#include "reference/account/internal/vector_length.h"
#include "reference/account/nearby_answer.h"

namespace raycheck::reference {

/// A point t of the box changes input k by t_k times the relative change that the neighbourhood
/// allows. The last coordinate of t moves the answer's s over its allowed range. For a miss, s is 0
/// and does not move.
class AnswerBox {
 public:
  AnswerBox(const ExactRay& ray, const scene::Sphere& sphere, const Neighbourhood& around,
            const std::optional<double>& answer);

  const Neighbourhood& around() const { return around_; }
  const std::optional<double>& answer() const { return answer_; }
  std::vector<double> middle() const;
  /// The magnitudes of the inputs, without the answer's s.
  std::vector<double> sizes() const;

  /// How a decider varies over the whole box. By the mean-value form, it encloses all values.
  const Variation& variation(Decider decider);
  /// Vectors and lengths that are compared if the neighbourhood is wide. moment(): f x g and r |g|;
  /// the line misses if the vector is longer. from_answer(): from the point at s to the centre, and
  /// r.
  VectorAndLength moment() const;
  VectorAndLength from_answer() const;
  /// g, in doubles.
  std::array<double, 3> direction() const;

  /// How a decider varies, to first order about a point.
  Variation variation_at(Decider decider, const std::vector<double>& t) const;
  Enclosure value_at(Decider decider, const std::vector<double>& t) const;
  /// An upper bound on |b - a mu| and on the root of the discriminant if the answer is near a
  /// double root. Then both roots lie within sqrt(R/a) of s, where R is the change of |T - mu g|^2
  /// - r^2 over the neighbourhood.
  Enclosure most_near_double_root();

  InputChange change_at(const std::vector<double>& t) const;
  /// Whether the answer is certainly right for changed inputs.
  bool is_right(const InputChange& change) const;

 private:
  /// Calls `use` with the ray's line and the sphere, both lifted.
  template <class Lift, class Use>
  auto with_pair(const Lift& lift, Use use) const;
  template <std::size_t N, class BaseLift, class Values>
  std::array<std::vector<Enclosure>, N> reaches_of(const Values& values, const BaseLift& base,
                                                   const Enclosure& s, const Enclosure& off) const;
  template <class BaseLift>
  std::vector<Enclosure> reach_of(Decider decider, const BaseLift& base, const Enclosure& s,
                                  const Enclosure& off) const;
  template <class Vector, class Length>
  VectorAndLength over_box(const Vector& vector, const Length& length) const;
  static bool moves_answer(Decider decider) { return decider != Decider::kMiddleOffAnswer; }
  Enclosure at_answer() const;
  Enclosure slack_of_answer() const;
  Enclosure parameter_at(const std::vector<double>& t) const;
  std::optional<Intersection> intersect_changed(const InputChange& change) const;

  const ExactRay& ray_;
  const scene::Sphere& sphere_;
  const Neighbourhood& around_;
  std::optional<double> answer_;
  // The allowed error of the answer's s, and the middle and half width of its allowed range.
  Enclosure slack_, middle_, half_width_;
  Enclosure reach_;  ///< R: the change of |T - mu g|^2 - r^2, to first order.
  std::array<std::optional<Variation>, kDeciderCount> variations_;
};

}  // namespace raycheck::reference
