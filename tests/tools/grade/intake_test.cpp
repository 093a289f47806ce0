// Submissions that nobody wrote for raycheck are built as they come.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<std::pair<std::string, std::string>>;

/// White pictures of the size that the driver file says.
const std::string kCpp = R"(#include <fstream>
#include <string>
#include "white.h"
int main(int, char** argv) {
  std::ifstream driver(argv[1]);
  int width = 0, height = 0;
  for (std::string word; driver >> word;) {
    if (word == "res") driver >> width >> height;
  }
  std::ofstream image(argv[2]);
  image << "P3 " << width << " " << height << " 255\n";
  for (int k = 0; k < width * height; ++k) image << white();
}
)";
const std::string kWhiteHeader = "const char* white();\n";
const std::string kWhiteSource =
    "#include \"white.h\"\nconst char* white() { return \"255 255 255 \"; }\n";
const std::string kC = R"(#include <math.h>
#include <stdio.h>
int main(int count, char** words) {
  char line[1000];
  int width = 0, height = 0;
  FILE* driver = fopen(words[1], "r");
  while (fgets(line, sizeof line, driver)) sscanf(line, "res %d %d", &width, &height);
  FILE* image = fopen(words[2], "w");
  fprintf(image, "P3 %d %d 255\n", width, height);
  for (int k = 0; k < width * height; ++k) fprintf(image, "255 %.0f 255 ", sqrt(65025.0 + 0 * count));
  fclose(image);
  return 0;
}
)";
const std::string kJava = R"(package de.uni;
import java.nio.file.*;
public class Main {
  public static void main(String[] words) throws Exception {
    for (String line : Files.readAllLines(Path.of(words[0]))) {
      if (!line.startsWith("res")) continue;
      int width = Integer.parseInt(line.split(" ")[1]), height = Integer.parseInt(line.split(" ")[2]);
      Files.writeString(Path.of(words[1]),
          "P3 " + width + " " + height + " 255\n" + util.White.of(width * height));
    }
  }
}
)";
const std::string kJavaWhite =
    "package util;\npublic class White {\n"
    "  public static String of(int count) { return \"255 255 255 \".repeat(count); }\n}\n";
const std::string kNotebook = R"({"nbformat": 4, "cells": [
  {"cell_type": "markdown", "source": ["# Rays\n", "not code"]},
  {"cell_type": "code", "source": ["%matplotlib inline\n", "import sys\n", "!pip install numpy\n",
    "def size(path):\n", "    for line in open(path):\n", "        if line.startswith('res'):\n",
    "            return tuple(map(int, line.split()[1:3]))\n"]},
  {"cell_type": "code", "source": ["%%bash\n", "ls -l\n"]},
  {"cell_type": "code", "source": "w, h = size(sys.argv[1])\nopen(sys.argv[2], 'w').write(f'P3 {w} {h} 255\\n' + '255 255 255 ' * (w * h))\n"}
]})";

class Intake : public testing::Test {
 protected:
  void SetUp() override { grading_.write("full.toml", kFullScene); }

  std::string submit(const std::string& name, const Files& files) const {
    for (const auto& [file, text] : files) grading_.write("class/" + name + "/" + file, text);
    return grading_.path("class/" + name);
  }
  nlohmann::json graded(const std::string& name, const std::string& head = "") const {
    const std::string rubric = grading_.write("auto.toml", full_rubric(1, head));
    grading_.grade(rubric, {grading_.path("class/" + name)});
    return grading_.result(name);
  }
  /// The submission is built, and right.
  nlohmann::json expect_full(const std::string& name, const Files& files) const {
    submit(name, files);
    nlohmann::json result = graded(name);
    EXPECT_EQ(result["score"], 10) << name << "\n" << result.dump(2);
    return result;
  }
  /// It is refused, and what is said has these parts.
  void expect_refused(const std::string& name, const Files& files,
                      const std::vector<std::string>& parts, const std::string& head = "") const {
    submit(name, files);
    const nlohmann::json result = graded(name, head);
    ASSERT_TRUE(result["refused"].is_object()) << result.dump(2);
    const std::string all = result["refused"]["why"].get<std::string>() + "\n" +
                            result["refused"]["said"].get<std::string>();
    for (const std::string& part : parts) expect_parts(all, {part});
  }
  Grading grading_;
};

