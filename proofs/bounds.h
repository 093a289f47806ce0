#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "proofs/term.h"

namespace raycheck::proofs {

/// An error bound on which a decision or a stage of a method relies, proved for the code's formula.
struct Bound {
  std::string_view name;   ///< Its script is proofs/NAME.gappa.
  std::string_view what;   ///< The value whose error is bounded, and the scale of the error.
  std::string_view where;  ///< The formula's file.
  double value;            ///< In `unit`.
  std::string_view unit;
  /// The script that proves `bound`, in `unit`, for the formula or a mutation of it.
  Script (*script)(double bound, std::optional<Mutation> mutation);
  /// The largest error for `samples` inputs, random or found by hill climbing, in `unit`.
  double (*observed)(int samples);
};

std::span<const Bound> bounds();

}  // namespace raycheck::proofs
