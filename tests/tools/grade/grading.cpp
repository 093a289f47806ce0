#include "tests/tools/grade/grading.h"

namespace raycheck::tests {
namespace {

/// Prints the document that a page contains in deflated form.
constexpr const char* kDocumentReader = R"py(import base64, re, sys, zlib
found = re.findall('id="document"[^>]*>([^<]*)<', open(sys.argv[1]).read())
assert len(found) == 1
sys.stdout.buffer.write(zlib.decompress(base64.b64decode(found[0])))
)py";

}  // namespace

Grading::Grading() : folder_(temporary_folder("grading")) {
  write("full.toml", camera_text(9, 7) + sphere_text("0, 0, -102", "100"));
}

Grading::~Grading() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string Grading::path(const std::string& name) const { return (folder_ / name).string(); }

std::string Grading::write(const std::string& name, const std::string& text) const {
  const fs::path path = folder_ / name;
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

std::string Grading::submit(const std::string& name, const std::string& file,
                            const std::string& first_line) const {
  const std::string text =
      contents(std::string(RAYCHECK_SOURCE_DIR) + "/tests/" +
               (file == "rays.py" ? "candidates/right.py" : "submissions/" + file));
  EXPECT_FALSE(text.empty()) << "there is no " << file;
  return hand_in(name, file == "hostile.cpp" ? "rays.cpp" : file, first_line + "\n" + text);
}

std::string Grading::hand_in(const std::string& name, const std::string& file,
                             const std::string& text) const {
  write("submissions/" + name + "/" + file, text);
  return path("submissions/" + name);
}

std::string Grading::submit_built(const std::string& name, const std::string& file,
                                  const std::string& wrong) const {
  const std::string folder = path("submissions/" + name);
  built_submission(file, wrong, folder);
  return folder;
}

std::string Grading::submit_broken(const std::string& name) const {
  return hand_in(name, "rays.cpp", "static_assert(false, \"this does not compile\");\n");
}

std::vector<std::string> Grading::submit_each(const std::vector<std::string>& wrong,
                                              const std::string& file) const {
  std::vector<std::string> folders;
  for (const std::string& name : wrong) folders.push_back(submit_built(name, file, name));
  return folders;
}

std::string Grading::lecture7_with(
    const std::vector<std::pair<std::string, std::string>>& replacements) const {
  const std::string root = RAYCHECK_SOURCE_DIR;
  std::string text = contents(root + "/" + kLecture7);
  for (const auto& [from, to] : replacements) text = replaced(text, from, to);
  // The new forms come before the form that fits every submission.
  const std::string last_form = "[[form]]\nhas = \"*\"";
  const std::string rubric =
      write("rubrics/lecture7.toml", replaced(text, last_form, kFormsOfBuilt + last_form));
  fs::copy(root + "/examples/rubrics/lecture7", path("rubrics/lecture7"),
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  return rubric;
}

std::string Grading::short_rubric(const std::string& keys, const std::string& items,
                                  const std::string& name) const {
  return write(name, keys + R"(
title = "A rubric"
[conventions]
samples = "edges"
origin = "pixel"
[driver]
preset = "B"
[[form]]
has = "rays.cpp"
candidate = "source:."
[[form]]
has = "rays.py"
candidate = "command:python3 {file}"
)" + kFormsOfBuilt + kAsTheyCome +
                         items);
}

std::string Grading::arguments(const std::string& rubric,
                               const std::vector<std::string>& submissions, const std::string& out,
                               const std::string& more) const {
  std::string words = "grade " + quoted(rubric);
  for (const std::string& submission : submissions) words += " " + quoted(submission);
  return words + " --out " + quoted(path(out)) + " " + more;
}

Outcome Grading::grade(const std::string& rubric, const std::vector<std::string>& submissions,
                       const std::string& out, const std::string& more,
                       std::optional<int> exit_code) const {
  return run(arguments(rubric, submissions, out, more), exit_code);
}

std::string Grading::file(const std::string& submission, const std::string& name,
                          const std::string& out) const {
  return contents((folder_ / out / submission / name).string());
}

json Grading::result(const std::string& submission, const std::string& out) const {
  const std::string text = file(submission, "result.json", out);
  EXPECT_FALSE(text.empty()) << submission << " has no result.json";
  return text.empty() ? json() : json::parse(text);
}

json Grading::figures(const std::string& submission, const std::string& out) const {
  const std::string page = file(submission, "figures.html", out);
  EXPECT_FALSE(page.empty()) << submission << " has no figures.html";
  const std::string reader = write("figures.py", kDocumentReader);
  const Outcome read =
      run_python(quoted(reader) + " " + quoted(path(out + "/" + submission + "/figures.html")));
  EXPECT_EQ(read.exit_code, 0) << read.err;
  return read.exit_code == 0 ? json::parse(read.out) : json();
}

std::string renderer_in_c(const std::string& format) {
  return R"(#include <stdio.h>
#include <stdlib.h>
int main(int count, char** words) {
  char line[1000];
  int width = 0, height = 0;
  double red = 0, green = 0, blue = 0;
  FILE* driver = fopen(words[count - 2], "r");
  while (fgets(line, sizeof line, driver)) {
    sscanf(line, "res %d %d", &width, &height);
    sscanf(line, "sphere %*f %*f %*f %*f %lf %lf %lf", &red, &green, &blue);
  }
  FILE* image = fopen(words[count - 1], "w");
  fprintf(image, "P3 %d %d 255\n", width, height);
  for (int k = 0; k < width * height; ++k) {
    int x = abs(2 * (k % width) - width + 1), y = abs(2 * (k / width) - height + 1);
    int far = x > y ? x : y, near = x + y - far;
    int share = height < 25 || far * far + near * near < 25 ||
                        (far - 15) * (far - 15) + near * near < 33 ? 255 : 0;
    fprintf(image, )" +
         format + R"(, share * red, share * green, share * blue);
  }
  return fclose(image);
}
)";
}

