#ifndef RAYCHECK_GTEST_H_
#define RAYCHECK_GTEST_H_

// Makes GoogleTest tests of raycheck's laws, one for each law and source of cases:
//
//     #include <raycheck/gtest.h>
//     RAYCHECK_TESTS(Tracer, my_candidate());
//
// The tests are Tracer.class/distance and so on: law/source, with _ for -, which means "not" in a
// filter.
// C++17; link raycheck::gtest.

#include <gtest/gtest.h>
#include <raycheck/law_tests.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace raycheck {

/// One law on one source. The test is skipped if too few of the source's cases could be judged.
class LawTest : public testing::Test {
 public:
  /// Failures are reported at `file` and `line`.
  LawTest(std::shared_ptr<const LawTests> tests, Check check, const char* file, int line)
      : tests_(std::move(tests)), check_(std::move(check)), file_(file), line_(line) {}

  /// Judges, and fails or skips.
  void TestBody() override {
    const LawOutcome outcome = tests_->run(check_);
    if (outcome.says_too_little) GTEST_SKIP() << outcome.text;
    if (!outcome.passes) ADD_FAILURE_AT(file_, line_) << outcome.text;
  }

 private:
  std::shared_ptr<const LawTests> tests_;
  Check check_;
  const char* file_;
  int line_;
};

/// Registers the tests. Call it before RUN_ALL_TESTS.
inline bool add_tests(const char* suite, LawTests law_tests, const char* file, int line) {
  const auto tests = std::make_shared<const LawTests>(std::move(law_tests));
  for (const Check& check : tests->checks()) {
    std::string name = check.law + "/" + check.source;
    std::replace(name.begin(), name.end(), '-', '_');
    testing::RegisterTest(suite, name.c_str(), nullptr, nullptr, file, line,
                          [=]() -> LawTest* { return new LawTest(tests, check, file, line); });
  }
  return true;
}

}  // namespace raycheck

/// Defines tests that judge a raycheck::Candidate, in a suite with this name.
#define RAYCHECK_TESTS(suite, candidate)        \
  static const bool raycheck_tests_of_##suite = \
      ::raycheck::add_tests(#suite, ::raycheck::LawTests(candidate), __FILE__, __LINE__)

#endif  // RAYCHECK_GTEST_H_
