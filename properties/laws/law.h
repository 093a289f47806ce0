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
  kVisible = 1 << 4,      ///< visible(), for an image not too large for the candidate.
  kImage = 1 << 5,        ///< image(), for an image not too large for the candidate.
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
  kEither = 1 << 15       ///< s or Q
};
constexpr Needs operator|(Needs a, Needs b) {
  return static_cast<Needs>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// Whether `needs` has one of `some`.
constexpr bool needs_any(Needs needs, Needs some) {
  return (static_cast<unsigned>(needs) & static_cast<unsigned>(some)) != 0;
}

/// The needs that only scenes with a camera meet; and those that only candidates meet that
/// intersect rays with spheres.
inline constexpr Needs kOfCameras = Needs::kFrame | Needs::kPixelPoints | Needs::kMadeRays |
                                    Needs::kBothOrigins | Needs::kVisible | Needs::kImage |
                                    Needs::kPlan;
inline constexpr Needs kOfIntersections =
    Needs::kIntersect | Needs::kNearest | Needs::kVisible | Needs::kImage | Needs::kPlan;
/// The needs that only candidates with functions other than `image` meet.
inline constexpr Needs kOfFunctions = Needs::kFrame | Needs::kPixelPoints | Needs::kMadeRays |
                                      Needs::kBothOrigins | Needs::kVisible | Needs::kPlan |
                                      Needs::kRays | Needs::kIntersect | Needs::kNearest;

/// The first need that a trial does not meet, as a sentence; empty when it meets all.
std::string_view what_is_missing(Needs needs, const Trial& trial);
/// Whether the scene of a trial meets all needs that are about scenes.
bool scene_suits(Needs needs, const Trial& trial);

/// A case with a camera's rays as given rays, and the pixel of each.
struct GivenRays {
  Case the_case;
  std::vector<scene::Pixel> pixels;
  std::int64_t width = 0;  ///< The width of the image.

  /// Replaces the ray in a place by its pixel.
  Place place(Place of_ray) const;
};

/// The case with given rays in place of its camera: the exact rays under these conventions,
/// correctly rounded to a format and then taken as exact. For candidates that intersect rays but
/// make none. Leaves out rays that are invalid once rounded; empty if no ray is left. Domain: a
/// valid scene with a camera; otherwise throws std::invalid_argument.
std::optional<GivenRays> given_rays(const Case& the_case, const scene::Conventions& conventions,
                                    scene::Precision precision = scene::Precision::kDouble);

/// The unit that a law judges: a scene, a ray, a ray with a sphere, or an image.
enum class Per { kScene, kRay, kPair, kImage };

/// One law: a function from (case, candidate, truth), bundled as a Trial, to a verdict: it holds,
/// it does not apply to the scene or the candidate, or there are discrepancies. All properties of
/// laws that callers use are here: callers do not depend on the names of laws.
struct Law {
  std::string_view name;
  std::string_view sentence;
  Per per;
  Needs needs;
  Quantity quantity;  ///< The first quantity that it judges.
  /// Whether it compares single answers with the truth, one quantity at a time, for `check`. The
  /// other laws compare several answers with each other, an answer with the ray that the candidate
  /// made for it, or a plan with the spheres that it leaves out.
  bool judges_values = false;
  /// The stage that it judges, if it judges only one.
  std::optional<Stage> stage = {};
  /// Whether it measures the stability of that stage (rather than what follows from other laws).
  bool tells_stability = false;
  /// Called only if its needs are met. It may leave the case out, with a reason.
  void (*judge)(Trial&, Verdict&) = nullptr;
};

/// Whether a law is about cameras, so that it needs scenes with one.
constexpr bool is_about_cameras(const Law& law) { return needs_any(law.needs, kOfCameras); }
/// Whether a law is about intersections of rays and spheres.
constexpr bool is_about_intersections(const Law& law) {
  return needs_any(law.needs, kOfIntersections);
}
/// Whether a law compares answers with the truth that are only right or wrong.
constexpr bool judges_decisions(const Law& law) {
  return law.judges_values && is_decision(law.quantity);
}

/// Every law, in the order of reports.
std::span<const Law> laws();

/// The laws for which a condition holds, in the same order.
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

/// The law's verdict; it is left out with the reason if its needs are not met. It is a discrepancy
/// if the candidate refuses the case, which is valid, or fails in another way. If the trial has a
/// search, a failed batch is asked again in halves: the questions to blame are discrepancies, at
/// most kMostFailuresSought of them, and the answers to the others are judged.
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
  Verdict apply(const Law& law);
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
