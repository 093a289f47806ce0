// Sends SIGINT, SIGTERM and SIGHUP in the middle of every command; closes its output pipe; and
// tries the largest accepted numbers with little memory.

#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

/// How the program is run and disturbed.
struct Circumstances {
  int signal = 0;
  double signal_after = 0;        ///< Seconds, after it catches signals.
  std::uint64_t memory = 0;       ///< Bytes of address space; 0: no limit.
  bool stalled = false;           ///< Whether its output is not read, but lost.
  std::string stays_in = "/tmp";  ///< TMPDIR
};

struct LimitedOutcome {
  int exit_code = -1;  ///< If a signal ended it, minus the signal.
  std::string out, err;
  bool caught = false;         ///< Whether it was seen to catch signals.
  bool was_signalled = false;  ///< Whether it was still running when the signal was due.
  double seconds_after = 0;    ///< CPU time from the signal to the end.
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A process that still runs after this time is killed; the machine may be loaded.
constexpr double kMostSecondsInAll = 120;

/// The CPU time of a process and its threads.
double cpu_seconds(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text, ')');  // its name
  for (int field = 3; field < 14; ++field) file >> text;
  double user = 0, system = 0;
  file >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Whether a process has begun to catch SIGTERM. On a loaded machine, it takes time to load a
/// program.
bool catches_signals(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("SigCgt:", 0) != 0) continue;
    return (std::stoull(line.substr(7), nullptr, 16) >> (SIGTERM - 1) & 1) != 0;
  }
  return false;
}

/// Runs the built program in the source folder, with an open, empty standard input.
LimitedOutcome run_limited(const std::vector<std::string>& arguments, const Circumstances& how) {
  const std::string folder = temporary_folder("limited");
  const std::string out = folder + "/out", err = folder + "/err", pipe = folder + "/pipe";
  if (mkfifo(pipe.c_str(), 0600) != 0) throw std::runtime_error("mkfifo");
  std::string line = "export TMPDIR=" + quoted(how.stays_in) + "; ";
  if (how.memory > 0) line += "ulimit -v " + std::to_string(how.memory / 1024) + "; ";
  line += "exec '" RAYCHECK_BINARY "'";
  for (const std::string& word : arguments) line += " " + quoted(word);
  // A pipe that is open at both ends has no end, and holds only little.
  const pid_t child = start_shell(line + " <>'" + pipe + "' " +
                                  (how.stalled ? "1<>'" + pipe : ">'" + out) + "' 2>'" + err + "'");
  LimitedOutcome outcome;
  int status = 0;
  pid_t ended = 0;
  const auto wait_until = [&](const auto& is_so, double most_seconds) {
    for (const auto start = Clock::now();
         ended == 0 && !is_so() && seconds_since(start) < most_seconds;) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ended = waitpid(child, &status, WNOHANG);
    }
  };
  if (how.signal != 0) {
    wait_until([&] { return outcome.caught = catches_signals(child); }, kMostSecondsInAll);
    wait_until([] { return false; }, how.signal_after);
  }
  const double before = cpu_seconds(child);
  if (how.signal != 0 && ended == 0) {
    outcome.was_signalled = true;
    kill(child, how.signal);
  }
  const auto note_time = [&] {
    outcome.seconds_after = cpu_seconds(child) - before;
    return false;
  };
  wait_until(note_time, kMostSecondsInAll);
  if (ended == 0) {
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
  }
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  outcome.out = contents(out);
  outcome.err = contents(err);
  return outcome;
}

/// raycheck promises to end within two seconds, in which two threads may compute.
constexpr double kMostSecondsToEnd = 4;

/// A command line that takes long. BIG and MANY stand for scenes, UNITS for a folder of units, OUT
/// for a file or folder to be written.
struct Line {
  std::string name;
  std::vector<std::string> arguments;
  bool is_json = true;
  bool is_quick = false;  ///< Whether it may end before it catches signals.
};

const std::string kNeverReplies = "command:python3 tests/candidates/hostile.py sleep";
const std::string kHangs = "renderer:python3 tests/candidates/rt.py hang {scene} {image}";
const std::string kTen = "scene/examples/ten-spheres.toml";

