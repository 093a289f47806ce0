#include "tools/external/sandbox/nameless_files.h"

#include <dirent.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/vfs.h>

#include <charconv>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace raycheck::tools {
namespace {

constexpr std::uint64_t kBlock = 512;

/// Lines of a process's mappings that are read: more has no program that is not hostile.
constexpr int kMostMappings = 4096;

/// Its device and its number there.
using Key = std::pair<dev_t, ino_t>;
struct Size {
  std::uint64_t bytes = 0;
  bool in_memory = false;
};
using Sizes = std::map<Key, Size>;

/// What lies behind a link of /proc; whether that can be seen.
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
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(opendir(folder.c_str()), closedir);
  if (!entries) return;
  while (const dirent* const entry = readdir(entries.get())) {
    if (entry->d_type == DT_LNK) take(folder + "/" + entry->d_name, sizes);
  }
}

/// Two hexadecimal numbers with a mark between them.
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
    // Links that only who administers the machine may follow.
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
