// `grade --probe`: what the dry run says, and that what it suggests does the same.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A renderer whose picture says nothing.
const std::string kBlackPicture = R"(import sys
print("line 4: I do not know that word")
with open(sys.argv[2], "w") as image:
    image.write("P3 25 25 255\n" + "0 0 0 " * 625)
)";
const std::string kSky = R"(import sys
with open(sys.argv[2], "w") as image:
    image.write("P3 25 25 255\n" + " ".join(f"{9 * i} {7 * j} 255" for j in range(25) for i in range(25)))
)";
const std::string kSilentlyMissing = R"(import sys
print("first words", file=sys.stderr)
print("last words", file=sys.stderr)
)";
const std::string kEmptyPicture = R"(import sys
print("wrote it", file=sys.stderr)
open(sys.argv[2], "w")
)";

const std::string kOnePicture = R"(
[[item]]
name = "one picture"
points = 10
[item.pictures]
judge = "mask"
image_change = 0.01
scenes = ["lecture7/frame.toml"]
)";

class Probe : public testing::Test {
 protected:
  Outcome probe(const std::string& rubric, const std::vector<std::string>& submissions,
                const std::string& more = "") const {
    return grading_.try_to_grade(rubric, submissions, "out", "--probe " + more);
  }
  /// One submission, as JSON.
  json probed(const std::string& folder, const std::string& rubric = kLecture7) const {
    const Outcome outcome = probe(rubric, {folder}, "--format json");
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.err;
    const json report = json::parse(outcome.out);
    EXPECT_EQ(report["submissions"].size(), 1u);
    EXPECT_EQ(outcome.exit_code, report["submissions"][0]["refused"].is_null() ? 0 : 1);
    return report["submissions"][0];
  }
  std::string hand_in(const std::string& name, const std::string& file,
                      const std::string& text) const {
    grading_.write("submissions/" + name + "/" + file, text);
    return grading_.path("submissions/" + name);
  }
  /// Driver files of one form alone.
  std::string one_form() const {
    return grading_.write("one-form.toml",
                          std::string("[driver]\npreset = \"2018\"\n") + kAsTheyCome + kOnePicture);
  }
  static std::string of_class(const std::string& name) {
    return RAYCHECK_SOURCE_DIR "/tests/submissions/class/" + name;
  }

  const Grading grading_;
};

TEST_F(Probe, says_what_each_builds_reads_writes_and_shows_and_writes_nothing) {
  const std::vector<std::string> folders = {
      of_class("farid"), of_class("dmitri"), grading_.submit("functions", "rays.py"),
      hand_in("broken", "rt.cpp", "int main() { return 0 }\n")};
  const Outcome outcome = probe(kLecture7, folders);
  EXPECT_EQ(outcome.exit_code, 1) << "one cannot be judged" << outcome.err;
  EXPECT_FALSE(fs::exists(grading_.path("out"))) << "nothing is graded";
  expect_parts(
      outcome.out,
      {"  2018   out.ppm  spheres\n    it writes out.ppm whatever name it is given\n",
       "\n    offers focal_ray, frame, intersect, nearest, pixel_point, pixel_ray\n",
       "could not be judged: 'g++ -O2 -std=c++20 rt.cpp' exited with 1\n",
       "error: expected ';' before '}' token\n", "4 submissions tried, 1 could not be judged\n"});
  EXPECT_FALSE(has(outcome.out, "does not read")) << "the rubric names no form";
  const json farid = probed(folders[0]);
  EXPECT_EQ(farid["dry_run"]["dialect"], "2018");
  EXPECT_EQ(farid["dry_run"]["driver"]["sphere_numbers"], 20);
  EXPECT_EQ(farid["dry_run"]["writes"], "out.ppm");
  EXPECT_EQ(farid["dry_run"]["shows_a_sphere"], true);
  EXPECT_GT(farid["build_seconds"], 0);
  expect_parts(farid["build"], {"make"});
  EXPECT_EQ(farid["program"], "renderer:./rt {scene} {image}");
}

