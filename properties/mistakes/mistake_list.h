#pragma once

// The mistakes by subject, each list in the file of that name, without their candidates. Internal
// to properties/.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "properties/mistakes/mistakes.h"

namespace raycheck::properties {

/// direct/cross
Candidate right_candidate();

template <class Triple>
scene::Vector3 vector(const Triple& v) {
  return {v.x, v.y, v.z};
}
template <class Triple>
double norm(const Triple& v) {
  return std::hypot(v.x, v.y, v.z);
}
scene::Vector3 normalised(const scene::Vector3& v);

/// The right answers for another camera.
inline Mistake camera_mistake(std::string sentence, ChangeCamera change,
                              Step step = Step::kPixelPoint) {
  return {.sentence = std::move(sentence), .step = step, .camera = std::move(change)};
}

std::vector<Mistake> input_mistakes();
std::vector<Mistake> number_mistakes();
std::vector<Mistake> camera_mistakes();
std::vector<Mistake> intersect_mistakes();
std::vector<Mistake> threshold_mistakes();

}  // namespace raycheck::properties
