#include "tools/rubric/shipped_rubrics.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "scene/files/file_text.h"
#include "scene/invalid_input.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/report/output_file.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

fs::path path_of(const std::string& name) {
  if (const auto path = shipped_rubric(name)) return *path;
  throw std::invalid_argument(
      fmt::format("rubric {}: raycheck has no rubric of this name; it has {}", name,
                  fmt::join(shipped_rubrics(), ", ")));
}

}  // namespace

std::string rubrics_text() {
  const std::vector<std::string> names = shipped_rubrics();
  std::size_t width = 0;
  for (const std::string& name : names) width = std::max(width, name.size());
  std::string text;
  for (const std::string& name : names) {
    const Rubric rubric = load_rubric(path_of(name));
    text += fmt::format("{:<{}}  {}, {}\n", name, width, rubric.title,
                        count_text(rubric.items.size(), "item"));
  }
  return text;
}

std::string rubric_file(const std::string& name) { return scene::file_text(path_of(name)); }

std::string copy_rubric(const std::string& name, const std::string& out) {
  const fs::path from = path_of(name);
  const Rubric rubric = load_rubric(from);
  std::map<std::string, fs::path> files = rubric.scene_files;
  files[from.filename().string()] = from;
  // A user's own changes are not overwritten.
  for (const auto& [file, source] : files) {
    if (fs::exists(fs::path(out) / file)) {
      throw scene::InvalidInput("out", out, file + " already exists there; give another folder");
    }
  }
  for (const auto& [file, source] : files) {
    const fs::path to = fs::path(out) / file;
    make_folder("out", to.parent_path());
    OutputFile("out", to).write(scene::file_text(source));
  }
  return fmt::format("wrote {} and {}\n", (fs::path(out) / from.filename()).string(),
                     count_text(rubric.scene_files.size(), "scene"));
}

}  // namespace raycheck::tools