TEST_F(Probe, suggests_what_does_the_same_in_a_rubric) {
  const std::vector<std::string> folders = {of_class("farid"), of_class("dmitri"),
                                            of_class("hanna")};
  const Outcome printed = probe(kLecture7, folders);
  const std::string suggestion =
      json::parse(probe(kLecture7, folders, "--format json").out)["suggestion"];
  EXPECT_TRUE(printed.out.ends_with(suggestion)) << printed.out;
  expect_parts(suggestion, {"[driver]\npreset = \"2018\"\nothers = true\n"});
  const std::string before = grading_.write("before.toml", kAsTheyCome + kOnePicture);
  const std::string pasted = grading_.write("pasted.toml", suggestion + kOnePicture);
  grading_.grade(before, folders, "before");
  grading_.grade(pasted, folders, "pasted");
  for (const char* name : {"farid", "dmitri", "hanna"}) {
    const json now = grading_.result(name, "pasted");
    const json then = grading_.result(name, "before");
    EXPECT_EQ(now["score"], 10) << name;
    for (const char* key : {"items", "driver", "program"}) EXPECT_EQ(now[key], then[key]) << name;
  }
  // The forms are those in words, not the one that builds as it comes.
  for (const json& one : json::parse(probe(pasted, folders, "--format json").out)["submissions"]) {
    const bool is_built = one["name"] == "farid";
    EXPECT_EQ(one["build"].is_string(), is_built) << one["name"];
  }
  EXPECT_FALSE(has(probe(pasted, folders).out, "[[form]]")) << "there is no more to say";
}

TEST_F(Probe, suggests_no_form_that_would_fit_others_too) {
  const std::vector<std::string> folders = {hand_in("one", "rt.py", kBlackPicture),
                                            hand_in("two", "rt.py", kBlackPicture),
                                            hand_in("three", "rt.py", "#!/usr/bin/python3\n")};
  grading_.write("submissions/three/main.cpp", "int main() {}\n");
  const std::string text = probe(one_form(), folders).out;
  EXPECT_FALSE(has(text, "has = \"rt.py\"")) << text;
  expect_parts(text, {"has = \"*\"\nbuild = \"auto\""});
  EXPECT_FALSE(has(text, "\n[driver]\n")) << "no form is read";
}

TEST_F(Probe, repeats_a_programs_own_words_where_its_picture_is_missing_empty_or_black) {
  const json missing = probed(hand_in("missing", "rt.py", kSilentlyMissing), one_form());
  EXPECT_EQ(missing["refused"]["why"], "it made no picture {image}");
  EXPECT_EQ(missing["refused"]["said"], "first words\nlast words");
  const json empty = probed(hand_in("empty", "rt.py", kEmptyPicture), one_form());
  ASSERT_FALSE(empty["refused"].is_null());
  expect_parts(empty["refused"].dump(), {"wrote it"});
  const std::string folder = hand_in("black", "rt.py", kBlackPicture);
  const json black = probed(folder, one_form());
  EXPECT_TRUE(black["refused"].is_null());
  EXPECT_EQ(black["dry_run"]["shows_a_sphere"], false);
  expect_parts(black["dry_run"]["said"], {"line 4: I do not know that word"});
  expect_parts(black["notes"].dump(), {"its picture is black"});
  const std::string text = probe(one_form(), {folder}).out;
  expect_parts(text, {"    it said:\n      line 4: I do not know that word\n"});
}

TEST_F(Probe, lists_what_is_done_where_nobody_watches_and_tries_again_alone_what_only_waits) {
  const std::string waits = hand_in("waits", "rt.py", "import time\ntime.sleep(60)\n");
  const std::string rubric = grading_.write(
      "one-second.toml", std::string("[limits]\nreply_seconds = 1\n[driver]\npreset = \"2018\"\n") +
                             kAsTheyCome + kOnePicture);
  const Outcome outcome =
      probe(rubric, {hand_in("black", "rt.py", kBlackPicture), waits}, "--format json");
  EXPECT_EQ(outcome.err,
            "submissions: 1 of 2 tried: black\nsubmissions: 2 of 2 tried: waits\n"
            "submissions: tried again, alone: waits\n");
  EXPECT_EQ(json::parse(outcome.out)["submissions"][1]["refused"]["why"],
            "it did not end, and computed next to nothing for 1 s (reply_seconds)");
}

