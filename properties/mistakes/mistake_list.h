#pragma once

// The mistakes by subject, each list in the file of that name, and the candidate that they are made
// from. Internal to properties/.

#include <string>
#include <vector>

#include "properties/mistakes/mistakes.h"

namespace raycheck::properties {

/// direct/cross
Candidate right_candidate();

/// A mistake in the formulas for hits.
Mistake hit_mistake(std::string sentence, const HitFormulas& formulas);
/// The same for a candidate that makes rays.
void find_hits_by(Mistake& mistake, const HitFormulas& formulas);

std::vector<Mistake> input_mistakes();
std::vector<Mistake> number_mistakes();
std::vector<Mistake> camera_mistakes();
std::vector<Mistake> intersect_mistakes();
std::vector<Mistake> threshold_mistakes();

}  // namespace raycheck::properties
