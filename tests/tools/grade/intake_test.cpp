// Submissions that were not written for raycheck are built automatically.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

using Files = std::map<std::string, std::string>;

const std::string kCpp = "#include \"format.h\"\n" + renderer_in_c("format()");
const std::string kFormatHeader = "const char* format();\n";
const std::string kFormatSource =
    "#include \"format.h\"\nconst char* format() { return \"%.0f %.0f %.0f \"; }\n";
/// It needs the mathematics library.
const std::string kC =
    "#include <math.h>\n" + renderer_in_c("sqrt(count) > 0 ? \"%.0f %.0f %.0f \" : \"\"");
const std::string kJava =
    "package de.uni;\npublic class Main {\n"
    "  public static void main(String[] words) throws Exception { util.Discs.main(words); }\n}\n";
const std::string kJavaDiscs = std::string("package util;\n") + kRendererInJava;
const std::string kNotebook =
    json({{"nbformat", 4},
          {"cells",
           {{{"cell_type", "markdown"}, {"source", {"# Rays\n", "not code"}}},
            {{"cell_type", "code"},
             {"source",
              {"%matplotlib inline\n", "import sys\n", "!pip install numpy\n",
               "name = sys.argv[2]\n"}}},
            {{"cell_type", "code"}, {"source", {"%%bash\n", "ls -l\n"}}},
            {{"cell_type", "code"}, {"source", renderer_in_python("", "name")}}}}})
        .dump();
/// A program that draws nothing and has a likelier name than the renderer.
const std::string kChecks = "#include <stdio.h>\nint main() { puts(\"all is well\"); return 0; }\n";
const std::string kNoSuchKey =
    "#include <stdio.h>\nint main() { puts(\"no such key\"); return 0; }\n";
const std::string kModule = R"(import fs from 'fs';
const [, , scene, image] = process.argv;
const words = name => new RegExp(`^${name} (.*)$`, 'm').exec(fs.readFileSync(scene, 'utf8'))[1].split(' ');
const [w, h] = words('res').map(Number);
const colour = words('sphere').slice(4, 7).map(x => Math.round(255 * x)).join(' ');
const seen = k => {
  const x = Math.abs(2 * (k % w) - w + 1), y = Math.abs(2 * Math.floor(k / w) - h + 1);
  const far = Math.max(x, y), near = Math.min(x, y);
  return h < 25 || far * far + near * near < 25 || (far - 15) ** 2 + near * near < 33;
};
const pixels = Array.from({length: w * h}, (_, k) => seen(k) ? colour : '0 0 0');
fs.writeFileSync(image, `P3 ${w} ${h} 255\n${pixels.join('\n')}\n`);
)";

/// A source that includes Eigen in any folder.
const std::string kUseOfEigen = "int unused() { return EIGEN_WORLD_VERSION; }\n";

Files with(Files files, const Files& more) {
  files.insert(more.begin(), more.end());
  return files;
}
const Files kSources = {
    {"rt.cpp", kCpp}, {"format.cpp", kFormatSource}, {"format.h", kFormatHeader}};

/// A submission, and its expected report.
struct Brought {
  const char* name;  ///< The expected outcome.
  Files files;
  std::string program = {};             ///< Part of its command line.
  std::vector<std::string> notes = {};  ///< Parts of the notes, in order.
  std::string needs = {};               ///< The test is skipped if this program is not installed.
  std::string limits = {};              ///< Keys of the rubric.
  /// Parts of the refusal; if empty, it must get all points.
  std::vector<std::string> refused = {};
};

void PrintTo(const Brought& brought, std::ostream* to) { *to << brought.name; }

/// A renderer in Python that chooses its output file itself, and the note about this.
Brought writing(const char* name, const std::string& to, const std::string& note,
                const std::string& before = "") {
  return {name, {{"rt.py", renderer_in_python(before, to)}}, "", {"it writes " + note}};
}

Brought refused(const char* name, const Files& files, const std::vector<std::string>& why,
                const std::string& limits = "", const std::vector<std::string>& notes = {}) {
  return {name, files, "", notes, "", limits, why};
}

