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

/// Changes the camera, under its conventions; the result may be invalid.
using ChangeCamera = std::function<void(Camera&, const Conventions&)>;
/// Changes the conventions.
using ChangeConventions = std::function<void(Conventions&)>;
/// Returns another pixel than the one asked about; it may lie outside the image.
using ChangePixel = std::function<Pixel(const Camera&, const Conventions&, const Pixel&)>;
/// Changes the sphere.
using ChangeSphere = std::function<void(Sphere&)>;
/// Returns another hit than the right one.
using ChangeHit = std::function<HitAnswer(const Ray&, const Sphere&, HitAnswer)>;

/// The formulas from a camera to its rays; an empty one stands for the right formula.
struct CameraFormulas {
  std::function<FrameAnswer(const Camera&)> frame = {};
  /// P from g = nW + alpha U + beta V
  std::function<Point3(const Camera&, const Vector3&)> point = {};
  /// D from P and g
  std::function<Vector3(const Camera&, const Point3&, const Vector3&)> direction = {};
  bool starts_at_eye = false;  ///< Even if the origin convention says otherwise.
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
  /// Whether pixels that `pixel` moves outside the image are black. If not, they have rays like the
  /// others.
  bool black_outside = false;
  CameraFormulas rays = {};
  HitFormulas hits = {};
  ChangeHit hit = {};             ///< Pictures do not show it.
  bool shows_in_pictures = true;  ///< Whether pictures may show the mistake.
  /// Whether a candidate can make the mistake. If null, every candidate can.
  bool (*is_offered)(const Candidate&) = nullptr;
  /// Rounds numbers to floats, which changes few answers by more than 1e-6.
  bool is_rounding = false;
  /// The name of the mistake's group; empty if it has none. Mistakes of one group differ only in a
  /// size, and each changes at least the answers that the one before it changes. If several of a
  /// group explain the same answers, only the first is named.
  std::string_view group = {};
  /// Makes the mistake; its other answers are those of direct/cross, in doubles. It has the
  /// functions `frame` to `nearest`. It throws std::invalid_argument if the change makes the camera
  /// invalid.
  Candidate candidate = {};

  /// Whether it replaces i/(w-1), or (i+1/2)/w, in alpha or beta. Two of these might cancel out.
  bool places_pixels = false;

  /// The name of its group; without a group its sentence.
  std::string_view name() const { return group.empty() ? std::string_view(sentence) : group; }
  /// Whether the mistake is in the formulas of rays.
  bool makes_rays() const { return rays.frame || rays.point || rays.direction; }
};

/// Every mistake; their sentences differ.
std::span<const Mistake> mistakes();
/// Sorts mistakes as in mistakes(), the order in which they are applied.
std::vector<const Mistake*> in_order(std::span<const Mistake* const> some);
/// A candidate that makes all these mistakes. Domain: mistakes of mistakes() that can be together
/// (fault.h).
Candidate candidate_with(std::span<const Mistake* const> mistakes);
/// The mistake with this sentence, or null.
const Mistake* find_mistake(std::string_view sentence);

/// The scene as code with this mistake reads it; it may be invalid.
Scene mistaken(const Mistake& mistake, Scene scene);

}  // namespace raycheck::properties
