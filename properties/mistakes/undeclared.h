#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/case.h"
#include "properties/laws/law.h"

namespace raycheck::properties {

/// Conventions that a candidate follows without declaring them: under them it keeps a law that it
/// otherwise breaks.
struct RightUnder {
  std::string conventions;    ///< "root = nearest"
  std::uint64_t defects = 0;  ///< The defects under the conventions that it declares.
};

/// The fewest such conventions, one or two, under which no answer about these cases is a defect,
/// though the candidate gives the same answers when it is asked to follow them. Empty if no such
/// conventions exist, if there are no defects, and for renderers, which are not given conventions.
/// Domain: cases of the candidate's format (rounded_case).
std::optional<RightUnder> right_under(const Law& law, const std::vector<Case>& cases,
                                      const Candidate& candidate);

/// The defects that a law finds in these cases together; 0 if the candidate fails on one of them.
std::uint64_t count_defects(const Law& law, const std::vector<Case>& cases,
                            const Candidate& candidate);

}  // namespace raycheck::properties
