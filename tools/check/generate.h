#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "properties/cases/case_source.h"
#include "scene/precision.h"

namespace raycheck::tools {

// Questions and answers, one per line, for programs between `raycheck generate` and `raycheck
// verify`: docs/candidates.md defines the format. A question is a ray and a sphere; its id,
// CASE:RAY:SPHERE, names the case, so that verify can make it again.

/// "SOURCE@SEVERITY:SEED"
std::string case_id(const properties::ChosenSource& source, std::uint64_t seed);

/// The source of that name, "FAMILY" or "FAMILY@SEVERITY".
/// Errors: std::invalid_argument naming the family if there is no such family, or its cases have
/// cameras.
properties::ChosenSource source_of_questions(const std::string& family);

/// The case of a seed, rounded to a format; empty if the format cannot hold it.
std::optional<properties::Case> case_asked(const properties::ChosenSource& source,
                                           std::uint64_t seed, scene::Precision precision);

/// The questions of that case: every ray with every sphere.
/// Domain: a source of given rays.
std::string questions(const properties::ChosenSource& source, std::uint64_t seed,
                      scene::Precision precision);

}  // namespace raycheck::tools
