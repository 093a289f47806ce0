#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/testing.h"
#include "tools/external/sandbox/file_tree.h"
#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Nested folders with names so long that the path of the innermost exceeds the system's limit.
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

TEST(HostileFiles, are_removed_at_any_depth_and_with_any_permissions) {
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

TEST(HostileFiles, with_several_names_count_once) {
  const PrivateFolder folder;
  constexpr std::size_t kSize = 1 << 20;
  fs::create_directories(folder.path() / "a" / "b");
  std::ofstream(folder.path() / "one") << std::string(kSize, 'x');
  std::ofstream(folder.path() / "a" / "b" / "two") << std::string(kSize, 'x');
  fs::create_directory_symlink("/usr", folder.path() / "link");
  for (int k = 0; k < 50; ++k) {
    fs::create_hard_link(folder.path() / "one", folder.path() / std::to_string(k));
  }
  const DiskUse use = disk_use(folder.path());
  EXPECT_GE(use.bytes, 2 * kSize);
  EXPECT_LT(use.bytes, 2 * kSize + 65536);
  EXPECT_EQ(use.files, 55);
  EXPECT_FALSE(use.are_too_many);
  EXPECT_FALSE(use.is_too_deep);
  nest(folder.path(), 200);
  EXPECT_TRUE(disk_use(folder.path()).is_too_deep);
}

constexpr std::size_t kFilled = std::size_t{4} << 20;

/// The nameless files of this process since the last call.
class More {
 public:
  NamelessFiles found() {
    const NamelessFiles now = all();
    const NamelessFiles more{now.in_memory - before_.in_memory, now.on_disk - before_.on_disk};
    before_ = now;
    return more;
  }

 private:
  static NamelessFiles all() {
    ProcessState self;
    self.pid = getpid();
    return nameless_files({self});
  }
  NamelessFiles before_ = all();
};

void fill(int file) {
  const std::string bytes(kFilled, 'x');
  ASSERT_EQ(write(file, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
}

TEST(HostileNamelessFiles, InMemoryCountEvenIfNotMapped) {
  More more;
  const int file = memfd_create("x", MFD_CLOEXEC);
  ASSERT_GE(file, 0);
  fill(file);
  EXPECT_EQ(more.found().in_memory, kFilled);
  const int again = dup(file);
  EXPECT_EQ(more.found().in_memory, 0) << "once";
  close(again);
  // Mapping one page keeps the whole file.
  void* const page = mmap(nullptr, 4096, PROT_READ, MAP_SHARED, file, 0);
  ASSERT_NE(page, MAP_FAILED);
  close(file);
  if (geteuid() == 0) {
    EXPECT_EQ(more.found().in_memory, 0) << "as much as before";
  }
  munmap(page, 4096);
}

TEST(HostileNamelessFiles, InMemoryCountIfOtherProcessesTouchedThem) {
  More more;
  void* const memory =
      mmap(nullptr, kFilled, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  ASSERT_EQ(madvise(memory, kFilled, MADV_POPULATE_WRITE), 0);
  ASSERT_EQ(madvise(memory, kFilled, MADV_DONTNEED),
            0);  // no longer mapped by this process, but still allocated
  EXPECT_EQ(more.found().in_memory, kFilled);
  munmap(memory, kFilled);
}

TEST(HostileNamelessFiles, OnDiskCountAfterRemoval) {
  More more;
  const PrivateFolder folder;
  const std::string path = folder.path() / "file";
  const int file = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
  ASSERT_GE(file, 0);
  fill(file);
  ASSERT_EQ(fsync(file), 0);
  const NamelessFiles named = more.found();
  EXPECT_EQ(named.on_disk + named.in_memory, 0);
  ASSERT_EQ(unlink(path.c_str()), 0);
  const NamelessFiles removed = more.found();  // in memory if TMPDIR is
  EXPECT_GE(removed.on_disk + removed.in_memory, kFilled);
  EXPECT_LT(removed.on_disk + removed.in_memory, kFilled + 65536);
  close(file);
}

}  // namespace
}  // namespace raycheck::tools
