#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "tools/external/sandbox/process_tree.h"

namespace raycheck::tools {

/// The bytes of files without a name: removed files, memfd_create(), shared memory.
struct NamelessFiles {
  std::uint64_t in_memory = 0, on_disk = 0;
};

/// Adds up the nameless files that the processes have open or mapped, each once. If the system does
/// not show the size of a file, its mapped part counts.
NamelessFiles nameless_files(const std::vector<ProcessState>& processes);

/// The bytes of a file, at most the first `most`. Errors: std::system_error if they cannot all be
/// read.
std::string file_bytes(const std::filesystem::path& file,
                       std::size_t most = std::numeric_limits<std::size_t>::max());

/// Removes a folder and its contents, of any depth and with any permissions; links are not
/// followed. True if nothing is left.
bool remove_tree(const std::filesystem::path& folder);

/// Copies a file with its modification time; creates the parent folders.
void copy_with_time(const std::filesystem::path& from, const std::filesystem::path& to);

/// Removes everything in a folder.
void empty_folder(const std::filesystem::path& folder);

/// disk_use() adds up at most this many files and folders.
inline constexpr int kMostFiles = 32'768;

/// The disk use of a folder. A file with several names counts once.
struct DiskUse {
  std::uint64_t bytes = 0;
  int files = 0;              ///< The number of files and folders.
  bool is_too_deep = false;   ///< Whether folders are nested too deep to be added up.
  bool are_too_many = false;  ///< Whether there are more than kMostFiles.
  bool is_closed = false;     ///< Whether a folder cannot be read.
};

/// The disk use of a folder. Links are not followed.
DiskUse disk_use(const std::filesystem::path& folder);

}  // namespace raycheck::tools
