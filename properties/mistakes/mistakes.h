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

/// One classic mistake. With a change it answers a different question rightly; without one it is a
/// wrong formula.
struct Mistake {
  std::string sentence;  ///< "rows are upside down"
  Step step = Step::kFrame;
  ChangeCamera camera = {};
  ChangeConventions conventions = {};
  ChangePixel pixel = {};
  ChangeSphere sphere = {};
  /// Pixels that `pixel` puts outside the image are black; otherwise they have rays, too.
  bool black_outside = false;
  /// Makes the mistake and is otherwise right: direct/cross, in doubles. It has the functions
  /// `frame` to `nearest`. A camera that the change makes invalid throws std::invalid_argument.
  Candidate candidate = {};
  /// Whether it makes rays by its own formula.
  bool makes_rays = false;
  /// Its own formulas for hits and the nearest sphere; empty where it follows correct methods.
  HitFormulas hits = {};
  /// Mistakes of one family differ in a size, and each does all that the one before it does: of
  /// several that explain the same answers the first is meant. Empty: it is alone.
  std::string_view family = {};
};

/// Every mistake; their sentences differ.
std::span<const Mistake> mistakes();

/// The mistake with this sentence, or null.
const Mistake* find_mistake(std::string_view sentence);

/// The scene as the mistake takes it; may be invalid. Domain: a scene with a camera.
scene::Scene mistaken(const Mistake& mistake, scene::Scene scene);

}  // namespace raycheck::properties
