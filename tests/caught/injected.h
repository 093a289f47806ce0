#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "properties/candidate.h"
#include "tests/caught/exact_candidate.h"

namespace raycheck::caught {

/// An otherwise exact candidate, and what it is made of.
struct ExactParts {
  std::shared_ptr<Sights> sights = std::make_shared<Sights>();
  std::shared_ptr<Sights::Pixels> looked_at = std::make_shared<Sights::Pixels>();
  properties::Candidate candidate = exact_candidate(sights, looked_at);
};

/// A kind of error, as large as base^-k.
struct ErrorKind {
  std::string_view name;      ///< "s"
  std::string_view sentence;  ///< "s times 1 + 2^-k"
  /// The laws that might notice it.
  std::vector<std::string_view> laws;
  properties::Candidate (*inject)(const ExactParts& exact, double size);
  bool of_rays_made = false;  ///< Of the rays that are made of a camera, not of given ones.
  int base = 2;
  int smallest = 53;  ///< The largest k: no double differs by less.
};

std::span<const ErrorKind> error_kinds();

}  // namespace raycheck::caught
