#include "tools/external/sandbox/private_folder.h"

#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string_view>
#include <system_error>

#include "tools/external/sandbox/descriptor.h"
#include "tools/external/sandbox/file_tree.h"

namespace raycheck::tools {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPrefix = "raycheck-run-";
/// The lock file in a run's folder. Folders of other programs may have the same prefix, but do not
/// have this file.
constexpr const char* kHeldBy = "held-by-raycheck";

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

bool others_may_enter(fs::path folder) {
  std::error_code error;
  for (;; folder = folder.parent_path()) {
    const fs::perms perms = fs::status(folder, error).permissions();
    if (error || (perms & fs::perms::others_exec) == fs::perms::none) return false;
    if (folder == folder.root_path()) return true;
  }
}

bool others_may_read(const fs::path& path) {
  std::error_code error;
  const fs::perms own = fs::status(path, error).permissions();
  const fs::perms needed = fs::is_directory(path, error)
                               ? fs::perms::others_read | fs::perms::others_exec
                               : fs::perms::others_read;
  return !error && (own & needed) == needed && others_may_enter(path.parent_path());
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
  if (!is_new) return to;
  try {
    open_to_others(copy->second.path());
    fs::copy(path, to, fs::copy_options::recursive);
    open_to_others(to);
  } catch (...) {
    copies.erase(copy);  // the copy is incomplete
    throw;
  }
  return to;
}

namespace {

/// Makes a new folder whose name begins with this.
fs::path new_folder(const fs::path& begin) {
  std::string name = begin.string() + "XXXXXX";
  if (mkdtemp(name.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), name);
  }
  return name;
}

/// Locks the lock file `by` of a run's folder, until it is closed or this process ends. The result
/// is not open if another process holds the lock, or if the file does not exist. `create`: O_CREAT
/// to create it.
Descriptor hold(const fs::path& by, int create = 0) {
  Descriptor opened(open(by.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | create, 0600));
  if (flock(opened.number(), LOCK_EX | LOCK_NB) != 0) opened.close();
  return opened;
}

/// Locks a new folder. The lock file gets its name only once it is locked.
Descriptor hold_new(const fs::path& folder) {
  const fs::path unseen = folder / "new";
  Descriptor held = hold(unseen, O_CREAT);
  if (held.is_open()) fs::rename(unseen, folder / kHeldBy);
  return held;
}

/// Removes the folders of killed runs: this user's run folders that are not locked.
void remove_left_overs(const fs::path& where) {
  std::error_code error;
  for (fs::directory_iterator at(where, error), end; !error && at != end; at.increment(error)) {
    if (!at->path().filename().string().starts_with(kPrefix)) continue;
    struct stat status {};
    if (lstat(at->path().c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) continue;
    if (status.st_uid != geteuid()) continue;
    if (hold(at->path() / kHeldBy).is_open()) remove_tree(at->path());
  }
}

/// The folder that contains all private folders of this process; removed when the process ends.
class RunFolder {
 public:
  RunFolder() : path_(new_folder(fs::temp_directory_path() / kPrefix)), held_(hold_new(path_)) {
    // Other users may enter subfolders whose names they are given, but cannot list them.
    fs::permissions(path_, fs::perms::others_exec, fs::perm_options::add);
    remove_left_overs(path_.parent_path());
  }
  ~RunFolder() { remove_tree(path_); }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  Descriptor held_;
};

const fs::path& run_folder() {
  static const RunFolder folder;
  return folder.path();
}

}  // namespace

PrivateFolder::PrivateFolder() : path_(new_folder(run_folder().string() + "/")) {}

std::string without_private_folders(const std::string& text) {
  const std::string begin = run_folder().string() + "/";
  constexpr std::size_t kNameSize = 6;
  std::string result;
  std::size_t at = 0;
  for (std::size_t found; (found = text.find(begin, at)) != std::string::npos;) {
    result.append(text, at, found - at);
    at = std::min(found + begin.size() + kNameSize, text.size());
    if (at < text.size() && text[at] == '/') ++at;
  }
  return result.append(text, at, std::string::npos);
}

PrivateFolder::~PrivateFolder() { remove_tree(path_); }

void lay_out(const StartingFolder& start, const std::filesystem::path& folder, std::uint64_t user) {
  const auto id = static_cast<uid_t>(user);
  for (const std::string& name : start.folders) {
    const auto path = folder / name;
    require(mkdir(path.c_str(), kFolderMode) == 0, name);
    require(user == 0 || chown(path.c_str(), id, id) == 0, name);
  }
  for (const auto& [name, text, runs] : start.files) {
    const Descriptor file(open((folder / name).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                               runs ? kProgramMode : kFileMode));
    require(file.is_open() && write_all(file.number(), text), name);
    require(user == 0 || fchown(file.number(), id, id) == 0, name);
  }
  for (const std::string& name : start.links) {
    require(symlink((start.linked->path() / name).c_str(), (folder / name).c_str()) == 0, name);
  }
}

}  // namespace raycheck::tools
