#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "proofs/term.h"

namespace raycheck::proofs {

/// An error bound that a decision or a stage of a method relies on, proved for the code's formula.
struct Bound {
  std::string_view name;   ///< Its script is proofs/NAME.gappa.
  std::string_view what;   ///< The value whose error is bounded, and what it is relative to.
  std::string_view where;  ///< The formula's file.
  double value;            ///< In `unit`.
  std::string_view unit;
  /// The script that proves `bound`, in `unit`, for the formula, or for a mutation of it.
  Script (*script)(double bound, std::optional<Mutation> mutation);
  /// The largest error of `samples` inputs, random or found by hill climbing, in `unit`.
  double (*observed)(int samples);
};

std::span<const Bound> bounds();

}  // namespace raycheck::proofs
