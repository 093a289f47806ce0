// Renderers that read scene files of other formats than driver files.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

const std::string kBalls =
    "v\nfrom 2.1 1.3 1.7\nat 0 0 0\nup 0 0 1\nangle 45\nhither 1\nresolution 64 48\nl 4 3 2\n"
    "f 1 .75 .33 .8 0 0 0 1\ns 0 0 0 .5\np 3\n12 12 -1\n-12 12 -1\n0 0 0\n"
    "s 0.27 0.27 0.54 .166667\n";

std::string renderer(const std::string& mistake = "") {
  return "--candidate 'renderer:python3 " RAYCHECK_SOURCE_DIR "/tests/candidates/nff.py " +
         mistake + "{scene} {image}' ";
}

/// A rubric for renderers of a format, with one item.
std::string rubric_of(const Grading& grading, const std::string& format,
                      const std::string& arguments = "{scene} {image}",
                      const std::string& conventions = "", int cases = 2) {
  return grading.write("rubric.toml",
                       "[driver]\npreset = \"" + format + "\"\n" + conventions +
                           "[[form]]\nhas = \"rt.py\"\ncandidate = \"renderer:python3 rt.py " +
                           arguments + "\"\n" +
                           item_of("pictures", "points = 10",
                                   "[item.pictures]\njudge = \"spheres\"\n"
                                   "sources = [\"course\"]\ncases = " +
                                       std::to_string(cases) + "\n"));
}

TEST(SceneFormats, of_scenes_are_known_by_the_ending_of_the_name) {
  const std::string balls = temporary_file("balls.nff", kBalls);
  const Outcome right = run("check " + balls + " " + renderer(), 0);
  expect_parts(right.out, {"64 x 48 pixels, 2 spheres", "not needed here: light, polygon",
                           "rows top-first, samples centres, origin focal", "no discrepancy"});
  const Outcome half = run("check " + balls + " " + renderer("half-angle "), 1);
  expect_parts(half.out, {"nearest sphere   3072  250 missed"});
  // An angle whose window has square pixels up to a rounding.
  const std::string wide = temporary_file("wide.nff", replaced(kBalls, "64 48", "60 40"));
  expect_parts(run("check " + wide + " " + renderer(), 0).out,
               {"2400 of 2400 rays judged", "no discrepancy"});
  expect_parts(run("image " + balls + " --out " + temporary_file("b.png", ""), 0).out,
               {"2 of 2 spheres visible"});
  expect_parts(run("plan " + balls, 0).out, {"64 x 48 pixels, 2 spheres"});
  const std::string angel = temporary_file("angel.nff", replaced(kBalls, "angle", "angel"));
  expect_parts(run("check " + angel, 2).err,
               {"angel.nff:5: angel: unknown keyword; angle is missing"});
}

TEST(SceneFormats, are_chosen_for_files_and_renderers) {
  const std::string named = temporary_file("balls.txt", kBalls);
  expect_parts(run("check " + named + " --dialect nff", 0).out, {"64 x 48 pixels, 2 spheres"});
  const Outcome drawn = run("properties --source course --cases 30 --dialect nff " + renderer(), 0);
  expect_parts(drawn.out, {"image            renderer:", "holds on ordinary cases"});
  const Outcome wide = run("check " RAYCHECK_SOURCE_DIR
                           "/scene/examples/first-camera.toml "
                           "--dialect nff " +
                           renderer());
  expect_parts(wide.out, {"the candidate accepts only symmetric windows with square pixels"});
  expect_parts(run("check " + named + " --dialect nfx", 2).err,
               {"--dialect nfx: must be one of A, B, C, 2017, ", "or a format: cse167, "});
}

