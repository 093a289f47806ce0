#ifndef RAYCHECK_FUZZ_H_
#define RAYCHECK_FUZZ_H_

// A fuzzer for a candidate: it makes a case from bytes, and judges the candidate by a law on it.
//
//     #include <raycheck/fuzz.h>
//     RAYCHECK_FUZZ(my_candidate(), "class")
//
// Compile this by clang and link it with raycheck::fuzz. The program stops at the first case that
// breaks the law, and prints this case. C++17. Without libFuzzer, link raycheck::raycheck and call
// LLVMFuzzerTestOneInput() yourself.

#include <raycheck/cases.h>
#include <raycheck/judge.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace raycheck {

/// Judges the case that the bytes make; if it breaks the law, prints the verdict and aborts.
inline void fuzz_one(const Candidate& candidate, const std::string& law, const std::uint8_t* bytes,
                     std::size_t count) {
  const auto the_case = case_of_bytes(bytes, count);
  if (!the_case) return;
  const Verdict verdict = judge_case(candidate, law, *the_case);
  if (verdict.finding != Finding::broken) return;
  std::fputs(verdict.text.c_str(), stderr);
  std::abort();
}

}  // namespace raycheck

/// Defines libFuzzer's entry point, which judges a raycheck::Candidate by a law.
#define RAYCHECK_FUZZ(candidate, law)                                                   \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) { \
    static const ::raycheck::Candidate raycheck_candidate = candidate;                  \
    ::raycheck::fuzz_one(raycheck_candidate, law, bytes, count);                        \
    return 0;                                                                           \
  }

#endif  // RAYCHECK_FUZZ_H_
