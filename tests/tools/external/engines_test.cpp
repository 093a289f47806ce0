// The examples of engines as candidates: built as their first lines say, and judged by the
// contracts that they state.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/tools/external/judged.h"

namespace raycheck::tests {
namespace {

using nlohmann::json;

/// An engine's library; empty where the package that it needs is not installed.
std::string built_engine(const std::string& compiler, const std::string& source,
                         const std::string& header, const std::string& flags) {
  if (!std::filesystem::exists(header)) return "";
  const std::string folder = temporary_file("engine", "") + ".d";
  std::filesystem::create_directory(folder);
  const std::string library = folder + "/engine.so";
  const std::string root = RAYCHECK_SOURCE_DIR;
  const std::string words = compiler + " -O2 -fPIC -shared -I" + root + "/include " + root +
                            "/examples/engines/" + source + " " + flags + " -o " + library +
                            " 2>/dev/null";
  EXPECT_EQ(std::system(words.c_str()), 0) << words;
  return library;
}

/// Hits are right on a plain scene, in the precision that it states.
void expect_judged(const std::string& library, const std::string& precision) {
  const json report = judged("scene/examples/ten-spheres.toml", "library:" + library);
  EXPECT_EQ(report["discrepancies_by_standing"]["defect"], 0) << report.dump(2);
  EXPECT_EQ(report["precision"], precision);
  EXPECT_TRUE(report["given_rays"]);
  EXPECT_GT(quantity_of(report["quantities"], "parameter")["cases"], 100);
}

/// The lines below a command of docs/candidates.md, up to the next or the end of the block.
std::vector<std::string> shown_below(const std::string& command) {
  std::ifstream page(std::string(RAYCHECK_SOURCE_DIR) + "/docs/candidates.md");
  std::vector<std::string> lines;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (inside && (line.starts_with("$ ") || line.starts_with("```"))) break;
    if (inside) lines.push_back(line);
    inside = inside || line == "$ raycheck " + command;
  }
  return lines;
}

/// Runs what the page shows, beside a library of that name, and compares what is printed.
void expect_as_shown(const std::string& library, const std::string& name,
                     const std::string& command) {
  const std::filesystem::path folder = std::filesystem::path(library).parent_path();
  std::filesystem::copy_file(library, folder / name);
  std::filesystem::create_directory_symlink(std::string(RAYCHECK_SOURCE_DIR) + "/scene",
                                            folder / "scene");
  const std::string words =
      "cd " + folder.string() + " && '" RAYCHECK_BINARY "' " + command + " > printed";
  ASSERT_NE(std::system(words.c_str()), -1);
  std::ifstream printed(folder / "printed");
  const std::vector<std::string> shown = shown_below(command);
  ASSERT_GT(shown.size(), 2u) << command;
  for (const std::string& expected : shown) {
    std::string line;
    std::getline(printed, line);
    const std::size_t kept = line.find("isolated by: ");  // which differs by machine
    EXPECT_EQ(line.substr(0, kept), expected.substr(0, kept)) << command;
  }
  for (const char* made : {"scene", "printed"}) std::filesystem::remove(folder / made);
  std::filesystem::remove(folder / name);
}

TEST(Engines, embree_is_judged_in_floats) {
  const std::string library =
      built_engine("g++ -std=c++20", "embree.cpp", "/usr/include/embree3/rtcore.h", "-lembree3");
  if (library.empty()) GTEST_SKIP() << "libembree-dev is not installed";
  expect_judged(library, "single");
  expect_as_shown(library, "embree.so",
                  "check scene/examples/ten-spheres.toml --candidate library:embree.so");
  expect_as_shown(library, "embree.so",
                  "properties --candidate library:embree.so --filter class --cases 300");
}

TEST(Engines, vecgeom_is_judged_in_doubles) {
  const std::string library =
      built_engine("g++ -std=c++20 -DVECCORE_ENABLE_VC", "vecgeom.cpp",
                   "/usr/include/VecGeom/volumes/UnplacedOrb.h", "-lvecgeom");
  if (library.empty()) GTEST_SKIP() << "libvecgeom-dev is not installed";
  expect_judged(library, "double");
  expect_as_shown(library, "vecgeom.so",
                  "properties --candidate library:vecgeom.so --filter parameter --cases 300");
}

}  // namespace
}  // namespace raycheck::tests
