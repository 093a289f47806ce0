// Builds the examples against an installed tree, and runs them.

#include <unistd.h>

#include "tests/library/shell.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;

/// Installs raycheck once for all tests.
class Consumers : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    installed() =
        shell(std::string("cmake --install ") + RAYCHECK_BUILD + " --prefix " + prefix().string());
  }
  /// Fails here, since tests of a suite whose set-up fails are skipped.
  void SetUp() override { ASSERT_EQ(installed().code, 0) << installed().text; }
  static Ended& installed() {
    static Ended ended;
    return ended;
  }
  static void TearDownTestSuite() { fs::remove_all(prefix()); }
  static fs::path prefix() {
    static const std::string name = "installed-" + std::to_string(getpid());
    return fs::path(RAYCHECK_BUILD) / "tests" / name;
  }

  /// Builds an example once, by its CMakeLists.txt; returns the folder of the build.
  static fs::path built(const std::string& name, const std::string& options = "") {
    static std::map<std::string, fs::path> known;
    const auto [its, is_new] = known.emplace(name + options, "");
    if (is_new) {
      its->second = prefix() / "built" / (name + "-" + std::to_string(known.size()));
      const Ended made = build_example(prefix(), name, its->second, options);
      EXPECT_EQ(made.code, 0) << made.text;
    }
    return its->second;
  }

  static std::size_t lines_of(const fs::path& path) {
    const std::vector<std::string> lines = raycheck::lines_of(contents(path));
    return lines.size() - std::count(lines.begin(), lines.end(), "");
  }
};

TEST(Installing, names_the_target_that_is_not_built) {
  const std::string folder =
      fs::path(RAYCHECK_BUILD) / "tests" / ("bare-" + std::to_string(getpid()));
  ASSERT_EQ(shell("cmake -S " RAYCHECK_SOURCE_DIR " -B " + folder).code, 0);
  const Ended installed = shell("cmake --install " + folder + " --prefix " + folder + "/installed");
  fs::remove_all(folder);
  EXPECT_NE(installed.code, 0);
  EXPECT_TRUE(has(installed.text, "raycheck-check is not built: build the target `installed`"));
}

TEST_F(Consumers, WithGoogleTestPassAndFindFiveMistakes) {
  const fs::path example = prefix() / "share/raycheck/examples/consumer-gtest";
  EXPECT_LE(lines_of(example / "CMakeLists.txt"), 6u);
  EXPECT_LE(lines_of(example / "tracer_test.cpp"), 5u);
  const std::string program = (built("consumer-gtest") / "tracer_test").string();
  const Ended good = shell(program);
  EXPECT_EQ(good.code, 0) << good.text;
  for (const auto& [mistake, law, sentence] :
       {std::array{"far_root", "nearest_root/rays", "far root"},
        {"behind", "class/rays", "s >= 0 is not tested"},
        {"upside_down", "direction/cameras", "upside down"},
        {"not_unit", "unit_direction/cameras", "not normalised"},
        {"pixel_step", "direction/cameras", "i/w"}}) {
    const Ended bad = shell("TRACER_MISTAKE=" + std::string(mistake) + " " + program);
    EXPECT_EQ(bad.code, 1) << mistake;
    EXPECT_TRUE(has(bad.text, "[  FAILED  ] Tracer." + std::string(law))) << mistake;
    EXPECT_TRUE(has(bad.text, sentence)) << mistake;
  }
}

/// The documentation contains the examples and their output.
TEST_F(Consumers, MatchTheDocumentation) {
  const fs::path source = RAYCHECK_SOURCE_DIR;
  const std::string page = contents(source / "docs/library.md");
  for (const char* file : {"consumer-gtest/CMakeLists.txt", "consumer-gtest/tracer_test.cpp",
                           "consumer-fuzz/tracer_fuzz.cpp"}) {
    EXPECT_TRUE(has(page, "\n" + contents(source / "examples" / file) + "```")) << file;
  }
  const std::string tracer = contents(source / "examples/tracer.h");
  const std::size_t from = tracer.find("inline raycheck::Candidate tracer()");
  EXPECT_TRUE(has(page, tracer.substr(from, tracer.find("\n}\n", from) - from)));
  const std::string test = (built("consumer-gtest") / "tracer_test").string();
  const std::string printed =
      shell((built("consumer-exact") / "truth").string()).text +
      shell((built("consumer-batch") / "batch").string()).text +
      shell("TRACER_MISTAKE=far_root " + test + " --gtest_filter=Tracer.nearest_root/rays").text;
  std::size_t shown = 0;
  const std::string fence = "\n```\n";
  for (std::size_t at = 0; (at = page.find("\n\n```\n", at)) != std::string::npos; ++shown) {
    at += 1 + fence.size();
    const std::string block = page.substr(at, page.find("\n```", at) - at);
    EXPECT_TRUE(has(printed, block)) << "\nis not in\n";
  }
  EXPECT_EQ(shown, 4u);
}

/// Each of these takes as long as all tests above.
class NightlyConsumers : public Consumers {};

