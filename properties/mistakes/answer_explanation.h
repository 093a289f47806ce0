#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/mistakes/explanation.h"
#include "properties/mistakes/imprecision.h"
#include "properties/mistakes/mistakes.h"

namespace raycheck::properties {

/// How far, relative to its size, an answer may be off and still be right, or be what a mistake
/// makes; the second where the first explains nothing, for what computes in `float`s.
inline constexpr std::array<double, 2> kAnswerTolerances = {1e-6, 1e-4};

/// Why the answers at one step are wrong: where several mistakes are named they explain the same.
struct AnswerCause {
  Step step = Step::kFrame;
  std::vector<Explanation> alternatives;
  std::optional<Arithmetic> roundings = {};  ///< Of what formula, where they are the cause.
};

/// The classic mistakes in a candidate's functions, at most one for each of three parts that are
/// asked apart: the camera (the frame, the pixel points and the rays under the origin convention);
/// then, on right rays, the hits; then the nearest sphere, where what explains the hits does not
/// explain it too. Of each part the first step that has wrong answers counts: named is what
/// explains at least kExplainedShare of these, and contradicts few of the answers there and at the
/// steps before; of several the best, all where they explain as many, and later steps do not tell
/// them apart, of one family the first. Of hits and choices, roundings that allow every wrong
/// answer are named instead of a mistake that explains but some; where these may be the cause, but
/// are not told, nothing is. A step that the candidate has no function for is passed over, and so
/// are tangents that are not judged, cases outside its domain and those that it refuses or fails
/// on. An answer counts as right where `direct/cross`, or another method of fast/ as precise as the
/// candidate, gives the same under the conventions that the candidate declares. Domain: valid
/// scenes, pixels inside their images; otherwise throws std::invalid_argument.
std::vector<AnswerCause> answer_causes(std::span<const Case> cases, const Candidate& candidate);

/// The alternatives of all causes.
std::vector<Explanation> explanations(const std::vector<AnswerCause>& causes);

}  // namespace raycheck::properties
