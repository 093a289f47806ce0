// `grade --probe`: the report of the dry run, and the effect of its suggestion, which must be the
// same.

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// Renderers are shell scripts, which start quickly: if no form works, a renderer is started a
/// hundred times.
const std::string kBlackPicture =
    "echo 'line 4: I do not know that word'\n"
    "{ echo P3 25 25 255; yes '0 0 0' | head -n 625; } > \"$2\"\n";
const std::string kSilentlyMissing = "echo 'first words' >&2\necho 'last words' >&2\n";
const std::string kEmptyPicture = "echo 'wrote it' >&2\n: > \"$2\"\n";
const std::string kOtherSize = "{ echo P3 9 7 255; yes '9 9 9' | head -n 63; } > \"$2\"\n";
const std::string kSky =
    "awk 'BEGIN { print \"P3 25 25 255\"; for (k = 0; k < 625; ++k) "
    "print 9 * (k % 25), 7 * int(k / 25), 255 }' > \"$2\"\n";

const std::string kOnePicture = item_of("one picture", "points = 10",
                                        "[item.pictures]\njudge = \"mask\"\nimage_change = 0.01\n"
                                        "scenes = [\"lecture7/frame.toml\"]");

class Probe : public testing::Test {
 protected:
  Outcome probe(const std::string& rubric, const std::vector<std::string>& submissions,
                const std::string& more = "") const {
    return grading_.grade(rubric, submissions, "out", "--probe " + (kLimitsOnly + more), {});
  }
  /// Submissions, as JSON.
  json probed(const std::vector<std::string>& folders,
              const std::string& rubric = kLecture7) const {
    const Outcome outcome = probe(rubric, folders, "--format json");
    json submissions = json::parse(outcome.out)["submissions"];
    EXPECT_EQ(submissions.size(), folders.size());
    bool is_refused = false;
    for (const json& one : submissions) is_refused = is_refused || !one["refused"].is_null();
    EXPECT_EQ(outcome.exit_code, is_refused ? 1 : 0) << outcome.err;
    return submissions;
  }
  /// A [driver] table with only one form.
  std::string one_form(const std::string& preset = "2018", const std::string& keys = "") const {
    return grading_.write("one-form.toml", keys + "[driver]\npreset = \"" + preset + "\"\n" +
                                               kAsTheyCome + kOnePicture);
  }
  static std::string of_class(const std::string& name) {
    return RAYCHECK_SOURCE_DIR "/tests/submissions/class/" + name;
  }

  const Grading grading_;
};

TEST_F(Probe, lists_what_each_submission_builds_reads_writes_and_shows) {
  const std::vector<std::string> folders = {
      of_class("farid"), grading_.submit("functions", "rays.py"),
      grading_.hand_in("broken", "rt.cpp", "int main() { return 0 }\n")};
  const Outcome outcome = probe(kLecture7, folders);
  EXPECT_EQ(outcome.exit_code, 1) << "one cannot be judged" << outcome.err;
  EXPECT_FALSE(fs::exists(grading_.path("out"))) << "nothing is graded";
  expect_parts(
      outcome.out,
      {"  2018   out.ppm  spheres\n    it writes out.ppm and ignores the given file name\n",
       "\n    implements focal_ray, frame, intersect, nearest, pixel_point, pixel_ray\n",
       "could not be judged: 'g++ -O2 -std=c++20 rt.cpp' exited with 1\n",
       "error: expected ';' before '}' token\n", "3 submissions tried, 1 could not be judged\n"});
  EXPECT_FALSE(has(outcome.out, "does not read")) << "the rubric names no form";
  const json farid = probed({folders[0]})[0];
  expect_values(farid["dry_run"], {{"dialect", "2018"},
                                   {"driver/sphere_numbers", 20},
                                   {"writes", "out.ppm"},
                                   {"shows_a_sphere", true}});
  EXPECT_GT(farid["build_seconds"], 0);
  expect_parts(farid["build"], {"make"});
  EXPECT_EQ(farid["program"], "renderer:./rt {scene} {image}");
}

