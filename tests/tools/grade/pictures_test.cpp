// The pictures in students' pages: the drawn picture, the expected one, and their differences.

#include "tests/tools/grade/grading.h"
#include "tests/tools/report/picture.h"

namespace raycheck::tests {
namespace {

/// Prints the pictures of a page as JSON: stated size, alt and bytes.
constexpr const char* kReader = R"py(import base64, html, json, re, sys
found = []
for image in re.findall('<img [^>]*>', open(sys.argv[1]).read()):
    said = dict(re.findall('(\\w+)="([^"]*)"', image))
    kind, data = said['src'].split(',')
    assert kind == 'data:image/png;base64'
    found.append({'size': [int(said['width']), int(said['height'])], 'alt': html.unescape(said['alt']),
                  'bytes': list(base64.b64decode(data, validate=True))})
print(json.dumps(found))
)py";

struct ShownPicture {
  std::string alt;
  ReadPicture picture;
};

/// The pictures of a submission's page.
std::vector<ShownPicture> pictures_of(const Grading& grading, const std::string& name) {
  const std::string reader = grading.write("reader.py", kReader);
  const Outcome read =
      run_python("'" + reader + "' '" + grading.path("out/" + name + "/report.html") + "'", 0);
  std::vector<ShownPicture> shown;
  for (const json& one : json::parse(read.out)) {
    const auto bytes = one["bytes"].get<std::vector<char>>();
    shown.push_back({one["alt"], read_png({bytes.begin(), bytes.end()})});
    // A mark has the same number of pixels on the page and in the file.
    const ReadPicture& picture = shown.back().picture;
    EXPECT_EQ(one["size"], (json{picture.width, picture.height})) << shown.back().alt;
  }
  return shown;
}

/// A picture of a record: "-", "?" or the sphere's number for each pixel, lines from the top.
std::vector<std::vector<std::string>> lines_of(const std::string& runs, std::size_t width) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream words(runs);
  std::size_t count = 0;
  char x = 0;
  for (std::string shown; words >> count >> x >> shown;) {
    for (; count > 0; --count) {
      if (lines.empty() || lines.back().size() == width) lines.emplace_back();
      lines.back().push_back(shown);
    }
  }
  // The rubric's scenes have row 0 at the bottom.
  return {lines.rbegin(), lines.rend()};
}

/// Grades submissions named after these mistakes; returns the item.
void grade_pictures(const Grading& grading, const std::vector<std::string>& folders,
                    const std::string& keys = "") {
  const std::string item = item_of(
      "seen", "points = 4\n" + keys,
      "[item.pictures]\nscenes = [\"lecture7/overlap.toml\", \"lecture7/orientation.toml\"]");
  grading.grade(grading.short_rubric("", item, "rubric.toml"), folders, "out",
                "--format gradescope");
}
json pictures_of_record(const Grading& grading, const std::string& name) {
  return item(grading.result(name), "seen")["failing"]["pictures"];
}

class Pictures : public GradingTest {};

TEST_F(Pictures, are_judged_by_what_their_form_declares) {
  std::string folder;
  for (const std::string name : {"right.py", "written.py", "rt.py"}) {
    folder =
        grading.hand_in("anna", name, contents(RAYCHECK_SOURCE_DIR "/tests/candidates/" + name));
  }
  for (const auto& [mistake, points] : {std::pair("corners", 4), {"right", 0}}) {
    const std::string form = std::string("[driver]\npreset = \"B\"\n[[form]]\nhas = \"rt.py\"\n") +
                             "candidate = \"renderer:python3 rt.py " + mistake +
                             " {scene} {image}\"\ndeclares = \"samples corners\"\n";
    const std::string item =
        item_of("seen", "points = 4", "[item.pictures]\nsources = [\"course\"]\ncases = 3\n");
    grading.grade(grading.write("declares.toml", form + item), {folder}, mistake,
                  "--format gradescope");
    EXPECT_EQ(grading.result("anna", mistake)["score"], points) << mistake;
  }
}

TEST_F(Pictures, show_the_drawn_and_the_exact_picture_pixel_by_pixel) {
  constexpr std::array<std::uint8_t, 3> kBlack = {}, kOrange = {0xe6, 0x9f, 0x00};
  std::set<std::array<std::uint8_t, 3>> colours;
  const std::vector<std::string> mistakes = {"mirrored", "upside_down", "first_sphere_wins",
                                             "u_and_w_flipped"};
  grade_pictures(grading, grading.submit_each(mistakes, "rt.cpp"));
  for (const std::string& mistake : mistakes) {
    const json recorded = pictures_of_record(grading, mistake);
    const auto shown = pictures_of(grading, mistake);
    ASSERT_EQ(shown.size(), 3u) << mistake;
    const auto width = static_cast<std::size_t>(shown[0].picture.width);
    const auto height = static_cast<std::size_t>(shown[0].picture.height);
    std::size_t wrong = 0;
    const auto got = lines_of(recorded["got"], width), exact = lines_of(recorded["exact"], width);
    ASSERT_EQ(got.size(), height);
    ASSERT_EQ(exact.size(), height);
    for (std::size_t y = 0; y < height; ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        for (const auto& [lines, drawn] : {std::pair(&got, &shown[0]), {&exact, &shown[1]}}) {
          const auto& colour = drawn->picture.pixels.at(width * y + x);
          EXPECT_EQ(colour == kBlack, (*lines)[y][x] == "-");
          EXPECT_EQ(colour == kOrange, (*lines)[y][x] == "0");
          colours.insert(colour);
        }
        // The wrong pixels have marks, and no others.
        std::set<std::array<std::uint8_t, 3>> mark;
        for (std::size_t k = 0; k < 49; ++k) {
          mark.insert(shown[2].picture.pixels.at((7 * y + k / 7) * 7 * width + 7 * x + k % 7));
        }
        EXPECT_EQ(mark.size(), got[y][x] == exact[y][x] ? 1u : 2u);
        wrong += got[y][x] == exact[y][x] ? 0 : 1;
      }
    }
    EXPECT_GT(wrong, 0u);
    const std::string counted =
        std::to_string(wrong) + " of " + std::to_string(width * height) + " pixels differ";
    EXPECT_TRUE(shown[2].alt.starts_with(counted)) << shown[2].alt;
    expect_parts(grading.file(mistake, "results.json"), {"\\n" + counted});
    // try_test.cpp runs the commands of the page.
    expect_parts(grading.file(mistake, "report.html"),
                 {"<pre class=\"command\">./" + mistake + ".rt seen.txt out.ppm</pre>",
                  "<pre class=\"command\">raycheck try rubric.toml .</pre>"});
  }
  EXPECT_GE(colours.size(), 3u) << "black and two spheres";
}

