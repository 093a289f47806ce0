#include "tools/external/sandbox/nameless_files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <string>

#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {
namespace {

constexpr std::size_t kSize = std::size_t{4} << 20;

/// What this process has of them since it was last asked.
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
  const std::string bytes(kSize, 'x');
  ASSERT_EQ(write(file, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
}

TEST(HostileNamelessFiles, OfMemoryCountWhereNothingIsMapped) {
  More more;
  const int file = memfd_create("x", MFD_CLOEXEC);
  ASSERT_GE(file, 0);
  fill(file);
  EXPECT_EQ(more.found().in_memory, kSize);
  const int again = dup(file);
  EXPECT_EQ(more.found().in_memory, 0) << "once";
  close(again);
  // One page of it keeps all.
  void* const page = mmap(nullptr, 4096, PROT_READ, MAP_SHARED, file, 0);
  ASSERT_NE(page, MAP_FAILED);
  close(file);
  if (geteuid() == 0) {
    EXPECT_EQ(more.found().in_memory, 0) << "as much as before";
  }
  munmap(page, 4096);
}

TEST(HostileNamelessFiles, OfMemoryCountWhereOthersTouchedThem) {
  More more;
  void* const memory =
      mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  ASSERT_EQ(madvise(memory, kSize, MADV_POPULATE_WRITE), 0);
  ASSERT_EQ(madvise(memory, kSize, MADV_DONTNEED),
            0);  // no longer of this process, and still there
  EXPECT_EQ(more.found().in_memory, kSize);
  munmap(memory, kSize);
}

TEST(HostileNamelessFiles, OnDiskCountThoughTheyAreRemoved) {
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
  const NamelessFiles removed = more.found();  // in memory, where TMPDIR is
  EXPECT_GE(removed.on_disk + removed.in_memory, kSize);
  EXPECT_LT(removed.on_disk + removed.in_memory, kSize + 65536);
  close(file);
}

}  // namespace
}  // namespace raycheck::tools
