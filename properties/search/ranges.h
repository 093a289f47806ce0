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
  /// The law breaks at both ends, and at all `samples` numbers tried in the range, of which up to
  /// kPointsBetween lie on each side of the value. The range may contain numbers that are invalid
  /// or outside the candidate's domain, which are not judged.
  Span span;
  int samples = 0;
  bool is_any = false;  ///< No number of the format is known at which the law holds.
  /// The part of the range in which the law is proved to break at every number: by certificates of
  /// boxes (properties/laws/certificate.h) and, between the boxes, by trying each number.
  std::optional<Span> certified = {};

  bool is_exact() const { return span.least == span.greatest; }
};

struct Ranges {
  std::vector<NumberRange> numbers;
  int questions = 0;          ///< Cases that the candidate answered.
  std::size_t not_tried = 0;  ///< Numbers left when the budget of questions was used up.
};

/// The numbers tried once an end is found: half spread evenly, half evenly in exponent.
inline constexpr int kPointsBetween = 32;
/// The most cases that a candidate is asked about, for all numbers together.
inline constexpr int kMostQuestions = 1 << 13;
/// Boxes tried for a certificate on each side of a number's value.
inline constexpr int kMostBoxes = 1 << 10;

/// Whether ranges are sought: not for pictures, since a renderer may take a second for each, nor if
/// the candidate died or was stopped, which may take as long each time.
bool has_ranges(const Candidate& candidate, const Verdict& verdict);

/// The ranges of a case's numbers. The search for an end steps outward from the number, each step
/// over twice as many numbers of the candidate's format, then bisects. A range ends before a number
/// that is tried and does not break the law as the case does (by the quantity and kind of its worst
/// discrepancy). Directions that must be unit vectors are left out. The same case gives the same
/// ranges. An interrupt (scene::poll) ends the search early.
/// Domain: a valid case in the candidate's format; a case that does not break the law has no
/// ranges.
Ranges ranges_of(const Law& law, const Candidate& candidate, const Case& shrunk,
                 std::optional<double> max_error = {}, bool strict = false);

}  // namespace raycheck::properties