/// A format that raycheck does not know, in a rubric.
TEST(SceneFormats, of_a_course_are_files_beside_its_rubric) {
  const Grading grading;
  const std::string nff = contents(RAYCHECK_SOURCE_DIR "/scene/formats/nff.toml");
  grading.write("ours.toml",
                replaced(replaced(nff, "from {eye}", "seen_from {eye}"), ".nff", ".ours") +
                    "[variant]\nlater = { \"seen_from {eye}\" = \"located {eye}\" }\n");
  const std::string rubric = rubric_of(grading, "ours.toml");
  const std::string text = replaced(contents(RAYCHECK_SOURCE_DIR "/tests/candidates/nff.py"),
                                    "camera[\"from\"]", "camera[\"seen_from\"]");
  const std::string right = grading.hand_in("right", "rt.py", text);
  const std::string half =
      grading.hand_in("half", "rt.py", replaced(text, "mistake == \"half-angle\"", "True"));
  const std::string later =
      grading.hand_in("later", "rt.py", replaced(text, "\"seen_from\"", "\"located\""));
  grading.grade(rubric, {right, half, later}, "out", kLimitsOnly);
  EXPECT_EQ(grading.result("right")["score"], 10);
  EXPECT_EQ(grading.result("later")["score"], 10);
  EXPECT_EQ(grading.result("later")["driver"]["dialect"], "ours.toml:later");
  const std::string again =
      grading.write("again.toml", replaced(contents(rubric), "ours.toml", "ours.toml:later"));
  grading.grade(again, {later}, "again", kLimitsOnly);
  EXPECT_TRUE(grading.result("later", "again")["notes"].empty());
  EXPECT_EQ(grading.result("half")["score"], 0);
  EXPECT_EQ(grading.result("half")["driver"]["dialect"], "ours.toml");
  expect_parts(grading.file("half", "report.html"), {"seen_from", "rt.py pictures.ours out.ppm"});
  expect_parts(grading.file("half", "pictures.ours"), {"seen_from"});
  grading.write("ours.toml", replaced(nff, "{eye}", "{eyes}"));
  const Outcome wrong = run("grade '" + rubric + "' '" + right + "' --out '" +
                                temporary_folder("wrong") + "' " + kLimitsOnly,
                            2);
  expect_parts(wrong.err, {"ours.toml:5: template = ", "{eyes} is not a slot"});
}

/// A scene is read in the user's format by check with a renderer, too, in the variant that fits; a
/// format that the file contradicts is not said to be the file's if it does not read it.
TEST(SceneFormats, of_users_are_those_of_scenes_that_renderers_draw) {
  const Grading grading;
  const std::string nff = contents(RAYCHECK_SOURCE_DIR "/scene/formats/nff.toml");
  const std::string ours = grading.write(
      "ours.toml", replaced(nff, "from {eye}", "seen_from {eye}") +
                       "[variant]\nlater = { \"seen_from {eye}\" = \"located {eye}\" }\n");
  const std::string text = contents(RAYCHECK_SOURCE_DIR "/tests/candidates/nff.py");
  for (const std::string keyword : {"seen_from", "located"}) {
    const std::string balls = temporary_file("balls.txt", replaced(kBalls, "from ", keyword + " "));
    const std::string program = grading.write(
        keyword + ".py", replaced(text, "camera[\"from\"]", "camera[\"" + keyword + "\"]"));
    expect_parts(
        run("check " + balls + " --dialect " + ours + (keyword == "located" ? ":later" : "") +
                " --candidate 'renderer:python3 " + program + " {scene} {image}'",
            0)
            .out,
        {"(format ours.toml", "64 x 48 pixels, 2 spheres", "no discrepancy"});
    expect_parts(run("check " + balls + " --dialect " + ours, 0).out, {"(format ours.toml"});
  }
}

/// Where pixels are sampled may be open.
TEST(SceneFormats, may_leave_samples_open) {
  const Grading grading;
  const std::string rubric =
      rubric_of(grading, "nff", "{scene} {image}", "[conventions]\nsamples = \"either\"\n");
  const std::string centres = contents(RAYCHECK_SOURCE_DIR "/tests/candidates/nff.py");
  const std::string corners = replaced(replaced(centres, "(i + 0.5)", "i"), "(j + 0.5)", "j");
  const std::string mixed = replaced(centres, "(i + 0.5)", "i");
  grading.grade(
      rubric,
      {grading.hand_in("centres", "rt.py", centres), grading.hand_in("corners", "rt.py", corners),
       grading.hand_in("mixed", "rt.py", mixed),
       grading.hand_in("random", "rt.py",
                       replaced(replaced(centres, "(i + 0.5)", "(i + random.random())"),
                                "import math", "import math\nimport random\nrandom.seed(1)"))},
      "out", kLimitsOnly);
  EXPECT_EQ(grading.result("centres")["score"], 10);
  EXPECT_EQ(grading.result("corners")["score"], 10);
  EXPECT_EQ(grading.result("mixed")["score"], 0);
  EXPECT_EQ(grading.result("random")["score"], 0);
  expect_parts(grading.result("random")["items"][0]["mistakes"].dump(),
               {"pixels are sampled elsewhere in their squares"});
}

