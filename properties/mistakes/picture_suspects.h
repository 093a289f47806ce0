#pragma once

// The faults that explain wrong pictures. Internal to picture_causes.

#include <vector>

#include "properties/mistakes/picture_causes.h"
#include "properties/mistakes/picture_evidence.h"

namespace raycheck::properties {

using Pictures = std::vector<Evidence>;

/// A fault that is not refuted, and how many pixels it does not explain.
struct Suspect {
  Fault fault;
  std::uint64_t left = 0;
};

/// What explains pictures with errors, the best first, as picture_causes() has it; those with most
/// errors come first. If all pictures are right except for excuses: what makes exactly these.
std::vector<Suspect> find_suspects(const Pictures& pictures);

}  // namespace raycheck::properties
