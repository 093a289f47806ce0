// Candidates that fail on some questions: these questions are found, and the others are judged. The
// line of the source where a candidate crashed or threw is reported, as data and in the message.

#include <future>

#include "properties/trial.h"
#include "tests/tools/external/judged.h"
#include "tools/external/protocol/frames.h"

namespace raycheck::tests {
namespace {

const std::string kTenSpheres = "scene/examples/ten-spheres.toml";

std::string fails_by(const std::string& how) {
  return "command:python3 tests/candidates/fails.py " + how;
}

/// The discrepancies with this blame.
std::vector<json> blaming(const json& report, const std::string& blame) {
  std::vector<json> found;
  for (const json& one : report["worst"]) {
    if (!one["failed"].is_null() && one["failed"]["blame"] == blame) found.push_back(one);
  }
  return found;
}

int cases(const json& report, const std::string& quantity) {
  const json found = quantity_of(report["quantities"], quantity);
  return found.is_null() ? 0 : found["cases"].get<int>();
}

TEST(FailingCandidate, is_reported_with_the_failing_question_for_every_kind_of_failure) {
  const json right = judged(kTenSpheres, fails_by("none none"));
  ASSERT_EQ(right["discrepancies"], 0);
  // The candidate that hangs runs in parallel with the others.
  auto hangs = std::async(std::launch::async, [] {
    return judged(kTenSpheres, fails_by("hang one"), "--timeout 0.5");
  });
  for (const std::string how : {"exit", "abort", "error", "garbage", "hang"}) {
    const json report = how == "hang" ? hangs.get() : judged(kTenSpheres, fails_by(how + " one"));
    ASSERT_EQ(report["discrepancies"], 1) << how << report["worst"].dump(2);
    const json& one = report["worst"][0];
    EXPECT_EQ(one["failed"]["blame"], "question") << how;
    EXPECT_EQ(one["pixel"], (json{11, 7})) << how;
    EXPECT_EQ(one["sphere"], 2) << how;
    // All other pairs are judged; the failing pair is a hit.
    EXPECT_EQ(cases(report, "class"), cases(right, "class") - 1) << how;
    EXPECT_EQ(cases(report, "parameter"), cases(right, "parameter") - 1) << how;
    EXPECT_EQ(cases(report, "direction"), cases(right, "direction")) << how;
    EXPECT_EQ(report["failures"]["found"], 1) << how;
    EXPECT_EQ(report["failures"]["batches"], 1) << how;
  }
}

TEST(FailingCandidate, fails_on_the_reported_scene) {
  const json report = judged(kTenSpheres, fails_by("exit one"));
  const std::string scene =
      temporary_file("question.toml", report["worst"][0]["failed"]["scene"].get<std::string>());
  const json again = judged(scene, fails_by("exit one"));
  EXPECT_EQ(again["discrepancies"], 1);
  EXPECT_EQ(cases(again, "class"), 0);
  EXPECT_EQ(judged(scene, fails_by("none none"))["discrepancies"], 0);
}

TEST(FailingCandidate, is_reported_with_the_pixel_whose_ray_fails) {
  const json report = judged(kTenSpheres, fails_by("exit made"));
  ASSERT_EQ(report["discrepancies"], 1) << report["worst"].dump(2);
  expect_values(report["worst"][0], {{"pixel", json{5, 7}}, {"sphere", nullptr}});
  EXPECT_EQ(cases(report, "direction"), 255);
  EXPECT_EQ(cases(report, "class"), 2550);
}

TEST(FailingCandidate, is_searched_with_a_limit) {
  const json report = judged(kTenSpheres, fails_by("exit lower"), "--top 100");
  EXPECT_EQ(report["failures"]["found"], properties::kMostFailuresSought);
  const std::vector<json> among = blaming(report, "among");
  EXPECT_EQ(among.size(), report["failures"]["not_sought"]);
  EXPECT_EQ(report["discrepancies"], properties::kMostFailuresSought + among.size());
  // Every question about a ray that points down is blamed once; all others are judged.
  int blamed = properties::kMostFailuresSought;
  for (const json& one : among) blamed += one["failed"]["questions"].get<int>();
  EXPECT_EQ(blamed, 1280);
  EXPECT_EQ(cases(report, "class"), 1280);
}

TEST(FailingCandidate, that_fails_for_no_single_question_is_reported_as_such) {
  const json report = judged(kTenSpheres, fails_by("once one"), "--top 100");
  EXPECT_EQ(report["failures"]["found"], 0);
  EXPECT_GE(report["failures"]["together"], properties::kMostFailuresSought);
  EXPECT_EQ(blaming(report, "together").size(), report["failures"]["together"]);
  EXPECT_GT(cases(report, "class"), 1000);
}

TEST(FailingCandidate, that_times_out_is_dropped) {
  const json report = judged(kTenSpheres, fails_by("hang all"), "--timeout 0.5 --top 100");
  EXPECT_EQ(cases(report, "class"), 0);
  EXPECT_EQ(blaming(report, "question").size(), 1u);
  EXPECT_EQ(blaming(report, "anything").size(), 1u);
}

TEST(FailingCandidate, is_reported_alike_with_any_number_of_threads) {
  const std::string many = "check " + kTenSpheres + " --top 50 --format json --candidate '" +
                           fails_by("error one") + "' --threads ";
  EXPECT_EQ(run(many + "1").out, run(many + "4").out);
}

TEST(FailingCandidate, is_reported_with_one_question_by_properties_and_a_replay) {
  for (const std::string how : {"exit lower", "hang lower"}) {
    const json campaign =
        report_of("properties --filter class --source cameras --cases 20 --timeout 0.5",
                  fails_by(how), 1)["campaigns"][0];
    EXPECT_EQ(campaign["finding"], "broken") << how;
    EXPECT_NE(campaign["replay"], "") << how;
    const std::string scene = campaign["scene"];
    for (const char* what : {"[[sphere]]", "[[ray]]"}) {
      EXPECT_NE(scene.find(what), std::string::npos) << how << "\n" << scene;
      EXPECT_EQ(scene.find(what), scene.rfind(what)) << how << "\n" << scene;
    }
  }
}

const std::string kDies = "tests/candidates/dies.cpp";

/// A line of a file, from 1 on.
struct Place {
  std::string file;
  int line = 0;
};

/// The lines with a name, "// dies: NAME" or "// dies: NAME; NAME".
std::map<std::string, Place> named_lines() {
  std::map<std::string, Place> found;
  for (const char* const file : {kDies.c_str(), "tests/candidates/dies_elsewhere.h"}) {
    int number = 0;
    for (const auto& line : lines_of(contents(std::string(RAYCHECK_SOURCE_DIR) + "/" + file))) {
      ++number;
      const std::string mark = "// dies: ";
      const std::size_t at = line.find(mark);
      if (at == std::string::npos) continue;
      std::istringstream names(line.substr(at + mark.size()));
      for (std::string name; std::getline(names >> std::ws, name, ';');) {
        found[name] = {file, number};
      }
    }
  }
  return found;
}

void write(const std::string& path, const std::string& text) {
  fs::rename(temporary_file("part", text), path);
}

/// A scene of rays that hit nothing; their origins have these x.
std::string scene_of(int first, int last) {
  std::string text = sphere_text("1000, 1000, 1000", "1");
  for (int k = first; k <= last; ++k) {
    text += ray_text(std::to_string(k) + ", 0, 0", "0, 0, 1");
  }
  return text;
}

/// The ways of dies.cpp in its order, and the message for each.
struct Way {
  std::string name, words;
};
const std::array kWays = {
    Way{"writes to an invalid address", "it was killed by signal 11"},
    Way{"reads beyond a file", "it was killed by signal 7"},
    Way{"divides by zero", "it was killed by signal 8"},
    Way{"executes an invalid instruction", "it was killed by signal 4"},
    Way{"asserts", "it was killed by signal 6"},
    Way{"aborts", "it was killed by signal 6"},
    Way{"throws an int", "it was killed by signal 6"},
    Way{"throws", "it failed: it is?so"},
    Way{"reads beyond a list", "it failed: vector::_M_range_check"},
    Way{"uses up its stack", "it was killed by signal 11"},
    Way{"raises", "it was killed by signal 8"},
    Way{"sorts invalid memory", "it was killed by signal 11"},
    Way{"sorts by a crashing comparison", "it was killed by signal 11"},
    Way{"frees an invalid pointer", "it was killed by signal 6"},
    Way{"throws in a noexcept function", "it was killed by signal 6"},
    Way{"smashes its stack", "it was killed by signal 11"},
    Way{"in an inlined function of another file", "it was killed by signal 8"},
};

TEST(FailingLine, is_reported_for_every_kind_of_crash) {
  const auto lines = named_lines();
  constexpr int kAtATime = 6;  // fewer than are searched for
  const int all = static_cast<int>(kWays.size());
  int reported = 0;
  for (int first = 0; first < all; first += kAtATime) {
    const std::string scene =
        temporary_file("deaths.toml", scene_of(first + 1, std::min(first + kAtATime, all)));
    const json report = judged(scene, "source:" + kDies, "--top 50");
    for (const json& one : report["worst"]) {
      const Way& way = kWays.at(first + one["ray"].get<std::size_t>());
      ASSERT_TRUE(lines.contains(way.name)) << way.name;
      const auto& [file, line] = lines.at(way.name);
      const std::string what = one["what"];
      expect_parts(what, {way.words});
      EXPECT_NE(what.find(" at " + file + ":" + std::to_string(line)), std::string::npos)
          << way.name << ": " << what << ", not line " << line;
      const json& at = one["failed"]["at"];
      ASSERT_FALSE(at.is_null()) << way.name;
      EXPECT_EQ(at["file"], file) << way.name;
      EXPECT_EQ(at["line"], line) << way.name;
      expect_parts(at["text"].get<std::string>(), {way.name});
      ++reported;
    }
  }
  EXPECT_EQ(reported, all);
}

TEST(FailingLine, is_reported_for_cmake_builds) {
  const std::string folder = temporary_folder("lines_of_cmake");
  fs::create_directory(folder + "/src");
  fs::copy_file(RAYCHECK_SOURCE_DIR "/tests/candidates/dies.cpp", folder + "/src/dies.cxx");
  fs::copy_file(RAYCHECK_SOURCE_DIR "/tests/candidates/dies_elsewhere.h",
                folder + "/src/dies_elsewhere.h");
  write(folder + "/CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.16)\nproject(dies CXX)\n"
        "set(CMAKE_CXX_STANDARD 20)\nadd_library(dies SHARED src/dies.cxx)\n");
  const std::string scene = temporary_file("death.toml", scene_of(17, 17));
  const json report = judged(scene, "source:" + folder);
  ASSERT_EQ(report["discrepancies"], 1);
  const json& at = report["worst"][0]["failed"]["at"];
  ASSERT_FALSE(at.is_null()) << report["worst"][0];
  EXPECT_EQ(at["file"], folder + "/src/dies_elsewhere.h");
  EXPECT_EQ(at["line"], named_lines()["in an inlined function of another file"].line);
}

TEST(FailingLine, is_missing_for_exits) {
  const json report =
      judged(temporary_file("ends.toml", scene_of(1, 1)), "source:tests/candidates/exits.cpp");
  ASSERT_EQ(report["discrepancies"], 1);
  EXPECT_TRUE(report["worst"][0]["failed"]["at"].is_null());
}

/// Candidates whose line tables claim that they crashed elsewhere.
TEST(HostileLines, AreAcceptedOnlyInTheCandidatesFolder) {
  const std::string folder = temporary_folder("claimed") + "/", own = folder + "own/";
  fs::create_directories(own);
  write(folder + "outside.h", "what is outside\n");
  fs::create_symlink(folder + "outside.h", own + "link.h");
  const std::vector<std::string> claims = {
      "2 \"" + own + "own.cpp\"", "1000 \"" + own + "own.cpp\"",   "1 \"" + own + "link.h\"",
      "1 \"" + own + "gone.h\"",  "1 \"" + own + "../outside.h\"", "1 \"/etc/passwd\"",
      "1 \"" + folder + "own\""};
  ASSERT_LT(claims.size(), properties::kMostFailuresSought);
  // A function for each claim, called from the claimed line.
  std::string functions, calls;
  for (std::size_t k = 0; k < claims.size(); ++k) {
    const std::string number = std::to_string(k), line = "\n#line " + claims[k] + "\n";
    functions += line + "[[gnu::noinline]] void die" + number + "() { *nowhere = " + number + "; }";
    calls += "case " + number + ":" + line + "die" + number + "(); break;\n";
  }
  write(own + "own.cpp",
        "#include <raycheck/candidate.hpp>\nint* volatile nowhere = nullptr;" + functions + R"(
std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray, const raycheck::Sphere&,
                                       const raycheck::Conventions&) {
  switch (int(ray.origin.x)) {
)" + calls + "}\nreturn {};\n}\nRAYCHECK_CANDIDATE(.intersect = intersect)\n");
  const std::string scene =
      temporary_file("claims.toml", scene_of(0, static_cast<int>(claims.size()) - 1));
  const json report = judged(scene, "source:" + own + "own.cpp", "--top 20");
  ASSERT_EQ(report["worst"].size(), claims.size()) << report.dump(2);
  for (const json& one : report["worst"]) {
    const std::size_t k = one["ray"];
    const json& at = one["failed"]["at"];
    EXPECT_EQ(has(one["what"].get<std::string>(), " at "), k == 0) << one;
    EXPECT_EQ(at.is_null(), k != 0) << claims.at(k) << at;
    if (k != 0) continue;
    expect_values(at, {{"line", 2}, {"text", "int* volatile nowhere = nullptr;"}});
  }
}

TEST(HostileLines, OfFramesAreReadOnlyInTheirExactForm) {
  using tools::frames_in;
  using Frames = std::vector<std::uint64_t>;
  EXPECT_EQ(frames_in("frames 1f 2\n"), (Frames{0x1f, 2}));
  EXPECT_EQ(frames_in("reply 1\n0 0\nframes 1f\nerror 1 why\n"), Frames{0x1f});
  EXPECT_EQ(frames_in("frames 1\nframes 2\n"), Frames{2});
  EXPECT_EQ(frames_in("frames ffffffffffffffff\n"), Frames{0xffffffffffffffff});
  std::string most = "frames", more;
  for (std::size_t k = 0; k < tools::kMostFrames; ++k) most += " 1";
  more = most + " 1\n";
  most += "\n";
  EXPECT_EQ(frames_in(most).size(), tools::kMostFrames);
  for (const std::string none :
       {more.c_str(), "", "frames 1f", "frames\n", "frames \n", "frames  1\n", "frames 1 \n",
        "frames g\n", "frames -1\n", "frames 0x1\n", "frames 10000000000000000\n", "framesets 1\n",
        "frames 1;rm\n"}) {
    EXPECT_TRUE(frames_in(none).empty()) << none;
  }
}

}  // namespace
}  // namespace raycheck::tests
