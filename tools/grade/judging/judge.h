#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "properties/run_control.h"
#include "tools/external/external_candidate.h"
#include "tools/grade/results/result.h"
#include "tools/grade/rubric/rubric.h"

namespace raycheck::tools {

/// What is known of the form of a renderer's driver files.
enum class FormKnown {
  kGiven,  ///< It is the one that the rubric asks for: to read another is a mistake.
  kFound,  ///< Of several it is the one in which a picture shows the scene.
  kNot     ///< None was found that is read.
};

/// Who is judged.
struct JudgedSubmission {
  properties::Candidate candidate;
  bool pictures = false;  ///< It is asked for pictures, otherwise for functions.
  FormKnown form_known = FormKnown::kGiven;
  scene::Dialect dialect = scene::Dialect::kB;  ///< Of its driver files.
  LastFailure last_failure = nullptr;           ///< Set where the candidate fails.
  /// Of its processes; null: its time is not limited.
  std::shared_ptr<const SpentTime> spent = nullptr;
};

/// Asks a candidate what the items of a rubric ask, and judges all answers together: a mistake
/// costs the points of one item, whatever else fails by it. The cases follow from the seed; what
/// the candidate declares yields to the rubric's conventions. A case holds where the laws hold and
/// the candidate answers all that raycheck's own methods answer.
std::vector<ItemGrade> judge(const Rubric& rubric, JudgedSubmission judged, std::uint64_t seed,
                             const properties::RunControl& control);

/// The item's points for a share of its cases.
double score_of(const Item& item, std::uint64_t held, std::uint64_t cases);

}  // namespace raycheck::tools
