#include "tools/external/sandbox/visible.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>

#include "tools/external/sandbox/launch.h"

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

std::vector<fs::path> own_paths() { return {adapters(), program_folder().parent_path() / "lib"}; }

std::vector<fs::path> hidden_paths() {
  std::vector<fs::path> named = {fs::read_symlink("/proc/self/exe"),
                                 program_folder().parent_path() / "share" / "raycheck" / "rubrics"};
  std::string_view folders = kProgramPath;
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    named.push_back(fs::path(folders.substr(0, end)) / "raycheck");
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
