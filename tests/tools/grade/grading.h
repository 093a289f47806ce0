#pragma once

#include "tests/tools/program.h"

namespace raycheck::tests {

/// The rubric of the seventh lecture, as the program finds it.
inline constexpr const char* kLecture7 = "examples/rubrics/lecture7.toml";

/// A folder of one test for submissions, rubrics and results, which goes when the test does.
class Grading {
 public:
  Grading();
  ~Grading();
  Grading(const Grading&) = delete;
  Grading& operator=(const Grading&) = delete;

  /// Where a file or folder of this name lies.
  std::string path(const std::string& name) const;
  /// Writes a file, in folders that are made; its path.
  std::string write(const std::string& name, const std::string& text) const;
  /// A submission: a folder of this name with a file of tests/submissions after a first line. Its
  /// path. Attacks lie in rays.cpp.
  std::string submit(const std::string& name, const std::string& file,
                     const std::string& first_line = "") const;
  /// The same of another file.
  std::string hand_in(const std::string& name, const std::string& file,
                      const std::string& text) const;
  /// The same, built: quicker than what is compiled when it is graded, and to be graded by
  /// `lecture7_with`. `wrong` is the name of its mistake or attack.
  std::string submit_built(const std::string& name, const std::string& file,
                           const std::string& wrong) const;
  /// Built submissions, each called as what it does wrong.
  std::vector<std::string> submit_each(const std::vector<std::string>& wrong,
                                       const std::string& file) const;
  /// One that g++ says does not compile.
  std::string submit_broken(const std::string& name) const;
  /// The lecture's rubric and its scenes, with each of the first texts replaced by the second; it
  /// takes built submissions, too.
  std::string lecture7_with(
      const std::vector<std::pair<std::string, std::string>>& replacements) const;

  /// A rubric that grades in a moment: after keys of the rubric, all of the forms below and items.
  std::string short_rubric(const std::string& keys, const std::string& items,
                           const std::string& name = "short.toml") const;

  /// Grades into the folder `out`, which ends so.
  Outcome grade(const std::string& rubric, const std::vector<std::string>& submissions,
                const std::string& out = "out", const std::string& more = "",
                std::optional<int> exit_code = 0) const;
  /// The arguments of the same.
  std::string arguments(const std::string& rubric, const std::vector<std::string>& submissions,
                        const std::string& out, const std::string& more = "") const;
  /// A file of a submission's results, empty where there is none, and its result.json.
  std::string file(const std::string& submission, const std::string& name,
                   const std::string& out = "out") const;
  json result(const std::string& submission, const std::string& out = "out") const;
  /// What a submission's page of figures shows, as data.
  json figures(const std::string& submission, const std::string& out = "out") const;

 private:
  fs::path folder_;
};

/// Where it is not tried how submissions are kept, none is: each start of a program is cheaper.
inline constexpr const char* kLimitsOnly = "--sandbox none --i-know ";

/// A test with such a folder.
class GradingTest : public testing::Test {
 protected:
  const Grading grading;
};

/// The [[form]]s of submissions that are built.
inline constexpr const char* kFormsOfBuilt = R"(
[[form]]
has = "*.so"
candidate = "library:{file}"

[[form]]
has = "*.rt"
candidate = "renderer:./{file} {scene} {image}"

)";

/// That of programs in Python.
inline constexpr const char* kFormOfPython = R"(
[[form]]
has = "*.py"
candidate = "command:python3 {file}"

)";

/// That of renderers as they come.
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

/// Pictures of a scene of a rubric.
std::string pictures(const std::string& scene, const std::string& more = "judge = \"mask\"\n");

/// Items of few cases, of functions and of pictures, which the submissions fail that are mirrored,
/// take the far root or the first sphere, do not test for s >= 0.
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

/// A rubric of one item of renderers as they come, so many pictures of full.toml, after a head.
/// That lies in each such folder: a sphere that fills the picture.
std::string full_rubric(int pictures, const std::string& head = "");

/// Renderers that are right about the scene above, and about those of the dry run, so that their
/// form of driver files is found at once: the discs of five spheres, in the last sphere's colour.
/// The one in C, or C++, prints three parts of a colour by a format; the one in Python does
/// something before it writes to a file; the one in Java is a class Discs.
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

/// An item of a result.json, by its name.
json item(const json& result, const std::string& name);

/// The names of the items in this state.
std::vector<std::string> items_that(const json& result, const std::string& state);

/// A result or page with "T" for each time: how long it took differs from run to run, and so which
/// of two equal submissions was built first.
std::string without_times(const std::string& text);

}  // namespace raycheck::tests
