#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

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
  /// The same, built: quicker than what is compiled when it is graded, and to be graded by
  /// `lecture7_with`. `wrong` is the name of its mistake or attack.
  std::string submit_built(const std::string& name, const std::string& file,
                           const std::string& wrong) const;
  /// The lecture's rubric and its scenes, with each of the first texts replaced by the second; it
  /// takes built submissions, too.
  std::string lecture7_with(
      const std::vector<std::pair<std::string, std::string>>& replacements) const;

  /// Grades into the folder `out`, which ends with 0; the other may end otherwise.
  Outcome grade(const std::string& rubric, const std::vector<std::string>& submissions,
                const std::string& out = "out", const std::string& more = "") const;
  Outcome try_to_grade(const std::string& rubric, const std::vector<std::string>& submissions,
                       const std::string& out = "out", const std::string& more = "") const;
  /// The arguments of the same.
  std::string arguments(const std::string& rubric, const std::vector<std::string>& submissions,
                        const std::string& out, const std::string& more = "") const;
  /// A file of a submission's results, empty where there is none, and its result.json.
  std::string file(const std::string& submission, const std::string& name,
                   const std::string& out = "out") const;
  nlohmann::json result(const std::string& submission, const std::string& out = "out") const;
  /// What a submission's page of figures shows, as data.
  nlohmann::json figures(const std::string& submission, const std::string& out = "out") const;

 private:
  std::filesystem::path folder_;
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

/// A sphere that fills the picture: a program that reads the size and writes white is right.
inline constexpr const char* kFullScene = R"([camera]
eye = [0, 0, 0]
look_at = [0, 0, -1]
up = [0, 1, 0]
near = -1
left = -1
right = 1
bottom = -1
top = 1
width = 9
height = 7

[[sphere]]
centre = [0, 0, -102]
radius = 100
)";

/// A rubric of one item of renderers as they come, so many pictures of full.toml, after a head.
std::string full_rubric(int pictures, const std::string& head = "");

/// A renderer in Python that reads the size, does what it is asked to, and writes white to a file.
std::string white_renderer(const std::string& before = "", const std::string& to = "sys.argv[2]");

/// The line that makes a file of tests/submissions wrong.
std::string mistake_line(const std::string& file, const std::string& mistake);

/// An item of a result.json, by its name.
nlohmann::json item(const nlohmann::json& result, const std::string& name);

/// The names of the items in this state.
std::vector<std::string> items_that(const nlohmann::json& result, const std::string& state);

/// A result or page with "T" for each time: how long it took differs from run to run, and so which
/// of two equal submissions was built first.
std::string without_times(const std::string& text);

}  // namespace raycheck::tests
