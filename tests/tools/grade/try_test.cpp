// `try` reports the same as `grade`, and a page's commands work in a copy of the submission.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// The files of a folder that students get.
std::map<std::string, std::string> files_of(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (name != "result.json") files[name] = contents(entry.path());
  }
  return files;
}

Outcome try_it(const Grading& grading, const std::string& rubric, const std::string& submission,
               const std::string& more = "") {
  return run("try '" + rubric + "' '" + submission + "' --out '" + grading.path("tried") + "' " +
             more);
}

/// The lines of `text` between the title and the first empty line, or the text after the items.
std::vector<std::string> item_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line) && !line.empty() && !line.starts_with("see ") &&
         !line.starts_with("wrote ") && !has(line, "not shown, but in the score")) {
    const bool is_of_items =
        !line.starts_with("isolated by: ") && !has(line, " graded") && !has(line, "  see ");
    if (is_of_items) lines.push_back(line);
  }
  return lines;
}

TEST(TryCommand, agrees_with_grade_in_every_file_and_line) {
  const Grading grading;
  const std::string rubric =
      grading.short_rubric("", kPixelZeroZero + kNearestRoot + kNearestSphere);
  const std::vector<std::string> submissions = {
      grading.submit("right", "rays.py"), grading.submit_built("far", "rays.cpp", "far_root"),
      grading.submit_built("mirrored", "rt.cpp", "mirrored"),
      grading.submit_built("crashing", "hostile.cpp", "crashes"),
      grading.path("submissions/broken")};
  grading.write("submissions/broken/rt.cpp", "#error this does not compile\nint main() {}\n");
  for (const std::string& submission : submissions) {
    const std::string name = fs::path(submission).filename();
    const Outcome graded = grading.grade(rubric, {submission});
    const Outcome tried = try_it(grading, rubric, submission);
    EXPECT_EQ(tried.exit_code, name == "right" ? 0 : 1) << tried.err;
    const auto lines = item_lines(tried.out);
    EXPECT_EQ(lines, item_lines(graded.out)) << name;
    EXPECT_GE(lines.size(), name == "broken" ? 2u : 4u) << tried.out;
    const auto files = files_of(grading.path("tried/" + name));
    EXPECT_EQ(files, files_of(grading.path("out/" + name))) << name;
    EXPECT_TRUE(files.contains("report.html"));
  }
}

TEST(TryCommand, shows_visible_items_and_counts_all) {
  const Grading grading;
  const std::string root = kNearestRoot;
  const std::string rubric = grading.short_rubric(
      "", item_of("camera frame", "points = 15\nvisibility = \"hidden\"",
                  functions("frame", "course", 6)) +
              std::string(root).insert(root.find("points"), "detail = \"nothing\"\n"));
  const std::string submission = grading.submit_built("mine", "rays.cpp", "no_test_for_t");
  const Outcome graded = grading.grade(rubric, {submission});
  const Outcome tried = try_it(grading, rubric, submission);
  EXPECT_FALSE(has(tried.out, "camera frame")) << tried.out;
  expect_parts(tried.out, {"\n  not shown, but in the score: 1 item\n"});
  const std::size_t at = tried.out.find("\nnearest root\n");
  ASSERT_NE(at, std::string::npos) << tried.out;
  const std::string shown = tried.out.substr(at, tried.out.find("\n\n", at) - at);
  expect_parts(shown, {"hint: "});
  for (const char* part : {"mistake", "[[sphere]]", "got", "the law"}) {
    EXPECT_FALSE(has(shown, part)) << shown;
  }
  EXPECT_EQ(item_lines(tried.out).front(), item_lines(graded.out).front()) << "the same score";
  EXPECT_EQ(files_of(grading.path("tried/mine")), files_of(grading.path("out/mine")));
}

/// Enough cases for a wrong camera to fail.
const std::string kFewPictures =
    item_of("a few pictures", "points = 10",
            "[item.pictures]\njudge = \"mask\"\n"
            "scenes = [\"lecture7/wide.toml\", \"lecture7/orientation.toml\"]");

