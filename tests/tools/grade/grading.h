#pragma once

#include "tests/tools/program.h"

namespace raycheck::tests {

/// The name of the seventh lecture's rubric.
inline constexpr const char* kLecture7 = "examples/rubrics/lecture7.toml";

/// A test's folder for submissions, rubrics and results, removed with the test.
class Grading {
 public:
  Grading();
  ~Grading();
  Grading(const Grading&) = delete;
  Grading& operator=(const Grading&) = delete;

  /// The path of a file or folder in it.
  std::string path(const std::string& name) const;
  /// Writes a file and makes its folders; returns its path.
  std::string write(const std::string& name, const std::string& text) const;
  /// Makes a submission, a folder with a file of tests/submissions, with `first` as the first line;
  /// returns its path. Attacks are named rays.cpp.
  std::string submit(const std::string& name, const std::string& file,
                     const std::string& first_line = "") const;
  /// Makes a submission with another file.
  std::string hand_in(const std::string& name, const std::string& file,
                      const std::string& text) const;
  /// Makes a submission that is already built, which is quicker than compiling it while grading;
  /// for `lecture7_with`. `wrong` is the name of its mistake or attack.
  std::string submit_built(const std::string& name, const std::string& file,
                           const std::string& wrong) const;
  /// Built submissions, each named after its mistake or attack.
  std::vector<std::string> submit_each(const std::vector<std::string>& wrong,
                                       const std::string& file) const;
  /// A submission that does not compile.
  std::string submit_broken(const std::string& name) const;
  /// Writes the lecture's rubric and its scenes, with the first text of each pair replaced by the
  /// second. The rubric also accepts built submissions.
  std::string lecture7_with(
      const std::vector<std::pair<std::string, std::string>>& replacements) const;

  /// Writes a quick rubric with these keys, all forms below, and these items.
  std::string short_rubric(const std::string& keys, const std::string& items,
                           const std::string& name = "short.toml") const;

  /// Grades into the folder `out`; expects this exit code.
  Outcome grade(const std::string& rubric, const std::vector<std::string>& submissions,
                const std::string& out = "out", const std::string& more = "",
                std::optional<int> exit_code = 0) const;
  /// The arguments for grading.
  std::string arguments(const std::string& rubric, const std::vector<std::string>& submissions,
                        const std::string& out, const std::string& more = "") const;
  /// A file of a submission's results, empty if it does not exist; result(): its result.json.
  std::string file(const std::string& submission, const std::string& name,
                   const std::string& out = "out") const;
  json result(const std::string& submission, const std::string& out = "out") const;
  /// The data of a submission's page of figures.
  json figures(const std::string& submission, const std::string& out = "out") const;

 private:
  fs::path folder_;
};

/// No isolation, so that each start of a program is cheaper; for tests of other subjects.
inline constexpr const char* kLimitsOnly = "--sandbox none --i-know ";

/// A test with a Grading.
class GradingTest : public testing::Test {
 protected:
  const Grading grading;
};

/// The [[form]]s of built submissions.
inline constexpr const char* kFormsOfBuilt = R"(
[[form]]
has = "*.so"
candidate = "library:{file}"

[[form]]
has = "*.rt"
candidate = "renderer:./{file} {scene} {image}"

)";

/// The [[form]] of programs in Python.
inline constexpr const char* kFormOfPython = R"(
[[form]]
has = "*.py"
candidate = "command:python3 {file}"

)";

/// The [[form]] of automatically built renderers.
inline constexpr const char* kAsTheyCome = R"(
[[form]]
has = "*"
build = "auto"
candidate = "renderer:{program} {scene} {image}"
)";

/// An [[item]] of a rubric: its keys, and its questions to functions.
std::string item_of(const std::string& name, const std::string& keys, const std::string& questions);
std::string functions(const std::string& law, const std::string& source, int cases,
                      const std::string& more = "");
inline constexpr const char* kGivenRays = "rays = \"given\"\n";

/// Questions for pictures of a rubric's scene.
std::string pictures(const std::string& scene, const std::string& more = "judge = \"mask\"\n");

/// Items with few cases, for functions and pictures. Submissions fail them that are mirrored, take
/// the far root or the first sphere, or do not test s >= 0.
inline const std::string kPixelZeroZero =
    item_of("pixel (0, 0)", "points = 4",
            functions("pixel-zero-zero", "course", 6) + pictures("lecture7/orientation.toml"));
inline const std::string kNearestRoot = item_of(
    "nearest root", "points = 10\nhint = \"What does your code do if s = v - d is negative?\"",
    "[item.functions]\nlaws = [\"class\", \"nearest-root\", \"parameter\"]\n"
    "sources = [\"course-behind\"]\ncases = 6\n" +
        (kGivenRays + pictures("lecture7/behind.toml")));
inline const std::string kNearestSphere = item_of(
    "nearest sphere", "points = 15",
    functions("nearest-sphere", "course", 12, kGivenRays) + pictures("lecture7/overlap.toml", ""));

/// A rubric that begins with `head` and has one item for automatically built renderers: `pictures`
/// pictures of full.toml, in which a sphere fills the picture.
std::string full_rubric(int pictures, const std::string& head = "");

/// Renderers that are right for the scene above and for the dry run's scenes, so that their form of
/// driver files is found at once. They draw the discs of five spheres in the colour of the last.
/// The renderer in C or C++ prints the three parts of a colour by this format; the one in Python
/// runs a command before it writes its file; the one in Java is a class Discs.
std::string renderer_in_c(const std::string& format = "\"%.0f %.0f %.0f \"");
std::string renderer_in_python(const std::string& before = "",
                               const std::string& to = "sys.argv[2]");
inline constexpr const char* kRendererInJava = R"(import java.nio.file.*;
public class Discs {
  public static void main(String[] words) throws Exception {
    String[] size = {}, sphere = {};
    for (String line : Files.readAllLines(Path.of(words[0]))) {
      if (line.startsWith("res")) size = line.split("\\s+");
      if (line.startsWith("sphere")) sphere = line.split("\\s+");
    }
    int width = Integer.parseInt(size[1]), height = Integer.parseInt(size[2]);
    StringBuilder image = new StringBuilder("P3 " + width + " " + height + " 255\n");
    for (int k = 0; k < width * height; ++k) {
      int x = Math.abs(2 * (k % width) - width + 1), y = Math.abs(2 * (k / width) - height + 1);
      int far = Math.max(x, y), near = Math.min(x, y);
      boolean isSeen = height < 25 || far * far + near * near < 25 ||
                       (far - 15) * (far - 15) + near * near < 33;
      for (int part = 5; part < 8; ++part)
        image.append(isSeen ? Math.round(255 * Double.parseDouble(sphere[part])) : 0).append(" ");
    }
    Files.writeString(Path.of(words[1]), image);
  }
}
)";

/// The item of this name in a result.json.
json item(const json& result, const std::string& name);

/// The names of the items in this state.
std::vector<std::string> items_that(const json& result, const std::string& state);

/// A result or page with "T" for each time, because times differ between runs, and so does the
/// order in which equal submissions are built.
std::string without_times(const std::string& text);

}  // namespace raycheck::tests
