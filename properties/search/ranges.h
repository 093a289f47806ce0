#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "properties/candidate.h"
#include "properties/case.h"
#include "properties/laws/law.h"

namespace raycheck::properties {

/// Every number of a format from `least` to `greatest`.
struct Span {
  double least = 0;
  double greatest = 0;
  bool operator==(const Span&) const = default;
};

/// The range of one number of a case, with the others fixed, in which a law breaks in the same way.
struct NumberRange {
  std::string name;  ///< By the names of scene files: "sphere 0 radius", "camera eye x".
  double value = 0;  ///< In the case.
  /// The law breaks at both ends, and at all of `samples` numbers tried in it, including up to
  /// kPointsBetween on each side of the value. The range may contain numbers that are invalid, or
  /// outside the candidate's domain, where nothing is judged.
  Span span;
  int samples = 0;
  bool is_any = false;  ///< No valid and judged number of the format is known at which it holds.
  /// The part of it where the law is proved to break at every number: by certificates of boxes
  /// (properties/laws/certificate.h) and, between those, by trying each; empty without one.
  std::optional<Span> certified = {};

  bool is_exact() const { return span.least == span.greatest; }
};

struct Ranges {
  std::vector<NumberRange> numbers;
  int questions = 0;          ///< Cases that the candidate answered.
  std::size_t not_tried = 0;  ///< Numbers for which the budget of questions was used up.
};

/// Tried once an end is found: half of them spread evenly, half evenly in exponent.
inline constexpr int kPointsBetween = 32;
/// For all numbers together.
inline constexpr int kMostQuestions = 1 << 13;
/// Boxes tried for a certificate on each side of a number's value.
inline constexpr int kMostBoxes = 1 << 10;

/// Whether ranges are sought: not for pictures, for each of which a renderer may take a second, nor
/// where the candidate died or was stopped, which may take as long each time.
bool has_ranges(const Candidate& candidate, const Verdict& verdict);

/// The ranges of a case's numbers: outward from each by steps that double in the numbers of the
/// candidate's format, then by bisection to the last of them, cut where one between does not break
/// the law as the case does (its worst discrepancy's quantity and kind). Directions that must be
/// unit are left out. The same case gives the same ranges. An interrupt (scene::poll) ends the
/// search early.
/// Domain: a valid case in the candidate's format; one that breaks nothing has no ranges.
Ranges ranges_of(const Law& law, const Candidate& candidate, const Case& shrunk,
                 std::optional<double> max_error = {}, bool strict = false);

}  // namespace raycheck::properties
