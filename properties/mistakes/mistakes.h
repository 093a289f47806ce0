#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "properties/candidate.h"
#include "properties/mistakes/altered_hits.h"

namespace raycheck::properties {

/// The step at which a mistake is made: the first answer that shows it.
enum class Step { kFrame, kPixelPoint, kRay, kIntersect, kNearest };
inline constexpr std::size_t kStepCount = 5;

/// Another camera than the one given, under its conventions; it may be invalid.
using ChangeCamera = std::function<void(scene::Camera&, const scene::Conventions&)>;
/// Other conventions than those given.
using ChangeConventions = std::function<void(scene::Conventions&)>;
/// Another pixel than the one asked about; it may lie outside the image.
using ChangePixel = std::function<scene::Pixel(const scene::Camera&, const scene::Conventions&,
                                               const scene::Pixel&)>;
/// Another sphere than the one given.
using ChangeSphere = std::function<void(scene::Sphere&)>;
/// Another hit than the right one.
using ChangeHit = std::function<HitAnswer(const scene::Ray&, const scene::Sphere&, HitAnswer)>;

/// The formulas from a camera to its rays; an empty one is the right one.
struct CameraFormulas {
  std::function<FrameAnswer(const scene::Camera&)> frame = {};
  /// P from g = nW + alpha U + beta V
  std::function<scene::Point3(const scene::Camera&, const scene::Vector3&)> point = {};
  /// D from P and g
  std::function<scene::Vector3(const scene::Camera&, const scene::Point3&, const scene::Vector3&)>
      direction = {};
  bool starts_at_eye = false;  ///< Whatever the origin convention says.
};

/// For Mistake::is_offered: the mistake explains only pictures.
inline bool never_of_functions(const Candidate&) { return false; }

/// One classic mistake: the right answer to another question, or wrong formulas.
struct Mistake {
  std::string sentence;  ///< "rows are upside down"
  Step step = Step::kFrame;
  ChangeCamera camera = {};
  ChangeConventions conventions = {};
  ChangePixel pixel = {};
  ChangeSphere sphere = {};
  /// Pixels that `pixel` puts outside the image are black; otherwise they have rays, too.
  bool black_outside = false;
  CameraFormulas rays = {};
  HitFormulas hits = {};
  ChangeHit hit = {};             ///< Pictures do not show it.
  bool shows_in_pictures = true;  ///< Whether pictures distinguish it.
  /// Whether a candidate can make the mistake; null: every candidate can.
  bool (*is_offered)(const Candidate&) = nullptr;
  bool is_rounding = false;  ///< Rounds numbers to floats, which few answers show up to 1e-6.
  /// Mistakes of one family differ in a size, and each changes all answers that the one before it
  /// changes: of several that explain the same answers the first is named. Empty: no family.
  std::string_view family = {};
  /// Makes the mistake and is otherwise right: direct/cross, in doubles. It has the functions
  /// `frame` to `nearest`. A camera that the change makes invalid throws std::invalid_argument.
  Candidate candidate = {};

  /// Whether it makes rays by its own formula.
  bool makes_rays() const { return rays.frame || rays.point || rays.direction; }
};

/// Every mistake; their sentences differ.
std::span<const Mistake> mistakes();
/// Mistakes in the order of mistakes(), in which they change their input.
std::vector<const Mistake*> in_order(std::span<const Mistake* const> some);
/// Makes several, which can be together (fault.h), as a mistake's candidate makes one.
Candidate candidate_with(std::span<const Mistake* const> mistakes);
/// The mistake with this sentence, or null.
const Mistake* find_mistake(std::string_view sentence);

/// The scene as the mistake takes it; may be invalid.
scene::Scene mistaken(const Mistake& mistake, scene::Scene scene);

}  // namespace raycheck::properties
