#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/mistakes/explanation.h"
#include "properties/mistakes/imprecision.h"
#include "properties/mistakes/mistakes.h"

namespace raycheck::properties {

/// An answer counts as right, or as the answer of a mistake, up to this relative error. The second,
/// for code that computes in `float`s, is tried if the first explains nothing.
inline constexpr std::array<double, 2> kAnswerTolerances = {1e-6, 1e-4};

/// Why the answers at one step are wrong. If several mistakes explain the same answers, all are
/// alternatives.
struct AnswerCause {
  Step step = Step::kFrame;
  std::vector<Explanation> alternatives;
  std::optional<Arithmetic> roundings = {};  ///< The formula whose roundings are the cause, if so.
  double tolerance = 0;                      ///< The one of kAnswerTolerances that found it.
};

/// The classic mistakes in a candidate's functions. Three parts are searched separately, and each
/// has at most one cause: the camera (the frame, the pixel points and the rays under the origin
/// convention); the hits, on right rays; the nearest sphere, unless the cause of the wrong hits
/// also explains it. In each part, the first step with wrong answers counts. A mistake must explain
/// at least kExplainedShare of these, and contradict few of the answers at this step and at earlier
/// steps. The best mistake is named. If several are equally good and later steps do not separate
/// them, all are named, but only the first of a group. For hits and choices, roundings that allow
/// every wrong answer are named rather than a mistake that explains only some of them; if roundings
/// may be the cause but it is not clear which, nothing is named. Steps for which the candidate has
/// no function, unjudged tangents, cases outside its domain, and cases on which it refuses or fails
/// are skipped. An answer counts as right if `direct/cross`, or another method of fast/ that is as
/// precise as the candidate, gives the same answer under the conventions that the candidate
/// declares. Domain: valid scenes, pixels inside their images; otherwise throws
/// std::invalid_argument.
std::vector<AnswerCause> answer_causes(std::span<const Case> cases, const Candidate& candidate);

/// The sentence of one explanation, or of several alternatives.
std::string sentence_of(const std::vector<Explanation>& alternatives);
/// One explanation for each cause: all its alternatives in one sentence.
std::vector<Explanation> explanations(const std::vector<AnswerCause>& causes);

}  // namespace raycheck::properties
