#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "proofs/term.h"

namespace raycheck::proofs {

/// A bound on which a decision stands, or a stage of a method, proved of the code's own formula.
struct Bound {
  std::string_view name;   ///< Also of its script, proofs/NAME.gappa.
  std::string_view what;   ///< What is bounded, as a share of what.
  std::string_view where;  ///< The formula's file.
  double value;            ///< In `unit`.
  std::string_view unit;
  /// What proves that `bound`, in `unit`, holds of the formula, or of it with a mutation.
  Script (*script)(double bound, std::optional<Mutation> mutation);
  /// The largest error of so many inputs, in `unit`, by enclosures: random, or climbed to.
  double (*observed)(int samples);
};

std::span<const Bound> bounds();

}  // namespace raycheck::proofs
