#ifndef RAYCHECK_PROPERTIES_MISTAKES_ANSWER_EXPLANATION_H_
#define RAYCHECK_PROPERTIES_MISTAKES_ANSWER_EXPLANATION_H_

#include <array>
#include <span>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/mistakes/explanation.h"

namespace raycheck::properties {

/// How far, relative to its size, an answer may be off and still be right, or be what a mistake
/// makes; the second where the first explains nothing, for what computes in `float`s.
inline constexpr std::array<double, 2> kAnswerTolerances = {1e-6, 1e-4};

/// The classic mistake in a candidate's functions: what explains at least kExplainedShare of the
/// wrong answers to the cases at the first step that has any, and contradicts few of the answers
/// there and at the steps before; of several the best, all where they explain as many. The steps
/// are the frame, the pixel points and the rays under the origin convention; then, on right rays,
/// the hits; then the nearest sphere. One that the candidate has no function for is passed over,
/// and so are tangents that are not judged, cases outside its domain and those that it refuses or
/// fails on. An answer counts as right where `direct/cross`, or another method of fast/ as precise
/// as the candidate, gives the same under the conventions that the candidate declares.
/// Domain: valid scenes, pixels inside their images; otherwise throws std::invalid_argument.
std::vector<Explanation> explanations(std::span<const Case> cases, const Candidate& candidate);

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_MISTAKES_ANSWER_EXPLANATION_H_
