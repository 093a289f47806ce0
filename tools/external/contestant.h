#pragma once

#include <string>
#include <variant>
#include <vector>

#include "tools/external/locate.h"
#include "tools/methods/methods.h"

namespace raycheck::tools {

/// Who is judged: a pair of raycheck's methods, or someone else's implementation.
using Contestant = std::variant<MethodPair, External>;

/// A candidate of its own for each call, for one thread.
properties::Candidate candidate_of(const Contestant& contestant);

/// Null where it is someone else's.
const MethodPair* methods_of(const Contestant& contestant);
const External* external_of(const Contestant& contestant);

/// What each is called from run to run, wherever it lies: as it says itself, or else by its words,
/// of files their names; as it was asked for, where others of these are called the same.
std::vector<std::string> lasting_names(const std::vector<Contestant>& contestants);

std::vector<Contestant> contestants(const std::vector<MethodPair>& pairs);

}  // namespace raycheck::tools