TEST(TryCommand, shows_every_submission_and_fails_if_one_does) {
  const Grading grading;
  const std::string rubric = grading.short_rubric("", kNearestRoot);
  const std::string right = grading.submit_built("right", "rays.cpp", "none");
  const std::string wrong = grading.submit_built("wrong", "rays.cpp", "no_test_for_t");
  for (const std::string& both :
       {"'" + right + "' '" + wrong + "'", "'" + wrong + "' '" + right + "'"}) {
    const Outcome tried = run("try '" + rubric + "' " + both, 1);
    expect_parts(tried.out, {"\nright: 10 of 10\n", "\nwrong: 0 of 10\n", "mistake: s >= 0",
                             "to repeat it, save it as nearest-root.toml:\n"});
    // Without --out no file is written; `goes wrong at` needs a single step that decides.
    for (const char* part : {"wrote ", "goes wrong at"}) EXPECT_FALSE(has(tried.out, part));
    expect_parts(tried.err, {"submissions: 2 of 2 done: "});
  }
  run("try '" + rubric + "' '" + right + "'", 0);
}

TEST(TryCommand, names_the_function_that_is_missing_and_what_to_do) {
  const Grading grading;
  const std::string rubric = grading.short_rubric(
      "",
      item_of("points", "points = 4\nhint = \"Print P.\"", functions("pixel-point", "course", 6)) +
          item_of("directions", "points = 4\nhint = \"Print D.\"",
                  functions("unit-direction", "course", 6)));
  const std::string submission = grading.hand_in(
      "few", "rays.py", "import raycheck_candidate as rc\nrc.run('few', nearest=print)\n");
  const Outcome tried = try_it(grading, rubric, submission);
  EXPECT_EQ(tried.exit_code, 1) << tried.err;
  expect_parts(tried.out, {"fails 6 of 6 cases (pixel_point() is missing: write it)",
                           "fails 6 of 6 cases (pixel_ray() is missing: write it)"});
  const std::string page = contents(grading.path("tried/few/report.html"));
  expect_parts(page, {"Hint: Write pixel_point(), and add it", "Hint: Write pixel_ray(), and add"});
  for (const char* part : {"Print P.", "Print D."}) EXPECT_FALSE(has(page, part)) << part;
}

TEST(TryCommand, names_the_file_names_for_functions_if_another_has_them) {
  const Grading grading;
  const std::string called = "import raycheck_candidate as rc\nrc.run('anna', nearest=print)\n";
  for (const char* name : {"anna.py", "anna.cpp"}) {
    const Outcome tried = run(std::string("try --dialect B ") + kLimitsOnly + kLecture7 + " '" +
                              grading.hand_in("in", name, called) + "/" + name + "'");
    expect_parts(tried.out,
                 {std::string(name) + " uses raycheck_candidate, but this rubric takes "
                                      "functions only from rays.cpp, rays.py, "
                                      "rays.ipynb, Rays.java: rename it; as a renderer"});
  }
  const Outcome drawn = run(std::string("try --dialect B ") + kLimitsOnly + kLecture7 + " '" +
                            grading.hand_in("no", "rt.sh", "exit 1\n") + "'");
  EXPECT_FALSE(has(drawn.out, "rename it")) << drawn.out;
}

/// Rays whose directions have this length, with this height of pixel (i, j) on the image plane.
std::string rays_in_python(const std::string& length, const std::string& height) {
  return R"(import math
import raycheck_candidate as rc

def pixel_ray(camera, conventions, pixel):
    def unit(v):
        return [x / math.hypot(*v) for x in v]
    def cross(a, b):
        return [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]]
    i, j = pixel
    w = unit([e - l for e, l in zip(camera.eye, camera.look_at)])
    u = unit(cross(camera.up, w))
    v = cross(w, u)
    a = camera.left + (camera.right - camera.left) * i / (camera.width - 1)
    b = )" +
         height + R"(
    d = [camera.near * n + a * x + b * y for n, x, y in zip(w, u, v)]
    return [e + x for e, x in zip(camera.eye, d)], [)" +
         length + R"( * x for x in unit(d)]

rc.run("mine", pixel_ray=pixel_ray, samples="edges", made_directions="any")
)";
}
constexpr const char *kUpwards =
                         "camera.bottom + (camera.top - camera.bottom) * j / (camera.height - 1)",
                     *kDownwards =
                         "camera.top - (camera.top - camera.bottom) * j / (camera.height - 1)";

/// What a submission declares must not take an item's subject away.
TEST(TryCommand, ignores_how_a_submission_would_be_called) {
  const Grading grading;
  const std::string rubric = grading.short_rubric(
      "", item_of("unit", "points = 4", functions("unit-direction", "course", 6)));
  const auto points = [&](const std::string& name, const std::string& length) {
    return try_it(grading, rubric,
                  grading.hand_in(name, "rays.py", rays_in_python(length, kUpwards)));
  };
  EXPECT_EQ(points("long", "3").exit_code, 1);
  EXPECT_EQ(points("unit", "1").exit_code, 0);
}

