#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "tools/external/sandbox/process_tree.h"

namespace raycheck::tools {

/// Bytes of files that are in no folder: removed files, memfd_create(), shared memory.
struct NamelessFiles {
  std::uint64_t in_memory = 0, on_disk = 0;
};

/// Counts those that the processes have open or mapped, each once. Where the system does not show
/// the size of one, what is mapped of it counts.
NamelessFiles nameless_files(const std::vector<ProcessState>& processes);

/// The bytes of a file, at most the first `most`. Errors: std::system_error; nothing is missed.
std::string file_bytes(const std::filesystem::path& file,
                       std::size_t most = std::numeric_limits<std::size_t>::max());

/// Removes a folder and all in it, however deep and whatever its permissions; links are not
/// followed. True if nothing is left.
bool remove_tree(const std::filesystem::path& folder);

/// Copies a file with its time, into folders that are made.
void copy_with_time(const std::filesystem::path& from, const std::filesystem::path& to);

/// Removes everything in a folder.
void empty_folder(const std::filesystem::path& folder);

/// The most files and folders that are added up.
inline constexpr int kMostFiles = 32'768;

/// What the files of a folder take on disk. A file with several names counts once.
struct DiskUse {
  std::uint64_t bytes = 0;
  int files = 0;              ///< And folders.
  bool is_too_deep = false;   ///< Folders are nested too deep to be added up.
  bool are_too_many = false;  ///< There are more than are added up.
  bool is_closed = false;     ///< A folder cannot be read.
};

/// Links are not followed.
DiskUse disk_use(const std::filesystem::path& folder);

}  // namespace raycheck::tools
