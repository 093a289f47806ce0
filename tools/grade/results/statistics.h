#pragma once

// What a graded class has in common.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/grade/results/result.h"

namespace raycheck::tools {

using Submissions = std::vector<const SubmissionGrade*>;

/// Those that could be judged, or those that could not, in the order of the class.
Submissions submissions_that(const ClassGrade& graded, bool are_judged);

/// The middle value, or the mean of the two in the middle; empty if there is none.
std::optional<double> median(std::vector<double> values);

/// How a class did on an item.
struct ItemStatistics {
  const Item* item = nullptr;
  std::size_t asked = 0;  ///< Of the submissions that could be judged.
  std::size_t failing = 0;
  std::size_t left_out = 0;  ///< Or not judged, as time was up.
};
/// In the order of the rubric. Domain: grades of `graded.rubric`, which outlives the result.
std::vector<ItemStatistics> item_statistics(const ClassGrade& graded);

/// A mistake, and who makes it.
struct MistakeStatistics {
  std::string sentence;
  Submissions students;  ///< Those with an item whose wrong answers it explains.
  /// The failing case that it explains with the fewest spheres, then pixels; null if there is none.
  const ItemGrade* smallest = nullptr;
  const SubmissionGrade* whose = nullptr;  ///< Whose smallest case it is; null likewise.
};
/// Most students first.
std::vector<MistakeStatistics> mistake_statistics(const ClassGrade& graded);

}  // namespace raycheck::tools
