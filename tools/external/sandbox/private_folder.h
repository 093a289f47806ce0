#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace raycheck::tools {

/// A new empty folder, removed by the destructor.
class PrivateFolder {
 public:
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Removes the names of private folders, which differ from run to run, from a text.
std::string without_private_folders(const std::string& text);

/// Whether a candidate's user may enter a folder and all its parents.
bool others_may_enter(std::filesystem::path folder);

/// Whether a candidate's user may read a path.
bool others_may_read(const std::filesystem::path& path);

/// Lets every user read a file, or a folder and its contents.
void open_to_others(const std::filesystem::path& path);

/// The path of one of raycheck's files or, if other users may not read it, of a copy. (Candidates'
/// files are copied in tools/external/locate.cpp.)
std::filesystem::path readable_copy(const std::filesystem::path& path);

/// The initial contents of a program's folder. The folder is made anew for every start, so that
/// changes do not last. All paths are relative to it.
struct StartingFolder {
  struct File {
    std::string name;
    std::string text;
    bool runs = false;  ///< Whether it is executable.
  };
  std::vector<std::string> folders;  ///< Parents before their subfolders.
  std::vector<File> files;           ///< The program may change them.
  std::vector<std::string> links;  ///< Paths of links to the files with the same paths in `linked`.
  std::shared_ptr<const PrivateFolder> linked;
};

/// Fills an empty folder; if `user` is not 0, the files belong to that user. Errors:
/// std::system_error naming the file or folder.
void lay_out(const StartingFolder& start, const std::filesystem::path& folder, std::uint64_t user);

}  // namespace raycheck::tools
