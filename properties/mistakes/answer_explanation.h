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

/// The relative error up to which an answer counts as right, or as that of a mistake; the second
/// is tried if nothing is explained with the first, for code that computes in `float`s.
inline constexpr std::array<double, 2> kAnswerTolerances = {1e-6, 1e-4};

/// Why the answers at one step are wrong. There are several alternatives if they explain the same.
struct AnswerCause {
  Step step = Step::kFrame;
  std::vector<Explanation> alternatives;
  std::optional<Arithmetic> roundings = {};  ///< The formula, if its roundings are the cause.
  double tolerance = 0;                      ///< The one of kAnswerTolerances that found it.
};

/// The classic mistakes in a candidate's functions, at most one for each of three parts, which are
/// asked separately: the camera (the frame, the pixel points and the rays under the origin
/// convention); then, on right rays, the hits; then the nearest sphere, unless what explains the
/// hits explains it too. In each part the first step with wrong answers counts: the mistake named
/// explains at least kExplainedShare of them, and contradicts few of the answers there and at
/// earlier steps. The best is named; if several are equally good and later steps do not separate
/// them, all are, but only the first of a family. For hits and choices, roundings that allow every
/// wrong answer are named rather than a mistake that explains only some; if roundings may be the
/// cause but it is not clear which, nothing is named. Skipped are steps for which the candidate has
/// no function, unjudged tangents, cases outside its domain and those that it refuses or fails on.
/// An answer counts as right if `direct/cross`, or another method of fast/ that is as precise as
/// the candidate, gives the same under the conventions that the candidate declares. Domain: valid
/// scenes, pixels inside their images; otherwise throws std::invalid_argument.
std::vector<AnswerCause> answer_causes(std::span<const Case> cases, const Candidate& candidate);

/// The sentence of one explanation, or of several that explain the same answers.
std::string sentence_of(const std::vector<Explanation>& alternatives);
/// A sentence for each cause: that of its alternatives.
std::vector<Explanation> explanations(const std::vector<AnswerCause>& causes);

}  // namespace raycheck::properties
