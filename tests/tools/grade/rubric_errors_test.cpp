// Invalid rubrics and command lines: nothing is graded, and the reason is printed.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// A valid rubric; each test replaces a part of it.
constexpr const char* kRubric = R"(title = "A rubric"
[[form]]
has = "rays.py"
candidate = "command:python3 {file}"
[[item]]
name = "one"
points = 4
[item.functions]
laws = ["class"]
sources = ["course"]
cases = 4
)";

struct Wrong {
  std::string part, instead;
  std::string said;  ///< The expected error: line, field, value and reason.
};

constexpr const char *kTitle = "title = \"A rubric\"", *kWorth = "points = 4",
                     *kCases = "cases = 4", *kAsked = "[item.functions]\nlaws = [\"class\"]";

/// What is between the title and the questions of kRubric.
const std::string kFormAndItem =
    "[[form]]\nhas = \"rays.py\"\ncandidate = \"command:python3 {file}\"\n[[item]]\nname = "
    "\"one\"\npoints = 4\n";

const std::vector<Wrong> kWrong = {
    {"title", "titel", "1: titel = \"A rubric\": unknown key; rubric accepts title, "},
    {kTitle, "title =", "1: not valid TOML: "},
    {kTitle, "seconds = 0", "1: seconds = 0: must be above 0"},
    {kTitle, "seconds = 1e9", "1: seconds = 1e9: must be above 0, and at most"},
    {kTitle, "driver = { preset = \"D\" }",
     "1: driver.preset = \"D\": must be one of A, B, C, 2017, 2018, 2019, 2020, auto, "
     "or a form such as B:17:no-light"},
    {kTitle, "tolerance = { ulp = 1, conditioning = 1 }",
     "1: tolerance = (a table): has both ulp and conditioning; give one"},
    {kTitle, "tolerance = { ulp = -1 }", "1: tolerance.ulp = -1: must be 0 or"},
    {kTitle, "conventions = { samples = \"middles\" }",
     "1: conventions.samples = \"middles\": must be one of edges, centres, corners"},
    {kTitle, "conventions = { t_min = -5 }",
     "1: conventions.t_min = -5: must be finite and at least 0, or -inf"},
    {kTitle, "conventions = { t_min = 2, t_max = 1 }", "1: conventions.t_max = 1: is below t_min"},
    {kTitle, "conventions = { root = \"smaller\", culling = \"front-faces\" }",
     "1: conventions.culling = \"front-faces\": culls every root"},
    {kTitle, "conventions = { samples = \"any\", t_min = 0.5 }",
     "1: conventions.samples = \"any\": is judged only where every root >= 0 counts; leave out"},
    {kTitle, "depth = \"y\"", "1: depth = \"y\": must be s or distance or z or image-plane, and"},
    {kTitle, "unjudged = 1.5", "1: unjudged = 1.5: must be between 0 and 1"},
    {kTitle, "driver = { preset = \"../a.toml\" }",
     "1: driver.preset = \"../a.toml\": must be a file name, without a folder"},
    {kTitle, "driver = { preset = \"B:15\" }",
     "1: driver.preset = \"B:15\": 15 numbers: a sphere line has one of 16, 17, "},
    {kTitle, "t_threshold = -1", "1: t_threshold = -1: must be 0 or more"},
    {kTitle, "precision = \"half\"", "1: precision = \"half\": must be one of"},
    {kTitle, "precision = \"single\"\ntolerance = { ulp = 1e10 }",
     "2: tolerance.ulp = 1e10: allows every answer"},
    {kTitle, "bounds = \"direct/none\"", "1: bounds = \"direct/none\": bounds none"},
    {kTitle, "limits = { file_mib = 0 }", "1: limits.file_mib = 0: must be 1 to 1048576"},
    {kTitle, "limits = { file = 1 }", "1: limits.file = 1: unknown key; limits accepts seconds, "},
    {"candidate = \"command:python3 {file}\"", "candidate = \"command:{program}\"",
     "4: form[0].candidate = \"command:{program}\": {program} requires build = \"auto\""},
    {"candidate =", "build = \"auto\"\ncandidate =",
     "5: form[0].candidate = \"command:python3 {file}\": build = \"auto\" requires {program}"},
    {"has =", "hass =", "3: form[0].hass = \"rays.py\": unknown key; form accepts has, "},
    {kTitle, "conventions = { rows = \"any\" }",
     "1: conventions.rows = \"any\": must be one of bottom-first, top-first"},
    {"candidate =", "declares = \"rays end; directions unit\"\ncandidate =",
     "4: form[0].declares = \"rays end; directions unit\": rays = end: cannot be combined"},
    {"candidate =", "declares = \"returns class\"\ncandidate =",
     "4: form[0].declares = \"returns class\": what functions return must be declared in"},
    {"candidate = \"command:python3 {file}\"",
     "declares = \"directions unit\"\ncandidate = \"renderer:./a {scene} {image}\"",
     "4: form[0].declares = \"directions unit\": of a renderer, which has no functions, only"},
    {"candidate = \"command:python3 {file}\"", "adapter = \"none.cpp\"",
     "4: form[0].adapter = \"none.cpp\": is not a file beside the rubric"},
    {"candidate = \"command:python3 {file}\"", "adapter = \"../none.cpp\"",
     "4: form[0].adapter = \"../none.cpp\": must be a file name, without a folder"},
    {"rays.py", "a/rays.py", "3: form[0].has = \"a/rays.py\": must be a file name, without"},
    {"candidate = \"command:python3 {file}\"\n", "", "2: form[0].candidate: is missing"},
    {"command:python3", "run:python3",
     "4: form[0].candidate = \"run:python3 {file}\": unknown kind 'run'; give library:PATH.so, "},
    {"name = \"one\"\n", "", "item[0].name: is missing"},
    {"\"one\"", "\"\"", "6: item[0].name = \"\": is empty"},
    {"points = 4\n", "", "item[0].points: is missing"},
    {kWorth, "points = -4", "7: item[0].points = -4: must be 0 to 10^9"},
    {kWorth, "points = 4\nbonus = 1", "8: item[0].bonus = 1: must be true or false"},
    {kWorth, "points = 4\ncredit = \"some\"",
     "8: item[0].credit = \"some\": must be one of all, share, steps"},
    {kWorth, "points = 4\ncredit = \"steps\"", "item[0].steps: is missing: [[share, "},
    {kWorth, "points = 4\nsteps = [[1, 1]]",
     "8: item[0].steps = [[1, 1]]: requires credit = \"steps\""},
    {kWorth, "points = 4\ncredit = \"steps\"\nsteps = [[1, 2]]",
     "9: item[0].steps[0][1] = 2: must be between 0 and 1"},
    {kWorth, "points = 4\ncredit = \"steps\"\nsteps = [[1]]",
     "9: item[0].steps[0] = [1]: must be [share, credit]"},
    {kWorth, "points = 4\nrequires = [\"two\"]",
     "8: item[0].requires[0] = \"two\": is not the name of an earlier item"},
    {kWorth, "points = 4\nrequires = [\"one\"]",
     "8: item[0].requires[0] = \"one\": is not the name of an earlier item"},
    {kWorth, "points = 4\nvisibility = \"secret\"",
     "8: item[0].visibility = \"secret\": must be one of visible, after_due_date, "},
    {kWorth, "points = 4\ndetail = \"some\"",
     "8: item[0].detail = \"some\": must be one of full, actual-only, nothing"},
    {kWorth, "points = 4\ntolerance = { abs = 1 }",
     "8: item[0].tolerance.abs = 1: unknown key; item[0].tolerance accepts ulp, conditioning"},
    {"\"class\"", "\"clas\"",
     "9: item[0].functions.laws[0] = \"clas\": is not a law; `raycheck list`"},
    {"\"class\"", "", "9: item[0].functions.laws = []: is empty"},
    {"laws = [\"class\"]\n", "", "item[0].functions.laws: is missing"},
    {"\"course\"", "\"courses\"",
     "10: item[0].functions.sources[0] = \"courses\": no source of cases is called 'courses'"},
    {"\"course\"", "\"distance@x\"", "10: item[0].functions.sources[0] = \"distance@x\": "},
    {kCases, "cases = 0", "11: item[0].functions.cases = 0: must be 1 to 1000000"},
    {kCases, "cases = 1.5", "11: item[0].functions.cases = 1.5: must be a whole number"},
    {"cases = 4\n", "", "item[0].functions.cases: is missing"},
    {"sources = [\"course\"]\n", "", "10: item[0].functions.cases = 4: requires sources"},
    {"sources = [\"course\"]\ncases = 4\n", "", "needs scenes or sources"},
    {kCases, "cases = 4\nrays = \"yours\"",
     "12: item[0].functions.rays = \"yours\": must be one of own, given"},
    {kCases, "cases = 4\njudge = \"mask\"", "12: item[0].functions.judge = \"mask\": unknown"},
    {kCases, "cases = 4\nscenes = [\"nowhere.toml\"]",
     "12: item[0].functions.scenes[0] = \"nowhere.toml\": "},
    {"[item.functions]\nlaws = [\"class\"]\nsources = [\"course\"]\ncases = 4",
     "[item.pictures]\nscenes = [\"lecture7/fame.toml\"]",
     "item[0].pictures.scenes[0] = \"lecture7/fame.toml\": is neither beside the rubric nor a "
     "scene "
     "that comes with "},
    {"title = \"A rubric\"\n" + kFormAndItem + kAsked,
     "conventions = { culling = \"front-faces\" }\n" + kFormAndItem +
         "[item.pictures]\nscenes = [\"smaller.toml\"]",
     "9: item[0].pictures.scenes[0] = \"smaller.toml\": contradicts the rubric's conventions: "
     "conventions.culling = front-faces: culls every root that root = smaller accepts"},
    {kCases, "cases = 4\nscenes = [\"../up.toml\"]",
     "12: item[0].functions.scenes[0] = \"../up.toml\": must be a path below the rubric's folder"},
    {kCases, "cases = 4\nscenes = [\"/etc/passwd\"]",
     "12: item[0].functions.scenes[0] = \"/etc/passwd\": must be a path below"},
    {kAsked, "[item.pictures]\njudge = \"depth\"",
     "9: item[0].pictures.judge = \"depth\": needs the rubric's key depth, such as"},
    {"title = \"A rubric\"\n" + kFormAndItem + kAsked,
     "depth = \"z\"\nconventions = { samples = \"any\" }\n" + kFormAndItem +
         "[item.pictures]\njudge = \"depth\"",
     "10: item[0].pictures.judge = \"depth\": is not possible with conventions.samples = \"any\""},
    {"title = \"A rubric\"\n" + kFormAndItem + kAsked,
     "depth = \"z\"\n" + kFormAndItem + "[item.pictures]\njudge = \"spheres\"",
     "9: item[0].pictures.judge = \"spheres\": needs judge = \"mask\" or \"depth\", because"},
    {"title = \"A rubric\"\n" + kFormAndItem + kAsked,
     "depth = \"z\"\n" + kFormAndItem + "[item.pictures]",
     "item[0].pictures = (a table): needs judge = \"mask\" or \"depth\", because"},
    {kAsked, "[item.pictures]\njudge = \"masks\"",
     "9: item[0].pictures.judge = \"masks\": must be one of spheres, mask"},
    {kAsked, "[item.pictures]\nvary = [\"size\", \"colour\"]",
     "9: item[0].pictures.vary[1] = \"colour\": must be one of scale, size, spheres, border"},
    {"[item.functions]\nlaws = [\"class\"]\nsources = [\"course\"]\ncases = 4\n", "",
     "item[0].functions: is missing, and so is pictures; give at least one of them"},
    {"cases = 4\n", "cases = 4\n[[item]]\nname = \"one\"\npoints = 1\n",
     "13: item[1].name = \"one\": is already the name of an earlier item"},
    {"[[item]]\nname = \"one\"\npoints = 4\n[item.functions]\nlaws = [\"class\"]\n"
     "sources = [\"course\"]\ncases = 4\n",
     "", "item: is missing"},
};

