#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

namespace raycheck::tools {

/// The bytes of a file, or so many of the first. Errors: std::system_error; nothing is missed.
std::string file_bytes(const std::filesystem::path& file,
                       std::size_t most = std::numeric_limits<std::size_t>::max());

/// Removes a folder and all in it, however deep and whatever its permissions; links are not
/// followed. Whether nothing is left.
bool remove_tree(const std::filesystem::path& folder);

/// Removes all that lies in a folder.
void empty_folder(const std::filesystem::path& folder);

/// Files and folders that are added up at most.
inline constexpr int kMostFiles = 32'768;

/// What the files of a folder take on disk. One of several names counts once.
struct DiskUse {
  std::uint64_t bytes = 0;
  int files = 0;              ///< And folders.
  bool is_too_deep = false;   ///< Folders lie in folders too deep to be added up.
  bool are_too_many = false;  ///< There are more than are added up.
  bool is_closed = false;     ///< A folder cannot be looked into.
};

/// Links are not followed.
DiskUse disk_use(const std::filesystem::path& folder);

}  // namespace raycheck::tools