const std::vector<Brought> kBuilt = {
    {"makes_a_program_whatever_it_is_called",
     with(kSources, {{"makefile",
                      "OBJECTS = rt.o format.o\nfirst: bin/shiny\nbin/shiny: $(OBJECTS)\n"
                      "\tmkdir -p bin\n\tg++ -o $@ $(OBJECTS)\n"},
                     {"rt.o", "of another machine"}}),
     "./bin/shiny"},
    // The submitted program is not mistaken for the built program.
    {"makes_a_program_in_a_folder_below",
     {{"report.txt", "see src"},
      {"src/rt.c", kC},
      {"src/rt", contents("/bin/false")},
      {"src/Makefile", "rt: rt.c\n\tcc -o rt rt.c -lm\n"}},
     "./src/rt"},
    {"is_compiled_where_its_makefile_fails_with_the_libraries_that_it_names",
     {{"rt.cpp", kCpp},
      {"format.cpp", replaced(kFormatSource, "return ", "return __gmp_version[0] == 0 ? \"\" : ")},
      {"format.h", kFormatHeader + "extern \"C\" const char* const __gmp_version;\n"},
      {"Makefile", "rt: rt.cpp\n\tclang++-99 -o rt rt.cpp format.cpp -lgmp -lnowhere\n"}},
     "./raycheck-built ",
     {"its Makefile failed; built from its sources"}},
    {"is_built_by_cmake_and_the_program_that_draws_is_run",
     {{"CMakeLists.txt",
       "cmake_minimum_required(VERSION 3.10)\nproject(shiny CXX)\nset(NAME ${PROJECT_NAME})\n"
       "add_library(helper STATIC src/format.cpp)\nadd_executable(rt src/checks.cpp)\n"
       "add_executable(${NAME} src/rt.cpp)\ntarget_link_libraries(${NAME} helper)\n"},
      {"src/rt.cpp", kCpp},
      {"src/format.cpp", kFormatSource},
      {"src/format.h", kFormatHeader},
      {"src/checks.cpp", kChecks},
      {"build/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=/home/someone\n"}},
     "./raycheck-build/shiny ",
     {"2 programs are built; ./raycheck-build/shiny is run"}},
    {"makes_several_programs_and_the_one_that_draws_is_run",
     {{"Makefile",
       "all: rt shiny\nrt: checks.c\n\tgcc -o rt checks.c\nshiny: rt.c\n\tgcc -o shiny rt.c -lm\n"},
      {"checks.c", kChecks},
      {"rt.c", kC}},
     "./shiny ",
     {"2 programs are built; ./shiny is run"}},
    {"makes_programs_of_which_those_called_tests_are_tried_last",
     {{"Makefile",
       "all:\n\tmkdir -p unit\n\tgcc -o unit/test_rt rt.c -lm\n\tgcc -o shiny rt.c -lm\n"},
      {"rt.c", kC}},
     "./shiny ",
     {"2 programs are built; ./shiny is run"}},
    {"is_compiled_wherever_its_sources_lie",
     {{"Main.CPP", kCpp},
      {"source/format.cc", kFormatSource},
      {"include/format.h", kFormatHeader},
      {"test/test.cpp", "int main() { return 1; }\n"},
      {"__MACOSX/._rt.cpp", "binary"}}},
    {"is_compiled_as_c", {{"rt.c", kC}}},
    {"is_compiled_by_an_older_standard",
     with({{"rt.cpp", replaced(kCpp, "int main", "struct concept {} requires;\nint main")}},
          kSources)},
    {"has_two_mains_of_which_the_likeliest_is_taken",
     with(kSources, {{"another.cpp", "int main() { return 1; }\n"}}),
     "",
     {"2 of its files have a main function; that of rt.cpp is used"}},
    {"has_a_source_that_does_not_compile_and_that_nothing_includes",
     with(kSources, {{"attempt.cpp", "this is not C++\n"}}),
     "",
     {"its sources failed; built from the sources that rt.cpp includes"}},
    {"has_a_makefile_and_a_source_that_both_fail",
     with(kSources, {{"Makefile", "rt:\n\tfalse\n"}, {"attempt.cpp", "this is not C++\n"}}),
     "",
     {"its Makefile and its sources failed; built from the sources that rt.cpp includes"}},
    {"finds_headers_by_names_of_other_systems",
     {{"src/rt.cpp", replaced(kCpp, "format.h", "..\\\\Include\\\\Format.h")},
      {"src/format.cpp", kFormatSource},
      {"include/format.h", kFormatHeader}},
     "",
     {" is replaced by "}},
    {"is_given_headers_that_gcc_says_are_missing",
     with(kSources, {{"one.cpp",
                      "#include \"format.h\"\n"
                      "std::tuple<int, std::optional<int>> unused() { return {1, 2}; }\n"
                      "auto digits() { return std::setprecision(2); }\n"}}),
     "",
     {"the missing #include <iomanip> is added to one.cpp",
      "the missing #include <tuple> is added to one.cpp",
      "the missing #include <optional> is added to one.cpp"}},
    {"is_given_headers_of_which_gcc_says_only_that_a_name_is_missing",
     with(kSources,
          {{"one.cpp",
            "#include \"format.h\"\n#include <vector>\n"
            "int unused(std::vector<double>& v) {\n"
            "  std::sort(v.begin(), v.end());\n"
            "  return static_cast<int>(sqrt(v[0])) + INT_MAX - int(strlen(\"\"));\n}\n"}}),
     "",
     {"the missing #include <algorithm> is added to one.cpp",
      "the missing #include <climits> is added to one.cpp",
      "the missing #include <cmath> is added to one.cpp",
      "the missing #include <cstring> is added to one.cpp"}},
    // As GCC reports an error in a header of the system.
    {"is_given_a_macro_that_an_error_names",
     with(kSources,
          {{"one.cpp", "#include <glm/glm.hpp>\n"},
           {"Makefile",
            "rt:\n\tgrep -q 'define GLM_ENABLE_EXPERIMENTAL' one.cpp || { printf '%s\\n' "
            "'In file included from one.cpp:1:' '/usr/include/glm/gtx/x.hpp:23:3: error: #error "
            "\"GLM: Use #define GLM_ENABLE_EXPERIMENTAL before including it\"'; false; }\n"
            "\tg++ -o rt rt.cpp format.cpp\n"}}),
     "./rt ",
     {"the missing #define GLM_ENABLE_EXPERIMENTAL is added to one.cpp"}},
    {"defines_a_variable_in_two_files",
     {{"rt.c", kC + "int shared;\n"}, {"two.c", "int shared;\n"}},
     "",
     {"compiled with -fcommon: several of its files define the same variable"}},
    {"passes_constants_where_gcc_takes_them_only_with_fpermissive",
     with(kSources,
          {{"one.cpp", "void* none() { return 0; }\nint* unused() { return none(); }\n"}}),
     "",
     {"compiled with -fpermissive: GCC names this option for some of its errors"}},
    {"is_linked_with_the_libraries_of_its_headers",
     {{"rt.c", "#include <GL/glut.h>\n#include <FreeImage.h>\n" +
                   replaced(kC, "char line",
                            "if (count > 9) glutInit(&count, words), glFlush(), "
                            "FreeImage_GetVersion();\n  char line")}},
     "",
     {"built with -lfreeimage -lglut -lGLU -lGL, which its headers need"},
     "/usr/include/FreeImage.h"},
    // Of several usual command lines, the one with which it draws is taken.
    {"takes_the_picture_first",
     {{"rt.py",
       replaced(renderer_in_python("", "sys.argv[1]"), "open(sys.argv[1])", "open(sys.argv[2])")}},
     "renderer:python3 ./rt.py {image} {scene}",
     {"it makes no picture when it is called as python3 ./rt.py {scene} {image}; it is called as "
      "python3 ./rt.py {image} {scene}"}},
    {"takes_options",
     {{"rt.py",
       "import sys\nwords = dict(zip(sys.argv[1::2], sys.argv[2::2]))\n"
       "sys.argv = ['', words['-input'], words['-output']]\n" +
           renderer_in_python()}},
     "-input {scene} -output {image}",
     {"it is called as python3 ./rt.py -input {scene} -output {image} -size {width} {height}"}},
    {"reads_its_scene_from_standard_input_and_prints_its_picture",
     {{"rt.c", replaced(replaced(kC, "fopen(words[count - 2], \"r\")", "stdin"),
                        "fopen(words[count - 1], \"w\")", "count == 1 ? stdout : 0")}},
     "sh -c '$* < {scene} > {image}' - ./raycheck-built",
     {"it is called as "}},
    {"is_a_script_beside_a_makefile_that_starts_it",
     {{"Makefile", "build:\nrun: build\n\tpython3 rt.py $(file)\n"},
      {"rt.py", renderer_in_python("", "'output.ppm'")}},
     "python3 ./rt.py",
     {"its Makefile makes no program; built from its sources", "it writes output.ppm"}},
    // package.json is preferred to the file with a likelier name.
    {"is_a_module_that_package_json_names",
     {{"package.json", R"({"type": "module", "main": "./src/tracer"})"},
      {"src/tracer.js", kModule},
      {"rt.js", "console.log(process.argv.length);\n"}},
     "",
     {},
     "node"},
    {"is_a_notebook", {{"Homework.ipynb", kNotebook}}},
    writing("writes_output", "'output.ppm'", "output.ppm"),
    writing("writes_into_a_folder", "'images/result.ppm'", "", "os.mkdir('images')\n"),
    writing("writes_scene", "'scene.ppm'", "scene.ppm"),
    writing("writes_a_number", "'42.ppm'", "42.ppm"),
    {"has_left_what_archives_and_compilers_leave_behind",
     {{"rt.c", kC},
      {"Eigen.gch", std::string(2 << 20, 'x')},
      {".git/objects/a", std::string(2 << 20, 'x')},
      {"env/pyvenv.cfg", ""},
      {"env/lib/big.py", std::string(2 << 20, 'x')}},
     "",
     {},
     "",
     "[limits]\nsubmission_mib = 1\n"},
    {"finds_eigen_where_it_was",
     with(kSources, {{"one.cpp", "#include \"../../libs/eigen/Eigen/src/Core/util/Macros.h\"\n" +
                                     kUseOfEigen}}),
     "",
     {" is replaced by <Eigen/src/Core/util/Macros.h>"},
     "/usr/include/eigen3"},
    {"finds_eigen_by_its_makefile",
     with(
         kSources,
         {{"one.cpp", "#include <eigen3/Eigen/src/Core/util/Macros.h>\n" + kUseOfEigen},
          {"Makefile",
           "rt: rt.cpp format.cpp one.cpp\n\tg++ -I/opt/eigen -o rt rt.cpp format.cpp one.cpp\n"}}),
     "",
     {" is replaced by <Eigen/src/Core/util/Macros.h>"},
     "/usr/include/eigen3"},
    // Its files are not compiled.
    {"brings_its_own_eigen",
     with(kSources, {{"one.cpp", "#include <Eigen/Dense>\nint two() { return kTwo; }\n"},
                     {"libs/eigen-3.4/Eigen/Dense", "constexpr int kTwo = 2;\n"},
                     {"libs/eigen-3.4/bench/bench.cpp", "no C++\n"}})}};

