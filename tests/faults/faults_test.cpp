// A system call of `raycheck grade` fails once: no grade is wrong, nothing is lost, and there is a
// message. The next run finishes the rest.

#include <cerrno>
#include <cstring>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

constexpr const char* kControlGroup = ", control group";

constexpr const char* kNames[] = {"right", "wrong", "drawn"};

/// A class that is graded without a fault, as "whole", and with faults.
class FaultyGrading {
 public:
  FaultyGrading() {
    const std::string hits =
        functions("class", "rays", 5, kGivenRays) +
        "[item.pictures]\njudge = \"mask\"\nsources = [\"course\"]\ncases = 1\n";
    rubric_ = grading_.write("rubric.toml", std::string("reply_seconds = 5\n") + kFormsOfBuilt +
                                                item_of("hits", "points = 10", hits));
    folders_ = {grading_.submit_built("right", "rays.cpp", "none"),
                grading_.submit_built("wrong", "rays.cpp", "no_test_for_t"),
                grading_.submit_built("drawn", "rt.cpp", "none")};
    const Variable preload("LD_PRELOAD", RAYCHECK_FAULTS);
    const Variable where("RAYCHECK_FAULT_COUNTS", grading_.path("counts"));
    EXPECT_EQ(grade("whole").exit_code, 0);
  }

  Outcome grade(const std::string& out) const {
    return grading_.grade(rubric_, folders_, out, "--jobs 1 --format json", {});
  }

  /// The same, with a fault.
  Outcome grade_with(const std::string& fault, const std::string& out) const {
    const Variable preload("LD_PRELOAD", RAYCHECK_FAULTS);
    const Variable which("RAYCHECK_FAULT", fault);
    return grade(out);
  }

  /// Its file is the same as without a fault, except for times.
  void expect_same(const std::string& name, const std::string& file, const std::string& out) const {
    const std::string text = without_times(grading_.file(name, file, out));
    std::string whole = without_times(grading_.file(name, file, "whole"));
    // If the trial of a control group at the start fails, the grade has none, and reports that.
    if (!has(text, kControlGroup) && has(whole, kControlGroup)) {
      whole = std::regex_replace(whole, std::regex(std::string(kControlGroup) + "[^\"]*"), "");
    }
    if (text == whole) return;
    const auto [at, other] = std::mismatch(text.begin(), text.end(), whole.begin(), whole.end());
    const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(at - text.begin() - 60, 0));
    ADD_FAILURE() << name << "/" << file << "\n  " << text.substr(from, 200) << "\n  instead of\n  "
                  << whole.substr(from, 200);
  }

  /// The numbers of `most` calls of this name that will fail, from different places in the program
  /// if there are enough.
  std::set<std::int64_t> points(const std::string& name, std::size_t most) const {
    std::int64_t count = 0;
    std::vector<std::int64_t> places;
    for (const std::string& line : lines_of(contents(grading_.path("counts")))) {
      if (!line.starts_with(name + " ")) continue;
      std::istringstream numbers(line.substr(name.size()));
      numbers >> count;
      for (std::int64_t call = 0; numbers >> call;) places.push_back(call);
    }
    std::sort(places.begin(), places.end());
    std::set<std::int64_t> chosen;
    // Places spread over the run; if there are too few, any calls.
    for (std::size_t k = 0; k < std::min(most, places.size()); ++k) {
      chosen.insert(places[k * places.size() / std::min(most, places.size())]);
    }
    for (std::size_t k = 0; k < most && chosen.size() < most; ++k) {
      if (count > 0)
        chosen.insert(static_cast<std::int64_t>(k) * count / static_cast<std::int64_t>(most));
    }
    return chosen;
  }

  const Grading& grading() const { return grading_; }
  const std::vector<std::string>& folders() const { return folders_; }

 private:
  Grading grading_;
  std::string rubric_;
  std::vector<std::string> folders_;
};

/// The error with which a call of this name fails, and the number of calls to try.
struct Fault {
  const char* call;
  int error;
  std::size_t most = 0;
};
class HostileFaults : public testing::TestWithParam<Fault> {
 protected:
  static void SetUpTestSuite() { faulty_ = std::make_unique<FaultyGrading>(); }
  static void TearDownTestSuite() { faulty_.reset(); }

  static std::unique_ptr<FaultyGrading> faulty_;
};
std::unique_ptr<FaultyGrading> HostileFaults::faulty_;

