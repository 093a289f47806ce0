// A system call of `raycheck grade` fails once: no grade is wrong, nothing is lost, and something
// is said. What is not finished is finished by the next run.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Fault {
  const char* name;
  int error;
};
/// What each call may fail with.
constexpr Fault kFaults[] = {
    {"open", EMFILE},        {"open", EIO},       {"openat", EMFILE},   {"fopen", EMFILE},
    {"read", EIO},           {"read", EINTR},     {"write", EIO},       {"write", ENOSPC},
    {"write", EINTR},        {"writev", ENOSPC},  {"writev", EIO},      {"pipe2", EMFILE},
    {"mkdir", ENOSPC},       {"mkdtemp", ENOSPC}, {"rename", EIO},      {"poll", EINTR},
    {"poll", ENOMEM},        {"waitpid", EINTR},  {"opendir", EMFILE},  {"posix_spawn", EAGAIN},
    {"posix_spawn", ENOMEM}, {"sendfile", EIO},   {"sendfile", ENOSPC}, {"chown", EIO}};

constexpr const char* kControlGroup = ", control group";

constexpr const char* kNames[] = {"right", "wrong", "drawn"};

class HostileFaultsAtAll : public testing::Test {
 protected:
  HostileFaultsAtAll() {
    rubric_ = grading_.write("rubric.toml", std::string("reply_seconds = 5\n") + kFormsOfBuilt + R"(
[[item]]
name = "hits"
points = 10
[item.functions]
laws = ["class"]
rays = "given"
sources = ["rays"]
cases = 5
[item.pictures]
judge = "mask"
sources = ["course"]
cases = 1
)");
    folders_ = {grading_.submit_built("right", "rays.cpp", "none"),
                grading_.submit_built("wrong", "rays.cpp", "no_test_for_t"),
                grading_.submit_built("drawn", "rt.cpp", "none")};
  }

  Outcome grade(const std::string& out) const {
    return grading_.try_to_grade(rubric_, folders_, out, "--jobs 1 --format json");
  }

  /// The same, with a fault.
  Outcome grade_with(const std::string& fault, const std::string& out) const {
    const Variable preload("LD_PRELOAD", RAYCHECK_FAULTS);
    const Variable which("RAYCHECK_FAULT", fault);
    return grade(out);
  }

  /// Its file is as it is without a fault, times aside.
  void expect_same(const std::string& name, const std::string& file, const std::string& out) const {
    const std::string text = without_times(grading_.file(name, file, out));
    std::string whole = without_times(grading_.file(name, file, "whole"));
    // Where a fault meets the trial of a control group at the start there is none, as is said.
    if (!has(text, kControlGroup) && has(whole, kControlGroup)) {
      whole = std::regex_replace(whole, std::regex(std::string(kControlGroup) + "[^\"]*"), "");
    }
    if (text == whole) return;
    const auto [at, other] = std::mismatch(text.begin(), text.end(), whole.begin(), whole.end());
    const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(at - text.begin() - 60, 0));
    ADD_FAILURE() << name << "/" << file << "\n  " << text.substr(from, 200) << "\n  instead of\n  "
                  << whole.substr(from, 200);
  }

  std::map<std::string, int> counts() const {
    const Variable preload("LD_PRELOAD", RAYCHECK_FAULTS);
    const Variable where("RAYCHECK_FAULT_COUNTS", grading_.path("counts"));
    EXPECT_EQ(grade("counted").exit_code, 0);
    std::istringstream lines(contents(grading_.path("counts")));
    std::map<std::string, int> counts;
    std::string name;
    for (int count = 0; lines >> name >> count;) counts[name] = count;
    return counts;
  }

  Grading grading_;
  std::string rubric_;
  std::vector<std::string> folders_;
};

/// A fault, and at how many points of a run it is tried.
struct Tried {
  Fault fault;
  int points;
};
class HostileFaults : public HostileFaultsAtAll, public testing::WithParamInterface<Tried> {};

TEST_P(HostileFaults, OfTheSystemMakeNoGradeWrongAndLoseNothing) {
  const auto [fault, points] = GetParam();
  if (fault.name == std::string("chown") && geteuid() != 0)
    GTEST_SKIP() << "root alone gives folders to users of their own";
  ASSERT_EQ(grade("whole").exit_code, 0);
  const int count = counts().at(fault.name);
  ASSERT_GT(count, 0) << fault.name << " is never called";
  const int tried = std::min(points, count);
  for (int k = 0; k < tried; ++k) {
    // Spread over the run.
    const int position = static_cast<int>(static_cast<std::int64_t>(k) * count / tried);
    const std::string point = std::string(fault.name) + ":" + std::to_string(position) + ":" +
                              std::to_string(fault.error);
    SCOPED_TRACE(point);
    const std::string out = "out" + std::to_string(k);
    const Outcome outcome = grade_with(point, out);
    const int code = outcome.exit_code;
    EXPECT_TRUE(code == 0 || code == 2 || code == 4) << code << "\n" << outcome.err;
    EXPECT_TRUE(code != 2 || !outcome.err.empty());
    bool is_whole = true;
    for (const char* name : kNames) {
      const std::string text = grading_.file(name, "result.json", out);
      const json result = json::parse(text, nullptr, false);
      const bool finished = !result.is_discarded() && result.value("finished", false);
      is_whole = is_whole && finished;
      if (finished) expect_same(name, "result.json", out);
    }
    EXPECT_TRUE(code != 0 || is_whole) << outcome.out;
    EXPECT_EQ(grade(out).exit_code, 0);
    for (const char* name : kNames) {
      expect_same(name, "result.json", out);
      expect_same(name, "report.html", out);
    }
    fs::remove_all(grading_.path(out));
  }
  for (const std::string& folder : folders_) {
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  }
}

/// What may fail is failed: this test would not hold if nothing were.
TEST_F(HostileFaultsAtAll, AreNoticed) {
  // Four are of the first process, which is tried again as another user where it fails.
  const Outcome outcome = grade_with("pipe2:4:" + std::to_string(EMFILE), "out");
  EXPECT_NE(outcome.exit_code, 0) << outcome.out;
}

std::vector<Tried> all_faults(int points) {
  std::vector<Tried> all;
  for (const Fault& fault : kFaults) all.push_back({fault, points});
  return all;
}
const auto kFaultName = [](const auto& the_test) {
  const Fault& fault = the_test.param.fault;
  return fault.name + std::string("_") + strerrorname_np(fault.error);
};
INSTANTIATE_TEST_SUITE_P(Each, HostileFaults, testing::ValuesIn(all_faults(2)), kFaultName);
INSTANTIATE_TEST_SUITE_P(LongEach, HostileFaults, testing::ValuesIn(all_faults(13)), kFaultName);

}  // namespace
}  // namespace raycheck::tests
