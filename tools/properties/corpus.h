#pragma once

// A folder of cases that once broke a law: scenes, whose comments say which law, with whom, and how
// to replay the case that each was shrunk from. Internal to `properties`.

#include <span>
#include <string>
#include <vector>

#include "tools/properties/properties.h"

namespace raycheck::tools {

/// Judges every case of the folder, in the order of the files' names, by its law, if that is among
/// these, on every candidate. Shape: a candidate for each implementation, in their order.
/// Errors: std::invalid_argument naming the file.
std::vector<CorpusFinding> try_corpus(const PropertiesOptions& options,
                                      std::span<const properties::Law* const> laws,
                                      std::span<const Implementation> implementations,
                                      std::span<const properties::Candidate> candidates);

/// Adds what breaks a law, shrunk, to the folder, which is made if missing; what is there stays.
/// Errors: std::invalid_argument, std::runtime_error.
void keep_in_corpus(const PropertiesReport& report, const std::string& folder);

}  // namespace raycheck::tools
