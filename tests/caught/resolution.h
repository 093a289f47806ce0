#pragma once

#include "properties/candidate.h"
#include "properties/cases/case_source.h"
#include "properties/laws/law.h"
#include "tests/caught/exact_candidate.h"
#include "tests/standard.h"

namespace raycheck::caught {

/// An otherwise exact candidate, and its parts.
struct ExactParts {
  std::shared_ptr<Sights> sights = std::make_shared<Sights>();
  std::shared_ptr<Sights::Pixels> looked_at = std::make_shared<Sights::Pixels>();
  properties::Candidate candidate = exact_candidate(sights, looked_at);
};

/// A kind of error of the size base^-k.
struct ErrorKind {
  std::string_view name;      ///< "s"
  std::string_view sentence;  ///< "s times 1 + 2^-k"
  /// The laws that might notice it.
  std::vector<std::string_view> laws;
  properties::Candidate (*inject)(const ExactParts& exact, double size);
  /// Whether it is in rays made from a camera. If not, it is in answers about given rays.
  bool of_rays_made = false;
  int base = 2;
  int smallest = 53;  ///< The largest k; doubles cannot differ by less.
};

std::span<const ErrorKind> error_kinds();

/// The number of cases of a source in which an error may be noticed, with kFewSeverities of its
/// severities in turn. A case of given rays has one ray; a case of a camera has several rays, and
/// several spheres.
constexpr int resolution_cases(const properties::CaseSource& source) {
  return source.has_camera ? 300 : 10000;
}

/// The smallest error that a law notices on the cases of a source.
struct Resolution {
  const ErrorKind* kind;
  const properties::Law* law;
  /// base^-k is the smallest error that is noticed together with all larger errors; empty if not
  /// even 1 is.
  std::optional<int> noticed = {};
  /// The same k at each severity at which an error is noticed.
  std::map<int, int> by_severity = {};
};

/// The resolutions on a source, for the laws and kinds of errors that are wanted; an empty list
/// means all.
std::vector<Resolution> resolutions(const properties::CaseSource& source, int cases,
                                    std::span<const ErrorKind* const> kinds,
                                    std::span<const properties::Law* const> laws = {});

}  // namespace raycheck::caught
