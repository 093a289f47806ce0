#include "tools/external/sandbox/visible.h"

#include <unistd.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>

#include "tools/external/sandbox/launch.h"
#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {

namespace fs = std::filesystem;

std::vector<fs::path> system_paths() {
  std::vector<fs::path> paths = {"/usr",
                                 "/bin",
                                 "/lib",
                                 "/lib64",
                                 "/etc/alternatives",
                                 "/etc/ld.so.cache",
                                 "/etc/ld.so.conf",
                                 "/etc/ld.so.conf.d",
                                 "/etc/ssl/openssl.cnf"};
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/etc", ignored)) {
    if (entry.path().filename().string().starts_with("java")) paths.push_back(entry.path());
  }
  return paths;
}

std::vector<fs::path> own_paths() {
  std::vector<fs::path> paths = {adapters()};
  const fs::path libraries = prefix() / "lib";
  // Where others may not read them they are of no use: what needs them runs as another user.
  if (fs::exists(libraries) && (geteuid() != 0 || others_may_read(libraries))) {
    paths.push_back(libraries);
  }
  return paths;
}

namespace {

/// Raycheck's programs in a folder, but for those that run what someone else made.
void add_programs(const fs::path& folder, std::vector<fs::path>& programs) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename();
    const bool is_helper = name == "raycheck-jail" || name == "raycheck-worker";
    if (name.starts_with("raycheck") && !is_helper && entry.is_regular_file(ignored)) {
      programs.push_back(entry.path());
    }
  }
}

}  // namespace

std::vector<fs::path> hidden_paths() {
  std::vector<fs::path> named = {prefix() / "share" / "raycheck" / "rubrics"};
  add_programs(program_folder(), named);
  std::string_view folders = kProgramPath;
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    const fs::path folder(folders.substr(0, end));
    named.push_back(folder / "raycheck");
    add_programs(folder.parent_path() / "libexec" / "raycheck", named);
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  std::vector<fs::path> found;
  for (const fs::path& path : named) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    if (!error && std::find(found.begin(), found.end(), real) == found.end()) found.push_back(real);
  }
  return found;
}

}  // namespace raycheck::tools
