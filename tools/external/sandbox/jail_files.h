#pragma once

#include <filesystem>
#include <vector>

namespace raycheck::tools {

/// What a program may do with files: by their absolute paths, folders with all that lies in them.
struct FileRights {
  std::vector<std::filesystem::path> reads;   ///< Reads and runs; what is not there is passed over.
  std::vector<std::filesystem::path> hidden;  ///< Of `reads`, what it may not.
  std::vector<std::filesystem::path> writes;  ///< Does whatever it likes in; these must be there.
  bool empty() const { return reads.empty() && writes.empty(); }
};

/// Keeps this process and what it starts to these files by Landlock, and from TCP where the kernel
/// can do that (6.7). Returns whether signals are kept in, too (6.12).
/// Errors: std::system_error where the kernel has no Landlock.
bool keep_to_files(const FileRights& rights);

}  // namespace raycheck::tools
