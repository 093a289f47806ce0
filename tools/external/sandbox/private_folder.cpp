#include "tools/external/sandbox/private_folder.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <map>
#include <mutex>
#include <regex>
#include <string>
#include <system_error>

namespace raycheck::tools {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPrefix = "raycheck-";

}  // namespace

bool others_may_read(const fs::path& path) {
  std::error_code error;
  const fs::perms own = fs::status(path, error).permissions();
  const fs::perms needed = fs::is_directory(path, error)
                               ? fs::perms::others_read | fs::perms::others_exec
                               : fs::perms::others_read;
  if (error || (own & needed) != needed) return false;
  for (fs::path folder = path.parent_path();; folder = folder.parent_path()) {
    const fs::perms perms = fs::status(folder, error).permissions();
    if (error || (perms & fs::perms::others_exec) == fs::perms::none) return false;
    if (folder == folder.root_path()) return true;
  }
}

void open_to_others(const fs::path& path) {
  const auto open = [](const fs::path& of) {
    const bool runs = fs::is_directory(of) ||
                      (fs::status(of).permissions() & fs::perms::owner_exec) != fs::perms::none;
    fs::permissions(of,
                    runs ? fs::perms::others_read | fs::perms::others_exec : fs::perms::others_read,
                    fs::perm_options::add);
  };
  open(path);
  if (!fs::is_directory(path)) return;
  for (const auto& entry : fs::recursive_directory_iterator(path)) open(entry.path());
}

fs::path readable_copy(const fs::path& path) {
  if (geteuid() != 0 || others_may_read(path)) return path;
  static std::mutex mutex;
  static std::map<fs::path, PrivateFolder> copies;
  const std::lock_guard lock(mutex);
  const auto [copy, is_new] = copies.try_emplace(path);
  const fs::path to = copy->second.path() / path.filename();
  if (is_new) {
    open_to_others(copy->second.path());
    fs::copy(path, to, fs::copy_options::recursive);
    open_to_others(to);
  }
  return to;
}

PrivateFolder::PrivateFolder() {
  std::string name = fs::temp_directory_path() / (std::string(kPrefix) + "XXXXXX");
  if (mkdtemp(name.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), name);
  }
  path_ = name;
}

std::string without_private_folders(const std::string& text) {
  static const std::regex folders((fs::temp_directory_path() / kPrefix).string() +
                                  "[A-Za-z0-9]{6}/?");
  return std::regex_replace(text, folders, "");
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace raycheck::tools