TEST_F(Probe, suggests_a_rubric_with_the_same_result) {
  const std::vector<std::string> folders = {of_class("farid"), of_class("hanna")};
  const Outcome printed = probe(kLecture7, folders);
  const std::string suggestion =
      json::parse(probe(kLecture7, folders, "--format json").out)["suggestion"];
  EXPECT_TRUE(printed.out.ends_with(suggestion)) << printed.out;
  expect_parts(suggestion, {"[driver]\npreset = \"2018\"\nothers = true\n"});
  const std::string before = grading_.write("before.toml", kAsTheyCome + kOnePicture);
  const std::string pasted = grading_.write("pasted.toml", suggestion + kOnePicture);
  grading_.grade(before, folders, "before");
  grading_.grade(pasted, folders, "pasted");
  for (const char* name : {"farid", "hanna"}) {
    const json now = grading_.result(name, "pasted");
    const json then = grading_.result(name, "before");
    EXPECT_EQ(now["score"], 10) << name;
    for (const char* key : {"items", "driver", "program"}) EXPECT_EQ(now[key], then[key]) << name;
  }
  // All forms have explicit commands, so that there is nothing to suggest for automatic builds.
  const json again = json::parse(probe(pasted, folders, "--format json").out);
  for (const json& one : again["submissions"]) {
    EXPECT_EQ(one["build"].is_string(), one["name"] == "farid") << one["name"];
  }
  EXPECT_FALSE(has(again["suggestion"], "[[form]]"));
}

TEST_F(Probe, suggests_no_form_that_fits_other_submissions) {
  const std::vector<std::string> folders = {grading_.hand_in("one", "rt.py", renderer_in_python()),
                                            grading_.hand_in("two", "rt.py", renderer_in_python()),
                                            grading_.hand_in("three", "rt.py", "pass\n")};
  grading_.write("submissions/three/main.cpp", "int main() {}\n");
  const std::string text = probe(one_form(), folders).out;
  EXPECT_FALSE(has(text, "has = \"rt.py\"")) << text;
  expect_parts(text, {"has = \"*\"\nbuild = \"auto\""});
}

TEST_F(Probe, reports_what_is_wrong_with_a_picture_and_the_programs_output) {
  const json all = probed(
      {grading_.hand_in("missing", "rt.sh", kSilentlyMissing),
       grading_.hand_in("empty", "rt.sh", kEmptyPicture),
       grading_.hand_in("other", "rt.sh", kOtherSize), grading_.hand_in("sky", "rt.sh", kSky)},
      one_form());
  EXPECT_EQ(all[0]["refused"]["why"], "it exited with 0, but did not write its picture, image.ppm");
  EXPECT_EQ(all[0]["refused"]["said"], "first words\nlast words");
  ASSERT_FALSE(all[1]["refused"].is_null());
  expect_parts(all[1]["refused"].dump(), {"wrote it"});
  EXPECT_TRUE(all[2]["refused"].is_null()) << all[2];
  EXPECT_EQ(all[2]["dry_run"]["shows_a_sphere"], false);
  expect_parts(all[3]["refused"].dump(), {"its background has more than one colour"});
  const std::string black =
      probe(one_form(), {grading_.hand_in("black", "rt.sh", kBlackPicture)}).out;
  expect_parts(black, {"    its output:\n      line 4: I do not know that word\n",
                       "    its picture is black in "});
  EXPECT_FALSE(has(black, "could not be judged:")) << black;
  EXPECT_FALSE(has(black, "\n[driver]\n")) << "no form is read";
}

TEST_F(Probe, logs_progress_without_a_terminal_and_retries_programs_that_only_wait) {
  const std::string waits = grading_.hand_in("waits", "rt.py", "import time\ntime.sleep(60)\n");
  const Outcome outcome =
      probe(one_form("2019", "reply_seconds = 1\n"),
            {grading_.hand_in("draws", "rt.py", renderer_in_python()), waits}, "--format json");
  EXPECT_EQ(outcome.err,
            "submissions: 1 of 2 done: draws\nsubmissions: 2 of 2 done: waits\n"
            "submissions: waits: repeated, with no other submission running\n");
  EXPECT_EQ(json::parse(outcome.out)["submissions"][1]["refused"]["why"],
            "it did not end, and used almost no CPU time for 1 s (reply_seconds)");
}

