#pragma once

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/discrepancy.h"
#include "properties/laws/law.h"
#include "scene/geometry.h"

namespace raycheck::properties {

/// Whether one answer is proved to be a defect of this kind in every case of a box: with all
/// roundings, the candidate's formula can have only one hit class there (Functions::classes_in),
/// which is not the exact one, nor that of any inputs within its excused change. False without a
/// proof, which exists only for wrong hit classes on given rays if every root >= 0 counts. Domain:
/// cases that differ in one number of one sign; both ends break the law. Source:
/// fast/internal/between.h; reference/interval_ray.h.
bool is_certain(const Law& law, const Candidate& candidate, const scene::Box<Case>& cases,
                DefectKind kind);

}  // namespace raycheck::properties
