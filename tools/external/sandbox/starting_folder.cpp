#include "tools/external/sandbox/starting_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>

namespace raycheck::tools {
namespace {

constexpr mode_t kFolderMode = 0755, kFileMode = 0644, kProgramMode = 0755;

void require(bool holds, const std::string& name) {
  if (!holds) throw std::system_error(errno, std::generic_category(), name);
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(file, text.data(), text.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

void lay_out(const StartingFolder& start, const std::filesystem::path& folder, std::uint64_t user) {
  const auto id = static_cast<uid_t>(user);
  for (const std::string& name : start.folders) {
    const auto path = folder / name;
    require(mkdir(path.c_str(), kFolderMode) == 0, name);
    require(user == 0 || chown(path.c_str(), id, id) == 0, name);
  }
  for (const auto& [name, text, runs] : start.files) {
    const int file = open((folder / name).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                          runs ? kProgramMode : kFileMode);
    require(file >= 0, name);
    const bool is_made = write_all(file, text) && (user == 0 || fchown(file, id, id) == 0);
    const int error = errno;
    close(file);
    errno = error;
    require(is_made, name);
  }
  for (const std::string& name : start.links) {
    require(symlink((start.linked->path() / name).c_str(), (folder / name).c_str()) == 0, name);
  }
}

}  // namespace raycheck::tools