/// An assignment that does not ask for unit directions, and accepts rows in either order.
TEST(TryCommand, judges_by_what_the_rubric_declares) {
  const Grading grading;
  const std::string rubric = grading.write(
      "either.toml", R"([conventions]
rows = "either"
samples = "edges"
origin = "pixel"
[[form]]
has = "rays.py"
candidate = "command:python3 {file}"
declares = "made_directions any"
)" + item_of("unit", "points = 4", functions("unit-direction", "course", 6)) +
                         item_of("rays", "points = 4", functions("direction", "course", 6)));
  const auto points = [&](const std::string& name, const std::string& height) {
    return try_it(grading, rubric, grading.hand_in(name, "rays.py", rays_in_python("3", height)));
  };
  EXPECT_EQ(points("up", kUpwards).exit_code, 0);
  EXPECT_EQ(points("down", kDownwards).exit_code, 0);
  EXPECT_TRUE(has(points("middle", "(camera.top + camera.bottom) / 2 + 0 * j").out, "4 of 8"));
}

/// Hits begin at t = 2 in this course, whatever a submission declares of its roots.
TEST(TryCommand, judges_by_the_roots_that_the_rubric_declares) {
  const Grading grading;
  const auto rubric = [&](const std::string& name, const std::string& declares) {
    return grading.write(
        name, "[[form]]\nhas = \"rays.py\"\ncandidate = \"command:python3 {file}\"\n" + declares +
                  item_of("hits", "points = 4", functions("class", "rays", 40, kGivenRays)));
  };
  const std::string own = grading.hand_in("own", "rays.py", R"(import raycheck_candidate as rc

def intersect(ray, sphere, conventions):
    (o, d), (c, r) = ray, sphere
    t = [x - y for x, y in zip(c, o)]
    a, b = sum(x * x for x in d), sum(x * y for x, y in zip(t, d))
    under = b * b - a * (sum(x * x for x in t) - r * r)
    if under < 0:
        return None
    return next((s for s in ((b - under**0.5) / a, (b + under**0.5) / a) if s >= 2), None)

rc.run("mine", intersect=intersect, returns="parameter", roots="as-asked", tangent="either")
)");
  EXPECT_EQ(try_it(grading, rubric("plain.toml", ""), own).exit_code, 1);
  const Outcome declared = try_it(grading, rubric("half.toml", "declares = \"t_min 2\"\n"), own);
  EXPECT_EQ(declared.exit_code, 0) << declared.out;
  // It contradicts only what the submission declares, which does not count.
  const Outcome solid =
      try_it(grading, rubric("solid.toml", "declares = \"from_inside start\"\n"), own);
  EXPECT_FALSE(has(solid.out, "cannot be combined")) << solid.out;
}

