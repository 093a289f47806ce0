#pragma once

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>

namespace raycheck::tools {

/// Owns a file descriptor, or none (-1). Closing preserves errno.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    close();
    number_ = std::exchange(other.number_, -1);
    return *this;
  }
  ~Descriptor() { close(); }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close() {
    const int error = errno;
    if (is_open()) ::close(number_);
    number_ = -1;
    errno = error;
  }

 private:
  int number_;
};

/// An open folder, closed by the destructor; null if it cannot be read.
using FolderEntries = std::unique_ptr<DIR, int (*)(DIR*)>;

/// Both ends of a pipe, with close-on-exec. Errors: std::system_error.
struct Pipe {
  Descriptor read, write;
  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw std::system_error(errno, std::generic_category(), "pipe");
    }
    read = Descriptor(ends[0]);
    write = Descriptor(ends[1]);
  }
};

}  // namespace raycheck::tools