TEST(Rubric, with_an_error_is_refused_with_file_line_field_and_value) {
  const Grading grading;
  const std::string folder = grading.submit("mine", "rays.py");
  grading.write("smaller.toml", contents(RAYCHECK_SOURCE_DIR "/scene/examples/probe.toml") +
                                    "[conventions]\nroot = \"smaller\"\n");
  for (const auto& [part, instead, said] : kWrong) {
    const std::string text = replaced(kRubric, part, instead);
    const std::string rubric = grading.write("rubric.toml", text);
    const Outcome outcome = grading.grade(rubric, {folder}, "out", "", 2);
    EXPECT_EQ(outcome.err.rfind("raycheck: " + rubric + ":", 0), 0u) << outcome.err;
    expect_parts(outcome.err, {said});
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(fs::exists(grading.path("out"))) << text;
  }
  grading.grade(grading.write("rubric.toml", kRubric), {folder});
  EXPECT_EQ(grading.result("mine")["score"], 4);
}

TEST(Rubric, with_an_error_in_a_scene_is_refused_with_the_line_of_both) {
  const Grading grading;
  grading.write("scene.toml", sphere_text("0, 0, 0", "-1"));
  std::string text = kRubric;
  text += "scenes = [\"scene.toml\"]\n";
  const Outcome outcome = run("grade '" + grading.write("rubric.toml", text) + "'", 2);
  expect_parts(outcome.err, {":12: item[0].functions.scenes[0] = \"scene.toml\": ",
                             "scene.toml:3: sphere[0].radius = -1"});
}