TEST_F(Probe, shows_no_sphere_in_a_picture_of_another_size_or_of_many_colours) {
  const json other = probed(hand_in("other", "rt.py", R"(import sys
open(sys.argv[2], "w").write("P3 9 7 255\n" + "9 9 9 " * 63)
)"),
                            one_form());
  EXPECT_TRUE(other["refused"].is_null()) << other;
  EXPECT_EQ(other["dry_run"]["shows_a_sphere"], false);
  const json sky = probed(hand_in("sky", "rt.py", kSky), one_form());
  expect_parts(sky["refused"].dump(), {"its background is not of one colour"});
}

TEST_F(Probe, names_the_form_that_is_read_where_another_is_asked_for) {
  // Its driver file says recursionlevel, which this one refuses.
  const std::string note =
      "it does not read driver files of form B, spheres of 16 numbers, recursionlevel 0, a light, "
      "but of form B, spheres of 13 numbers, a light";
  const std::string rubric = grading_.lecture7_with({{"preset = \"auto\"", "preset = \"2019\""}});
  const json refuses = probed(of_class("kofi"), rubric);
  EXPECT_EQ(refuses["refused"]["why"], "it exited with 1");
  EXPECT_EQ(refuses["notes"], json({note}));
  expect_parts(probe(rubric, {of_class("kofi")}).out, {"    " + note + "\n"});
  // What only shows nothing is judged in the form that was asked for.
  const std::string farid = of_class("farid");
  grading_.grade(kLecture7, {farid}, "asked", "--dialect C");
  const json asked = grading_.result("farid", "asked");
  expect_parts(asked["notes"].dump(), {"it does not read driver files of form C, "});
  EXPECT_EQ(asked["driver"]["dialect"], "C");
  EXPECT_EQ(asked["score"], 0);
}

/// Draws the spheres it is given, in the colours they have, where they have one.
std::string drawing_renderer(const std::string& more) {
  return R"(import math, sys
spheres = []
for line in open(sys.argv[1]):
    word, *rest = line.split()
    if word == 'eye': eye = list(map(float, rest))
    if word == 'look': look = list(map(float, rest))
    if word == 'd': d = float(rest[0])
    if word == 'bounds': left, right, bottom, top = map(float, rest)
    if word == 'res': w, h = map(int, rest)
    if word == 'sphere': spheres.append(list(map(float, rest[:7])))
BLACK = [0, 0, 0]
)" + more +
         R"(
print_to = open(sys.argv[2], 'w')
print_to.write(f'P3 {w} {h} 255\n')
for j in range(h):
    for i in range(w):
        x, y = left + (right - left) * i / (w - 1), top + (bottom - top) * j / (h - 1)
        length = math.sqrt(x * x + y * y + d * d)
        D = [x / length, y / length, d / length]
        best, colour = math.inf, BLACK
        for sphere in spheres:
            T = [sphere[k] - eye[k] for k in range(3)]
            v = sum(T[k] * D[k] for k in range(3))
            square = sphere[3] ** 2 - sum(t * t for t in T) + v * v
            if square >= 0 and SEEN(v) and v < best:
                best, colour = v, sphere[4:]
        print_to.write(' '.join(str(int(255 * c)) for c in SHOWN(colour)) + '\n')
)";
}

TEST_F(Probe, says_of_colours_what_they_tell_and_nothing_where_spheres_are_not_shown) {
  const std::string note = "its colours do not tell which sphere is seen";
  const auto notes_of = [&](const std::string& name, const std::string& more) {
    const json one = probed(hand_in(name, "rt.py", drawing_renderer(more)));
    EXPECT_EQ(one["dry_run"]["shows_a_sphere"], true) << name << one;
    return one["notes"].dump();
  };
  const std::string as_they_are = "SHOWN = lambda c: c\n";
  EXPECT_FALSE(has(notes_of("right", as_they_are + "SEEN = lambda v: v > 0\n"), note));
  EXPECT_FALSE(has(notes_of("behind", as_they_are + "SEEN = lambda v: v < 0\n"), note));
  // Of fewer spheres than five it shows none.
  EXPECT_FALSE(
      has(notes_of("many", as_they_are + "SEEN = lambda v: v > 0 and len(spheres) > 5\n"), note));
  expect_parts(notes_of("grey", "SHOWN = lambda c: [sum(c) / 3] * 3\nSEEN = lambda v: v > 0\n"),
               {note});
  expect_parts(notes_of("red", "SHOWN = lambda c: [c[0], 0, 0]\nSEEN = lambda v: v > 0\n"), {note});
}

