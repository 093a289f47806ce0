#include "tools/rubric/rubric.h"

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

#include "tools/grade/rubric/rubric.h"
#include "tools/grade/rubric/rubric_files.h"
#include "tools/report/output_file.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

fs::path path_of(const std::string& name) {
  if (const auto path = shipped_rubric(name)) return *path;
  std::string known;
  for (const std::string& one : shipped_rubrics()) known += (known.empty() ? "" : ", ") + one;
  throw std::invalid_argument(
      fmt::format("rubric {}: none of that name comes with raycheck; there is {}", name, known));
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::runtime_error(fmt::format("rubric: {} cannot be read", path.string()));
  return text;
}

}  // namespace

std::vector<ShippedRubric> list_rubrics() {
  std::vector<ShippedRubric> all;
  for (const std::string& name : shipped_rubrics()) {
    const Rubric rubric = load_rubric(path_of(name));
    all.push_back({name, rubric.title, rubric.items.size()});
  }
  return all;
}

std::string rubric_file(const std::string& name) { return text_of(path_of(name)); }

CopiedRubric copy_rubric(const std::string& name, const std::string& out) {
  const fs::path from = path_of(name);
  const Rubric rubric = load_rubric(from);
  std::map<std::string, fs::path> files = rubric.scene_files;
  files[from.filename().string()] = from;
  // A user's own changes are not overwritten.
  for (const auto& [file, source] : files) {
    if (fs::exists(fs::path(out) / file)) {
      throw std::invalid_argument(fmt::format("out {}: {} is there already", out, file));
    }
  }
  for (const auto& [file, source] : files) {
    const fs::path to = fs::path(out) / file;
    std::error_code error;
    fs::create_directories(to.parent_path(), error);
    if (error) throw std::invalid_argument(fmt::format("out {}: {}", out, error.message()));
    OutputFile("out", to).write(text_of(source));
  }
  return {(fs::path(out) / from.filename()).string(), rubric.scene_files.size()};
}

}  // namespace raycheck::tools
