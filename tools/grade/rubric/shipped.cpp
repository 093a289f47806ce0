#include "tools/grade/rubric/shipped.h"

#include <algorithm>

#include "tools/external/sandbox/process.h"
#include "tools/report/version.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Beside the installed program, or in the sources.
fs::path shipped_folder() {
  fs::path installed = prefix() / "share/raycheck/rubrics";
  return fs::is_directory(installed) ? installed : fs::path(kSourceFolder) / "tools/grade/rubrics";
}

std::optional<fs::path> if_file(const fs::path& path) {
  return fs::is_regular_file(path) ? std::optional(path) : std::nullopt;
}

}  // namespace

std::vector<std::string> shipped_rubrics() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(shipped_folder(), none)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<fs::path> shipped_rubric(const fs::path& name) {
  if (name.has_parent_path()) return {};
  const fs::path path = shipped_folder() / name;
  return if_file(path.extension() == ".toml" ? path : fs::path(path.string() + ".toml"));
}

std::optional<fs::path> shipped_scene(const fs::path& name) {
  return if_file(shipped_folder() / name);
}

}  // namespace raycheck::tools
