#include "tools/grade/rubric/rubric.h"

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "scene/files/scene_file.h"
#include "tests/fuzz/targets.h"

namespace raycheck::tests {
namespace {

/// A folder of its own, so that no file lies beside the rubric.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / "raycheck-fuzz-XXXXXX") {
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no folder can be made");
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string file() const { return path_ + "/rubric.toml"; }

 private:
  std::string path_;
};

}  // namespace

void fuzz_rubric(std::string_view bytes) {
  static const Folder folder;
  std::ofstream(folder.file(), std::ios::binary) << bytes;
  try {
    tools::load_rubric(folder.file());
  } catch (const scene::SceneFileError&) {
  }
}

}  // namespace raycheck::tests
