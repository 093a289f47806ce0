#pragma once

#include <filesystem>
#include <string>

namespace raycheck::tools {

/// An empty folder, gone with the object.
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

/// Whether a user of its own may enter a folder, by all that lead to it.
bool others_may_enter(std::filesystem::path folder);

/// Whether a user of its own may read a path.
bool others_may_read(const std::filesystem::path& path);

/// Lets every user read a file, or a folder and all in it.
void open_to_others(const std::filesystem::path& path);

/// raycheck's own files as any user may read them: where they are closed to others, a copy. Of
/// candidates' files tools/external/locate.cpp makes the copies.
std::filesystem::path readable_copy(const std::filesystem::path& path);

}  // namespace raycheck::tools
