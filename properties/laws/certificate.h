#pragma once

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/discrepancy.h"
#include "properties/laws/law.h"
#include "scene/geometry.h"

namespace raycheck::properties {

/// Whether an answer is proved to be a defect of this kind in every case of a box: the candidate's
/// formula, all rounding included (Functions::classes_in), can have only one hit class there; that
/// class is wrong, and no inputs within the excused change have it. False if there is no proof.
/// Proofs exist only for wrong hit classes on given rays, if every root >= 0 counts. Domain: cases
/// that differ in one number, which does not change sign; both ends break the law. Source:
/// fast/internal/between.h; reference/interval_ray.h.
bool is_certain(const Law& law, const Candidate& candidate, const scene::Box<Case>& cases,
                DefectKind kind);

}  // namespace raycheck::properties
