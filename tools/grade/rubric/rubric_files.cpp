#include <fmt/ranges.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <string>

#include "scene/files/file_text.h"
#include "scene/invalid_input.h"
#include "scene/text.h"
#include "tools/external/sandbox/process.h"
#include "tools/grade/rubric/rubric.h"
#include "tools/report/output_file.h"
#include "tools/report/version.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// File systems allow at most 255 bytes.
constexpr std::size_t kLongestName = 80;

/// The folder of the shipped rubrics: beside the installed program, or in the sources.
fs::path shipped_folder() {
  fs::path installed = prefix() / "share/raycheck/rubrics";
  return fs::is_directory(installed) ? installed : fs::path(kSourceFolder) / "examples/rubrics";
}

std::optional<fs::path> if_file(const fs::path& path) {
  return fs::is_regular_file(path) ? std::optional(path) : std::nullopt;
}

/// The file names of the shipped rubrics, sorted.
std::vector<std::string> shipped_rubrics() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(shipped_folder(), none)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace

std::string file_name(std::string_view item) {
  std::string name;
  for (const char c : item) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (is_plain) {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  name.resize(std::min(name.size(), kLongestName));
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "item" : name;
}

std::optional<fs::path> shipped_rubric(const fs::path& name) {
  if (name.has_parent_path()) return {};
  const fs::path path = shipped_folder() / name;
  return if_file(path.extension() == ".toml" ? path : fs::path(path.string() + ".toml"));
}

fs::path rubric_path(const fs::path& name) {
  if (const auto path = shipped_rubric(name)) return *path;
  throw std::invalid_argument(fmt::format("{}: there is no such rubric; raycheck comes with {}",
                                          scene::visible_line(name.string()),
                                          fmt::join(shipped_rubrics(), ", ")));
}

std::optional<fs::path> shipped_scene(const fs::path& name) {
  return if_file(shipped_folder() / name);
}

std::string rubrics_text() {
  const std::vector<std::string> names = shipped_rubrics();
  std::size_t width = 0;
  for (const std::string& name : names) width = std::max(width, name.size());
  std::string text;
  for (const std::string& name : names) {
    const Rubric rubric = load_rubric(rubric_path(name));
    text += fmt::format("{:<{}}  {}, {}\n", name, width, rubric.title,
                        count_text(rubric.items.size(), "item"));
  }
  return text;
}

std::string copy_rubric(const std::string& name, const std::string& out) {
  const fs::path from = rubric_path(name);
  const Rubric rubric = load_rubric(from);
  std::map<std::string, fs::path> files = rubric.files;
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
                     count_text(rubric.files.size(), "file"));
}

std::uint64_t secret_seed(std::string_view secret, std::string_view name) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned int size = 0;
  const auto* const text = reinterpret_cast<const unsigned char*>(name.data());
  if (HMAC(EVP_sha256(), secret.data(), static_cast<int>(secret.size()), text, name.size(),
           bytes.data(), &size) == nullptr) {
    throw std::runtime_error("HMAC-SHA-256 is not available");
  }
  std::uint64_t seed = 0;
  for (int k = 0; k < 8; ++k) seed = seed << 8 | bytes[static_cast<std::size_t>(k)];
  return seed;
}

}  // namespace raycheck::tools
