#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/case.h"
#include "properties/laws/law.h"

namespace raycheck::properties {

/// Conventions that a candidate follows without declaring them, or valid roots other than those
/// that it declares. Under these it keeps a law that it breaks.
struct RightUnder {
  std::string conventions;    ///< "root = nearest"
  std::uint64_t defects = 0;  ///< The number of defects under the conventions that it declares.
};

/// The smallest such set of conventions, one or two, under which no answer about these cases is a
/// defect. The candidate must give the same answers when it is asked to follow them. Empty if there
/// is no such set, if there are no defects, and for renderers, which do not get conventions.
/// Domain: cases of the candidate's format (rounded_case).
std::optional<RightUnder> right_under(const Law& law, const std::vector<Case>& cases,
                                      const Candidate& candidate);

/// The number of defects that a law finds in these cases; 0 if the candidate fails on one of them.
std::uint64_t count_defects(const Law& law, const std::vector<Case>& cases,
                            const Candidate& candidate);

}  // namespace raycheck::properties
