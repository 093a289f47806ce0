#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/cases/case_source.h"
#include "scene/precision.h"

namespace raycheck::tools {

// Questions and answers, one per line, for programs between `raycheck generate` and `raycheck
// verify`: docs/candidates.md defines the format. A question is a ray and a sphere; its id,
// CASE:RAY:SPHERE, names the case, so that verify can make it again.

/// "SOURCE@SEVERITY:SEED"
std::string case_id(const properties::ChosenSource& source, std::uint64_t seed);

/// The case of a seed, rounded to a format; empty if the format cannot hold it.
std::optional<properties::Case> case_asked(const properties::ChosenSource& source,
                                           std::uint64_t seed, scene::Precision precision);

/// A ray and a sphere of a case.
struct AskedPair {
  std::string id;
  std::size_t ray, sphere;
};
/// Every ray of the case of that id with every sphere.
std::vector<AskedPair> questions_of(const properties::Case& asked, const std::string& id);

/// The questions of a case, a line each.
/// Domain: a source of given rays.
std::string question_lines(const properties::ChosenSource& source, std::uint64_t seed,
                           scene::Precision precision);

}  // namespace raycheck::tools
