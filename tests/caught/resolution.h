#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tests/caught/injected.h"

namespace raycheck::caught {

/// So many cases of a source, of kFewSeverities of its severities in turn, are to notice an error.
/// A case of given rays has one; of a camera it has several, with as many spheres each.
constexpr int resolution_cases(const properties::CaseSource& source) {
  return source.has_camera ? 300 : 10000;
}

/// How small an error a law notices on the cases of a source.
struct Resolution {
  const ErrorKind* kind;
  const properties::Law* law;
  /// base^-k is the smallest error noticed, and every larger one is; empty: not even 1.
  std::optional<int> noticed = {};
  std::map<int, int> by_severity = {};  ///< The same at each severity that noticed any.
};

/// The resolutions of the laws wanted (empty: all) on a source, for the kinds wanted.
std::vector<Resolution> resolutions(const properties::CaseSource& source, int cases,
                                    std::span<const ErrorKind* const> kinds,
                                    std::span<const properties::Law* const> laws = {});

}  // namespace raycheck::caught