const Files kMakesWhatFails = {
    {"Makefile", "check:\n\techo 'int main() { return 3; }' > check.c\n\tgcc -o check check.c\n"}};
constexpr const char* kNoPicture =
    "it exited with 0, but did not write its picture, image.ppm; it printed: no such key";
const std::string kLimits =
    "[limits]\nfile_mib = 1\nprocesses = 8\nmemory_mib = 300\nsubmission_mib = 1\nfiles = 3\n";

const std::vector<Brought> kRefused = {
    refused("makes_programs_that_do_not_draw_of_which_the_likeliest_is_quoted",
            {{"Makefile", "all:\n\tgcc -o checks checks.c\n\tgcc -o rt rt.c\n"},
             {"checks.c", kChecks},
             {"rt.c", kNoSuchKey}},
            {kNoPicture}),
    // The Makefile's program fails; the program built from sources makes no picture.
    refused("is_built_in_several_ways_of_which_the_one_that_comes_farthest_is_quoted",
            with(kMakesWhatFails, {{"rt.c", kNoSuchKey}}), {kNoPicture}, "",
            {"the program built from its Makefile shows no spheres; it was built from its sources "
             "instead"}),
    refused("is_built_in_several_ways_of_which_the_first_is_quoted_where_none_comes_farther",
            with(kMakesWhatFails, {{"rt.c", "int main() { return 4; }\n"}}), {"it exited with 3"}),
    refused("is_a_program_of_windows", {{"rt.exe", "MZ"}}, {"rt.exe is a Windows program"}),
    refused("has_no_main",
            {{"vec.cpp", "int one() { return 1; }\n"},
             {"glm-0.9/glm/glm.hpp", ""},
             {"glm-0.9/doc/pages.js", "document.write();\n"}},
            {"none of its source files has a main function"}),
    refused("does_not_compile", {{"rt.cpp", "int main() { return 0 }\n"}},
            {"'g++ -O2 -std=c++20 rt.cpp' exited with 1", "error: expected"}),
    refused("cannot_be_made", {{"Makefile", "rt: missing.cpp\n"}},
            {"'make' exited with 2", "missing.cpp"}),
    refused("says_much_of_which_the_first_and_the_last_is_quoted",
            {{"Makefile", "rt:\n\t@for k in $$(seq 60); do echo line $$k; done; false\n"}},
            {"line 1\n", "line 12\n... ", " lines left out ...\n", "line 60\n"}),
    refused("says_something_in_place_of_a_picture", {{"rt.sh", "echo 'usage: rt WIDTH HEIGHT'\n"}},
            {"it exited with 0, but did not write its picture, image.ppm; it printed: usage: rt "
             "WIDTH HEIGHT"}),
    refused("ends_with_an_error", {{"rt.sh", "echo 'line 3:' >&2\necho 'what?' >&2\nexit 1\n"}},
            {"it exited with 1\nline 3:\nwhat?"}),
    refused("reads_whole_numbers_only",
            {{"rt.sh",
              "awk '/[0-9]\\.[0-9]|e-/ { print \"not whole: \" $0; exit 1 }' \"$1\" >&2 || exit 1\n"
              "{ echo P3 25 25 255; yes 1 2 3 | head -n 625; } > \"$2\"\n"}},
            {"it reads numbers as integers, and fails if a number has a fraction", "not whole: "}),
    refused("opens_a_window",
            {{"rt.sh", "echo \"freeglut (rt): failed to open display ''\" >&2\nexit 1\n"}},
            {"it exited with 1; it opens a window, and there is no display: it must draw without "
             "one, into a file",
             "failed to open display"}),
    refused("writes_too_large_a_file",
            {{"rt.c",
              "#include <stdio.h>\nint main() { FILE* f = fopen(\"image.ppm\", \"w\");\n"
              "for (int k = 0; k < 3000000; ++k) putc(65, f);\nreturn 0; }\n"}},
            {"signal 25 (File size limit exceeded): a file may have at most 1 MiB (file_mib)"},
            kLimits),
    refused("takes_too_much_memory", {{"rt.py", "x = bytearray(1 << 30)\n"}},
            {"at most 300 MiB of memory (memory_mib)", "MemoryError"}, kLimits),
    refused("takes_too_long", {{"rt.sh", "while :; do :; done\n"}},
            {"did not end within 1 s of CPU time (reply_seconds)"},
            "[limits]\nreply_seconds = 1\n"),
    refused("has_too_many_threads",
            {{"rt.py",
              "import threading, time\nfor k in range(99):\n"
              "    threading.Thread(target=time.sleep, args=(1,), daemon=True).start()\n"}},
            {"it may have at most 8 processes and threads (processes)"}, kLimits),
    refused("is_too_large", {{"rt.py", std::string(2 << 20, ' ')}},
            {"it has more than 1 MiB (limits.submission_mib)"}, kLimits),
    refused("has_too_many_files", {{"1.py", ""}, {"2.py", ""}, {"3.py", ""}, {"4.py", ""}},
            {"it has more than 3 files (limits.files)"}, kLimits),
    refused("is_built_too_slowly", {{"Makefile", "rt:\n\tsleep 30\n"}},
            {"did not end, and used almost no CPU time for 1 s (build_seconds)"},
            "[limits]\nbuild_seconds = 1\n")};

