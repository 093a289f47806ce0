#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace raycheck::tools {

/// The list of what raycheck wrote into a folder of results; no submission may have this name.
inline constexpr std::string_view kOwnFilesList = ".raycheck-files";

/// The files that raycheck wrote below a folder of results, in this and earlier runs, recognised by
/// name and contents: it never replaces or removes any other, be it a user's, or raycheck's but
/// edited since. Names are relative to the folder. Thread-safe.
class OwnFiles {
 public:
  /// Reads the list; the folder need not exist yet. Errors: std::invalid_argument if something else
  /// is in the list's place.
  explicit OwnFiles(std::filesystem::path out);

  /// Throws std::invalid_argument naming the file if one of that name is not raycheck's own.
  void require_own(const std::filesystem::path& name) const;
  /// Makes a folder that is not there yet. Errors: std::invalid_argument.
  void make_folder(const std::filesystem::path& name) const;
  /// Writes a file; replaces only raycheck's own. Errors: as require_own(); std::runtime_error if
  /// it could not be written.
  void write(const std::filesystem::path& name, const std::string& text);
  /// Makes a folder, writes these files into it, and removes all other files of raycheck directly
  /// in it, except kRecordFile. Errors: as write().
  void replace(const std::filesystem::path& folder,
               const std::map<std::string, std::string>& files);

 private:
  bool is_own(const std::filesystem::path& name) const;
  void list(const std::string& digest);

  std::filesystem::path out_;
  mutable std::mutex mutex_;
  std::set<std::string> digests_;  ///< Of names and contents.
};

}  // namespace raycheck::tools
