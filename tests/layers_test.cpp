// The arrows between folders, read from their #include lines:
// scene <- reference, scene <- fast, {scene, reference, fast} <- properties <- tools.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Include {
  std::string from;    ///< "reference/kernels.h"
  std::string target;  ///< What stands between the quotes or brackets.
};

fs::path root() { return RAYCHECK_SOURCE_DIR; }

/// Includes of a folder's sources, by folder.
std::vector<Include> includes_of(const std::string& folder) {
  std::vector<Include> result;
  for (const auto& entry : fs::directory_iterator(root() / folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      const std::size_t at = line.find_first_not_of(" \t");
      if (at == std::string::npos || line.compare(at, 8, "#include") != 0) continue;
      const std::size_t begin = line.find_first_of("\"<", at);
      const std::size_t end = line.find_first_of("\">", begin + 1);
      result.push_back({folder + "/" + entry.path().filename().string(),
                        line.substr(begin + 1, end - begin - 1)});
    }
  }
  return result;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

bool is_header(const std::string& file) { return file.size() > 2 && file.ends_with(".h"); }

const std::vector<std::string> kFolders = {"scene", "reference", "fast", "properties", "tools"};

/// Which folders each may see, itself aside.
const std::map<std::string, std::set<std::string>> kSees = {
    {"scene", {}},
    {"reference", {"scene"}},
    {"fast", {"scene"}},
    {"properties", {"scene", "reference", "fast"}},
    {"tools", {"scene", "reference", "fast", "properties"}}};

/// Headers of reference/ that show CGAL; none of its other headers may include one.
const std::set<std::string> kInternalToReference = {
    "reference/kernels.h",        "reference/formulas.h",       "reference/rounding.h",
    "reference/camera_impl.h",    "reference/radical_sum.h",    "reference/ray_impl.h",
    "reference/dual.h",           "reference/condition_impl.h", "reference/rational_interval.h",
    "reference/error_formulas.h", "reference/visibility_impl.h"};

TEST(Layers, HaveArrowsOneWay) {
  for (const std::string& folder : kFolders) {
    const auto includes = includes_of(folder);
    EXPECT_GT(includes.size(), 10u) << folder;
    for (const Include& include : includes) {
      for (const std::string& other : kFolders) {
        if (other == folder || !starts_with(include.target, other + "/")) continue;
        EXPECT_TRUE(kSees.at(folder).contains(other))
            << include.from << " includes " << include.target;
      }
      EXPECT_FALSE(starts_with(include.target, "tests/")) << include.from;
      EXPECT_EQ(include.target.find(".."), std::string::npos) << include.from;
    }
  }
}

TEST(Layers, LetPeersSeeScenesAndMethodsOnly) {
  std::size_t found = 0;
  for (const Include& include : includes_of("tools/peers")) {
    if (starts_with(include.target, "tools/peers/")) continue;
    for (const std::string& other : kFolders) {
      if (!starts_with(include.target, other + "/")) continue;
      ++found;
      EXPECT_TRUE(other == "scene" || other == "fast")
          << include.from << " includes " << include.target;
    }
    if (starts_with(include.target, "CGAL/")) {
      EXPECT_EQ(include.from, "tools/peers/core.cpp");
    }
  }
  EXPECT_GT(found, 5u);
}

TEST(Layers, LinkOnlyWhatTheyMaySee) {
  for (const std::string folder : {"reference", "fast", "properties"}) {
    std::ifstream file(root() / folder / "CMakeLists.txt");
    std::string seen;
    for (std::string line; std::getline(file, line);) {
      const std::size_t at = line.find("SEES ");
      if (at != std::string::npos) seen = line.substr(at + 5);
    }
    std::string expected;
    for (const std::string& other : kFolders) {
      if (!kSees.at(folder).contains(other)) continue;
      expected += (expected.empty() ? "" : " ") + other;
    }
    EXPECT_EQ(seen, expected) << folder;
  }
}

TEST(Layers, KeepCgalInsideReference) {
  std::size_t found = 0;
  for (const std::string& folder : kFolders) {
    for (const Include& include : includes_of(folder)) {
      if (!starts_with(include.target, "CGAL/")) continue;
      ++found;
      EXPECT_EQ(folder, "reference") << include.from << " includes " << include.target;
      EXPECT_TRUE(!is_header(include.from) || kInternalToReference.contains(include.from))
          << include.from << " includes " << include.target;
    }
  }
  EXPECT_GT(found, 0u);
}

TEST(Layers, ShowNoInternalHeaderOfReference) {
  for (const std::string& folder : kFolders) {
    for (const Include& include : includes_of(folder)) {
      if (!kInternalToReference.contains(include.target)) continue;
      EXPECT_EQ(folder, "reference") << include.from << " includes " << include.target;
      EXPECT_TRUE(!is_header(include.from) || kInternalToReference.contains(include.from))
          << include.from << " includes " << include.target;
    }
  }
  for (const std::string& header : kInternalToReference) {
    EXPECT_TRUE(fs::exists(root() / header)) << header;
  }
}

TEST(Layers, KeepEigenInsideFast) {
  for (const std::string& folder : kFolders) {
    for (const Include& include : includes_of(folder)) {
      if (starts_with(include.target, "Eigen/")) {
        EXPECT_EQ(folder, "fast") << include.from;
      }
    }
  }
}

TEST(Layers, KeepRapidCheckOutOfHeaders) {
  for (const std::string& folder : kFolders) {
    for (const Include& include : includes_of(folder)) {
      if (!starts_with(include.target, "rapidcheck")) continue;
      EXPECT_EQ(folder, "properties") << include.from;
      EXPECT_FALSE(is_header(include.from)) << include.from;
    }
  }
}

}  // namespace