TEST_P(HostileFaults, InSystemCallsMakeNoGradeWrongAndLoseNothing) {
  const auto& [call, error, most] = GetParam();
  if (call == std::string("chown") && geteuid() != 0)
    GTEST_SKIP() << "needs root: submissions are run as separate users";
  const FaultyGrading& faulty = *faulty_;
  const Grading& grading = faulty.grading();
  const std::set<std::int64_t> points = faulty.points(call, most);
  ASSERT_GT(points.size(), 0u) << call << " is never called";
  for (const std::int64_t position : points) {
    const std::string point =
        std::string(call) + ":" + std::to_string(position) + ":" + std::to_string(error);
    SCOPED_TRACE(point);
    const Outcome outcome = faulty.grade_with(point, "out");
    const int code = outcome.exit_code;
    EXPECT_TRUE(code == 0 || code == 2 || code == 4) << code << "\n" << outcome.err;
    EXPECT_TRUE(code != 2 || !outcome.err.empty());
    bool is_whole = true;
    for (const char* name : kNames) {
      const std::string text = grading.file(name, "result.json");
      const json result = json::parse(text, nullptr, false);
      const bool finished = !result.is_discarded() && result.value("finished", false);
      is_whole = is_whole && finished;
      if (finished) faulty.expect_same(name, "result.json", "out");
    }
    EXPECT_TRUE(code != 0 || is_whole) << outcome.out;
    EXPECT_EQ(faulty.grade("out").exit_code, 0);
    for (const char* name : kNames) {
      faulty.expect_same(name, "result.json", "out");
      faulty.expect_same(name, "report.html", "out");
    }
    fs::remove_all(grading.path("out"));
  }
  for (const std::string& folder : faulty.folders()) {
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  }
}

/// Runs raycheck with an exception thrown at the `operation`-th operation on enclosures.
Outcome run_throwing(const std::string& arguments, int operation = 0) {
  const Variable preload("LD_PRELOAD", RAYCHECK_FAULTS);
  const Variable which("RAYCHECK_THROW", std::to_string(operation));
  return run(arguments);
}

void expect_internal(const Outcome& outcome) {
  EXPECT_EQ(outcome.exit_code, 70) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  expect_parts(outcome.err, {"raycheck: internal error: ", "injected\nThis is a bug in raycheck"});
}

TEST(InternalErrors, InLawsAreNotBlamedOnTheCandidate) {
  for (const std::string law :
       {"frame", "pixel-point", "bounds", "image-plane", "centre-pixel", "pixel-zero-zero",
        "square-pixels", "direction", "ray-origin", "class", "parameter", "backward-error",
        "hit-point", "focal-and-pixel", "axes", "look-at", "up"}) {
    SCOPED_TRACE(law);
    const Outcome outcome =
        run_throwing("properties --rays lecture --intersect lecture --cases 150 --filter " + law);
    expect_internal(outcome);
    expect_parts(outcome.err, {"internal error: law " + law + ": injected",
                               "properties' '--rays' 'lecture'", "# internal error"});
  }
}

TEST(InternalErrors, EndEveryCommandThatJudges) {
  const std::string scene = RAYCHECK_SOURCE_DIR "/scene/examples/optical-axis.toml";
  const std::string page = temporary_folder("internal") + "/page.html";
  for (const std::string& command : {
           "check " + scene,
           "explain " + scene + " --pixel 2,2",
           "tradeoff " + scene,
           "view " + scene + " --out " + page,
           std::string("stress --cases 5"),
       }) {
    SCOPED_TRACE(command);
    expect_internal(run_throwing(command));
  }
  EXPECT_FALSE(fs::exists(page));
}

/// Exceptions of the C++ library about a file are reported with its name; an incomplete copy does
/// not count as a copy.
TEST(Faults, InFilesAreReportedWithTheName) {
  const std::string folder = temporary_folder("library");
  const std::string library = built_submission("right.cpp", "right", folder);
  const std::string asked =
      "check scene/examples/lecture-examples.toml --candidate library:" + library;
  const Variable preload("LD_PRELOAD", RAYCHECK_FAULTS);
  long count = 0;
  {
    const Variable counts("RAYCHECK_FAULT_COUNTS", folder + "/counts");
    EXPECT_EQ(run(asked).exit_code, 0);
    for (const std::string& line : lines_of(contents(folder + "/counts"))) {
      if (line.starts_with("sendfile ")) count = std::stol(line.substr(line.find(' ')));
    }
  }
  int refused = 0;
  for (long k = 0; k < count; ++k) {
    const Variable which("RAYCHECK_FAULT",
                         "sendfile:" + std::to_string(k) + ":" + std::to_string(EIO));
    const Outcome outcome = run(asked);
    if (outcome.exit_code == 0) continue;  // it continued without a layer of the sandbox
    ++refused;
    EXPECT_TRUE(outcome.exit_code == 2 && has(outcome.err, ": Input/output error")) << outcome.err;
  }
  EXPECT_GT(refused, 0);
}

