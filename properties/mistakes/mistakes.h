#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "properties/candidate.h"
#include "properties/mistakes/altered_hits.h"

namespace raycheck::properties {

/// Where a mistake is made: the first answer that shows it.
enum class Step { kFrame, kPixelPoint, kRay, kIntersect, kNearest };
inline constexpr std::size_t kStepCount = 5;

/// Another camera than the one given, under its conventions; it may be no valid one.
using ChangeCamera = std::function<void(scene::Camera&, const scene::Conventions&)>;
/// Other conventions than those given.
using ChangeConventions = std::function<void(scene::Conventions&)>;
/// Another pixel than the one asked about; it may lie outside the image.
using ChangePixel = std::function<scene::Pixel(const scene::Camera&, const scene::Conventions&,
                                               const scene::Pixel&)>;
/// Another sphere than the one given.
using ChangeSphere = std::function<void(scene::Sphere&)>;

/// One classic mistake. With a change it is a right answer to that other question; without any it
/// is a wrong formula.
struct Mistake {
  std::string sentence;  ///< "rows are upside down"
  Step step = Step::kFrame;
  ChangeCamera camera = {};
  ChangeConventions conventions = {};
  ChangePixel pixel = {};
  ChangeSphere sphere = {};
  /// Pixels that `pixel` puts outside the image are black; otherwise they have rays, too.
  bool black_outside = false;
  /// It makes the mistake and is otherwise right: direct/cross, in doubles. It has the functions
  /// `frame` to `nearest`. A camera that the change makes invalid throws std::invalid_argument.
  Candidate candidate = {};
  /// Whether its rays come of a formula of its own.
  bool makes_rays = false;
  /// Its own formulas for what is hit and what is nearest; none where it answers as right methods.
  HitFormulas hits = {};
  /// Mistakes of one family differ in a size, and what one does the next does too, and more, or in
  /// what single rays do not show: of several that explain the same the first is meant. Empty: it is
  /// alone.
  std::string_view family = {};
};

/// Every mistake; their sentences differ.
std::span<const Mistake> mistakes();

/// The mistake of that sentence, or null.
const Mistake* find_mistake(std::string_view sentence);

/// The scene as the mistake takes it; it may be no valid one. Domain: a scene with a camera.
scene::Scene mistaken(const Mistake& mistake, scene::Scene scene);

}  // namespace raycheck::properties
