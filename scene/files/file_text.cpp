#include "scene/files/file_text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "scene/files/scene_file.h"
#include "scene/text.h"

namespace raycheck::scene {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw SceneFileError(visible_line(path.string()) + ": cannot be read: " + reason);
}

[[noreturn]] void refuse_for_error(const fs::path& path, int error) {
  refuse(path, std::generic_category().message(error));
}

/// Call this before opening the file, since opening a named pipe may block.
void require_readable_kind(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error) refuse(path, error.message());
  if (fs::is_directory(status)) refuse(path, "it is a folder; give a file");
  if (fs::is_block_file(status)) refuse(path, "it is a device; give a file");
  if (!fs::is_fifo(status)) return;
  // The only path of an anonymous pipe is that of its descriptor.
  const fs::path named = fs::canonical(path, error);
  if (!error && !named.empty()) refuse(path, "it is a named pipe; give a file, or /dev/stdin");
}

class Descriptor {
 public:
  explicit Descriptor(const fs::path& path)
      : number_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

std::string file_text(const fs::path& path, std::uintmax_t most) {
  require_readable_kind(path);
  const Descriptor file(path);
  struct stat status = {};
  if (file.number() < 0 || fstat(file.number(), &status) != 0) refuse_for_error(path, errno);
  if (S_ISCHR(status.st_mode) && isatty(file.number()) == 0) {
    refuse(path, "it is a device; give a file");
  }
  const std::string too_large =
      "it has more than " + std::to_string(most) + " bytes, which is the limit";
  if (S_ISREG(status.st_mode) && static_cast<std::uintmax_t>(status.st_size) > most) {
    refuse(path, too_large);
  }
  std::string text;
  std::array<char, 1 << 16> buffer{};
  for (;;) {
    const ssize_t count = read(file.number(), buffer.data(), buffer.size());
    if (count == 0) return text;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse_for_error(path, errno);
    text.append(buffer.data(), static_cast<std::size_t>(count));
    if (text.size() > most) refuse(path, too_large);
  }
}

}  // namespace raycheck::scene