void bring(const Grading& grading, const std::string& name, const Files& files) {
  for (const auto& [file, text] : files) {
    const std::string path = grading.write("class/" + name + "/" + file, text);
    if (text.starts_with("\x7f"
                         "ELF"))
      fs::permissions(path, fs::perms::owner_all);
  }
}

/// Grades these submissions; `head` begins the rubric.
void grade_brought(const Grading& grading, const std::vector<std::string>& names,
                   const std::string& head = "", const std::string& more = "") {
  std::vector<std::string> folders;
  for (const std::string& name : names) folders.push_back(grading.path("class/" + name));
  grading.grade(grading.write("auto.toml", full_rubric(1, head)), folders, "out", more);
}

bool is_here(const std::string& needed) {
  return needed.empty() || (needed[0] == '/' ? fs::exists(needed) : is_installed(needed));
}

/// A list of submissions, graded in one run.
const Grading& graded(const std::vector<Brought>& list) {
  static std::map<const void*, Grading> known;
  const auto [at, is_new] = known.try_emplace(&list);
  const Grading& grading = at->second;
  if (!is_new) return grading;
  std::map<std::string, std::vector<std::string>> names;
  for (const Brought& one : list) {
    if (!is_here(one.needs)) continue;
    bring(grading, one.name, one.files);
    names[one.limits].push_back(one.name);
  }
  for (const auto& [limits, some] : names) {
    const bool may_go_without = limits.empty() && !list.front().refused.empty();
    grade_brought(grading, some, limits, may_go_without ? kLimitsOnly : "");
  }
  return grading;
}