TEST_F(Probe, names_the_form_that_is_read_if_another_is_requested) {
  // Driver files of 2019 contain recursionlevel, which this submission rejects.
  const std::string note =
      "it does not read driver files of form B, spheres of 16 numbers, recursionlevel 0, a light, "
      "but of form B, spheres of 13 numbers, a light";
  const json refuses = probed({of_class("kofi")}, one_form("2019"))[0];
  expect_values(refuses, {{"refused/why", "it exited with 1"}, {"notes", json({note})}});
  // A submission that shows nothing is judged in the requested form.
  const std::string farid = of_class("farid");
  grading_.grade(one_form("auto"), {farid}, "asked", "--dialect C");
  const json asked = grading_.result("farid", "asked");
  expect_parts(asked["notes"].dump(), {"it does not read driver files of form C, "});
  expect_values(asked, {{"driver/dialect", "C"}, {"score", 0}});
}

/// Draws the given spheres in their colours, if they have colours.
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

TEST_F(Probe, describes_colours_only_if_spheres_are_shown) {
  const std::string note = "its colours do not identify the spheres";
  const auto drawing = [&](const std::string& name, const std::string& shown,
                           const std::string& seen) {
    return grading_.hand_in(
        name, "rt.py",
        drawing_renderer("SHOWN = lambda c: " + shown + "\nSEEN = lambda v: " + seen + "\n"));
  };
  // The third draws no sphere if there are fewer than five.
  const json all = probed({drawing("right", "c", "v > 0"), drawing("behind", "c", "v < 0"),
                           drawing("many", "c", "v > 0 and len(spheres) > 5"),
                           drawing("grey", "[sum(c) / 3] * 3", "v > 0"),
                           drawing("red", "[c[0], 0, 0]", "v > 0")});
  for (const json& one : all) {
    EXPECT_EQ(one["dry_run"]["shows_a_sphere"], true) << one;
    EXPECT_EQ(has(one["notes"].dump(), note), one["name"] == "grey" || one["name"] == "red") << one;
  }
}

/// It draws green and blue spheres in black.
TEST_F(Probe, shows_white_spheres_to_a_renderer_whose_colours_do_not_identify_them) {
  const std::string red = grading_.hand_in(
      "red", "rt.py", drawing_renderer("SHOWN = lambda c: [c[0], 0, 0]\nSEEN = lambda v: v > 0\n"));
  const std::string seen = item_of("seen", "points = 10",
                                   "[item.pictures]\njudge = \"mask\"\nimage_change = 0.01\n"
                                   "scenes = [\"lecture7/overlap.toml\"]");
  grading_.grade(grading_.write("seen.toml", kAsTheyCome + seen), {red});
  EXPECT_EQ(grading_.result("red")["score"], 10) << grading_.result("red").dump(2);
}