const std::vector<Line>& lines() {
  static const std::vector<Line> all = {
      {"check", {"check", "BIG", "--threads", "2"}},
      {"check_many_spheres", {"check", "MANY"}},
      {"check_every_method", {"check", "MANY", "--all"}},
      {"check_that_hangs", {"check", kTen, "--candidate", kNeverReplies, "--timeout", "60"}},
      {"check_hanging_renderer", {"check", kTen, "--candidate", kHangs, "--timeout", "60"}},
      {"check_compiling",
       {"check", kTen, "--candidate", "source:tests/candidates/right.cpp", "--pixels", "all"}},
      {"properties", {"properties", "--cases", "1000000000"}},
      {"properties_shrinking",
       {"properties", "--cases", "100000", "--intersect", "quadratic", "--level", "extreme"}},
      {"properties_kept", {"properties", "--cases", "1000000", "--out", "OUT"}},
      {"properties_shard",
       {"properties", "--cases", "1000000", "--out", "OUT", "--shard", "1/2"},
       false},
      {"merge", {"merge", "UNITS"}, true, true},
      {"explain", {"explain", "MANY", "--pixel", "7,7"}},
      {"stress", {"stress", "--cases", "1000000"}},
      {"tradeoff", {"tradeoff", "--cases", "1000000000"}},
      {"tradeoff_timing", {"tradeoff", "--cases", "20"}},
      {"tradeoff_scene", {"tradeoff", "MANY", "--cases", "1000000000"}},
      {"worst",
       {"worst", "--method", "intersect/cross", "--family", "rays", "--cases", "1000000000"}},
      {"worst_climbing",
       {"worst", "--method", "intersect/cross", "--family", "rays", "--cases", "10", "--steps",
        "1000000000"}},
      {"image", {"image", "BIG", "--out", "OUT.png"}},
      {"image_of_errors", {"image", "MANY", "--what", "error", "--out", "OUT.ppm"}},
      {"view", {"view", "MANY", "--out", "OUT.html"}},
      {"view_of_a_candidate", {"view", kTen, "--candidate", kNeverReplies, "--timeout", "60"}},
      {"view_of_a_family", {"view", "--family", "distance", "--out", "OUT.html"}},
      {"plan", {"plan", "MANY"}},
      {"plan_classes", {"plan", "BIG", "--wanted", "class"}},
      {"grade", {"grade", "lecture7.toml", "tests/submissions/rays.cpp", "--out", "OUT"}},
      {"grade_own", {"grade", "lecture7.toml"}},
      {"grade_probe", {"grade", "lecture7.toml", "tests/submissions/class/ella", "--probe"}},
      {"try", {"try", "lecture7.toml", "tests/submissions/rays.cpp"}, false},
      {"rubric", {"rubric"}, false, true},
      {"list", {"list"}, true, true},
      {"new", {"new", "mine", "--out", "OUT"}, false, true}};
  return all;
}

/// A scene of a camera's image, with spheres spread over it.
void write_scene(const std::string& path, int side, int spheres) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> across(-48, 42), along(-130, -40), radius(0.5, 5);
  std::ofstream file(path);
  file << camera_text(side, side, 20, 30);
  for (int k = 0; k < spheres; ++k) {
    file << "[[sphere]]\ncentre = [" << across(random) << ", " << across(random) << ", "
         << along(random) << "]\nradius = " << radius(random) << "\n";
  }
}

/// The input files of all command lines.
struct ReadByLines {
  std::string folder = temporary_folder("read"), big = folder + "/big.toml",
              many = folder + "/many.toml", units = folder + "/units";

  static const ReadByLines& once() {
    static const ReadByLines its;
    return its;
  }

 private:
  ReadByLines() {
    write_scene(big, 30000, 3);
    write_scene(many, 4096, 5000);
    run("properties --filter frame --cases 50 --shard 1/1 --out " + units, 0);
  }
};

/// The moment of the signal; it differs from line to line. RAYCHECK_SIGNAL_SEED gives other
/// moments.
double moment(std::size_t line, int signal) {
  const char* const seed = std::getenv("RAYCHECK_SIGNAL_SEED");
  std::mt19937_64 random((seed == nullptr ? 1 : std::strtoull(seed, nullptr, 10)) * 100000 +
                         line * 100 + static_cast<std::size_t>(signal));
  return std::uniform_real_distribution<double>(0.02, 0.4)(random);
}

class HostileSignals : public testing::TestWithParam<std::size_t> {};