class GradeCommand : public GradingTest {};

TEST_F(GradeCommand, fails_with_2_and_grades_nothing) {
  const std::string mine = grading.submit("mine", "rays.py");
  const std::string again = grading.path("elsewhere/mine"),
                    taken = grading.write("taken", "a file");
  grading.write("elsewhere/mine/rays.py", "");
  const std::string out = " --out '" + grading.path("out") + "'";
  const std::string asked = std::string("grade ") + kLecture7 + " " + mine;
  expect_refused(
      asked + " " + again + out,
      again + ": " + mine +
          " has the same name, mine, under which results are stored; rename one of them");
  expect_refused(asked + out + " --secret-file '" + grading.write("empty", "") + "'", "is empty");
  expect_refused(asked + " --out '" + taken + "'", taken + "/mine: cannot be made: ");
  EXPECT_FALSE(fs::exists(grading.path("out")));
  EXPECT_EQ(contents(taken), "a file");
}

TEST_F(GradeCommand, names_a_fitting_file_that_is_too_deep) {
  const std::string deep = grading.write("submissions/deep/notes.txt", "see code\n");
  grading.write("submissions/deep/code/rays.java", "class Rays {}\n");
  grading.grade(grading.write("java.toml",
                              "[[form]]\nhas = \"*.java\"\nbuild = \"javac *.java\"\n"
                              "candidate = \"command:java Rays\"\n" +
                                  kNearestRoot),
                {grading.path("submissions/deep")});
  EXPECT_EQ(
      grading.result("deep")["refused"]["why"],
      "it has none of the required files: *.java (only in a folder: code/rays.java; has = \"*\" "
      "accepts every submission)");
}

