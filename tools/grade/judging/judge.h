#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "properties/run_control.h"
#include "tools/external/external_candidate.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// How raycheck knows a renderer's form of driver files.
enum class FormKnown {
  kGiven,  ///< The rubric requires it; reading another form is a mistake.
  kFound,  ///< It was found by trial: the picture shows the scene.
  kNot     ///< It is unknown: no form was found that the renderer reads.
};

/// A submission ready to be judged.
struct JudgedSubmission {
  properties::Candidate candidate;
  bool pictures = false;  ///< Whether it is judged by pictures. If not, by functions.
  FormKnown form_known = FormKnown::kGiven;
  const scene::FileFormat* format = nullptr;  ///< Of its scene files; never null.
  LastFailure last_failure = nullptr;         ///< Set whenever the candidate fails.
  /// Whether an instructor declares for it, by an adapter or in the rubric: then its roots and
  /// lengths count, too.
  bool is_declared = false;
  /// The time of its processes; null if it is unlimited.
  std::shared_ptr<const SpentTime> spent = nullptr;
};

/// Asks a candidate all items of a rubric and judges the answers together. A mistake costs the
/// points of only one item, even if other items fail because of it. The cases follow from the seed.
/// The rubric's conventions override those that the candidate declares. A case holds if the laws
/// hold and the candidate answers everything that raycheck's own methods answer.
std::vector<ItemGrade> judge(const Rubric& rubric, JudgedSubmission judged, std::uint64_t seed,
                             const properties::RunControl& control);

}  // namespace raycheck::tools