/// Any point of a pixel's square may be its sample, and no point beyond.
TEST(SceneFormats, may_have_a_sample_anywhere_in_a_pixel) {
  const Grading grading;
  const std::string rubric =
      rubric_of(grading, "nff", "{scene} {image}", "[conventions]\nsamples = \"any\"\n", 12);
  const auto sampled = [&](const std::string& name, const std::string& across,
                           const std::string& down) {
    const std::string centres = contents(RAYCHECK_SOURCE_DIR "/tests/candidates/nff.py");
    const std::string text = replaced(replaced(centres, "(i + 0.5)", "(i + " + across + ")"),
                                      "(j + 0.5)", "(j + " + down + ")");
    return grading.hand_in(
        name, "rt.py", replaced(text, "import math", "import math\nimport random\nrandom.seed(1)"));
  };
  grading.grade(
      rubric,
      {sampled("mixed", "0", "0.5"), sampled("last", "1", "1"),
       sampled("random", "random.random()", "random.random()"), sampled("beyond", "1.25", "0.5"),
       sampled("above", "0.5", "-0.5"),
       grading.hand_in("far", "rt.py",
                       replaced(contents(RAYCHECK_SOURCE_DIR "/tests/candidates/nff.py"),
                                "s < nearest", "s > (0 if nearest == math.inf else nearest)"))},
      "out", kLimitsOnly);
  for (const char* right : {"mixed", "last", "random"}) {
    EXPECT_EQ(grading.result(right)["score"], 10) << right;
  }
  for (const char* wrong : {"beyond", "above", "far"}) {
    EXPECT_EQ(grading.result(wrong)["score"], 0) << wrong;
  }
}

/// Two sizes of one scene have the same file if the size is only among the arguments.
TEST(SceneFormats, may_leave_the_size_to_the_arguments) {
  const Grading grading;
  const std::string nff = contents(RAYCHECK_SOURCE_DIR "/scene/formats/nff.toml");
  grading.write("ours.toml", replaced(nff, "resolution {width} {height}\n", "") +
                                 "[default]\nwidth = 64\nheight = 48\n");
  for (const std::string size : {"20 15", "40 30"}) {
    grading.write("balls" + size.substr(0, 2) + ".nff", replaced(kBalls, "64 48", size));
  }
  const std::string rubric = rubric_of(grading, "ours.toml", "{scene} {image} {width} {height}");
  const std::string sizes = grading.write(
      "sizes.toml", replaced(contents(rubric), "sources = [\"course\"]\ncases = 2",
                             "scenes = [\"balls20.nff\", \"balls40.nff\"]\nvary = []"));
  const std::string text =
      replaced(replaced(contents(RAYCHECK_SOURCE_DIR "/tests/candidates/nff.py"),
                        "([\"\"] + sys.argv[1:])[-3:]", "\"\", *sys.argv[1:3]"),
               "camera[\"resolution\"]", "sys.argv[3:]");
  grading.grade(sizes, {grading.hand_in("right", "rt.py", text)}, "out", kLimitsOnly);
  EXPECT_EQ(grading.result("right")["score"], 10);
}

/// A renderer that takes only the scene, and chooses the picture's name.
TEST(SceneFormats, may_be_all_that_a_renderer_is_told) {
  const Grading grading;
  const std::string rubric = rubric_of(grading, "nff", "{scene}");
  const std::string text =
      replaced(contents(RAYCHECK_SOURCE_DIR "/tests/candidates/nff.py"),
               "([\"\"] + sys.argv[1:])[-3:]", "\"\", sys.argv[1], \"balls.ppm\"");
  const std::string right = grading.hand_in("right", "rt.py", text);
  const std::string silent =
      grading.hand_in("silent", "rt.py", replaced(text, "\"balls.ppm\"", "\"balls\""));
  grading.grade(rubric, {right, silent}, "out", kLimitsOnly);
  EXPECT_EQ(grading.result("right")["score"], 10);
  EXPECT_TRUE(grading.result("right")["notes"].empty());
  EXPECT_EQ(grading.result("silent")["refused"]["why"],
            "it exited with 0, but did not write a picture");
}

}  // namespace
}  // namespace raycheck::tests