TEST(InternalErrors, WriteNoUnitNoBaselineAndNoReport) {
  const std::string asked =
      "properties --intersect lecture --filter parameter --source distance@9 ";
  const std::string folder = temporary_folder("units") + "/of", file = folder + ".json";
  const auto units = [&] {
    return std::distance(fs::recursive_directory_iterator(folder),
                         fs::recursive_directory_iterator());
  };
  expect_internal(run_throwing(asked + "--out " + folder));
  const auto before = units();
  run(asked + "--out " + folder, 1);
  EXPECT_GT(units(), before);
  expect_internal(run_throwing("merge --report json=" + file + " " + folder));
  expect_internal(run_throwing(asked + "--baseline " + file + " --update-baseline"));
  EXPECT_FALSE(fs::exists(file));
}

TEST(InternalErrors, InTheGraderGiveNoPoints) {
  const FaultyGrading faulty;
  const Variable preload("LD_PRELOAD", RAYCHECK_FAULTS);
  const Variable which("RAYCHECK_THROW", "0");
  const Outcome outcome = faulty.grade("out");
  EXPECT_EQ(outcome.exit_code, 70) << outcome.err;
  expect_parts(outcome.err, {"raycheck: internal error: wrong: "});
  // Earlier grades are kept.
  EXPECT_EQ(faulty.grading().file("wrong", "result.json"), "");
  EXPECT_EQ(faulty.grading().file("drawn", "result.json"), "");
  faulty.expect_same("right", "result.json", "out");
}

/// Faults really occur: the tests above would also pass without any.
TEST(HostileFaultsAtAll, AreNoticed) {
  // Four occur in the first process, which is started again as another user if it fails.
  const Outcome outcome = FaultyGrading().grade_with("pipe2:4:" + std::to_string(EMFILE), "out");
  EXPECT_NE(outcome.exit_code, 0) << outcome.out;
}

const auto kNameOfFault = [](const auto& the_test) {
  return the_test.param.call + std::string("_") + strerrorname_np(the_test.param.error);
};
std::vector<Fault> all_in(std::size_t most, std::vector<Fault> faults) {
  for (Fault& fault : faults) fault.most = most;
  return faults;
}

/// Each in two calls, and in twelve every night: several suites, which run in parallel.
#define RAYCHECK_TRY_FAULTS(name, ...)                                                       \
  INSTANTIATE_TEST_SUITE_P(name, HostileFaults, testing::ValuesIn(all_in(2, {__VA_ARGS__})), \
                           kNameOfFault);                                                    \
  INSTANTIATE_TEST_SUITE_P(Nightly##name, HostileFaults,                                     \
                           testing::ValuesIn(all_in(12, {__VA_ARGS__})), kNameOfFault)
RAYCHECK_TRY_FAULTS(Opening, {"open", EMFILE}, {"open", EIO}, {"openat", EMFILE}, {"fopen", EMFILE},
                    {"opendir", EMFILE}, {"pipe2", EMFILE});
RAYCHECK_TRY_FAULTS(Reading, {"read", EIO}, {"read", EINTR}, {"poll", EINTR}, {"poll", ENOMEM},
                    {"sendfile", EIO}, {"sendfile", ENOSPC});
RAYCHECK_TRY_FAULTS(Writing, {"write", EIO}, {"write", ENOSPC}, {"write", EINTR},
                    {"writev", ENOSPC}, {"writev", EIO}, {"rename", EIO});
RAYCHECK_TRY_FAULTS(Making, {"mkdir", ENOSPC}, {"mkdtemp", ENOSPC}, {"chown", EIO},
                    {"waitpid", EINTR}, {"posix_spawn", EAGAIN}, {"posix_spawn", ENOMEM});

}  // namespace
}  // namespace raycheck::tests