TEST_F(Probe, leaves_out_a_light_by_which_alone_a_renderer_fails) {
  // The light of the dry run's scene is at whole numbers.
  const json lit = probed(hand_in(
      "lit", "rt.py",
      drawing_renderer("SHOWN = lambda c: c\nSEEN = lambda v: v > 0\n"
                       "for line in open(sys.argv[1]):\n"
                       "    if line.startswith('light'): [int(x) for x in line.split()[1:]]\n")));
  EXPECT_EQ(lit["dry_run"]["driver"]["light"], "none") << lit;
  expect_parts(lit["notes"].dump(),
               {"it fails where there is a light, so its driver files have none"});
}

/// Of renderers in Python that are tried in many forms.
class LongProbe : public Probe {};

TEST_F(LongProbe, does_not_call_pictures_black_of_what_has_points) {
  // It shows the spheres of every scene but of the dry run's, which has fifteen.
  const std::string odd =
      hand_in("odd", "rt.py",
              drawing_renderer("SHOWN = lambda c: c\n"
                               "SEEN = lambda v: v > 0 and len(spheres) < 15\n"));
  expect_parts(probed(odd)["notes"].dump(), {"its picture is black in the "});
  grading_.grade(kLecture7, {odd});
  const json result = grading_.result("odd");
  EXPECT_GT(result["score"], 0);
  EXPECT_FALSE(has(result["notes"].dump(), "its picture is black")) << result["notes"];
}

TEST_F(Probe, says_how_much_time_a_slow_renderer_needs) {
  const std::string folder =
      hand_in("slow", "rt.py", "import sys, time\ntime.sleep(1.5)\n" + kBlackPicture);
  const json slow =
      probed(folder, grading_.lecture7_with({{"reply_seconds = 5", "reply_seconds = 1"},
                                             {"preset = \"auto\"", "preset = \"2019\""}}));
  ASSERT_FALSE(slow["refused"].is_null());
  expect_parts(slow["refused"]["why"], {"it needs more time"});
  // A tenth of a second in which it waits for a processor is not its own.
  EXPECT_GT(slow["dry_run"]["needed_seconds"], 1.2);
}

TEST_F(Probe, is_the_first_step_of_grading_whose_table_has_its_notes) {
  expect_parts(
      grading_.grade(one_form(), {of_class("farid"), hand_in("black", "rt.py", kBlackPicture)}).out,
      {"    it writes out.ppm whatever name it is given\n", "    its picture is black in "});
}

TEST_F(Probe, reads_what_the_dialect_says_in_place_of_the_rubrics) {
  const std::string farid = of_class("farid");
  const std::string as_2018 = grading_.write(
      "2018.toml", std::string("[driver]\npreset = \"2018\"\n") + kAsTheyCome + kOnePicture);
  const auto form_of = [&](const std::string& rubric, const std::string& more) {
    grading_.grade(rubric, {farid}, "out", more);
    const json result = grading_.result("farid");
    return result["driver"]["dialect"].get<std::string>() +
           std::to_string(result["driver"]["sphere_numbers"].get<int>());
  };
  EXPECT_EQ(form_of(as_2018, ""), "A20");
  EXPECT_EQ(form_of(as_2018, "--dialect auto"), "A20");
  EXPECT_EQ(form_of(as_2018, "--dialect B:17:no-light"), "B17");
  EXPECT_EQ(form_of(as_2018, ""), "A20");
}

}  // namespace
}  // namespace raycheck::tests
