#ifndef RAYCHECK_TESTS_MUTANTS_CAREFUL_H_
#define RAYCHECK_TESTS_MUTANTS_CAREFUL_H_

#include <string>

#include "properties/candidate.h"

namespace raycheck::mutants {

/// By how much a careful candidate is off; not at all by default.
struct Fault {
  double s = 0;        ///< s times 1 + this
  double Q = 0;        ///< Q moved by this share of its distance from the world's origin
  double D = 0;        ///< directions turned by this
  double epsilon = 0;  ///< hits at less than this are dropped
  double band = 0;     ///< hit and miss exchanged where |b - r| < this r, b the impact parameter
};

/// What a careful student writes (tests/candidates/right.cpp), but for a fault; held to what anyone
/// else's code is held to.
properties::Candidate careful_candidate(std::string name, const Fault& fault = {});

}  // namespace raycheck::mutants

#endif  // RAYCHECK_TESTS_MUTANTS_CAREFUL_H_