class EachBrought : public testing::TestWithParam<Brought> {};

TEST_P(EachBrought, IsBuiltAndRightOrIsRefused) {
  const Brought& one = GetParam();
  if (!is_here(one.needs)) GTEST_SKIP() << one.needs << " is not installed";
  const bool is_right = one.refused.empty();
  const json result = graded(is_right ? kBuilt : kRefused).result(one.name);
  EXPECT_EQ(result["score"], is_right ? 10 : 0) << result.dump(2);
  if (is_right || !one.notes.empty()) {
    ASSERT_EQ(result["notes"].size(), one.notes.size()) << result["notes"];
  }
  for (std::size_t k = 0; k < one.notes.size(); ++k) {
    expect_parts(result["notes"][k], {one.notes[k]});
  }
  if (is_right) {
    expect_parts(result["program"], {one.program});
    return;
  }
  ASSERT_TRUE(result["refused"].is_object()) << result.dump(2);
  expect_parts(result["refused"]["why"].get<std::string>() + "\n" +
                   result["refused"]["said"].get<std::string>(),
               one.refused);
}

const auto kNameOfBrought = [](const auto& the_test) { return std::string(the_test.param.name); };
INSTANTIATE_TEST_SUITE_P(Intake, EachBrought, testing::ValuesIn(kBuilt), kNameOfBrought);
INSTANTIATE_TEST_SUITE_P(LongIntake, EachBrought, testing::ValuesIn(kRefused), kNameOfBrought);

