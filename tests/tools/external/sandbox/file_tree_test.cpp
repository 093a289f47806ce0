#include "tools/external/sandbox/file_tree.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Folders in folders, with names so long that a path to the innermost is too long for the system.
void nest(const fs::path& folder, int depth) {
  const std::string name(200, 'd');
  int here = open(folder.c_str(), O_DIRECTORY | O_RDONLY);
  for (int k = 0; k < depth; ++k) {
    ASSERT_EQ(mkdirat(here, name.c_str(), 0700), 0);
    const int next = openat(here, name.c_str(), O_DIRECTORY | O_RDONLY);
    close(here);
    here = next;
  }
  close(here);
}

TEST(HostileFiles, are_removed_however_deep_and_closed_they_lie) {
  const PrivateFolder folder;
  const fs::path tree = folder.path() / "tree";
  fs::create_directories(tree / "closed" / "below");
  std::ofstream(tree / "closed" / "below" / "file") << "text";
  fs::create_symlink("/etc", tree / "link");
  nest(tree, 3000);
  fs::permissions(tree / "closed", fs::perms::none);
  EXPECT_TRUE(remove_tree(tree));
  EXPECT_FALSE(fs::exists(fs::symlink_status(tree)));
  EXPECT_TRUE(fs::exists("/etc/passwd"));
  EXPECT_TRUE(remove_tree(tree)) << "what is not there";
}

TEST(HostileFiles, are_added_up_without_links_and_too_deep_ones_are_said) {
  const PrivateFolder folder;
  constexpr std::size_t kSize = 1 << 20;
  fs::create_directories(folder.path() / "a" / "b");
  std::ofstream(folder.path() / "one") << std::string(kSize, 'x');
  std::ofstream(folder.path() / "a" / "b" / "two") << std::string(kSize, 'x');
  fs::create_directory_symlink("/usr", folder.path() / "link");
  const DiskUse use = disk_use(folder.path());
  EXPECT_GE(use.bytes, 2 * kSize);
  EXPECT_LT(use.bytes, 2 * kSize + 65536);
  EXPECT_FALSE(use.is_too_deep);
  nest(folder.path(), 200);
  EXPECT_TRUE(disk_use(folder.path()).is_too_deep);
}

TEST(HostileFiles, of_several_names_count_once) {
  const PrivateFolder folder;
  constexpr std::size_t kSize = 1 << 20;
  std::ofstream(folder.path() / "one") << std::string(kSize, 'x');
  for (int k = 0; k < 50; ++k) {
    fs::create_hard_link(folder.path() / "one", folder.path() / std::to_string(k));
  }
  const DiskUse use = disk_use(folder.path());
  EXPECT_GE(use.bytes, kSize * 9 / 10);
  EXPECT_LT(use.bytes, kSize + 65536);
  EXPECT_EQ(use.files, 51);
  EXPECT_FALSE(use.are_too_many);
}

}  // namespace
}  // namespace raycheck::tools