TEST_F(NightlyConsumers, WithOtherFrameworksPassAndFail) {
  for (const auto& [framework, program, said] :
       {std::tuple("catch2", "tracer_test", "nearest-root/rays"),
        {"doctest", "tracer_test", "nearest-root/rays"},
        {"rapidcheck", "tracer_properties", "[[sphere]]"}}) {
    const std::string name = framework;
    if (name != "rapidcheck" && !fs::exists("/usr/include/" + name)) continue;
    const std::string built_program = (built("consumer-" + name) / program).string();
    const Ended good = shell(built_program);
    EXPECT_EQ(good.code, 0) << name << good.text;
    const Ended bad = shell("TRACER_MISTAKE=far_root " + built_program);
    EXPECT_NE(bad.code, 0) << name;
    EXPECT_TRUE(has(bad.text, said)) << name;
  }
}

/// Checks the output of a fuzzer that found the far root.
void expect_far_root(const Ended& bad) {
  EXPECT_NE(bad.code, 0) << bad.text;
  EXPECT_TRUE(has(bad.text, "nearest-root: tracer broken"));
  EXPECT_TRUE(has(bad.text, "[[sphere]]"));
}

TEST_F(NightlyConsumers, WithLibFuzzerSurviveAndFail) {
  if (shell("echo 'extern \"C\" int LLVMFuzzerTestOneInput() { return 0; }' | clang++ -x c++ "
            "-fsanitize=fuzzer -o /dev/null -")
          .code != 0) {
    GTEST_SKIP() << "clang++ with libFuzzer is not installed";
  }
  EXPECT_LE(lines_of(prefix() / "share/raycheck/examples/consumer-fuzz/tracer_fuzz.cpp"), 5u);
  const fs::path folder = built("consumer-fuzz", "-DCMAKE_CXX_COMPILER=clang++");
  const std::string fuzzer = "cd " + folder.string() + " && ./tracer_fuzz -seed=1 ";
  const Ended good = shell(fuzzer + "-runs=20000");
  EXPECT_EQ(good.code, 0) << good.text;
  EXPECT_TRUE(has(good.text, "Done 20000 runs"));
  expect_far_root(shell("export TRACER_MISTAKE=far_root; " + fuzzer + "-runs=20000"));
}

/// Calls the fuzzer's entry point, built with the available compiler, with random bytes.
TEST_F(NightlyConsumers, WithFuzzHSurviveAndFailOnRandomBytes) {
  const fs::path example = prefix() / "share/raycheck/examples/consumer-fuzz";
  const std::string program = (prefix() / "random_bytes").string();
  const std::string library = "$(find " + prefix().string() + " -name libraycheck.so.0)";
  const Ended made = shell("c++ -std=c++17 -I" + (prefix() / "include").string() + " " +
                           (example / "tracer_fuzz.cpp").string() + " " + RAYCHECK_SOURCE_DIR +
                           "/tests/library/random_bytes.cpp " + library + " -Wl,-rpath,$(dirname " +
                           library + ") -o " + program);
  ASSERT_EQ(made.code, 0) << made.text;
  const Ended good = shell(program + " 5000");
  EXPECT_EQ(good.code, 0) << good.text;
  expect_far_root(shell("TRACER_MISTAKE=far_root " + program + " 5000"));
}

/// The compiler flags of consumers do not affect answers.
TEST_F(NightlyConsumers, GetTheSameAnswersWithAllCompilerFlags) {
  const Ended plain = shell((built("consumer-exact") / "truth").string());
  EXPECT_EQ(plain.code, 0);
  EXPECT_TRUE(has(plain.text, "exactly"));
  const std::vector<std::string> ways = {
      "-DCMAKE_CXX_FLAGS='-Ofast -march=native' -DCMAKE_CXX_STANDARD=17",
      "-DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS='-Ofast -march=native'"};
  for (const std::string& way : ways) {
    if (way.find("clang") != std::string::npos && shell("clang++ --version").code != 0) continue;
    EXPECT_EQ(shell((built("consumer-exact", way) / "truth").string()).text, plain.text) << way;
  }
}

TEST_F(Consumers, FindTheLibraryByPkgConfig) {
  const Ended flags = shell("PKG_CONFIG_PATH=$(dirname $(find " + prefix().string() +
                            " -name raycheck.pc)) pkg-config --cflags --libs raycheck");
  if (flags.code == 127) GTEST_SKIP() << "pkg-config is not installed";
  ASSERT_EQ(flags.code, 0) << flags.text;
  const fs::path to = prefix() / "by-pkg-config";
  std::string line = flags.text;
  while (!line.empty() && line.back() == '\n') line.pop_back();
  const Ended made =
      shell("c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror " +
            (prefix() / "share/raycheck/examples/consumer-exact/truth.cpp").string() + " -o " +
            to.string() + " " + line);
  EXPECT_EQ(made.code, 0) << made.text;
}

TEST_F(Consumers, FindOnlyTheInterface) {
  const Ended symbols =
      shell("nm -D --defined-only -C $(find " + prefix().string() + " -name libraycheck.so.0)");
  ASSERT_EQ(symbols.code, 0) << symbols.text;
  const std::vector<std::string> lines = raycheck::lines_of(symbols.text);
  for (const std::string& line : lines) {
    for (const char* hidden : {"raycheck::scene::", "raycheck::reference::", "raycheck::fast::",
                               "raycheck::properties::", "raycheck::tools::", "CGAL", "nlohmann"}) {
      EXPECT_FALSE(has(line, hidden));
    }
  }
  EXPECT_GT(lines.size(), 30u);
}

}  // namespace
}  // namespace raycheck::tests
