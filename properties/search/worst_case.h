#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "properties/cases/case_source.h"
#include "properties/search/stress.h"

namespace raycheck::properties {

/// The value that a search maximises: the error; the error divided by bound_growth(), the factor by
/// which the documented bound grows with the condition number; or the stability ratio rho.
enum class Climb { kError, kOverGrowth, kRatio };
inline constexpr std::array<std::string_view, 3> kClimbNames = {"error", "bound", "rho"};

struct SearchOptions {
  std::vector<ChosenSource> sources;  ///< The search starts from cases of each in turn.
  Quantity quantity = Quantity::kParameter;
  Climb climb = Climb::kError;
  int cases = 2000;  ///< Random cases; the search climbs from the worst few.
  int steps = 4000;  ///< Changes of one number that are tried, in all climbs together.
  std::uint64_t seed = 1;
};

/// The worst input found. It is shrunk as long as its verdict stays and the maximised value stays
/// at least half.
struct WorstCase {
  Case the_case;
  double error = 0;
  Stability stability;
  double height = 0;          ///< The maximised value of `the_case`.
  double height_random = 0;   ///< The maximised value of the worst random case.
  double height_climbed = 0;  ///< The maximised value before shrinking.
  Discrepancy shown;          ///< The place, the candidate's answer and the exact one.
  void serialize(auto& archive) {
    archive(the_case, error, stability.condition, stability.ratio, stability.outcome, height,
            height_random, height_climbed, shown);
  }
};

/// Searches for the input on which a stage's certified error is worst, in the candidate's stated
/// domain and format. It tries random cases and climbs from the worst of them by changing one
/// significand, exponent or sign at a time. Empty if nothing was measured. The same options give
/// the same result.
std::optional<WorstCase> find_worst_case(const Candidate& candidate, Stage stage,
                                         const SearchOptions& options,
                                         const RunControl& control = {});

/// The law that measures a quantity of a stage, or null.
const Law* law_of(Stage stage, Quantity quantity);

}  // namespace raycheck::properties
