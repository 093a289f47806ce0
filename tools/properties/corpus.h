#pragma once

// A folder of cases that once broke a law. Each is a scene whose comments name the law, the
// candidate, and how to replay the case from which it was shrunk. Internal to `properties`.

#include <span>
#include <string>
#include <vector>

#include "tools/properties/properties.h"

namespace raycheck::tools {

/// Judges every candidate on every case of the folder, in the order of the file names, by the
/// case's law if that is selected. Shape: a candidate for each implementation, in their order.
/// Errors: std::invalid_argument naming the file.
std::vector<CorpusFinding> try_corpus(const PropertiesOptions& options,
                                      std::span<const properties::Law* const> laws,
                                      std::span<const Implementation> implementations,
                                      std::span<const properties::Candidate> candidates);

/// Adds shrunk cases that break a law to the folder, which is made if missing. Other files stay.
/// Errors: std::invalid_argument, std::runtime_error.
void keep_in_corpus(const PropertiesReport& report, const std::string& folder);

}  // namespace raycheck::tools
