#include "tools/external/sandbox/file_tree.h"

#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "tools/external/sandbox/descriptor.h"

namespace raycheck::tools {

namespace {

/// Sizes of folders are added up to this depth.
constexpr int kMostDepth = 128;
/// The unit of st_blocks, in bytes.
constexpr std::uint64_t kBlock = 512;

FolderEntries entries_of(int folder) {
  DIR* const entries = fdopendir(folder);
  if (entries == nullptr) close(folder);
  return {entries, closedir};
}

bool is_here_or_above(std::string_view name) { return name == "." || name == ".."; }

constexpr int kOpenFolder = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

Descriptor open_folder_in(int folder, const char* name) {
  Descriptor opened(openat(folder, name, kOpenFolder));
  if (!opened.is_open() && errno == EACCES && fchmodat(folder, name, S_IRWXU, 0) == 0) {
    opened = Descriptor(openat(folder, name, kOpenFolder));
  }
  return opened;
}

/// Removes the files and empty folders in an open folder; returns the name of a folder in it that
/// is not empty, if any. Sets `failed` if something could not be removed.
std::string remove_entries(int folder, bool& failed) {
  const FolderEntries entries = entries_of(openat(folder, ".", kOpenFolder));
  if (!entries) {
    failed = true;
    return "";
  }
  fchmod(folder, S_IRWXU);
  while (const dirent* const entry = readdir(entries.get())) {
    if (is_here_or_above(entry->d_name)) continue;
    if (unlinkat(folder, entry->d_name, 0) == 0) continue;
    if (unlinkat(folder, entry->d_name, AT_REMOVEDIR) == 0) continue;
    if (errno == ENOTEMPTY || errno == EEXIST) return entry->d_name;
    failed = true;
  }
  return "";
}

void add_up(int folder, int depth, DiskUse& use) {
  const FolderEntries entries = entries_of(folder);
  if (!entries) return;
  while (const dirent* const entry = readdir(entries.get())) {
    if (is_here_or_above(entry->d_name)) continue;
    struct stat status {};
    if (fstatat(folder, entry->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0) continue;
    if (++use.files > kMostFiles) {
      use.are_too_many = true;
      return;
    }
    const auto bytes = static_cast<std::uint64_t>(status.st_blocks) * kBlock;
    if (!S_ISDIR(status.st_mode)) {
      // A file's bytes are divided among its hard links.
      use.bytes += bytes / std::max<std::uint64_t>(status.st_nlink, 1);
      continue;
    }
    use.bytes += bytes;
    if (depth >= kMostDepth) {
      use.is_too_deep = true;
      continue;
    }
    const int below = openat(folder, entry->d_name, kOpenFolder);
    if (below >= 0) {
      add_up(below, depth + 1, use);
    } else if (errno == EACCES) {
      use.is_closed = true;
    }
    if (use.are_too_many) return;
  }
}

}  // namespace

std::string file_bytes(const std::filesystem::path& file, std::size_t most) {
  const Descriptor opened(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  std::string bytes;
  std::array<char, 65536> buffer{};
  ssize_t count = opened.is_open() ? 1 : -1;
  while (count > 0 && bytes.size() < most) {
    do {
      count = read(opened.number(), buffer.data(), std::min(buffer.size(), most - bytes.size()));
    } while (count < 0 && errno == EINTR);
    if (count > 0) bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
  if (count < 0) throw std::system_error(errno, std::generic_category(), file.filename());
  return bytes;
}

bool remove_tree(const std::filesystem::path& folder) {
  Descriptor here = open_folder_in(AT_FDCWD, folder.c_str());
  if (!here.is_open()) return errno == ENOENT;
  bool failed = false;
  // Descends into folders that are not empty and ascends from empty ones, with one folder open at a
  // time, so that neither the number of descriptors nor the length of paths is a limit.
  for (std::int64_t depth = 0;;) {
    const std::string below = remove_entries(here.number(), failed);
    if (below.empty() && (depth == 0 || failed)) break;
    Descriptor next = open_folder_in(here.number(), below.empty() ? ".." : below.c_str());
    if (!next.is_open()) break;
    here = std::move(next);
    depth += below.empty() ? -1 : 1;
  }
  return rmdir(folder.c_str()) == 0 || errno == ENOENT;
}

void copy_with_time(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::filesystem::create_directories(to.parent_path());
  std::filesystem::copy_file(from, to);
  std::filesystem::last_write_time(to, std::filesystem::last_write_time(from));
}

void empty_folder(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::filesystem::remove_all(entry.path());
  }
}

DiskUse disk_use(const std::filesystem::path& folder) {
  DiskUse use;
  const int opened = open(folder.c_str(), kOpenFolder);
  if (opened >= 0) add_up(opened, 0, use);
  return use;
}

namespace {

/// At most this many lines of a process's mappings are read; only hostile programs have more.
constexpr int kMostMappings = 4096;

/// A file's device and inode.
using Key = std::pair<dev_t, ino_t>;
struct Size {
  std::uint64_t bytes = 0;
  bool in_memory = false;
};
using Sizes = std::map<Key, Size>;

/// Records the file behind a link in /proc if that file has no name; false if it cannot be
/// examined.
bool take(const std::string& link, Sizes& sizes) {
  struct stat status {};
  if (stat(link.c_str(), &status) != 0) return false;
  if (!S_ISREG(status.st_mode) || status.st_nlink != 0) return true;
  struct statfs system {};
  const bool in_memory = statfs(link.c_str(), &system) == 0 &&
                         (system.f_type == TMPFS_MAGIC || system.f_type == HUGETLBFS_MAGIC);
  sizes[{status.st_dev, status.st_ino}] = {static_cast<std::uint64_t>(status.st_blocks) * kBlock,
                                           in_memory};
  return true;
}

void take_open(const std::string& process, Sizes& sizes) {
  const std::string folder = process + "/fd";
  const FolderEntries entries(opendir(folder.c_str()), closedir);
  if (!entries) return;
  while (const dirent* const entry = readdir(entries.get())) {
    if (entry->d_type == DT_LNK) take(folder + "/" + entry->d_name, sizes);
  }
}

/// Two hexadecimal numbers with a separator.
std::optional<std::pair<std::uint64_t, std::uint64_t>> pair_of(std::string_view text, char mark) {
  std::uint64_t first = 0, second = 0;
  constexpr int kBase = 16;
  const char* const end = text.data() + text.size();
  const auto before = std::from_chars(text.data(), end, first, kBase);
  if (before.ptr == end || *before.ptr != mark) return {};
  const auto after = std::from_chars(before.ptr + 1, end, second, kBase);
  if (after.ptr != end) return {};
  return std::pair(first, second);
}

void take_mapped(const std::string& process, Sizes& sizes) {
  std::ifstream lines(process + "/maps");
  std::string line;
  for (int count = 0; count < kMostMappings && std::getline(lines, line); ++count) {
    // FROM-TO rw-s OFFSET MAJOR:MINOR INODE /memfd:x (deleted)
    if (!line.ends_with("(deleted)")) continue;
    std::istringstream words(line);
    std::string range, rights, offset, device, name;
    ino_t inode = 0;
    words >> range >> rights >> offset >> device >> inode >> name;
    // Only administrators may follow these links.
    if (take(process + "/map_files/" + range, sizes)) continue;
    const auto ends = pair_of(range, '-'), numbers = pair_of(device, ':');
    if (!words || !ends || !numbers) continue;
    const Key key{
        makedev(static_cast<unsigned>(numbers->first), static_cast<unsigned>(numbers->second)),
        inode};
    const bool in_memory = name.starts_with("/memfd:") || name.starts_with("/dev/");
    sizes.try_emplace(key, Size{ends->second - ends->first, in_memory});
  }
}

}  // namespace

NamelessFiles nameless_files(const std::vector<ProcessState>& processes) {
  Sizes sizes;
  for (const ProcessState& process : processes) {
    take_open("/proc/" + std::to_string(process.pid), sizes);
  }
  for (const ProcessState& process : processes) {
    take_mapped("/proc/" + std::to_string(process.pid), sizes);
  }
  NamelessFiles sum;
  for (const auto& [key, size] : sizes)
    (size.in_memory ? sum.in_memory : sum.on_disk) += size.bytes;
  return sum;
}

}  // namespace raycheck::tools
