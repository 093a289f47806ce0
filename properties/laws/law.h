#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "properties/case.h"
#include "properties/quantity.h"
#include "properties/trial.h"
#include "properties/verdict.h"
#include "scene/conventions.h"
#include "scene/precision.h"

namespace raycheck::properties {

/// What a law needs from a scene and a candidate to be applied: any combination of these.
enum class Needs : unsigned {
  // Of a camera:
  kFrame = 1 << 0,
  kPixelPoints = 1 << 1,
  kMadeRays = 1 << 2,     ///< Rays that the candidate makes under the origin convention.
  kBothOrigins = 1 << 3,  ///< Rays from the pixel points and rays from the eye.
  kVisible = 1 << 4,      ///< The spheres seen; the image must not be too large for the candidate.
  kImage = 1 << 5,        ///< An image that is not too large for the candidate.
  kPlan = 1 << 6,
  // Of rays, whether made or given:
  kRays = 1 << 7,
  kIntersect = 1 << 8,
  kNearest = 1 << 9,
  // Of either:
  kSpheres = 1 << 10,
  kSeveralSpheres = 1 << 11,
  kRefusals = 1 << 12,
  // Of the values that a candidate returns for a hit:
  kParameters = 1 << 13,  ///< s, or a distance.
  kPoints = 1 << 14,      ///< Q
  kEither = 1 << 15,      ///< kParameters or kPoints.
  kAnyRay = 1 << 16       ///< Intersections of any rays, not only those of a camera's pixels.
};
constexpr Needs operator|(Needs a, Needs b) {
  return static_cast<Needs>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// Whether `needs` contains one of `some`.
constexpr bool needs_any(Needs needs, Needs some) {
  return (static_cast<unsigned>(needs) & static_cast<unsigned>(some)) != 0;
}

/// kOfCameras: only scenes with a camera meet these. kOfIntersections: only candidates that
/// intersect rays with spheres meet these.
inline constexpr Needs kOfCameras = Needs::kFrame | Needs::kPixelPoints | Needs::kMadeRays |
                                    Needs::kBothOrigins | Needs::kVisible | Needs::kImage |
                                    Needs::kPlan;
inline constexpr Needs kOfIntersections =
    Needs::kIntersect | Needs::kNearest | Needs::kVisible | Needs::kImage | Needs::kPlan;
/// The needs that only candidates with functions other than `image` meet.
inline constexpr Needs kOfFunctions = Needs::kFrame | Needs::kPixelPoints | Needs::kMadeRays |
                                      Needs::kBothOrigins | Needs::kVisible | Needs::kPlan |
                                      Needs::kRays | Needs::kIntersect | Needs::kNearest;

/// The first need that a trial does not meet, as a sentence; empty if it meets all.
std::string_view what_is_missing(Needs needs, const Trial& trial);
/// Whether the trial's scene meets all needs, regardless of the candidate.
bool scene_suits(Needs needs, const Trial& trial);

/// A case with a camera's rays as given rays, and the pixel of each.
struct GivenRays {
  Case the_case;
  std::vector<Pixel> pixels;
  std::int64_t width = 0;  ///< The width of the image.

  /// The place with its ray replaced by the ray's pixel.
  Place place(Place of_ray) const;
};

/// The case with given rays in place of its camera: the exact rays under these conventions,
/// correctly rounded to what a candidate accepts and then taken as exact. For candidates that
/// intersect rays but make none. Rays that round to non-finite ones are left out; empty if no ray
/// is left. Domain: a valid scene with a camera; otherwise throws std::invalid_argument.
std::optional<GivenRays> given_rays(const Case& the_case, const Conventions& conventions,
                                    InputFormat format = {});

/// The unit that a law judges: a scene, a ray, a ray with a sphere, or an image.
enum class Per { kScene, kRay, kPair, kImage };

/// One law: a function from a Trial (a case, a candidate and the truth) to a Verdict. The verdict
/// is that the law holds, that it does not apply to the scene or the candidate, or a list of
/// discrepancies. Callers use these members and never depend on the names of laws.
struct Law {
  std::string_view name;
  std::string_view sentence;
  Per per;
  Needs needs;
  Quantity quantity;  ///< The first quantity that it judges.
  /// Called only if `needs` are met. It may still leave the case out, with a reason.
  void (*judge)(Trial&, Verdict&) = nullptr;
  /// Whether it compares single answers with the truth, one quantity at a time, as `check` reports
  /// them. The other laws relate several answers to each other, an answer to the ray that the
  /// candidate made for it, or a plan to the spheres that it leaves out.
  bool judges_values = false;
  /// The stage that it judges; empty if it is about both.
  std::optional<Stage> stage = {};
  /// Whether it measures the stability of that stage, rather than something that follows from other
  /// laws.
  bool tells_stability = false;
};
/// Law::judges_values, and Law::tells_stability, in the arrays of laws.
inline constexpr bool kValues = true, kRelations = false, kStability = true;

/// Whether a law needs scenes with a camera.
constexpr bool is_about_cameras(const Law& law) { return needs_any(law.needs, kOfCameras); }
/// Whether a law is about intersections of rays and spheres.
constexpr bool is_about_intersections(const Law& law) {
  return needs_any(law.needs, kOfIntersections);
}
/// Whether a law compares each answer with the truth, and answers are only right or wrong.
constexpr bool judges_decisions(const Law& law) {
  return law.judges_values && is_decision(law.quantity);
}

/// Every law, in the order of reports.
std::span<const Law> laws();

/// The laws for which a condition holds, in the order of reports.
template <class Condition>
std::vector<const Law*> laws_that(const Condition& holds) {
  std::vector<const Law*> found;
  for (const Law& law : laws()) {
    if (holds(law)) found.push_back(&law);
  }
  return found;
}

/// The law with this name, or null.
const Law* find_law(std::string_view name);

/// The law's verdict. If its needs are not met, the case is left out, with the reason. If the
/// candidate refuses the case, which is valid, or fails in another way, that is a discrepancy. If
/// the trial has a search, a failed batch is asked again in halves: at most kMostFailuresSought
/// questions to blame become discrepancies, and the answers to the others are judged.
Verdict apply(const Law& law, Trial& trial);

/// A candidate's trial on a case. If the candidate intersects rays but does not make them, laws
/// about hits are judged on the camera's exact rays (given_rays), with places as pixels.
class Trials {
 public:
  Trials(const Case& the_case, const Candidate& candidate, const TrialOptions& options = {});
  Trials(const Trials&) = delete;
  Trials& operator=(const Trials&) = delete;

  Trial& on_case() { return on_case_; }
  /// The trial on which a law is judged.
  Trial& of(const Law& law);
  /// `earlier`: see Trial::set_earlier.
  Verdict apply(const Law& law, const Verdict* earlier = nullptr);
  /// Whether a law was judged on given rays.
  bool gave_rays() const { return on_given_.has_value(); }

 private:
  const Case& case_;
  TrialOptions options_;
  Trial on_case_;
  std::optional<GivenRays> given_;
  std::optional<Trial> on_given_;
};

}  // namespace raycheck::properties
