#ifndef RAYCHECK_CATCH2_H_
#define RAYCHECK_CATCH2_H_

// Makes a Catch2 test of raycheck's laws, with a section for each law and source of cases:
//
//     #include <raycheck/catch2.h>
//     RAYCHECK_TESTS("tracer", my_candidate());
//
// The test is "tracer", tagged [raycheck]; its sections are class/distance and so on. Catch2 2 or
// 3; C++17; link raycheck::catch2.

#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#else
#include <catch2/catch.hpp>
#endif
#include <raycheck/law_tests.h>

/// Defines a test with this name, which judges a raycheck::Candidate.
#define RAYCHECK_TESTS(name, candidate)                                                     \
  TEST_CASE(name, "[raycheck]") {                                                           \
    static const ::raycheck::LawTests raycheck_tests(candidate);                            \
    for (const ::raycheck::Check& raycheck_check : raycheck_tests.checks()) {               \
      DYNAMIC_SECTION(raycheck_check.law << "/" << raycheck_check.source) {                 \
        const ::raycheck::LawOutcome raycheck_outcome = raycheck_tests.run(raycheck_check); \
        INFO(raycheck_outcome.text);                                                        \
        CHECK(raycheck_outcome.passes);                                                     \
      }                                                                                     \
    }                                                                                       \
  }                                                                                         \
  static_assert(true, "a semicolon follows")

#endif  // RAYCHECK_CATCH2_H_
