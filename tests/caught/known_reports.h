#pragma once

#include "properties/candidate.h"
#include "properties/mistakes/altered_hits.h"
#include "tests/standard.h"

namespace raycheck::caught {

// What they are made of.
using namespace properties;
using namespace scene;

/// A report about rays and spheres from the tracker of a library, and its mutant.
struct KnownReport {
  std::string_view thread;  ///< "owner/name#number"; more: that say the same.
  std::string_view said;
  std::string_view mutant;  ///< Its name.
  /// The reported formula in our words, else right.
  properties::Hit (*hit)(const scene::Ray&, const scene::Sphere&, const scene::Conventions&);
  /// What the default run is to name: each sentence that any broken law does.
  std::vector<std::string> sentences = {};
  /// Where nothing, or not the truth, is said: what would say it.
  std::string_view needed = {};
  bool is_found = true;
  scene::Precision precision = scene::Precision::kDouble;
};
std::span<const KnownReport> known_reports();

/// What `raycheck properties --candidate` says of a mutant.
struct FoundReport {
  /// The first law that breaks, at which source, and after how many of its cases; empty: none.
  std::string law, source;
  std::int64_t cases = 0;
  std::vector<std::string> sentences;  ///< Of any law, each once.
};
properties::Candidate candidate_of(const KnownReport& report);
FoundReport found(const properties::Candidate& candidate);

}  // namespace raycheck::caught