TEST_P(HostileSignals, end_a_command_with_a_partial_report_and_leave_nothing) {
  const Line& line = lines()[GetParam()];
  const ReadByLines& scenes = ReadByLines::once();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string temporary = temporary_folder("tmp"), written = temporary_folder("out");
    std::vector<std::string> arguments = line.arguments;
    for (std::string& word : arguments) {
      if (word == "BIG") word = scenes.big;
      if (word == "MANY") word = scenes.many;
      if (word == "UNITS") word = scenes.units;
      if (word.rfind("OUT", 0) == 0) word = written + "/" + word;
    }
    if (line.is_json) arguments.insert(arguments.end(), {"--format", "json"});
    const LimitedOutcome outcome = run_limited(
        arguments,
        {.signal = signal, .signal_after = moment(GetParam(), signal), .stays_in = temporary});
    EXPECT_TRUE(outcome.caught || line.is_quick);
    EXPECT_LT(outcome.seconds_after, kMostSecondsToEnd);
    EXPECT_EQ(names_in(temporary), std::vector<std::string>{});
    for (const std::string& name : names_in(written)) {
      EXPECT_FALSE(name.ends_with(".part")) << name;
    }
    EXPECT_TRUE(outcome.out.empty() || outcome.out.back() == '\n');
    const json report = line.is_json ? json::parse(outcome.out, nullptr, false) : json();
    EXPECT_FALSE(report.is_discarded()) << outcome.out.substr(0, 200);
    if (!outcome.was_signalled || outcome.exit_code < 128) {
      // The command was done, or had only to print its report.
      EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1 || outcome.exit_code == 4)
          << outcome.exit_code << outcome.err;
      continue;
    }
    EXPECT_EQ(outcome.exit_code, 128 + signal) << outcome.err;
    if (line.is_json) {
      EXPECT_EQ(report.value("interrupted", json()), true) << outcome.out;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, HostileSignals, testing::Range(std::size_t{0}, lines().size()),
                         [](const auto& each) { return lines()[each.param].name; });

TEST(HostileSignalsToAll, are_tried_on_every_command) {
  for (const std::string& name : all_commands()) {
    EXPECT_TRUE(std::any_of(lines().begin(), lines().end(), [&](const Line& line) {
      return line.arguments.front() == name;
    })) << name;
  }
}

