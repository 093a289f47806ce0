#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "tools/external/sandbox/process_tree.h"

namespace raycheck::tools {

/// Bytes of files without a name: removed files, memfd_create(), shared memory.
struct NamelessFiles {
  std::uint64_t in_memory = 0, on_disk = 0;
};

/// Counts the nameless files that the processes have open or mapped, each once. If the system does
/// not show the size of a file, its mapped part counts.
NamelessFiles nameless_files(const std::vector<ProcessState>& processes);

/// The bytes of a file, at most the first `most`. Errors: std::system_error; the result is never
/// incomplete.
std::string file_bytes(const std::filesystem::path& file,
                       std::size_t most = std::numeric_limits<std::size_t>::max());

/// Removes a folder and its contents, of any depth and with any permissions; links are not
/// followed. True if nothing is left.
bool remove_tree(const std::filesystem::path& folder);

/// Copies a file with its modification time; creates the parent folders.
void copy_with_time(const std::filesystem::path& from, const std::filesystem::path& to);

/// Removes everything in a folder.
void empty_folder(const std::filesystem::path& folder);

/// The most files and folders that disk_use() adds up.
inline constexpr int kMostFiles = 32'768;

/// The disk use of a folder. A file with several names counts once.
struct DiskUse {
  std::uint64_t bytes = 0;
  int files = 0;              ///< Including folders.
  bool is_too_deep = false;   ///< Folders are nested too deep to be added up.
  bool are_too_many = false;  ///< There are more than kMostFiles.
  bool is_closed = false;     ///< A folder cannot be read.
};

/// Links are not followed.
DiskUse disk_use(const std::filesystem::path& folder);

}  // namespace raycheck::tools
