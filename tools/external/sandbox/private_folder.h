#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

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

/// What lies in a program's folder whenever it starts, made anew each time: what it changes there
/// is gone the next time. All by their paths in that folder.
struct StartingFolder {
  struct File {
    std::string name;
    std::string text;
    bool runs = false;  ///< Its mode says that it is a program.
  };
  std::vector<std::string> folders;  ///< Each behind those that it lies in.
  std::vector<File> files;           ///< Which it may change.
  std::vector<std::string> links;    ///< To files of these paths in `linked`, which it may read.
  std::shared_ptr<const PrivateFolder> linked;
};

/// Makes it in an empty folder, owned by `user` where that is not 0.
/// Errors: std::system_error naming the part.
void lay_out(const StartingFolder& start, const std::filesystem::path& folder, std::uint64_t user);

}  // namespace raycheck::tools
