#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "properties/given_rays.h"
#include "properties/laws/needs.h"
#include "properties/quantity.h"
#include "properties/stage.h"
#include "properties/trial.h"
#include "properties/verdict.h"

namespace raycheck::properties {

/// What a law judges one by one: a scene, a ray, a ray with a sphere, or an image.
enum class Per { kScene, kRay, kPair, kImage };

/// One law: a function from (case, candidate, truth), bundled as a Trial, to a verdict: it holds,
/// it does not apply to the scene or the candidate, or there are discrepancies. Callers find all
/// they need to know about a law here: none knows a law by its name.
struct Law {
  std::string_view name;
  std::string_view sentence;
  Per per;
  Needs needs;
  Quantity quantity;  ///< The first that it judges.
  /// It compares single answers with the truth, one quantity at a time, as `check` reports them;
  /// the others relate several answers to each other, an answer to the ray that its own candidate
  /// made, or a plan to what it leaves out.
  bool judges_values = false;
  /// The stage that it judges, if it is about only one.
  std::optional<Stage> stage = {};
  /// Whether it tells if that stage is stable (rather than what follows from other laws).
  bool tells_stability = false;
  /// Called only where its needs are met. It may still leave the case out, with a reason.
  void (*judge)(Trial&, Verdict&) = nullptr;
};

/// Whether a law is about cameras, so that it needs scenes with one.
constexpr bool speaks_of_cameras(const Law& law) { return needs_any(law.needs, kOfCameras); }
/// Whether it is about intersections of rays and spheres.
constexpr bool speaks_of_intersections(const Law& law) {
  return needs_any(law.needs, kOfIntersections);
}
/// Whether its answers are simply right or wrong, each compared with the truth.
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

/// The law of that name, or null.
const Law* find_law(std::string_view name);

/// The law's verdict, left out with the reason where its needs are not met. A candidate that
/// refuses the case, which is valid, or fails in another way, is a discrepancy. If the trial has a
/// search, a failed batch is asked again in halves: the questions to blame are discrepancies, at
/// most kMostFailuresSought of them, and the answers to the others are judged.
Verdict apply(const Law& law, Trial& trial);

/// A candidate's trial on a case. Laws about rays that it meets with spheres and does not make are
/// asked on the camera's exact rays, given to it (given_rays.h), and say so of the pixels.
class Trials {
 public:
  Trials(const Case& the_case, const Candidate& candidate, const TrialOptions& options = {});
  Trials(const Trials&) = delete;
  Trials& operator=(const Trials&) = delete;

  Trial& on_case() { return on_case_; }
  /// The one on which a law is asked.
  Trial& of(const Law& law);
  Verdict apply(const Law& law);
  /// Whether a law was asked on given rays.
  bool gave_rays() const { return on_given_.has_value(); }

 private:
  const Case& case_;
  TrialOptions options_;
  Trial on_case_;
  std::optional<GivenRays> given_;
  std::optional<Trial> on_given_;
};

}  // namespace raycheck::properties
