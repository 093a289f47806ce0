#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "properties/run_control.h"
#include "tools/external/external_candidate.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// How a renderer's form of driver files is known.
enum class FormKnown {
  kGiven,  ///< The rubric requires it: reading another one is a mistake.
  kFound,  ///< By trial: the picture shows the scene.
  kNot     ///< Unknown: no form was found that it reads.
};

/// A submission ready to be judged.
struct JudgedSubmission {
  properties::Candidate candidate;
  bool pictures = false;  ///< It is judged by pictures, not by functions.
  FormKnown form_known = FormKnown::kGiven;
  scene::Dialect dialect = scene::Dialect::kB;  ///< Of its driver files.
  LastFailure last_failure = nullptr;           ///< Set when the candidate fails.
  /// Its processes' time; null: unlimited.
  std::shared_ptr<const SpentTime> spent = nullptr;
};

/// Asks a candidate all items of a rubric and judges the answers together: a mistake costs the
/// points of one item, even if other items fail by it, too. The cases follow from the seed; the
/// rubric's conventions override those that the candidate declares. A case holds if the laws hold
/// and the candidate answers everything that raycheck's own methods answer.
std::vector<ItemGrade> judge(const Rubric& rubric, JudgedSubmission judged, std::uint64_t seed,
                             const properties::RunControl& control);

}  // namespace raycheck::tools