/// What takes long to build, or is tried in many forms.
class LongIntake : public Intake {};

Files with(const Files& files, const Files& more) {
  Files all = files;
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

const Files kSources = {{"rt.cpp", kCpp}, {"white.cpp", kWhiteSource}, {"white.h", kWhiteHeader}};

TEST_F(Intake, builds_by_a_makefile_whatever_it_calls_the_program) {
  const auto result = expect_full(
      "make", with(kSources, {{"makefile",
                               "OBJECTS = rt.o white.o\nfirst: bin/shiny\nbin/shiny: $(OBJECTS)\n"
                               "\tmkdir -p bin\n\tg++ -o $@ $(OBJECTS)\n"},
                              {"rt.o", "of another machine"}}));
  expect_parts(result["program"], {"./bin/shiny"});
}

TEST_F(Intake, builds_by_a_makefile_in_a_folder_below_and_takes_none_of_the_programs_handed_in) {
  const std::string folder = submit("below", {{"report.txt", "see src"},
                                              {"src/rt.c", kC},
                                              {"src/Makefile", "rt: rt.c\n\tcc -o rt rt.c -lm\n"}});
  fs::copy("/bin/false", folder + "/src/rt");
  EXPECT_EQ(graded("below")["score"], 10);
}

TEST_F(Intake, builds_from_sources_where_a_makefile_fails_and_says_so) {
  const auto result = expect_full(
      "fails", with(kSources, {{"Makefile", "rt: rt.cpp\n\tclang++-99 -o rt rt.cpp white.cpp\n"}}));
  EXPECT_EQ(result["notes"][0], "its Makefile failed; built from its sources");
}

TEST_F(Intake, builds_by_cmake) {
  const auto result = expect_full(
      "cmake", {{"CMakeLists.txt",
                 "cmake_minimum_required(VERSION 3.10)\nproject(rays CXX)\n"
                 "add_library(helper STATIC src/white.cpp)\n"
                 "add_executable(shiny src/rt.cpp)\ntarget_link_libraries(shiny helper)\n"},
                {"src/rt.cpp", kCpp},
                {"src/white.cpp", kWhiteSource},
                {"src/white.h", kWhiteHeader},
                {"build/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=/home/someone\n"}});
  expect_parts(result["program"], {"shiny"});
}

/// A program of a likelier name than the renderer's, which draws nothing.
const std::string kChecks =
    "#include <cstdio>\nint main() { std::puts(\"all is well\"); return 0; }\n";

TEST_F(LongIntake, runs_of_several_programs_that_are_built_the_one_that_draws) {
  const auto result = expect_full(
      "several", with(kSources, {{"CMakeLists.txt",
                                  "cmake_minimum_required(VERSION 3.10)\nproject(shiny CXX)\n"
                                  "add_executable(rt checks.cpp)\nset(NAME ${PROJECT_NAME})\n"
                                  "add_executable(${NAME} rt.cpp white.cpp)\n"},
                                 {"checks.cpp", kChecks}}));
  expect_parts(result["program"], {"./raycheck-build/shiny "});
  EXPECT_EQ(result["notes"][0], "2 programs are built; ./raycheck-build/shiny is run");
  const auto again = graded("several", "title = \"again, from the store\"\n");
  EXPECT_EQ(again["build_is_stored"], true);
  EXPECT_EQ(again["score"], 10) << again.dump(2);
  expect_full("makes", with(kSources, {{"Makefile",
                                        "all: rt shiny\nrt: checks.cpp\n\tg++ -o rt checks.cpp\n"
                                        "shiny: rt.cpp white.cpp\n\tg++ -o shiny $^\n"},
                                       {"checks.cpp", kChecks}}));
}

TEST_F(LongIntake, builds_in_another_way_what_draws_nothing_by_its_makefile) {
  const Files files = with(
      kSources,
      {{"Makefile", "check: checks.cpp\n\tg++ -o check checks.cpp\n"}, {"checks.cpp", kChecks}});
  const auto result = expect_full("other", files);
  EXPECT_EQ(result["notes"][1],
            "nothing that draws comes from its Makefile; built from its sources");
  expect_parts(result["program"], {"./raycheck-built "});
  auto again = graded("other", "title = \"again, from the store\"\n");
  EXPECT_EQ(again["build_is_stored"], true);
  for (const char* key : {"program", "build", "driver", "notes", "score"}) {
    EXPECT_EQ(again[key], result[key]) << key;
  }
}

/// The Makefile's program fails; the other, of its sources, ends without a picture.
TEST_F(LongIntake, says_of_several_ways_to_build_what_the_one_that_comes_farthest_says) {
  const Files files = {
      {"Makefile",
       "check:\n\techo 'int main() { return 3; }' > check.c\n"
       "\tgcc -o check check.c\n"},
      {"rt.cpp", "#include <cstdio>\nint main() { std::puts(\"no such key\"); }\n"}};
  expect_refused("farther", files, {"it made no picture {image}; it said: no such key"});
  EXPECT_EQ(graded("farther")["notes"][0],
            "nothing that draws comes from its Makefile; built from its sources");
  expect_refused("no-farther", {files[0], {"rt.cpp", "int main() { return 4; }\n"}},
                 {"it exited with 3"});
}

TEST_F(LongIntake, tries_programs_that_are_called_tests_last) {
  // This one draws, too.
  const auto result = expect_full(
      "tests", with(kSources,
                    {{"CMakeLists.txt",
                      "cmake_minimum_required(VERSION 3.10)\nproject(shiny CXX)\n"
                      "add_subdirectory(unit)\nadd_executable(shiny rt.cpp white.cpp)\n"},
                     {"unit/CMakeLists.txt", "add_executable(test_rt ../rt.cpp ../white.cpp)\n"}}));
  expect_parts(result["program"], {"./raycheck-build/shiny "});
}

TEST_F(LongIntake, says_of_several_programs_what_the_likeliest_says_where_none_draws) {
  expect_refused("none",
                 {{"CMakeLists.txt",
                   "cmake_minimum_required(VERSION 3.10)\nproject(shiny CXX)\n"
                   "add_executable(checks checks.cpp)\nadd_executable(rt rt.cpp)\n"},
                  {"checks.cpp", kChecks},
                  {"rt.cpp", "#include <cstdio>\nint main() { std::puts(\"no such key\"); }\n"}},
                 {"it made no picture {image}; it said: no such key"});
}

TEST_F(Intake, compiles_plain_sources_wherever_they_lie) {
  expect_full("plain", {{"Main.CPP", kCpp},
                        {"source/white.cc", kWhiteSource},
                        {"include/white.h", kWhiteHeader},
                        {"test/test.cpp", "int main() { return 1; }\n"},
                        {"__MACOSX/._rt.cpp", "binary"}});
  expect_full("c", {{"rt.c", kC}});
}

TEST_F(Intake, compiles_what_only_older_standards_take) {
  std::string old = kCpp;
  old.replace(old.find("int main"), 0, "struct concept {} requires;\n");
  expect_full("old", {{"rt.cpp", old}, {"white.cpp", kWhiteSource}, {"white.h", kWhiteHeader}});
}

TEST_F(Intake, takes_the_likeliest_of_several_mains) {
  const auto result =
      expect_full("two", with(kSources, {{"another.cpp", "int main() { return 1; }\n"}}));
  ASSERT_FALSE(result["notes"].empty());
  EXPECT_EQ(result["notes"][0], "2 of its files have a main; this is that of rt.cpp");
}

TEST_F(Intake, leaves_out_sources_that_do_not_compile_and_that_nothing_includes) {
  expect_full("stray", with(kSources, {{"attempt.cpp", "this is no C++\n"}}));
}

TEST_F(LongIntake, finds_eigen_wherever_it_was) {
  if (!fs::exists("/usr/include/eigen3")) GTEST_SKIP() << "Eigen is not installed";
  const std::string use =
      "int unused() { return static_cast<int>(Eigen::Vector3d::Zero().size()); }\n";
  expect_full("missing",
              with(kSources, {{"one.cpp", "#include \"../../libs/eigen/Eigen/Core\"\n" + use}}));
  expect_full("makefile", with(kSources, {{"one.cpp", "#include <eigen3/Eigen/Core>\n" + use},
                                          {"Makefile",
                                           "rt: rt.cpp white.cpp one.cpp\n"
                                           "\tg++ -I/opt/eigen -o rt $^\n"}}));
  // Someone's own: what lies in it is not compiled.
  expect_full("vendored",
              with(kSources, {{"one.cpp", "#include <Eigen/Dense>\nint two() { return kTwo; }\n"},
                              {"libs/eigen-3.4/Eigen/Dense", "constexpr int kTwo = 2;\n"},
                              {"libs/eigen-3.4/bench/bench.cpp", "no C++\n"}}));
}

TEST_F(Intake, finds_headers_by_names_of_other_systems) {
  std::string shouting = kCpp;
  shouting.replace(shouting.find("white.h"), 7, "..\\\\Include\\\\White.h");
  const auto result = expect_full("windows", {{"src/rt.cpp", shouting},
                                              {"src/white.cpp", kWhiteSource},
                                              {"include/white.h", kWhiteHeader}});
  EXPECT_FALSE(result["notes"].empty());
}

TEST_F(Intake, adds_headers_that_gcc_says_are_missing) {
  std::string use = "std::tuple<int, std::optional<int>> unused() { return {1, 2}; }\n";
  const auto result =
      expect_full("headers", with(kSources, {{"one.cpp", "#include \"white.h\"\n" + use}}));
  EXPECT_EQ(result["notes"].size(), 2u) << result["notes"];
  expect_parts(result["notes"].dump(),
               {"#include <tuple> is added to one.cpp, where it is missing"});
}

/// A folder that a form means is not unwrapped.
TEST_F(Intake, leaves_a_folder_that_a_form_names) {
  submit("named", {{"source/rt.c", kC}, {"source/Makefile", "rt: rt.c\n\tcc -o rt rt.c -lm\n"}});
  std::string rubric = full_rubric(1);
  rubric = rubric.substr(0, rubric.find("[[form]]")) +
           "[[form]]\nhas = \"*\"\nbuild = \"cd source && make\"\n"
           "candidate = \"renderer:./source/rt {scene} {image}\"\n" +
           rubric.substr(rubric.find("[[item]]"));
  grading_.grade(grading_.write("named.toml", rubric), {grading_.path("class/named")});
  EXPECT_EQ(grading_.result("named")["score"], 10);
}

TEST_F(LongIntake, builds_java_with_packages_and_jars) {
  if (!is_installed("javac")) GTEST_SKIP() << "Java is not installed";
  const std::string folder =
      submit("java", {{"src/de/uni/Main.java", kJava}, {"other/White.java", kJavaWhite}});
  const std::string jar = "cd '" + folder +
                          "' && mkdir -p lib && javac -d classes other/White.java && "
                          "jar cf lib/white.jar -C classes . && rm -r classes other\n";
  ASSERT_EQ(run_bash(temporary_file("jar.sh", jar)).exit_code, 0);
  const auto result = graded("java");
  EXPECT_EQ(result["score"], 10) << result.dump(2);
  EXPECT_EQ(result["program"],
            "renderer:java -cp raycheck-classes:.:lib/white.jar de.uni.Main {scene} {image}");
}

TEST_F(LongIntake, finds_classes_that_lie_unpacked_beside_the_sources) {
  if (!is_installed("javac")) GTEST_SKIP() << "Java is not installed";
  const std::string folder =
      submit("unpacked", {{"src/Main.java", kJava}, {"White.java", kJavaWhite}});
  const std::string words = "cd '" + folder + "' && javac -d . White.java && rm White.java\n";
  ASSERT_EQ(run_bash(temporary_file("javac.sh", words)).exit_code, 0);
  EXPECT_EQ(graded("unpacked")["score"], 10);
}

TEST_F(LongIntake, runs_classes_that_a_makefile_makes) {
  if (!is_installed("javac")) GTEST_SKIP() << "Java is not installed";
  const auto result =
      expect_full("javac", {{"Main.java", kJava},
                            {"White.java", kJavaWhite},
                            {"Makefile", "all:\n\tjavac -d bin Main.java White.java\n"}});
  EXPECT_EQ(result["program"], "renderer:java -cp ./bin:. de.uni.Main {scene} {image}");
  EXPECT_TRUE(result["notes"].empty()) << result["notes"];
}

TEST_F(LongIntake, names_the_package_whose_jar_is_missing) {
  if (!is_installed("javac")) GTEST_SKIP() << "Java is not installed";
  expect_refused("jar",
                 {{"Main.java", "import org.ejml.simple.SimpleMatrix;\n" + kJava.substr(16)}},
                 {"there is no package org.ejml.simple in it, so put the jar that has it beside"});
}

/// A module, of which package.json says that it is the program's, by a name without its ending.
TEST_F(Intake, runs_what_package_json_names) {
  if (!is_installed("node")) GTEST_SKIP() << "Node is not installed";
  expect_full(
      "module",
      {{"package.json", R"({"type": "module", "main": "./src/tracer"})"},
       {"src/tracer.js",
        "import fs from 'fs';\nconst [, , scene, image] = process.argv;\n"
        "const [w, h] = /res (\\d+) (\\d+)/.exec(fs.readFileSync(scene, 'utf8')).slice(1);\n"
        "fs.writeFileSync(image, `P3 ${w} ${h} 255\\n` + '255 255 255 '.repeat(w * h));\n"},
       {"rt.js", "console.log(process.argv.length);\n"}});
}

TEST_F(Intake, runs_notebooks) { expect_full("notebook", {{"Homework.ipynb", kNotebook}}); }

TEST_F(Intake, runs_a_program_without_sources) {
  const std::string folder = submit("built", {{"readme.txt", "no sources"}});
  const std::string source = temporary_file("rt.c", kC);
  ASSERT_EQ(run_bash(temporary_file("cc.sh", "gcc -o '" + folder + "/tracer' '" + source +
                                                 "' -lm && chmod -x '" + folder + "/tracer'\n"))
                .exit_code,
            0);
  EXPECT_EQ(graded("built")["score"], 10);
}

TEST_F(Intake, refuses_what_cannot_be_built_and_says_why) {
  expect_refused("windows", {{"rt.exe", "MZ"}}, {"rt.exe is a program of Windows"});
  expect_refused("library", {{"vec.cpp", "int one() { return 1; }\n"}},
                 {"none of its sources is a program's main one"});
  expect_refused("wrong", {{"rt.cpp", "int main() { return 0 }\n"}},
                 {"'g++ -O2 -std=c++20 rt.cpp' exited with 1", "error: expected"});
  expect_refused("target", {{"Makefile", "rt: missing.cpp\n"}},
                 {"'make' exited with 2", "missing.cpp"});
}

TEST_F(Intake, shows_the_first_and_the_last_of_what_a_compiler_says) {
  expect_refused("many",
                 {{"Makefile", "rt:\n\t@for k in $$(seq 60); do echo line $$k; done; false\n"}},
                 {"line 1\n", "line 12\n... ", " lines left out ...\n", "line 60\n"});
}

TEST_F(LongIntake, shows_what_a_program_says_that_makes_no_picture) {
  expect_refused("silent", {{"rt.py", "print('usage: rt WIDTH HEIGHT')\n"}},
                 {"it made no picture {image}; it said: usage: rt WIDTH HEIGHT"});
  expect_refused("fails", {{"rt.py", "raise ValueError('no such key: res')\n"}},
                 {"it exited with 1\nTraceback", "ValueError: no such key: res"});
}

/// In the forms that it reads it waits; the others it does not read.
TEST_F(LongIntake, shows_what_a_program_says_where_it_comes_farthest) {
  const std::string folder = submit("far", {{"rt.py",
                                             "import sys, time\nfor line in open(sys.argv[1]):\n"
                                             "    words = line.split()\n"
                                             "    if words[0] == 'sphere': last = words[17]\n"
                                             "time.sleep(60)\n"}});
  std::string rubric = full_rubric(1, "[limits]\nreply_seconds = 1\n");
  rubric.replace(rubric.find("\"B\""), 3, "\"auto\"");
  grading_.grade(grading_.write("far.toml", rubric), {folder});
  EXPECT_EQ(grading_.result("far")["refused"]["why"],
            "it did not end, and computed next to nothing for 1 s (reply_seconds)");
}

TEST_F(LongIntake, says_that_a_program_reads_whole_numbers_alone) {
  expect_refused("whole",
                 {{"rt.py", white_renderer("for line in open(sys.argv[1]):\n"
                                           "    [int(word) for word in line.split()[1:]]\n")}},
                 {"it reads numbers as integers, and fails where one has a fraction",
                  "ValueError: invalid literal for int()"});
}

TEST_F(LongIntake, finds_the_picture_under_another_name) {
  for (const char* const name : {"output.ppm", "images/result.ppm", "scene.ppm", "42.ppm"}) {
    expect_full(std::string("at-") + static_cast<char>('a' + name[0] % 26),
                {{"rt.py", white_renderer("os.makedirs('images', exist_ok=True)\n",
                                          "'" + std::string(name) + "'")}});
  }
}

TEST_F(Intake, names_the_limit_that_is_met) {
  const std::string head =
      "[limits]\nfile_mib = 1\nprocesses = 8\nmemory_mib = 300\n"
      "reply_seconds = 2\nsubmission_mib = 1\nfiles = 3\n";
  expect_refused("file",
                 {{"rt.c",
                   "#include <stdio.h>\nint main() { FILE* f = fopen(\"image.ppm\", \"w\");\n"
                   "for (int k = 0; k < 3000000; ++k) putc(65, f);\nreturn 0; }\n"}},
                 {"signal 25 (File size limit exceeded): a file may have at most 1 MiB (file_mib)"},
                 head);
  expect_refused("memory", {{"rt.py", "x = bytearray(1 << 30)\n"}},
                 {"it may use at most 300 MiB (memory_mib)", "MemoryError"}, head);
  expect_refused("time", {{"rt.py", "while True: pass\n"}},
                 {"did not end within 2 s of CPU time (reply_seconds)"}, head);
  expect_refused("threads",
                 {{"rt.py",
                   "import threading, time\nfor k in range(99):\n"
                   "    threading.Thread(target=time.sleep, args=(1,), daemon=True).start()\n"}},
                 {"it may have at most 8 processes and threads (processes)"}, head);
  expect_refused("large", {{"rt.py", std::string(2 << 20, ' ')}},
                 {"it has more than 1 MiB (submission_mib)"}, head);
  expect_refused("many", {{"1.py", ""}, {"2.py", ""}, {"3.py", ""}, {"4.py", ""}},
                 {"it has more than 3 files (files)"}, head);
  expect_refused("building", {{"Makefile", "rt:\n\tsleep 30\n"}},
                 {"did not end, and computed next to nothing for 1 s (build_seconds)"},
                 "[limits]\nbuild_seconds = 1\n");
}

TEST_F(Intake, counts_nothing_that_archives_and_compilers_leave_behind) {
  submit("left", {{"rt.c", kC},
                  {"Eigen.gch", std::string(2 << 20, 'x')},
                  {".git/objects/a", std::string(2 << 20, 'x')},
                  {"env/pyvenv.cfg", ""},
                  {"env/lib/big.py", std::string(2 << 20, 'x')}});
  EXPECT_EQ(graded("left", "[limits]\nsubmission_mib = 1\n")["score"], 10);
}

}  // namespace
}  // namespace raycheck::tests