std::string renderer_in_python(const std::string& before, const std::string& to) {
  return R"(import os, sys
for line in open(sys.argv[1]):
    word, *rest = line.split() or ['']
    if word == 'res': w, h = map(int, rest[:2])
    if word == 'sphere': colour = [round(255 * float(x)) for x in rest[4:7]]
def shown(k):
    x, y = abs(2 * (k % w) - w + 1), abs(2 * (k // w) - h + 1)
    far, near = max(x, y), min(x, y)
    is_seen = h < 25 or far * far + near * near < 25 or (far - 15) ** 2 + near * near < 33
    return colour if is_seen else [0, 0, 0]
)" + before +
         "with open(" + to + R"(, 'w') as image:
    print('P3', w, h, 255, *(part for k in range(w * h) for part in shown(k)), file=image)
)";
}

std::string item_of(const std::string& name, const std::string& keys,
                    const std::string& questions) {
  return "[[item]]\nname = \"" + name + "\"\n" + keys + "\n" + questions + "\n";
}

std::string functions(const std::string& law, const std::string& source, int cases,
                      const std::string& more) {
  return "[item.functions]\nlaws = [\"" + law + "\"]\nsources = [\"" + source +
         "\"]\ncases = " + std::to_string(cases) + "\n" + more;
}

std::string pictures(const std::string& scene, const std::string& more) {
  return "[item.pictures]\n" + more + "scenes = [\"" + scene + "\"]\n";
}

std::string full_rubric(int pictures, const std::string& head) {
  std::string scenes;
  for (int k = 0; k < pictures; ++k) scenes += "\"full.toml\", ";
  return head + "[driver]\npreset = \"B\"\n" + kAsTheyCome + R"(
[[item]]
name = "all"
points = 10
[item.pictures]
judge = "mask"
scenes = [)" +
         scenes + "]\n";
}

json item(const json& result, const std::string& name) {
  json one = found(result["items"], "name", name);
  EXPECT_FALSE(one.is_null()) << "there is no item " << name << " in " << result.dump(2);
  return one;
}

std::vector<std::string> items_that(const json& result, const std::string& state) {
  std::vector<std::string> names;
  for (const json& one : result["items"]) {
    if (one["state"] == state) names.push_back(one["name"]);
  }
  return names;
}

std::string without_times(const std::string& text) {
  static const std::regex kTimes(
      R"(("(build|judge)_seconds": [0-9.e-]+)|("build_is_stored": (true|false))|([0-9.]+ s(, ([0-9]+ )?from the store)?))");
  return std::regex_replace(text, kTimes, "T");
}

}  // namespace raycheck::tests
