#include "tools/external/sandbox/jail_files.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <string>
#include <system_error>

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// As newer kernels than these headers have it: what is zero need not be known.
struct Attributes {
  std::uint64_t files = 0, network = 0, scopes = 0;
};

// What the kernel's ABI of this number brought.
constexpr int kAbiRefer = 2, kAbiTruncate = 3, kAbiNetwork = 4, kAbiDevices = 5, kAbiScopes = 6;
constexpr std::uint64_t kFirstRights = (std::uint64_t{1} << 13) - 1;
constexpr std::uint64_t kRefer = std::uint64_t{1} << 13;
constexpr std::uint64_t kTruncate = std::uint64_t{1} << 14;
constexpr std::uint64_t kDevices = std::uint64_t{1} << 15;
constexpr std::uint64_t kBindAndConnect = 3;
constexpr std::uint64_t kAbstractSocketsAndSignals = 3;

constexpr std::uint64_t kReads =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
/// Of these rights files have their own; the others are those of folders.
constexpr std::uint64_t kOfFiles = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE |
                                   LANDLOCK_ACCESS_FS_READ_FILE | kTruncate | kDevices;

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), "landlock: " + what);
}

Attributes handled_by(int abi) {
  Attributes all;
  all.files = kFirstRights | (abi >= kAbiRefer ? kRefer : 0) |
              (abi >= kAbiTruncate ? kTruncate : 0) | (abi >= kAbiDevices ? kDevices : 0);
  all.network = abi >= kAbiNetwork ? kBindAndConnect : 0;
  all.scopes = abi >= kAbiScopes ? kAbstractSocketsAndSignals : 0;
  return all;
}

class Ruleset {
 public:
  explicit Ruleset(const Attributes& handled)
      : handled_(handled.files),
        descriptor_(
            static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0U))) {
    if (descriptor_ < 0) fail("rules");
  }
  ~Ruleset() { close(descriptor_); }
  Ruleset(const Ruleset&) = delete;
  Ruleset& operator=(const Ruleset&) = delete;

  void allow(const fs::path& path, std::uint64_t rights) const {
    const int of = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (of < 0) fail(path);
    landlock_path_beneath_attr rule{};
    rule.parent_fd = of;
    rule.allowed_access = rights & handled_ & (fs::is_directory(path) ? ~0ULL : kOfFiles);
    const auto failed =
        syscall(SYS_landlock_add_rule, descriptor_, LANDLOCK_RULE_PATH_BENEATH, &rule, 0U);
    const int error = errno;
    close(of);
    errno = error;
    if (failed != 0) fail(path);
  }

  /// Of a folder with something hidden in it everything else, one by one.
  void allow_reads(const fs::path& path, const std::vector<fs::path>& hidden) const {
    if (std::find(hidden.begin(), hidden.end(), path) != hidden.end()) return;
    const std::string below = path.string() + "/";
    if (std::none_of(hidden.begin(), hidden.end(),
                     [&](const fs::path& one) { return one.string().starts_with(below); })) {
      allow(path, kReads);
      return;
    }
    allow(path, LANDLOCK_ACCESS_FS_READ_DIR);
    for (const auto& entry : fs::directory_iterator(path)) {
      if (!entry.is_symlink()) allow_reads(entry.path(), hidden);
    }
  }

  void enforce() const {
    if (syscall(SYS_landlock_restrict_self, descriptor_, 0U) != 0) fail("beginning");
  }

 private:
  std::uint64_t handled_;
  int descriptor_;
};

}  // namespace

bool keep_to_files(const FileRights& rights) {
  const auto abi = static_cast<int>(
      syscall(SYS_landlock_create_ruleset, nullptr, 0UL, LANDLOCK_CREATE_RULESET_VERSION));
  if (abi < 1) fail("this kernel has none");
  const Ruleset rules(handled_by(abi));
  for (const fs::path& path : rights.reads) {
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    if (!error) rules.allow_reads(real, rights.hidden);
  }
  for (const fs::path& path : rights.writes) rules.allow(path, ~0ULL);
  rules.enforce();
  return abi >= kAbiScopes;
}

}  // namespace raycheck::tools