TEST_F(GradeCommand, grades_other_submissions_if_one_fits_no_form) {
  const std::string other = grading.write("submissions/other/main.rb", "puts 1\n");
  const std::string nothing = grading.path("submissions/nothing");
  fs::create_directories(nothing);
  grading.grade(grading.short_rubric("", kNearestRoot),
                {grading.path("submissions/other"), nothing, grading.submit("mine", "rays.py")});
  for (const auto& [name, why] : {std::pair("other", "there is nothing to build or run"),
                                  std::pair("nothing", "it contains no files")}) {
    const auto result = grading.result(name);
    EXPECT_EQ(result["score"], 0);
    expect_parts(result["refused"]["why"], {why});
  }
  EXPECT_EQ(grading.result("mine")["score"], 10);
}

TEST_F(GradeCommand, grades_other_submissions_if_names_are_not_text) {
  const std::string text = contents(grading.submit("mine", "rays.py") + "/rays.py");
  const std::string odd =
      "o\xff"
      "dd";
  grading.write("submissions/" + odd + "/rays.py", text);
  grading.write("submissions/file/" + odd + ".py", text);
  const std::string path = grading.write("rubric.toml", replaced(kRubric, "rays.py", "*.py"));
  for (const char* format : {"json", "csv", "gradescope", "prairielearn"}) {
    grading.grade(path,
                  {grading.path("submissions/" + odd), grading.path("submissions/file"),
                   grading.path("submissions/mine")},
                  "out", std::string("--format ") + format);
    for (const std::string& name : {odd, std::string("file"), std::string("mine")}) {
      EXPECT_EQ(grading.result(name)["score"], 4) << format;
    }
    expect_parts(grading.file("", "index.html"), {"o%FFdd/report.html"});
  }
}

}  // namespace
}  // namespace raycheck::tests
