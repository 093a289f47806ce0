#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace raycheck::tools {

/// An empty folder, removed with the object.
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

/// A text without the names of such folders, which differ from run to run.
std::string without_private_folders(const std::string& text);

/// Whether a candidate's own user may enter a folder, and every folder on the way to it.
bool others_may_enter(std::filesystem::path folder);

/// Whether a candidate's own user may read a path.
bool others_may_read(const std::filesystem::path& path);

/// Lets every user read a file, or a folder and all in it.
void open_to_others(const std::filesystem::path& path);

/// One of raycheck's own files, or a copy of it where other users may not read it. Candidates'
/// files are copied by tools/external/locate.cpp.
std::filesystem::path readable_copy(const std::filesystem::path& path);

/// What lies in a program's folder whenever it starts. It is made anew for every start, so that
/// changes do not last. All paths are relative to that folder.
struct StartingFolder {
  struct File {
    std::string name;
    std::string text;
    bool runs = false;  ///< It is executable.
  };
  std::vector<std::string> folders;  ///< Each after those that contain it.
  std::vector<File> files;           ///< Which it may change.
  std::vector<std::string> links;    ///< To files of these paths in `linked`, which it may read.
  std::shared_ptr<const PrivateFolder> linked;
};

/// Makes it in an empty folder, owned by `user` unless that is 0.
/// Errors: std::system_error naming the part.
void lay_out(const StartingFolder& start, const std::filesystem::path& folder, std::uint64_t user);

}  // namespace raycheck::tools
