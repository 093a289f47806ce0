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

/// The range of one number of a case, the other numbers fixed, in which a law breaks in the same
/// way.
struct NumberRange {
  std::string name;  ///< As in scene files: "sphere 0 radius", "camera eye x".
  double value = 0;  ///< Its value in the case.
  /// The law breaks at both ends, and at all `samples` numbers tried between them, up to
  /// kPointsBetween on each side of the value. The range may contain numbers that are invalid or
  /// outside the candidate's domain; these are not judged.
  Span span;
  int samples = 0;
  bool is_any = false;  ///< No number of the format was found at which the law is judged and holds.
  /// The part of the range where the law is proved to break at every number: by certificates of
  /// boxes (properties/laws/certificate.h) and, between these, by trying each number. Empty if
  /// there is none.
  std::optional<Span> certified = {};

  bool is_exact() const { return span.least == span.greatest; }
};

struct Ranges {
  std::vector<NumberRange> numbers;
  int questions = 0;          ///< Cases that the candidate answered.
  std::size_t not_tried = 0;  ///< Numbers not tried, because the budget of questions was used up.
};

/// Numbers tried between the value and an end that was found: half of them spread evenly, half
/// evenly in exponent.
inline constexpr int kPointsBetween = 32;
/// The budget of questions for all numbers together.
inline constexpr int kMostQuestions = 1 << 13;
/// At most this many boxes are tried for a certificate on each side of a number's value.
inline constexpr int kMostBoxes = 1 << 10;

/// Whether ranges are sought: not for pictures, since a renderer may take a second for each, and
/// not if the candidate died or was stopped, since that may take as long each time.
bool has_ranges(const Candidate& candidate, const Verdict& verdict);

/// The ranges of a case's numbers. The search goes outward from each number in doubling steps
/// through the numbers of the candidate's format, then bisects to the last one that breaks the law
/// as the case does: with the quantity and kind of its worst discrepancy. A number between that
/// does not break it so cuts the range. Directions that must be unit are left out. The same case
/// gives the same ranges. An interrupt (scene::poll) ends the search early.
/// Domain: a valid case in the candidate's format. A case that does not break the law has no
/// ranges.
Ranges ranges_of(const Law& law, const Candidate& candidate, const Case& shrunk,
                 std::optional<double> max_error = {}, bool strict = false);

}  // namespace raycheck::properties
