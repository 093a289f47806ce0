#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "properties/candidate.h"
#include "properties/mistakes/mistakes.h"

namespace raycheck::properties {

/// The mistakes that a program makes at the same time, one or two; empty: it is right.
using Fault = std::vector<const Mistake*>;

/// Their sentences joined: "rows are upside down; and top is -bottom".
std::string sentence_of(const Fault& fault);

/// The possible mistakes at a place of a fault. If the alternatives are all pairs of some mistakes
/// with some others: all mistakes at that place; otherwise the mistake of the first alternative.
std::vector<const Mistake*> mistakes_at(std::size_t place, const std::vector<Fault>& alternatives);

/// The sentence of alternatives: "rows are upside down, or: V has the wrong sign"; for all pairs of
/// some with others "(A, or: B); and (C, or: D)"; for other pairs "(A; and B), or: (C; and D)".
std::string sentence_of(const std::vector<Fault>& alternatives);
/// This sentence in parts, "A, or: B" and "C, or: D"; one part if the alternatives are not all
/// pairs of some with others.
std::vector<std::string> sentences_of(const std::vector<Fault>& alternatives);

/// Whether one program can make both mistakes: they do not replace the same formula.
bool can_be_together(const Mistake& a, const Mistake& b);

/// The picture of a scene by a program with a fault, in doubles: applies the changes of the
/// mistakes in their order, makes rays by the formula of the mistake that has one, and hits by the
/// formulas of all. A camera that becomes invalid shows nothing. Domain: a valid scene with a
/// camera, which outlives it; mistakes that can be together.
class FaultyView {
 public:
  FaultyView(const Fault& fault, const scene::Scene& scene);

  /// The rays of these pixels; empty where the camera is invalid, or the pixel is black.
  std::vector<std::optional<scene::Ray>> rays(std::span<const scene::Pixel> pixels) const;
  /// The scene as the program reads it.
  const scene::Scene& taken() const { return taken_; }

  /// The sphere at each of these pixels. Radii grow by this share of the distance from the eye.
  ImageAnswer seen(std::span<const scene::Pixel> pixels, double growth = 0) const;

 private:
  const scene::Scene& asked_;
  scene::Scene taken_;
  const Candidate* rays_;
  NearestSpheres nearest_;
  std::vector<const Mistake*> pixels_;
};

/// The whole image that a program with this fault draws.
ImageAnswer predicted(const Fault& fault, const scene::Scene& scene);

}  // namespace raycheck::properties