class LongIntake : public GradingTest {};

TEST_F(LongIntake, gives_the_same_grades_from_the_store) {
  bring(grading, "other",
        {{"Makefile", "check: checks.cpp\n\tgcc -o check checks.cpp\n"},
         {"checks.cpp", kChecks},
         {"rt.c", kC}});
  grade_brought(grading, {"other"});
  const json other = grading.result("other");
  EXPECT_EQ(other["notes"][1],
            "the program built from its Makefile shows no spheres; it was built from its sources "
            "instead");
  expect_parts(other["program"], {"./raycheck-built "});
  grade_brought(grading, {"other"}, "title = \"again\"\n");
  const json again = grading.result("other");
  EXPECT_EQ(again["build_is_stored"], true);
  EXPECT_EQ(again["score"], 10) << again.dump(2);
  for (const char* key : {"program", "build", "driver", "notes", "score"}) {
    EXPECT_EQ(again[key], other[key]) << key;
  }
}

/// A folder that a form names is not unwrapped.
TEST_F(LongIntake, does_not_unwrap_a_folder_that_a_form_names) {
  bring(grading, "named",
        {{"source/rt.c", kC}, {"source/Makefile", "rt: rt.c\n\tcc -o rt rt.c -lm\n"}});
  const std::string rubric =
      replaced(replaced(full_rubric(1), "build = \"auto\"", "build = \"cd source && make\""),
               "renderer:{program}", "renderer:./source/rt");
  grading.grade(grading.write("named.toml", rubric), {grading.path("class/named")});
  EXPECT_EQ(grading.result("named")["score"], 10);
}

