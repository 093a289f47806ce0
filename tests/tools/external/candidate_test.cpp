// External candidates, right and hostile, through `check --candidate`.

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

const std::string kCamera = "scene/examples/ten-spheres.toml";
const std::string kRays = "scene/examples/lecture-examples.toml";

constexpr const char* kFloats = RAYCHECK_SOURCE_DIR "/tests/candidates/float_quadratic.cpp";

/// Whether candidates run in bubblewrap here.
bool is_in_bubblewrap() {
  static const std::string isolated_by = judged(kRays, right_library())["isolated_by"];
  return has(isolated_by, "bubblewrap");
}

void expect_right(const std::string& scene, const std::string& candidate) {
  const json report = judged(scene, candidate);
  EXPECT_EQ(report["discrepancies"], 0) << candidate << "\n" << report.dump(2);
  std::uint64_t cases = 0;
  for (const json& quantity : report["quantities"]) cases += quantity["cases"].get<std::uint64_t>();
  EXPECT_GT(cases, 8u) << candidate;
}

TEST(Candidate, is_judged_if_raycheck_is_in_a_folder_that_other_users_may_not_enter) {
  const fs::path closed = temporary_folder("closed");
  fs::create_directories(closed / "lib");
  fs::create_directories(closed / "build/tools");
  const fs::path programs = fs::path(RAYCHECK_BINARY).parent_path();
  for (const char* name : {"raycheck", "raycheck-check", "raycheck-jail", "raycheck-worker"}) {
    fs::copy_file(programs / name, closed / "build/tools" / name);
  }
  fs::permissions(closed, fs::perms::owner_all);
  // The file is beside that folder, so that the compiler can read the folder that contains both.
  const std::string candidate = temporary_file("floats.cpp", contents(kFloats));
  const Outcome outcome = run_bash("cd '" RAYCHECK_SOURCE_DIR "' && exec '" + closed.string() +
                                   "/build/tools/raycheck' check scene/examples/optical-axis.toml "
                                   "--sandbox available --candidate 'source:" +
                                   candidate + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_parts(outcome.out, {"no discrepancy"});
  if (is_in_bubblewrap()) expect_parts(outcome.out, {"bubblewrap"});
}

/// kCamera under other conventions.
std::string corners() {
  return temporary_file("corners.toml",
                        contents(RAYCHECK_SOURCE_DIR "/" + kCamera) +
                            "[conventions]\nsamples = \"corners\"\nrows = \"top-first\"\n");
}

TEST(Candidate, follows_corners_of_a_scene) {
  const std::string scene = corners();
  expect_right(scene, right_library());
  expect_right(scene, "command:python3 tests/candidates/right.py");
}

TEST(Candidate, without_rays_receives_them_and_the_report_says_so) {
  const std::string meets = "command:python3 tests/candidates/meets.py none";
  const json right = judged(kCamera, meets);
  EXPECT_EQ(right["discrepancies"], 0) << right.dump(2);
  EXPECT_TRUE(right["given_rays"]);
  EXPECT_GT(right["quantities"][0]["cases"], 2000);
  EXPECT_FALSE(judged(kCamera, "command:python3 tests/candidates/right.py")["given_rays"]);
  EXPECT_FALSE(judged(kRays, meets)["given_rays"]);
  expect_parts(run("check " + kCamera + " --candidate '" + meets + "'").out,
               {"has no pixel_ray(): is given raycheck's rays"});
}

TEST(Candidate, that_is_wrong_on_given_rays_has_pixels_and_explanations_in_its_report) {
  const std::string proofs = temporary_file("proofs", "");
  const json wrong = judged(kCamera, "command:python3 tests/candidates/meets.py far-root",
                            "--certificates " + proofs);
  EXPECT_GT(wrong["discrepancies_by_standing"]["defect"], 0);
  ASSERT_FALSE(wrong["worst"].empty());
  for (const json& one : wrong["worst"]) {
    ASSERT_EQ(one["pixel"].size(), 2u) << one.dump(2);
    EXPECT_EQ(one["ray"].get<int>() % 16, one["pixel"][0].get<int>());
  }
  expect_parts(wrong["explanations"].dump(), {"the far root is taken"});
  run_python("tools/verify_certificates.py " + proofs, 0);
}

TEST(Candidate, without_rays_is_judged_by_laws_on_cameras_too) {
  const auto campaign = [](const std::string& mistake, int exit_code) {
    return report_of("properties --filter nearest-root --source course --cases 40",
                     "command:python3 tests/candidates/meets.py " + mistake,
                     exit_code)["campaigns"][0];
  };
  EXPECT_EQ(campaign("none", 0)["given_rays"], 40);
  const json wrong = campaign("far-root", 1);
  // After shrinking, the case has one of the rays that the candidate received, in short numbers.
  const std::string shrunk = wrong["scene"];
  EXPECT_FALSE(has(shrunk, "[camera]"));
  EXPECT_EQ(shrunk.find("[[ray]]"), shrunk.rfind("[[ray]]"));
  EXPECT_EQ(shrunk.find("[[sphere]]"), shrunk.rfind("[[sphere]]"));
  EXPECT_LT(shrunk.size(), 150u);
  expect_parts(wrong["explanations"].dump(), {"the far root is taken"});
}

TEST(Candidate, keeps_every_law_on_ordinary_cases) {
  expect_parts(run("properties --cases 300 --candidate " + right_library(), 0).out,
               {"states no error bounds, so those of direct/cross apply"});
}

/// The report of `properties` on right.cpp with `from` replaced by `to`.
auto altered(const std::string& from, const std::string& to) {
  const std::string source =
      replaced(contents(RAYCHECK_SOURCE_DIR "/tests/candidates/right.cpp"), from, to);
  const std::string name = std::to_string(std::hash<std::string>()(to)) + ".cpp";
  const std::string library = compiled(temporary_file(name, source));
  return [library](const std::string& more) {
    return printed_json("properties --candidate " + library + " " + more);
  };
}

TEST(Candidate, that_is_slightly_wrong_breaks_only_the_matching_law) {
  std::set<std::string> broken;
  const auto wrong = altered("return Hit{s, out(", "return Hit{s * (1 + 0x1p-46), out(");
  const json report = wrong("--cases 300");
  for (const json& campaign : report["campaigns"]) {
    if (campaign["finding"] == "broken") broken.insert(campaign["law"]);
  }
  EXPECT_EQ(broken, std::set<std::string>{"parameter"});
}

TEST(Candidate, is_judged_by_its_declared_level_and_lengths) {
  const auto stating = altered(
      ".nearest = nearest,",
      ".nearest = nearest, .level = Level::demanding, .smallest_length = 1e-9, .largest_length = "
      "1e9,");
  const auto campaign = [&](const std::string& more) {
    return stating("--filter class --cases 100 " + more)["campaigns"][0];
  };
  const json demanding = campaign("--source rays");
  expect_values(demanding, {{"level", "demanding"}, {"finding", "holds"}, {"not_judged", 0}});
  EXPECT_EQ(campaign("--source rays --level ordinary")["level"], "ordinary");
  const json of_other_lengths = campaign("--source scale@100");
  expect_values(of_other_lengths, {{"finding", "not judged here"}, {"not_judged", 100}});
}

TEST(Candidate, is_judged_by_the_bounds_of_the_chosen_method) {
  const auto worse = altered("return Hit{s, out(", "s *= 1 + 0x1p-30; return Hit{s, out(");
  const std::string asked = "--filter parameter --cases 200 --source rays";
  const json by_default = worse(asked);
  EXPECT_EQ(by_default["campaigns"][0]["finding"], "broken");
  EXPECT_EQ(by_default["borrowed_bounds"][0]["methods"], "direct/cross");
  const json single = worse(asked + " --bounds direct/single-quadratic");
  EXPECT_EQ(single["campaigns"][0]["finding"], "holds");
  EXPECT_EQ(single["borrowed_bounds"][0]["methods"], "direct/single-quadratic");
}

TEST(Candidate, is_right_as_a_cmake_project_with_eigen) {
  const std::string folder = temporary_folder("right") + "/";
  fs::copy_file(RAYCHECK_SOURCE_DIR "/tests/candidates/right.cpp", folder + "right.cpp");
  std::ofstream(folder + "CMakeLists.txt")
      << "cmake_minimum_required(VERSION 3.20)\nproject(right CXX)\n"
         "set(CMAKE_CXX_STANDARD 20)\nfind_package(Eigen3 REQUIRED)\n"
         "add_library(right SHARED right.cpp)\n"
         "target_link_libraries(right Eigen3::Eigen)\n";
  expect_right(kCamera, "source:" + folder + "CMakeLists.txt");
}

TEST(Candidate, is_right_in_java) {
  if (!is_installed("javac")) GTEST_SKIP() << "Java is not installed";
  const std::string folder = temporary_folder("java");
  const std::string words = "javac -d " + folder +
                            " " RAYCHECK_SOURCE_DIR
                            "/tools/external/adapters/RaycheckCandidate.java " RAYCHECK_SOURCE_DIR
                            "/tests/candidates/Right.java";
  ASSERT_EQ(std::system(words.c_str()), 0);
  expect_right(kRays, "command:java -cp " + folder + " Right");
}

TEST(Candidate, can_read_folders_and_headers_given_by_options) {
  const std::string folder = temporary_folder("shown");
  std::ofstream(folder + "/right.h") << contents(kFloats);
  std::ofstream(folder + "/beside.py")
      << contents(RAYCHECK_SOURCE_DIR "/tests/candidates/right.py");
  // Headers in folders below the source's are found anyway.
  const std::string source = temporary_folder("source") + "/shown.cpp";
  std::ofstream(source) << "#include \"right.h\"\n";
  const std::string program = temporary_file("shows.py", "import runpy\nrunpy.run_path('" + folder +
                                                             "/beside.py', run_name='__main__')\n");
  for (const auto& [candidate, option] :
       {std::pair("source:" + source, "--include "), {"command:python3 " + program, "--read "}}) {
    const std::string words = "check " + kRays + " --candidate '" + candidate + "' ";
    run(words + option + folder, 0);
    if (is_in_bubblewrap()) {
      const Outcome hidden = run(words);
      EXPECT_EQ(hidden.exit_code, 2) << candidate << hidden.out;
      expect_parts(hidden.err,
                   {"add a folder by --read DIR, or a folder of headers by --include DIR"});
    }
  }
  run("check " + kRays + " --candidate 'source:" + source + "' --include /no/such", 2);
}

TEST(Candidate, in_JavaScript_can_implement_all_functions) {
  if (!is_installed("node")) GTEST_SKIP() << "Node is not installed";
  const std::string folder = temporary_folder("javascript");
  for (const char* name :
       {"/tests/candidates/right.mjs", "/tools/external/adapters/raycheck_candidate.mjs"}) {
    const fs::path from = std::string(RAYCHECK_SOURCE_DIR) + name;
    fs::copy_file(from, fs::path(folder) / from.filename());
  }
  expect_right(kRays, "command:node " + folder + "/right.mjs");
  expect_right(kCamera, "command:node " + folder + "/right.mjs");
  expect_right(corners(), "command:node " + folder + "/right.mjs");
}

/// The error message for a candidate that cannot be run.
std::string refusal_of(const std::string& candidate, const std::string& more = "") {
  return run("check " + kRays + " --candidate '" + candidate + "' " + more, 2).err;
}

TEST(Candidate, in_Python_reports_its_errors_with_their_lines) {
  const auto candidate = [](const std::string& lines) {
    return "command:python3 " +
           temporary_file("mistaken.py", "import raycheck_candidate as rc\n" + lines);
  };
  const json report = judged(kRays, candidate("def intersect(ray, sphere, conventions):\n"
                                              "    return 1 / 0\n"
                                              "rc.run('mine', intersect=intersect)\n"));
  expect_parts(
      report["worst"].dump(),
      {"intersect: it failed: ZeroDivisionError: division by zero (", "mistaken.py, line 3)"});
  expect_parts(refusal_of(candidate("rc.run('mine', interset=print)\n")),
               {"no such function: interset; the functions are frame, pixel_point"});
  expect_parts(refusal_of(candidate("print('hello')\nrc.run('mine', nearest=print)\n")),
               {"its first line is 'hello', not 'raycheck 1 NAME'; print only"});
}

TEST(Candidate, in_JavaScript_reports_its_errors) {
  if (!is_installed("node")) GTEST_SKIP() << "Node is not installed";
  const std::string folder = temporary_folder("wrong-javascript");
  fs::copy_file(RAYCHECK_SOURCE_DIR "/tools/external/adapters/raycheck_candidate.mjs",
                folder + "/raycheck_candidate.mjs");
  const auto candidate = [&](const std::string& text) {
    std::ofstream(folder + "/it.mjs") << "import { run } from './raycheck_candidate.mjs';\n"
                                      << text;
    return "command:node " + folder + "/it.mjs";
  };
  expect_parts(refusal_of(candidate("throw new Error('no library')")),
               {"it exited with 1; it printed: Error: no library\n"});
  for (const auto& [roots, wrong] :
       {std::pair("5", "has '5', not one of [], [), (], ()"),
        {"{ tmin: 1 }", "no such roots: tmin"},
        {"0", "has '0', not one of []"},
        {"'as-asked', root: 'smallest'", "'smallest', not one of nearest, smaller"}}) {
    expect_parts(refusal_of(candidate(std::string("run('it', { intersect: () => null, roots: ") +
                                      roots + " })")),
                 {wrong});
  }
  for (const char* hit : {"0", "NaN", "[]"}) {
    const json report = judged(
        kRays,
        candidate(std::string("run('it', { returns: 'class', intersect: () => ") + hit + " })"));
    expect_parts(report["worst"].dump(), {"neither true nor false"});
  }
  // The program reserves address space, but does not use it.
  const std::string wasm = candidate(
      "new WebAssembly.Memory({ initial: 1, maximum: 65536 });\nrun('it', { intersect: () => null "
      "})");
  expect_parts(
      refusal_of(wasm),
      {"it may use, and each of its processes reserve, at most 4096 MiB of memory (--memory)"});
  EXPECT_GT(judged(kRays, wasm, "--memory 65536")["discrepancies"], 0);
}

TEST(Candidate, is_reported_with_the_limit_that_it_met_and_its_last_message) {
  const auto says = [](const std::string& text) {
    return refusal_of("command:python3 " +
                      temporary_file("says.py", "import sys\nsys.exit('" + text + "')\n"));
  };
  const std::string thread = says(
      "Exception in thread main java.lang.OutOfMemoryError: unable to create native thread: "
      "possibly out of memory\\n\\tat Mine.main(Mine.java:3)");
  expect_parts(thread, {"it printed: Exception in thread main",
                        "it may have at most 64 processes and threads"});
  EXPECT_FALSE(has(thread, "MiB of memory"));
  expect_parts(says("MemoryError"), {"at most 4096 MiB of memory (--memory)"});
}

TEST(Candidate, is_judged_by_campaigns_and_replays) {
  const std::string candidate = "--candidate 'command:python3 tests/candidates/right.py'";
  run("properties --filter nearest-root --source rays --cases 60 " + candidate, 0);
  const Outcome broken =
      run("properties --filter class --source direction-length --level extreme --cases 200 " +
              candidate,
          1);
  const std::string replay = behind("replay: raycheck ", broken.out);
  ASSERT_NE(replay, "") << broken.out;
  run(replay, 1);
}

TEST(Candidate, may_be_in_a_folder_that_other_users_may_not_read) {
  const std::string folder = temporary_folder("closed");
  for (const std::string name : {"right.py", "float_quadratic.cpp"}) {
    fs::copy_file(RAYCHECK_SOURCE_DIR "/tests/candidates/" + name, folder + "/" + name);
  }
  fs::permissions(folder, fs::perms::owner_all);
  // The candidate can read a named file even if other users may not.
  fs::permissions(folder + "/float_quadratic.cpp", fs::perms::owner_read);
  expect_right(kRays, "command:python3 " + folder + "/right.py");
  expect_right(kRays, "source:" + folder + "/float_quadratic.cpp");
  // If raycheck runs as root, the candidate does not.
  const json open = judged(kRays, "command:python3 tests/candidates/right.py");
  EXPECT_EQ(judged(kRays, "command:python3 " + folder + "/right.py")["isolated_by"],
            open["isolated_by"]);
}

/// A way in which tests/candidates/hostile.py fails, and the report of `check`.
struct Hostile {
  const char* how;
  const char* what;   ///< Part of the report.
  const char* layer;  ///< The layer that prevents it.
};
void PrintTo(const Hostile& hostile, std::ostream* out) { *out << hostile.how; }

class EachHostile : public testing::TestWithParam<Hostile> {};

TEST_P(EachHostile, GainsNothing) {
  const auto& [how, what, layer] = GetParam();
  const std::string one_question =
      temporary_file("one.toml", ray_text("0, 0, 0", "0, 0, 1") + sphere_text("9, 0, 5", "2"));
  const std::string secret = temporary_file(std::string(how) + ".secret", "the expected answers");
  ASSERT_EQ(chmod(secret.c_str(), 0600), 0);
  // Candidates that never end get a short limit.
  const bool is_endless = has(what, "1 s");
  const json report =
      judged(one_question,
             "command:python3 tests/candidates/hostile.py " + std::string(how) + " " + secret,
             is_endless ? "--timeout 1" : "--timeout 3");
  const bool is_kept = report["isolated_by"].get<std::string>().find(layer) != std::string::npos;
  if (!is_kept) GTEST_SKIP() << "here works only: " << report["isolated_by"];
  EXPECT_GT(report["discrepancies"], 0);
  expect_parts(report["worst"].dump(), {what});
  EXPECT_EQ(contents(secret), "the expected answers");
  fs::remove(secret);
}

INSTANTIATE_TEST_SUITE_P(
    Ways, EachHostile,
    testing::Values(
        Hostile{"exit", "it exited with 0", ""}, Hostile{"crash", "it was killed by signal 6", ""},
        Hostile{"loop", "it gave no reply within 1 s of CPU time", ""},
        Hostile{"sleep", "it gave no reply, and used almost no CPU time for 1 s", ""},
        Hostile{"output", "it replied with more than", ""}, Hostile{"memory", "refused: ", ""},
        Hostile{"fork", "refused: BlockingIOError", "own user"},
        Hostile{"write", "refused: ", "own user"}, Hostile{"read", "refused: ", "own user"},
        Hostile{"preload", "refused: ", "own user"},
        Hostile{"socket", "refused: PermissionError", "seccomp"},
        Hostile{"parent", "refused: ", "bubblewrap"},
        Hostile{"score", "its reply begins with 'score 100'", ""},
        Hostile{"short", "its reply begins with 'reply'", ""}, Hostile{"nothing", "class", ""}),
    [](const auto& the_test) { return std::string(the_test.param.how); });

/// Its first time-out takes ten limits, so that no further question is asked.
TEST(Candidate, that_mostly_waits_is_waited_for_once) {
  const std::string waits = temporary_file("waits.py", R"(import time
import raycheck_candidate as rc
def intersect(ray, sphere, conventions):
  while True:
    time.sleep(0.1)
    began = time.process_time()
    while time.process_time() < began + 0.004: pass
rc.run("waits", intersect=intersect)
)");
  const json report = judged(kRays, "command:python3 " + waits, "--timeout 0.5");
  EXPECT_EQ(report["failures"]["found"], 0) << report["failures"];
  expect_parts(report["worst"].dump(), {"not called any more", "the last: ", " s of waiting"});
}

TEST(Candidate, cannot_judge_itself_from_its_library_or_affect_others) {
  // It prints a full score and right answers before any request.
  const std::string boasts =
      "library:" + built_submission("hostile.cpp", "boasts", temporary_folder("boasts"));
  const json report =
      report_of("check " + kRays + " --candidate source:tests/candidates/exits.cpp --candidate " +
                    right_library() + " --intersect robust",
                boasts, 1)["candidates"];
  ASSERT_EQ(report.size(), 4u);
  expect_values(report[0], {{"name", "direct/robust"}, {"isolated_by", nullptr}});
  expect_parts(report[1]["worst"].dump(), {"it exited with 0"});
  EXPECT_EQ(report[2]["discrepancies"], 0);
  EXPECT_GT(report[3]["discrepancies"], 3);
  EXPECT_GT(quantity_of(report[3]["quantities"], "parameter")["max"], 1e10);
}

TEST(Candidate, is_isolated_as_requested) {
  const std::string right = "command:python3 tests/candidates/right.py";
  EXPECT_EQ(judged(kRays, right, "--sandbox none --i-know")["isolated_by"], "limits only");
  const Outcome required = check(kRays, right, "--sandbox require");
  if (required.exit_code == 2) {
    expect_parts(required.err, {"sandbox require: not available here: "});
  } else {
    const std::string kept = json::parse(required.out)["candidates"][0]["isolated_by"];
    expect_parts(kept, {"seccomp, bubblewrap"});
  }
}

TEST(Candidate, that_does_not_build_or_has_unknown_functions_or_declarations_is_refused) {
  const std::string declaring =
      "#include <raycheck/candidate.hpp>\nusing namespace raycheck;\nRAYCHECK_CANDIDATE(";
  for (const auto& [text, why] : {std::pair<std::string, const char*>("int main( {\n", "error: "),
                                  {"int x;\n", "raycheck_candidate_functions"},
                                  {declaring + ".rows = static_cast<Rows>(7))\n",
                                   "rows = 7: expected 1 (bottom-first), 2 (top-first)"},
                                  {declaring + ".precision = static_cast<Precision>(7))\n",
                                   "precision = 7: expected 0 (double)"}}) {
    const std::string source = temporary_file("broken.cpp", text);
    expect_refused("check " + kRays + " --candidate source:" + source, why);
  }
}

}  // namespace
}  // namespace raycheck::tests
