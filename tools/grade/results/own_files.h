#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace raycheck::tools {

/// The list of what raycheck wrote into a folder of results; no submission is called so.
inline constexpr std::string_view kOwnFilesList = ".raycheck-files";

/// The files that raycheck wrote below a folder of results, in this run and in earlier ones, which
/// it knows again by their names and contents: no other is ever replaced or removed, be it
/// someone's own or raycheck's and edited since. Names are relative to the folder. For all threads.
class OwnFiles {
 public:
  /// Reads the list; the folder need not be there yet. Errors: std::invalid_argument where there is
  /// something else in the list's place.
  explicit OwnFiles(std::filesystem::path out);

  /// Throws std::invalid_argument that names the file where one of that name is not raycheck's own.
  void require_own(const std::filesystem::path& name) const;
  /// Makes a folder that is not there yet. Errors: std::invalid_argument.
  void make_folder(const std::filesystem::path& name) const;
  /// Writes a file, in place of its own at most. Errors: as require_own(); std::runtime_error where
  /// it could not be written.
  void write(const std::filesystem::path& name, const std::string& text);
  /// Writes the files of a folder, by their names there, which is made, and removes what else is
  /// its own right below it, but for kRecordFile. Errors: as write().
  void replace(const std::filesystem::path& folder,
               const std::map<std::string, std::string>& files);

 private:
  bool is_own(const std::filesystem::path& name) const;
  void list(const std::string& digest);

  std::filesystem::path out_;
  mutable std::mutex mutex_;
  std::set<std::string> digests_;  ///< Of a name and contents.
};

}  // namespace raycheck::tools
