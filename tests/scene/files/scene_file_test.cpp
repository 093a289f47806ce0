#include "scene/files/scene_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace raycheck::scene {
namespace {

TEST(LoadScene, NamesTheFileAndTheReason) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  for (const char* const file : {"raycheck-no-such-file.toml", "raycheck-no-such-file"}) {
    try {
      load_scene(folder / file);
      ADD_FAILURE();
    } catch (const SceneFileError& error) {
      EXPECT_EQ(error.what(),
                (folder / file).string() + ": cannot be read: No such file or directory");
    }
  }
  try {
    load_scene(folder);
    ADD_FAILURE();
  } catch (const SceneFileError& error) {
    EXPECT_EQ(error.what(), folder.string() + ": cannot be read: it is a folder; give a file");
  }
}

TEST(LoadScene, WarnsThatADialectDoesNotConcernToml) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) /
                                     ("raycheck-dialect-" + std::to_string(getpid()) + ".toml");
  std::ofstream(path) << "[[ray]]\norigin = [0, 0, 0]\ndirection = [1, 0, 0]\n";
  EXPECT_TRUE(load_scene(path).warnings.empty());
  EXPECT_EQ(load_scene(path, Dialect::kA).warnings,
            (std::vector<std::string>{
                path.string() + ": a dialect was asked for, but only driver files have one"}));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace raycheck::scene
