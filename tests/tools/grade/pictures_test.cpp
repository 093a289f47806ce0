// The pictures in students' pages: what was drawn, what is expected, and where they differ.

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

/// Prints the pictures of a page as JSON: width, height, alt, and lines of colours from the top.
constexpr const char* kReader = R"py(import base64, html, json, re, struct, sys, zlib
def pixels(data):
    assert data[:8] == b'\x89PNG\r\n\x1a\n'
    at, idat = 8, b''
    while at < len(data):
        size, kind = struct.unpack('>I4s', data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b'IHDR':
            width, height, depth, colour = struct.unpack('>IIBB', body[:10])
            assert (depth, colour) == (8, 2)
        if kind == b'IDAT':
            idat += body
        at += 12 + size
    raw, before, lines = zlib.decompress(idat), bytes(3 * width), []
    for y in range(height):
        kind, line = raw[y * (3 * width + 1)], bytearray(raw[y * (3 * width + 1) + 1:(y + 1) * (3 * width + 1)])
        for k in range(3 * width):
            a, b, c = (line[k - 3] if k > 2 else 0), before[k], (before[k - 3] if k > 2 else 0)
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line[k] = line[k] + (0, a, b, (a + b) // 2, paeth)[kind] & 255
        before = bytes(line)
        lines.append([before[k:k + 3].hex() for k in range(0, 3 * width, 3)])
    return lines
found = []
for image in re.findall('<img [^>]*>', open(sys.argv[1]).read()):
    said = dict(re.findall('(\\w+)="([^"]*)"', image))
    kind, data = said['src'].split(',')
    assert kind == 'data:image/png;base64'
    found.append({'width': int(said['width']), 'height': int(said['height']),
                  'alt': html.unescape(said['alt']), 'lines': pixels(base64.b64decode(data, validate=True))})
print(json.dumps(found))
)py";

/// The pictures of a submission's page.
json pictures_of(const Grading& grading, const std::string& name) {
  const std::string reader = grading.write("reader.py", kReader);
  const Outcome read =
      run_python("'" + reader + "' '" + grading.path("out/" + name + "/report.html") + "'", 0);
  return read.exit_code == 0 ? json::parse(read.out) : json();
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

/// The item of submissions with these mistakes, called as they are, graded.
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

TEST(Pictures, are_what_was_drawn_and_what_is_exact_pixel_by_pixel) {
  const Grading grading;
  std::set<std::string> colours;
  const std::vector<std::string> mistakes = {"mirrored", "upside_down", "first_sphere_wins",
                                             "u_and_w_flipped"};
  std::vector<std::string> folders;
  for (const std::string& mistake : mistakes) {
    folders.push_back(grading.submit_built(mistake, "rt.cpp", mistake));
  }
  grade_pictures(grading, folders);
  for (const std::string& mistake : mistakes) {
    const json recorded = pictures_of_record(grading, mistake);
    const json shown = pictures_of(grading, mistake);
    ASSERT_EQ(shown.size(), 3u) << mistake;
    const std::size_t width = shown[0]["width"], height = shown[0]["height"];
    std::size_t wrong = 0;
    const auto got = lines_of(recorded["got"], width), exact = lines_of(recorded["exact"], width);
    ASSERT_EQ(got.size(), height);
    ASSERT_EQ(exact.size(), height);
    for (std::size_t y = 0; y < height; ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        for (const auto& [lines, drawn] : {std::pair(got, shown[0]), {exact, shown[1]}}) {
          const std::string colour = drawn["lines"][y][x];
          EXPECT_EQ(colour == "000000", lines[y][x] == "-");
          EXPECT_EQ(colour == "e69f00", lines[y][x] == "0");
          colours.insert(colour);
        }
        // A wrong pixel has a mark, a right one has none.
        std::set<std::string> mark;
        for (std::size_t k = 0; k < 49; ++k) {
          mark.insert(shown[2]["lines"][7 * y + k / 7][7 * x + k % 7].get<std::string>());
        }
        EXPECT_EQ(mark.size(), got[y][x] == exact[y][x] ? 1u : 2u);
        wrong += got[y][x] == exact[y][x] ? 0 : 1;
      }
    }
    EXPECT_GT(wrong, 0u);
    const std::string counted =
        std::to_string(wrong) + " of " + std::to_string(width * height) + " pixels differ";
    EXPECT_EQ(shown[2]["alt"].get<std::string>().find(counted), 0u) << shown[2]["alt"];
    expect_parts(grading.file(mistake, "results.json"), {"\\n" + counted});
  }
  EXPECT_GE(colours.size(), 3u) << "black and two spheres";
}

TEST(Pictures, that_are_withheld_are_not_there) {
  const std::vector<std::pair<std::string, std::size_t>> kinds = {
      {"", 3},
      {"detail = \"actual-only\"", 1},
      {"detail = \"nothing\"", 0},
      {"visibility = \"hidden\"", 0},
      {"visibility = \"after_published\"", 0}};
  const Grading grading;
  const std::string folder = grading.submit_built("mine", "rt.cpp", "mirrored");
  for (const auto& [keys, count] : kinds) {
    grade_pictures(grading, {folder}, keys);
    const json recorded = pictures_of_record(grading, "mine");
    EXPECT_TRUE(recorded["got"].is_string() && recorded["exact"].is_string()) << keys;
    const json shown = pictures_of(grading, "mine");
    ASSERT_EQ(shown.size(), count) << keys;
    EXPECT_EQ(count > 0, has(shown.dump(), "\"yours, ")) << keys;
    EXPECT_EQ(has(grading.file("mine", "report.html"), "differ"), count == 3) << keys;
    const bool may_tell = count == 3 || keys == "visibility = \"after_published\"";
    EXPECT_EQ(has(grading.file("mine", "results.json"), "pixels differ"), may_tell)
        << keys << ": Gradescope itself keeps what is shown late";
  }
}

/// The commands beside them are run by home_test.cpp.
TEST(Pictures, are_the_same_later_with_commands_that_repeat_them) {
  const Grading grading;
  const std::string folder = grading.submit_built("mine", "rt.cpp", "mirrored");
  grade_pictures(grading, {folder});
  const std::string page = grading.file("mine", "report.html");
  grading.grade(grading.path("rubric.toml"), {folder});
  EXPECT_EQ(grading.file("mine", "report.html"), page);
  expect_parts(page, {"<pre class=\"command\">./mirrored.rt seen.txt out.ppm</pre>",
                      "<pre class=\"command\">raycheck try rubric.toml .</pre>"});
}

}  // namespace
}  // namespace raycheck::tests
