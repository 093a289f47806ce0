#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/case.h"
#include "properties/laws/law.h"

namespace raycheck::properties {

/// Conventions that a candidate follows without declaring them, and under which it keeps a law that
/// it breaks; or under which roots count that its declared ones exclude.
struct RightUnder {
  std::string conventions;    ///< "root = nearest"
  std::uint64_t defects = 0;  ///< Under the conventions that it declares.
};

/// The fewest such conventions, one or two, under which no answer about these cases is a defect,
/// though the candidate gives the same answers when it is asked to follow them. Empty if no such
/// conventions exist, if there are no defects, and for renderers, which are not given conventions.
/// Domain: cases of the candidate's format (rounded_case).
std::optional<RightUnder> right_under(const Law& law, const std::vector<Case>& cases,
                                      const Candidate& candidate);

/// The defects that a law finds in some cases together; 0 where the candidate fails on one.
std::uint64_t count_defects(const Law& law, const std::vector<Case>& cases,
                            const Candidate& candidate);

}  // namespace raycheck::properties