/// Code that takes every direction for a unit one is not given only such.
TEST(TryCommand, gives_directions_of_any_length_to_a_submission_that_declares_unit_ones) {
  const Grading grading;
  const std::string rubric = grading.short_rubric(
      "", item_of("lengths", "points = 4",
                  functions("parameter", "direction-length@60", 6, kGivenRays)));
  const auto points = [&](const std::string& name, const std::string& length) {
    return try_it(grading, rubric, grading.hand_in(name, "rays.py", R"(import math
import raycheck_candidate as rc

def intersect(ray, sphere, conventions):
    (o, d), (c, r) = ray, sphere
    n = )" + length + R"(
    d = [x / n for x in d]
    t = [x - y for x, y in zip(c, o)]
    m = [t[1]*d[2] - t[2]*d[1], t[2]*d[0] - t[0]*d[2], t[0]*d[1] - t[1]*d[0]]
    v = sum(x * y for x, y in zip(t, d))
    s = r * r - sum(x * x for x in m)
    if s < 0:
        return None
    near, far = v - math.sqrt(s), v + math.sqrt(s)
    return near / n if near >= 0 else far / n if far >= 0 else None

rc.run("mine", intersect=intersect, returns="parameter", root="nearest", directions="unit")
)"));
  };
  EXPECT_EQ(points("unit", "1").exit_code, 1);
  EXPECT_EQ(points("any", "math.hypot(*d)").exit_code, 0);
}

TEST(TryCommand, ignores_tolerances_that_a_submission_declares) {
  const Grading grading;
  const std::string rubric = grading.short_rubric(
      "", item_of("class", "points = 4", functions("class", "course", 6, kGivenRays)));
  const auto points = [&](const std::string& name, const std::string& counts) {
    return try_it(grading, rubric, grading.hand_in(name, "rays.py", R"(
import raycheck_candidate as rc

def intersect(ray, sphere, conventions):
    (o, d), (c, r) = ray, sphere
    t = [x - y for x, y in zip(c, o)]
    m = [t[1]*d[2] - t[2]*d[1], t[2]*d[0] - t[0]*d[2], t[0]*d[1] - t[1]*d[0]]
    dot = lambda p, q: sum(x * y for x, y in zip(p, q))
    is_ahead = dot(t, t) <= r * r or dot(t, d) >= 0
    return dot(m, m) <= r * r * dot(d, d) and is_ahead and )" + counts + R"(

rc.run("mine", intersect=intersect, returns="class", tolerance_distance=1e30)
)"));
  };
  EXPECT_EQ(points("half", "d[0] < 0").exit_code, 1);
  EXPECT_EQ(points("all", "True").exit_code, 0);
}

TEST(TryCommand, writes_no_placeholder_to_the_page_of_a_program_that_does_not_compile) {
  const Grading grading;
  const std::string rubric = grading.write("rubric.toml", kAsTheyCome + kFewPictures);
  const std::string submission =
      grading.hand_in("broken", "rt.cpp", "#error this does not compile\nint main() {}\n");
  EXPECT_EQ(try_it(grading, rubric, submission).exit_code, 1);
  const std::string page = contents(grading.path("tried/broken/report.html"));
  expect_parts(page, {"Why your submission could not be judged", "this does not compile"});
  EXPECT_FALSE(has(page, "{program}"));
}

/// Tries a submission with a mistake, and runs in a copy of its folder the report's commands for
/// the first failing item.
void expect_the_commands_to_work(const Grading& grading, const std::string& hand_in,
                                 const std::string& head = "") {
  const std::string rubric = grading.write("few.toml", head + kAsTheyCome + kFewPictures);
  const Outcome tried =
      run("try '" + rubric + "' '" + hand_in + "' --out '" + grading.path("out") + "'", 1);
  const std::string build =
      behind("\n  Build it as the grader did, in a copy of your folder: ", tried.out);
  const std::string draw = behind("\n  Draw the case: ", tried.out);
  const std::string check = behind("\n  Check every pixel: ", tried.out);
  ASSERT_FALSE(build.empty()) << tried.out;
  ASSERT_FALSE(draw.empty()) << tried.out;
  ASSERT_FALSE(check.empty()) << tried.out;
  const std::string home = grading.path("home");
  fs::copy(hand_in, home, fs::copy_options::recursive);
  for (const auto& entry :
       fs::directory_iterator(grading.path("out/" + fs::path(hand_in).filename().string()))) {
    fs::copy(entry.path(), home, fs::copy_options::recursive);
  }
  const Outcome at_home =
      run_bash("raycheck() { '" RAYCHECK_BINARY "' \"$@\"; }\ncd '" + home + "'\n" + build +
                   " > /dev/null || exit 10\n" + draw + " > /dev/null || exit 11\n" + check,
               1);
  expect_parts(at_home.out, {"image"});
}

TEST(Home, CommandsBuildAndRepeatAsGraded) {
  const std::vector<std::map<std::string, std::string>> hand_ins = {
      {{"rt.cpp", renderer_in_c()}},
      // Built by a Makefile, from sources in a folder below.
      {{"src/rt.c", renderer_in_c()},
       {"src/Makefile", "rt: rt.c\n\tgcc -O1 -o rt rt.c\n"},
       {"readme.txt", "see src\n"}},
      {{"rt.c", renderer_in_c()},
       {"CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.10)\nproject(mine C)\n"
        "find_package(Eigen3 REQUIRED)\nfind_package(Threads REQUIRED)\n"
        "add_executable(rt rt.c)\ntarget_link_libraries(rt Eigen3::Eigen Threads::Threads)\n"}},
      {{"Discs.java", kRendererInJava}}};
  for (const auto& files : hand_ins) {
    if (files.contains("Discs.java") && !is_installed("javac")) continue;
    const Grading grading;
    for (const auto& [name, text] : files) grading.write("mine/" + name, text);
    expect_the_commands_to_work(grading, grading.path("mine"), "[driver]\npreset = \"B\"\n");
  }
  // The command must name the form of driver files.
  expect_the_commands_to_work(Grading(), RAYCHECK_SOURCE_DIR "/tests/submissions/class/kofi");
}

}  // namespace
}  // namespace raycheck::tests
