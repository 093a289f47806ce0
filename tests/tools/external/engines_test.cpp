// The adapters of engines as candidates, judged by their declarations. The target `engines` builds
// them.

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

/// Expects right hits on a plain scene, in the declared precision.
void expect_judged(const std::string& library, const std::string& precision) {
  const json report = judged("scene/examples/ten-spheres.toml", "library:" + library);
  EXPECT_EQ(report["discrepancies_by_standing"]["defect"], 0) << report.dump(2);
  EXPECT_EQ(report["precision"], precision);
  EXPECT_TRUE(report["given_rays"]);
  EXPECT_GT(quantity_of(report["quantities"], "parameter")["cases"], 100);
}

/// The lines below a command of docs/candidates.md, up to the next or the end of the block.
std::vector<std::string> shown_below(const std::string& command) {
  std::vector<std::string> lines;
  bool inside = false;
  for (const std::string& line : lines_of(contents(RAYCHECK_SOURCE_DIR "/docs/candidates.md"))) {
    if (inside && (line.starts_with("$ ") || line.starts_with("```"))) break;
    if (inside) lines.push_back(line);
    inside = inside || line == "$ raycheck " + command;
  }
  return lines;
}

/// A line without the parts that differ between machines: the isolation, and the last bits of
/// Embree, whose roots and reciprocals start from the processor's estimates.
std::string on_any_machine(const std::string& line) {
  static const std::regex figures("isolated by: .*| +[0-9.]+ +[0-9.]+ +88  ulp of float  .*");
  return std::regex_replace(line, figures, "");
}

/// Runs a command of the page in a folder with a library of this name, and compares the output.
void expect_as_shown(const std::string& library, const std::string& name,
                     const std::string& command) {
  const fs::path folder = temporary_folder("engine");
  fs::copy_file(library, folder / name);
  fs::create_directory_symlink(std::string(RAYCHECK_SOURCE_DIR) + "/scene", folder / "scene");
  const std::vector<std::string> shown = shown_below(command);
  const std::vector<std::string> printed =
      lines_of(run_bash("cd " + folder.string() + " && '" RAYCHECK_BINARY "' " + command).out);
  ASSERT_GT(shown.size(), 2u) << command;
  ASSERT_GE(printed.size(), shown.size()) << command;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    EXPECT_EQ(on_any_machine(printed[k]), on_any_machine(shown[k])) << command;
  }
}

/// An engine's library, and the precision in which it computes.
struct Engine {
  const char *name, *precision;
  std::string library() const { return std::string(RAYCHECK_ENGINES "/") + name + ".so"; }
  bool is_built() const { return fs::exists(library()); }
};
const Engine kEmbree = {"embree", "single"}, kVecgeom = {"vecgeom", "double"};

class Engines : public testing::TestWithParam<Engine> {
 protected:
  void SetUp() override {
    if (!GetParam().is_built()) {
      GTEST_SKIP() << GetParam().name
                   << " is not built, which target `engines` does where its package is installed";
    }
  }
};

TEST_P(Engines, are_right_on_a_plain_scene_under_their_declarations) {
  expect_judged(GetParam().library(), GetParam().precision);
}

TEST_P(Engines, are_timed_as_methods_are) {
  const json report = report_of("tradeoff --family rays --cases 20 --method cross" + kUnkept,
                                "library:" + GetParam().library(), 0);
  EXPECT_TRUE(report["intersections"][1]["called_in_process"])
      << report["intersections"][1]["note"];
}

INSTANTIATE_TEST_SUITE_P(Each, Engines,
                         testing::Values(Engine{"boost", "double"}, Engine{"core", "double"},
                                         kEmbree, Engine{"glm", "double"}, Engine{"gsl", "double"},
                                         kVecgeom),
                         [](const auto& one) { return one.param.name; });

TEST(Shaders, in_a_module_with_an_unterminated_string_are_read) {
  std::string module = "`float hit;`\n\"";
  for (int k = 0; k < 100; ++k) module += "\\\n";
  const std::string shader = temporary_file(
      "of.glsl", "// raycheck include " + temporary_file("module.js", module) + "\n");
  const std::string read =
      "import signal, sys; signal.alarm(60); sys.path.insert(0, 'examples/engines/shaders'); "
      "import shader; print(shader.read('" +
      shader + "')[0])";
  expect_parts(run_python("-c " + quoted(read), 0).out, {"float hit;"});
}

TEST(ShownEngines, are_judged_as_the_page_shows) {
  if (!kEmbree.is_built()) GTEST_SKIP() << "embree is not built";
  expect_as_shown(kEmbree.library(), "embree.so",
                  "check scene/examples/ten-spheres.toml --candidate library:embree.so");
  expect_as_shown(kEmbree.library(), "embree.so",
                  "properties --candidate library:embree.so --filter class --cases 300");
}

}  // namespace
}  // namespace raycheck::tests
