#pragma once

#include <string>

#include "tools/properties/properties.h"

namespace raycheck::tools {

/// shown_name() if first_lines() says which candidate has this name, otherwise the candidate's name
/// on the command line.
std::string name_in_rows(const PropertiesReport& report, const std::string& candidate);

/// A line about each external candidate on which several laws were tried: what explains its wrong
/// answers, or the level up to which it is right; and what it answers where the verdict does not
/// depend on it.
std::string first_lines(const PropertiesReport& report);

}  // namespace raycheck::tools