/// A renderer of a format, for which only the variants 1d have enough numbers of a colour.
TEST_F(Probe, takes_the_variant_of_a_format_in_which_colours_identify_spheres) {
  const auto drawing = [&](const std::string& name, const std::string& colour) {
    return grading_.hand_in(name, "rt.py", R"(import sys
words = [line.split() for line in open(sys.argv[1])]
w, h = next([int(x) for x in one[1:]] for one in words if one[0] == 'imsize')
material = next([float(x) for x in one[1:]] for one in words if one[0] == 'mtlcolor')
colour = )" + colour + R"(
def shown(k):
    x, y = abs(2 * (k % w) - w + 1), abs(2 * (k // w) - h + 1)
    far, near = max(x, y), min(x, y)
    return far * far + near * near < 25 or (far - 15) ** 2 + near * near < 33
with open(sys.argv[2], 'w') as image:
    print('P3', w, h, 255, file=image)
    for k in range(w * h): print(*(colour if shown(k) else (0, 0, 0)), file=image)
)");
  };
  const json all =
      probed({drawing("first", "[round(255 * x) for x in material[:3]]"),
              drawing("full",
                      "[round(255 * x) for x in material[:3]] if len(material) > 9 else "
                      "[255, 255, 255]")},
             one_form("cse5607"));
  EXPECT_EQ(all[0]["dry_run"]["dialect"], "cse5607") << all[0];
  EXPECT_EQ(all[1]["dry_run"]["dialect"], "cse5607-1d") << all[1];
  EXPECT_EQ(all[1]["dry_run"]["tells_spheres"], true) << all[1];
}

TEST_F(Probe, omits_a_light_if_only_the_light_makes_a_renderer_fail) {
  // The light in the dry run's scene has integer coordinates.
  const json lit = probed({grading_.hand_in(
      "lit", "rt.py",
      drawing_renderer(
          "SHOWN = lambda c: c\nSEEN = lambda v: v > 0\n"
          "for line in open(sys.argv[1]):\n"
          "    if line.startswith('light'): [int(x) for x in line.split()[1:]]\n"))})[0];
  EXPECT_EQ(lit["dry_run"]["driver"]["light"], "none") << lit;
  expect_parts(lit["notes"].dump(),
               {"it fails on driver files with a light, so it is given files without"});
}

TEST_F(Probe, prefers_the_most_complete_form_that_is_read) {
  const json drawn = probed({grading_.hand_in("any", "rt.py", renderer_in_python())})[0]["dry_run"];
  EXPECT_EQ(drawn["driver"]["extra_lines"], json({"recursionlevel 0"})) << drawn;
  EXPECT_EQ(drawn["dialect"], "2019");
}

TEST_F(Probe, reports_programs_that_draw_differently_each_time) {
  // The picture is right the first time, and black afterwards.
  const std::string once = "'" + grading_.path("once") + "'";
  const std::string black =
      "if os.path.exists(" + once + "): colour = [0, 0, 0]\nopen(" + once + ", 'w').close()\n";
  const json unsteady = probed({grading_.hand_in("unsteady", "rt.py", renderer_in_python(black))},
                               one_form("2019"))[0];
  EXPECT_EQ(unsteady["dry_run"]["shows_a_sphere"], true);
  expect_parts(unsteady["notes"].dump(), {"differently each time", "not initialised"});
}

TEST_F(Probe, does_not_call_pictures_black_if_the_submission_has_points) {
  // It shows the sphere of the rubric's scene, but no sphere of the dry run's.
  const std::string odd = grading_.hand_in(
      "odd", "rt.sh",
      "while read -r word w h; do [ \"$word\" = res ] && break; done < \"$1\"\n"
      "part=0; [ $h -lt 25 ] && part=255\n"
      "{ echo P3 $w $h 255; yes $part $part $part | head -n $((w * h)); } > \"$2\"\n");
  const std::string rubric = grading_.write("odd.toml", full_rubric(1));
  expect_parts(probed({odd}, rubric)[0]["notes"].dump(), {"its picture is black in "});
  grading_.grade(rubric, {odd});
  const json result = grading_.result("odd");
  EXPECT_GT(result["score"], 0);
  EXPECT_FALSE(has(result["notes"].dump(), "its picture is black")) << result["notes"];
}

TEST_F(Probe, reports_the_time_that_a_slow_renderer_needs) {
  const json slow = probed({grading_.hand_in("slow", "rt.sh", "sleep 1.5\n" + kBlackPicture)},
                           one_form("2019", "reply_seconds = 1\n"))[0];
  ASSERT_FALSE(slow["refused"].is_null());
  expect_parts(slow["refused"]["why"], {"it needs more time"});
  // The time in which it waits for a processor, a tenth of a second, does not count.
  EXPECT_GT(slow["dry_run"]["needed_seconds"], 1.2);
}

TEST_F(Probe, is_the_first_step_of_grading_and_its_notes_are_in_the_table) {
  const std::string draws = grading_.hand_in("draws", "rt.py", renderer_in_python());
  expect_parts(grading_.grade(one_form(), {of_class("farid"), draws}).out,
               {"    it writes out.ppm and ignores the given file name\n"});
}

TEST_F(Probe, uses_the_dialect_option_instead_of_the_rubrics) {
  const std::string farid = of_class("farid");
  const std::string as_2018 = one_form();
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