TEST_F(LongIntake, runs_a_program_without_sources) {
  bring(grading, "built", {{"readme.txt", "no sources"}});
  const std::string source = grading.write("rt.c", kC),
                    program = grading.path("class/built/tracer");
  run_bash("gcc -o '" + program + "' '" + source + "' -lm && chmod -x '" + program + "'\n", 0);
  grade_brought(grading, {"built"});
  EXPECT_EQ(grading.result("built")["score"], 10);
}

TEST_F(LongIntake, builds_java_with_packages_jars_and_classes) {
  if (!is_installed("javac")) GTEST_SKIP() << "Java is not installed";
  const Files sources = {{"src/Main.java", kJava}, {"Discs.java", kJavaDiscs}};
  bring(grading, "jars", {{"src/de/uni/Main.java", kJava}});
  bring(grading, "unpacked", {{"src/Main.java", kJava}});
  bring(grading, "makefile",
        with({{"Makefile", "all:\n\tjavac -d bin src/Main.java Discs.java\n"}}, sources));
  bring(grading, "silent",
        {{"Main.java",
          "public class Main {\n  public static void main(String[] words) {\n"
          "    System.out.println(\"no picture\");\n  }\n}\n"}});
  bring(grading, "missing",
        {{"Main.java", "import org.ejml.simple.SimpleMatrix;\n" + kJava.substr(16)}});
  const std::string discs = grading.write("Discs.java", kJavaDiscs);
  run_bash("cd '" + grading.path("class") + "' && mkdir jars/lib && javac -d unpacked '" + discs +
               "' && cd unpacked && "
               "python3 -m zipfile -c ../jars/lib/discs.jar util\n",
           0);
  grade_brought(grading, {"jars", "unpacked", "makefile", "silent", "missing"});
  for (const auto& [name, path] : {std::pair("jars", "raycheck-classes:.:lib/discs.jar"),
                                   {"unpacked", "raycheck-classes:."},
                                   {"makefile", "./bin:."}}) {
    const json result = grading.result(name);
    EXPECT_EQ(result["score"], 10) << result.dump(2);
    EXPECT_EQ(result["program"],
              std::string("renderer:java -cp ") + path + " de.uni.Main {scene} {image}");
    EXPECT_TRUE(result["notes"].empty()) << result["notes"];
  }
  expect_parts(grading.result("missing")["refused"]["why"],
               {"the package org.ejml.simple is missing: put its jar beside the sources"});
  EXPECT_FALSE(has(grading.result("missing").dump(), "JAVA_TOOL_OPTIONS"));
  EXPECT_EQ(grading.result("silent")["refused"]["why"],
            "it exited with 0, but did not write its picture, image.ppm; it printed: no picture");
}

/// The program waits in the forms that it reads, and rejects the others.
TEST_F(LongIntake, shows_the_output_of_the_form_in_which_a_program_gets_farthest) {
  bring(grading, "far",
        {{"rt.py",
          "import sys, time\nfor line in open(sys.argv[1]):\n    words = line.split()\n"
          "    if words[0] == 'sphere': last = words[17]\ntime.sleep(60)\n"}});
  const std::string rubric =
      replaced(full_rubric(1, "[limits]\nreply_seconds = 1\n"), "\"B\"", "\"auto\"");
  grading.grade(grading.write("far.toml", rubric), {grading.path("class/far")});
  EXPECT_EQ(grading.result("far")["refused"]["why"],
            "it did not end, and used almost no CPU time for 1 s (reply_seconds)");
}

}  // namespace
}  // namespace raycheck::tests