TEST_F(Pictures, are_omitted_if_withheld) {
  const std::vector<std::pair<std::string, std::size_t>> kinds = {
      {"", 3},
      {"detail = \"actual-only\"", 1},
      {"detail = \"nothing\"", 0},
      {"visibility = \"hidden\"", 0},
      {"visibility = \"after_published\"", 0}};
  const std::string folder = grading.submit_built("mine", "rt.cpp", "mirrored");
  for (const auto& [keys, count] : kinds) {
    grade_pictures(grading, {folder}, keys);
    const json recorded = pictures_of_record(grading, "mine");
    EXPECT_TRUE(recorded["got"].is_string() && recorded["exact"].is_string()) << keys;
    const auto shown = pictures_of(grading, "mine");
    ASSERT_EQ(shown.size(), count) << keys;
    EXPECT_EQ(count > 0,
              std::any_of(shown.begin(), shown.end(),
                          [](const auto& one) { return one.alt.starts_with("yours, "); }))
        << keys;
    EXPECT_EQ(has(grading.file("mine", "report.html"), "differ"), count == 3) << keys;
    const bool may_tell = count == 3 || keys == "visibility = \"after_published\"";
    EXPECT_EQ(has(grading.file("mine", "results.json"), "pixels differ"), may_tell)
        << keys << ": Gradescope itself keeps what is shown late";
  }
}

TEST_F(Pictures, are_read_by_imagemagick_or_the_submission_is_not_graded) {
  const std::string rubric =
      grading.write("formats.toml", R"(title = "Formats"
[conventions]
origin = "pixel"
[driver]
preset = "B"
[[form]]
has = "rt.py"
candidate = "renderer:python3 {file} right {scene} out.)" +
                                        std::string(has_imagemagick() ? "jpg" : "bmp") +
                                        R"("
[[item]]
name = "seen"
points = 4
[item.pictures]
sources = ["course"]
cases = 4
)");
  std::string folder;
  for (const std::string file : {"rt.py", "right.py", "written.py"}) {
    folder =
        grading.hand_in("mine", file, contents(RAYCHECK_SOURCE_DIR "/tests/candidates/" + file));
  }
  const Outcome graded = grading.grade(rubric, {folder}, "out", "", has_imagemagick() ? 0 : 4);
  expect_parts(graded.out,
               has_imagemagick()
                   ? std::vector<std::string>{"4 of 4", "it writes a JPEG"}
                   : std::vector<std::string>{"for a reason outside the submission: ",
                                              "BMP, which raycheck reads by ImageMagick: "
                                              "install the Debian package imagemagick"});
}

TEST_F(Pictures, of_depths_are_judged_by_the_rubrics_depth) {
  std::string folder;
  for (const std::string file : {"rt.py", "right.py", "written.py"}) {
    folder =
        grading.hand_in("mine", file, contents(RAYCHECK_SOURCE_DIR "/tests/candidates/" + file));
  }
  const auto graded = [&](const std::string& kind, const std::string& depth) {
    const std::string pictures = "scenes = [\"lecture7/frame.toml\"]\nsources = [\"course\"]\n";
    const std::string rubric = grading.write(
        "depth.toml",
        "depth = \"" + depth +
            "\"\n[[form]]\nhas = \"rt.py\"\ncandidate = \"renderer:python3 {file} depth:" + kind +
            " {scene} out.pfm\"\n" +
            item_of("mask", "points = 4",
                    "[item.pictures]\njudge = \"mask\"\ncases = 4\n" + pictures) +
            item_of("depth", "points = 6",
                    "[item.pictures]\njudge = \"depth\"\ncases = 4\n" + pictures));
    grading.grade(rubric, {folder});
    return grading.result("mine");
  };
  const json right = graded("z:0", "z miss 0");
  EXPECT_EQ(right["score"], 10) << right.dump(2);
  EXPECT_EQ(right["notes"], json::array()) << right["notes"];
  const json wrong = graded("z:0", "distance miss 0");
  expect_values(item(wrong, "mask"), {{"score", 4}});
  expect_values(item(wrong, "depth"), {{"score", 0}});
  expect_parts(grading.file("mine", "report.html"), {"--depth", "distance miss 0"});
}

}  // namespace
}  // namespace raycheck::tests
