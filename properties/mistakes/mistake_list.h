#pragma once

// The lists of mistakes by subject, each defined in the file of its name. Mistake::candidate is
// still empty. Internal to properties/.

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "properties/mistakes/mistakes.h"

namespace raycheck::properties {

/// direct/cross
Candidate right_candidate();
/// The other methods of fast/ that are at least as precise as a candidate.
std::vector<Candidate> other_right_candidates(const Candidate& candidate);

template <class Triple>
Vector3 vector(const Triple& v) {
  return {v.x, v.y, v.z};
}
template <class Triple>
double norm(const Triple& v) {
  return std::hypot(v.x, v.y, v.z);
}
template <class A, class B>
Vector3 cross(const A& a, const B& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vector3 normalised(const Vector3& v);

/// For Mistake::is_offered.
inline bool returns_points(const Candidate& candidate) {
  return gives_point(candidate.interface.returns);
}

/// A mistake whose answers are right for another camera.
inline Mistake camera_mistake(std::string sentence, ChangeCamera change,
                              Step step = Step::kPixelPoint) {
  return {.sentence = std::move(sentence), .step = step, .camera = std::move(change)};
}

/// Concatenates lists.
inline std::vector<Mistake> all_of(std::initializer_list<std::vector<Mistake>> lists) {
  std::vector<Mistake> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

std::vector<Mistake> input_mistakes();
std::vector<Mistake> number_mistakes();
/// Mistakes in the pixels' positions between the bounds. They are made from the mistakes in bounds,
/// and follow these in mistakes().
std::vector<Mistake> step_mistakes();
std::vector<Mistake> camera_mistakes();
std::vector<Mistake> intersect_mistakes();
std::vector<Mistake> threshold_mistakes();

}  // namespace raycheck::properties
