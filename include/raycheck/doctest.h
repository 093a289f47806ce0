#ifndef RAYCHECK_DOCTEST_H_
#define RAYCHECK_DOCTEST_H_

// Makes a doctest test of raycheck's laws, with a subcase for each law and source of cases:
//
//     #define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
//     #include <raycheck/doctest.h>
//     RAYCHECK_TESTS("tracer", my_candidate());
//
// The test is "tracer"; its subcases are class/distance and so on. doctest 2.4; C++17; link
// raycheck::doctest.

#include <doctest/doctest.h>
#include <raycheck/law_tests.h>

/// Defines a test with this name, which judges a raycheck::Candidate.
#define RAYCHECK_TESTS(name, candidate)                                                     \
  TEST_CASE(name) {                                                                         \
    static const ::raycheck::LawTests raycheck_tests(candidate);                            \
    for (const ::raycheck::Check& raycheck_check : raycheck_tests.checks()) {               \
      SUBCASE((raycheck_check.law + "/" + raycheck_check.source).c_str()) {                 \
        const ::raycheck::LawOutcome raycheck_outcome = raycheck_tests.run(raycheck_check); \
        INFO(raycheck_outcome.text);                                                        \
        CHECK(raycheck_outcome.passes);                                                     \
      }                                                                                     \
    }                                                                                       \
  }                                                                                         \
  static_assert(true, "a semicolon follows")

#endif  // RAYCHECK_DOCTEST_H_
