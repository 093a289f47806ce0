#ifndef RAYCHECK_PROPERTIES_LAWS_LAW_H_
#define RAYCHECK_PROPERTIES_LAWS_LAW_H_

#include <span>
#include <string_view>

#include "properties/trial.h"
#include "properties/verdict.h"

namespace raycheck::properties {

/// One law: a function from (case, candidate, truth), bundled as a Trial, to a verdict: it holds,
/// it is left out because the scene or the candidate has nothing that it speaks of, or there are
/// discrepancies.
struct Law {
  std::string_view name;
  std::string_view sentence;
  /// What it speaks of decides which cases are worth making for it.
  enum class Subject { kCamera, kIntersection, kCameraAndIntersection, kAny } subject;
  /// It compares single answers with the truth, one quantity at a time, as `check` reports them;
  /// the others relate several answers to each other, an answer to the ray that its own candidate
  /// made, or a plan to what it leaves out.
  bool judges_values;
  Verdict (*judge)(Trial&);
};

/// Every law, in the order of reports.
std::span<const Law> laws();

/// The law of that name, or null.
const Law* find_law(std::string_view name);

/// The law's verdict. A candidate that refuses the case, which is a problem, or fails in another
/// way, is a discrepancy.
Verdict apply(const Law& law, Trial& trial);

}  // namespace raycheck::properties

#endif  // RAYCHECK_PROPERTIES_LAWS_LAW_H_