TEST(HostileSignalsToAll, keep_an_ignored_hangup_ignored) {
  std::signal(SIGHUP, SIG_IGN);
  const LimitedOutcome outcome =
      run_limited({"plan", kTen}, {.signal = SIGHUP, .signal_after = 0.01});
  std::signal(SIGHUP, SIG_DFL);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(HostileReaders, that_close_the_pipe_end_a_command_as_sigpipe_would) {
  const std::string temporary = temporary_folder("tmp");
  const auto piped = [&](const std::string& command) {
    return run_bash("export TMPDIR='" + temporary + "'\n'" RAYCHECK_BINARY "' " + command +
                    "\necho \"${PIPESTATUS[@]}\" >&2\n");
  };
  const Outcome large = piped("check " + kTen + " --all --format json | head -n 1");
  EXPECT_EQ(large.out, "{\n");
  EXPECT_EQ(large.err, "141 0\n");
  const Outcome candidate = piped("check " + kTen +
                                  " --candidate 'command:python3 tests/candidates/right.py' "
                                  "--format json | true");
  EXPECT_EQ(candidate.err, "141 0\n");
  EXPECT_EQ(names_in(temporary), std::vector<std::string>{});
}

TEST(HostileReaders, that_do_not_read_cannot_block_a_command) {
  const LimitedOutcome outcome =
      run_limited({"check", kTen, "--all", "--format", "json"},
                  {.signal = SIGTERM, .signal_after = 3, .stalled = true});
  EXPECT_EQ(outcome.exit_code, 128 + SIGTERM);
  EXPECT_LT(outcome.seconds_after, kMostSecondsToEnd);
}

#ifdef __SANITIZE_ADDRESS__
constexpr std::uint64_t kMemory = 0;  // its shadow needs all addresses
#else
constexpr std::uint64_t kMemory = std::uint64_t{1} << 30;
#endif

/// The interrupt comes after this time if the work has not ended before.
constexpr double kSeconds = 0.5;

LimitedOutcome run_in_memory(const std::vector<std::string>& arguments) {
  return run_limited(arguments, {.signal = SIGINT, .signal_after = kSeconds, .memory = kMemory});
}

const std::string kSphere = sphere_text("0, 0, -46", "12");
constexpr std::int64_t kMostSide = (std::int64_t{1} << 31) - 1;

TEST(HostileSizes, of_pictures_are_planned_and_not_timed) {
  for (const auto& [width, height, field] :
       {std::tuple(kMostSide, std::int64_t{16}, "camera.width"),
        {16, kMostSide, "camera.height"},
        {kMostSide, kMostSide, "camera.width"}}) {
    const std::string path = temporary_file("large.toml", camera_text(width, height) + kSphere);
    for (const char* wanted : {"nearest", "class", "point"}) {
      const LimitedOutcome outcome =
          run_in_memory({"plan", path, "--wanted", wanted, "--format", "json"});
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_TRUE(has(outcome.err, "nothing is timed: " + std::string(field) +
                                       " = 2147483647: visibility is computed for at most "
                                       "4194304"));
      const json report = json::parse(outcome.out);
      expect_values(report, {{"image_ms", nullptr}, {"pixels_timed", 0}});
      EXPECT_EQ(report["spheres"].size(), 1u);
    }
    EXPECT_TRUE(has(run_in_memory({"plan", path}).out, "the image is not timed\n"));
  }
}

TEST(HostileSizes, of_pictures_are_timed_up_to_a_limit) {
  constexpr std::int64_t kMostTimed = std::int64_t{1} << 22;
  for (const auto& [width, height] : {std::pair(kMostTimed, std::int64_t{16}), {16, kMostTimed}}) {
    const std::string path = temporary_file("long.toml", camera_text(width, height) + kSphere);
    const LimitedOutcome outcome =
        run_limited({"plan", path, "--wanted", "point", "--format", "json"}, {.memory = kMemory});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_GT(json::parse(outcome.out)["pixels_timed"], 0);
  }
}

TEST(HostileSizes, of_pictures_times_spheres_are_not_timed_beyond_a_limit) {
  std::string spheres;
  for (int k = 0; k < 600; ++k) {
    spheres += sphere_text("0, 0, " + std::to_string(-46 - k), "900");
  }
  const std::string path =
      temporary_file("full.toml", camera_text(16, std::int64_t{1} << 22) + spheres);
  const LimitedOutcome outcome =
      run_limited({"plan", path, "--wanted", "point"}, {.memory = kMemory});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(has(outcome.err, "nothing is timed: spheres: they cover 157286400 bands"));
}

TEST(HostileSizes, of_cases_and_of_scenes_take_bounded_memory) {
  const std::string path = temporary_file("all.toml", camera_text(kMostSide, kMostSide) + kSphere);
  const std::vector<std::vector<std::string>> all = {
      {"tradeoff", "--cases", "1000000000"},
      {"tradeoff", path, "--cases", "1000000000"},
      {"properties", "--cases", "1000000000"},
      {"properties", "--cases", "1000000000", "--source", "distance@3", "--filter", "class"},
      {"stress", "--cases", "1000000"},
      {"worst", "--method", "intersect/cross", "--family", "rays", "--cases", "1000000000"},
      {"check", path}};
  for (std::vector<std::string> arguments : all) {
    arguments.insert(arguments.end(), {"--format", "json"});
    const LimitedOutcome outcome = run_in_memory(arguments);
    EXPECT_EQ(outcome.exit_code, 130) << arguments[0] << ": " << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["interrupted"], true);
  }
}

TEST(HostileSizes, are_reported_when_memory_is_short) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "its shadow needs all addresses";
#endif
  std::string spheres;
  for (int k = 0; k < 50000; ++k) spheres += kSphere;
  const std::string path = temporary_file("many.toml", camera_text(16, 16) + spheres);
  // This memory is too little for such a scene, but enough to start the program with its libraries.
  constexpr std::uint64_t kStep = std::uint64_t{4} << 20, kMost = std::uint64_t{4} << 30;
  std::uint64_t memory = kStep;
  while (memory < kMost && run_limited({"--version"}, {.memory = memory}).exit_code != 0) {
    memory += kStep;
  }
  const LimitedOutcome outcome = run_limited({"check", path}, {.memory = memory + kStep});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.exit_code;
  EXPECT_EQ(outcome.err, "raycheck: check: not enough memory\n");
}

}  // namespace
}  // namespace raycheck::tests
