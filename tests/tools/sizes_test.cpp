// The largest numbers that are taken, in memory that is not large.

#include <gtest/gtest.h>

#include <csignal>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/tools/limited_run.h"
#include "tests/tools/program.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

#ifdef __SANITIZE_ADDRESS__
constexpr std::uint64_t kMemory = 0;  // its shadow needs all addresses
#else
constexpr std::uint64_t kMemory = std::uint64_t{1} << 30;
#endif

/// An interrupt comes after so long, where work does not end before.
constexpr double kSeconds = 1;

LimitedOutcome run_in_memory(const std::vector<std::string>& arguments) {
  return run_limited(arguments, {.signal = SIGINT, .signal_after = kSeconds, .memory = kMemory});
}

std::string scene(std::int64_t width, std::int64_t height, const std::string& spheres) {
  return "[camera]\neye = [8, 8, 100]\nlook_at = [8, 8, 54]\nup = [0, 1, 0]\nnear = -30\nfar = "
         "-75\n"
         "left = -20\nright = 20\nbottom = -20\ntop = 20\nwidth = " +
         std::to_string(width) + "\nheight = " + std::to_string(height) + "\n" + spheres;
}

const std::string kSphere = "[[sphere]]\ncentre = [8, 8, 54]\nradius = 12\n";
constexpr std::int64_t kMostSide = (std::int64_t{1} << 31) - 1;

struct Size {
  std::int64_t width, height;
  std::string field;
};

TEST(HostileSizes, of_pictures_are_planned_and_not_timed) {
  for (const auto& [width, height, field] :
       {Size{kMostSide, 16, "camera.width"}, Size{16, kMostSide, "camera.height"},
        Size{kMostSide, kMostSide, "camera.width"}}) {
    const std::string path = temporary_file("large.toml", scene(width, height, kSphere));
    for (const char* wanted : {"nearest", "class", "point"}) {
      const LimitedOutcome outcome =
          run_in_memory({"plan", path, "--wanted", wanted, "--format", "json"});
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_NE(outcome.err.find("nothing is timed: " + field +
                                 " = 2147483647: what is seen is "
                                 "worked out of at most 4194304"),
                std::string::npos)
          << outcome.err;
      const json report = json::parse(outcome.out);
      EXPECT_TRUE(report["image_ms"].is_null());
      EXPECT_EQ(report["pixels_timed"], 0);
      EXPECT_EQ(report["spheres"].size(), 1u);
    }
    const LimitedOutcome text = run_in_memory({"plan", path});
    EXPECT_NE(text.out.find("the image is not timed\n"), std::string::npos) << text.out;
  }
}

TEST(HostileSizes, of_pictures_are_timed_up_to_a_limit) {
  for (const auto& [width, height, field] :
       {Size{std::int64_t{1} << 22, 16, ""}, Size{16, std::int64_t{1} << 22, ""}}) {
    const std::string path = temporary_file("long.toml", scene(width, height, kSphere));
    const LimitedOutcome outcome =
        run_limited({"plan", path, "--wanted", "point", "--format", "json"}, {.memory = kMemory});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_GT(json::parse(outcome.out)["pixels_timed"], 0);
  }
}

TEST(HostileSizes, of_pictures_times_spheres_are_not_timed_beyond_a_limit) {
  std::string spheres;
  for (int k = 0; k < 600; ++k) {
    spheres += "[[sphere]]\ncentre = [8, 8, " + std::to_string(54 - k) + "]\nradius = 900\n";
  }
  const std::string path = temporary_file("full.toml", scene(16, std::int64_t{1} << 22, spheres));
  const LimitedOutcome outcome =
      run_limited({"plan", path, "--wanted", "point"}, {.memory = kMemory});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("nothing is timed: spheres: they reach into 157286400 bands"),
            std::string::npos)
      << outcome.err;
}

TEST(HostileSizes, of_cases_and_of_scenes_take_no_more_memory_the_longer_it_takes) {
  const std::string path = temporary_file("all.toml", scene(kMostSide, kMostSide, kSphere));
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

TEST(HostileSizes, are_named_where_memory_is_short) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "its shadow needs all addresses";
#endif
  std::string spheres;
  for (int k = 0; k < 50000; ++k) spheres += kSphere;
  const std::string path = temporary_file("many.toml", scene(16, 16, spheres));
  // Less than it takes for such a scene, more than to start it: its libraries take what they take.
  constexpr std::uint64_t kStep = std::uint64_t{4} << 20, kMost = std::uint64_t{4} << 30;
  std::uint64_t memory = kStep;
  while (memory < kMost && run_limited({"--version"}, {.memory = memory}).exit_code != 0) {
    memory += kStep;
  }
  const LimitedOutcome outcome = run_limited({"check", path}, {.memory = memory + kStep});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.exit_code;
  EXPECT_EQ(outcome.err, "raycheck: check: takes more memory than there is for it\n");
}

}  // namespace
}  // namespace raycheck::tests
