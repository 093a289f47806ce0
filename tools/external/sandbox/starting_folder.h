#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {

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
