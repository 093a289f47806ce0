#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "properties/candidate.h"
#include "properties/mistakes/altered_hits.h"

namespace raycheck::properties {

/// The step at which a mistake is made. The answers at this step are the first that show it.
enum class Step { kFrame, kPixelPoint, kRay, kIntersect, kNearest };
inline constexpr std::size_t kStepCount = 5;

/// Changes a camera under its conventions; the result may be invalid.
using ChangeCamera = std::function<void(scene::Camera&, const scene::Conventions&)>;
/// Changes conventions.
using ChangeConventions = std::function<void(scene::Conventions&)>;
/// Another pixel than the given one; it may lie outside the image.
using ChangePixel = std::function<scene::Pixel(const scene::Camera&, const scene::Conventions&,
                                               const scene::Pixel&)>;
/// Changes a sphere.
using ChangeSphere = std::function<void(scene::Sphere&)>;
/// Another hit than the given right one.
using ChangeHit = std::function<HitAnswer(const scene::Ray&, const scene::Sphere&, HitAnswer)>;

/// The formulas from a camera to its rays; for an empty one the right formula is used.
struct CameraFormulas {
  std::function<FrameAnswer(const scene::Camera&)> frame = {};
  /// P from g = nW + alpha U + beta V
  std::function<scene::Point3(const scene::Camera&, const scene::Vector3&)> point = {};
  /// D from P and g
  std::function<scene::Vector3(const scene::Camera&, const scene::Point3&, const scene::Vector3&)>
      direction = {};
  bool starts_at_eye = false;  ///< Rays start at the eye under every origin convention.
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
  /// Whether pixels that `pixel` moves outside the image are black; if not, they have rays.
  bool black_outside = false;
  CameraFormulas rays = {};
  HitFormulas hits = {};
  ChangeHit hit = {};             ///< Pictures do not show this change.
  bool shows_in_pictures = true;  ///< Whether pictures distinguish it.
  /// Whether a candidate can make the mistake; null: every candidate can.
  bool (*is_offered)(const Candidate&) = nullptr;
  bool is_rounding = false;  ///< Rounds numbers to floats, which changes few answers by 1e-6.
  /// Mistakes of one family differ only in a size, and each changes all answers that the one before
  /// it changes. Of those that explain the same answers, the first is named. Empty: no family.
  std::string_view family = {};
  /// A candidate that makes the mistake and is otherwise direct/cross, in doubles. It has the
  /// functions `frame` to `nearest`, which throw std::invalid_argument for a camera that the change
  /// makes invalid.
  Candidate candidate = {};

  /// Whether the mistake is in the formulas of rays.
  bool makes_rays() const { return rays.frame || rays.point || rays.direction; }
};

/// Every mistake; their sentences differ.
std::span<const Mistake> mistakes();
/// Sorts mistakes as mistakes() does: they change their input in this order.
std::vector<const Mistake*> in_order(std::span<const Mistake* const> some);
/// A candidate that makes all these mistakes. Domain: can_be_together() (fault.h).
Candidate candidate_with(std::span<const Mistake* const> mistakes);
/// The mistake with this sentence, or null.
const Mistake* find_mistake(std::string_view sentence);

/// The scene as code with this mistake reads it; may be invalid.
scene::Scene mistaken(const Mistake& mistake, scene::Scene scene);

}  // namespace raycheck::properties
