#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "properties/candidate.h"
#include "properties/mistakes/mistakes.h"

namespace raycheck::properties {

/// The mistakes, one or two, that a program makes at the same time. Empty: the program is right.
using Fault = std::vector<const Mistake*>;

/// Their sentences joined: "rows are upside down; and top is -bottom".
std::string sentence_of(const Fault& fault);

/// The possible mistakes at a place of a fault: of "(A, or: B); and (C, or: D)" (see sentence_of())
/// A and B at place 0. If the alternatives are not all combinations, the first alternative's only.
std::vector<const Mistake*> mistakes_at(std::size_t place, const std::vector<Fault>& alternatives);

/// The sentence of alternatives: "rows are upside down, or: V has the wrong sign". If they are all
/// combinations of A or B with C or D: "(A, or: B); and (C, or: D)". For other pairs: "(A; and B),
/// or: (C; and D)".
std::string sentence_of(const std::vector<Fault>& alternatives);
/// The sentence in parts, "A, or: B" and "C, or: D"; one part if the alternatives are not all
/// combinations.
std::vector<std::string> sentences_of(const std::vector<Fault>& alternatives);

/// Whether one program can make both mistakes: they do not replace the same formula.
bool can_be_together(const Mistake& a, const Mistake& b);

/// The picture that a program with a fault draws of a scene, in doubles. The changes of the
/// mistakes are applied in the order of mistakes(); the rays come from the mistake that has a
/// formula for rays; the hits use the formulas of all mistakes. If the camera becomes invalid, the
/// picture is black. Domain: a valid scene with a camera, which outlives this object; mistakes that
/// can be together.
class FaultyView {
 public:
  FaultyView(const Fault& fault, const Scene& scene);

  /// The rays of these pixels; empty if the camera is invalid or the pixel is black.
  std::vector<std::optional<Ray>> rays(std::span<const Pixel> pixels) const;
  /// The scene as code with this fault reads it.
  const Scene& taken() const { return taken_; }

  /// The sphere that each of these pixels shows. Radii are enlarged by `growth` times the distance
  /// from the eye.
  ImageAnswer seen(std::span<const Pixel> pixels, double growth = 0) const;

 private:
  const Scene& asked_;
  Scene taken_;
  const Candidate* rays_;
  NearestSpheres nearest_;
  std::vector<const Mistake*> pixels_;
};

/// The whole image that a program with this fault draws.
ImageAnswer predicted(const Fault& fault, const Scene& scene);

}  // namespace raycheck::properties
