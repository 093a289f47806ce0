#pragma once

#include "properties/candidate.h"
#include "properties/mistakes/altered_hits.h"
#include "tests/standard.h"

namespace raycheck::caught {

// The types of reports.
using namespace properties;
using namespace scene;

/// A report about rays and spheres from a library's issue tracker, and a mutant with the reported
/// fault.
struct KnownReport {
  std::string_view thread;  ///< "owner/name#number", or several that report the same.
  std::string_view said;
  std::string_view mutant;  ///< The name of its mutant.
  /// The reported formula; everything else of the mutant is right. Null: the mutant of this name in
  /// tests/mutants.
  properties::Hit (*hit)(const scene::Ray&, const scene::Sphere&,
                         const scene::Conventions&) = nullptr;
  /// The causes that the default run must name, in all broken laws together.
  std::vector<std::string> sentences = {};
  /// If no cause or a wrong cause is named: what is needed for the right one.
  std::string_view needed = {};
  bool is_found = true;
  scene::Precision precision = scene::Precision::kDouble;
  scene::ValidRoots valid = {};  ///< The roots that it declares to count.
};
std::span<const KnownReport> known_reports();

/// The result of `raycheck properties --candidate` for a mutant.
struct FoundReport {
  /// The first broken law, its source, and the number of its cases until then; empty if no law
  /// breaks.
  std::string law, source;
  std::int64_t cases = 0;
  std::vector<std::string> sentences;  ///< The causes in all laws, each once.
};
properties::Candidate candidate_of(const KnownReport& report);
FoundReport found(const properties::Candidate& candidate);

}  // namespace raycheck::caught
