#pragma once

#include <cerrno>
#include <mutex>
#include <string>
#include <system_error>

namespace raycheck::tools {

/// Whether an error of the system is the machine's, which has no room or no luck, and not of what
/// was asked for: another time it may not be met.
inline bool is_of_the_machine(const std::error_code& error) {
  for (const std::errc of_it :
       {std::errc::no_space_on_device, std::errc::not_enough_memory, std::errc::io_error,
        std::errc::too_many_files_open, std::errc::too_many_files_open_in_system,
        std::errc::resource_unavailable_try_again, std::errc::interrupted,
        std::errc::no_buffer_space, std::errc::read_only_file_system}) {
    if (error == of_it) return true;
  }
  return error == std::error_code(EDQUOT, std::generic_category());
}

/// What the machine did to a candidate: where it failed for a cause outside it, its answers count
/// for nothing. One for all its processes.
class Surroundings {
 public:
  /// `alone`: no other candidate runs beside it, so that what happens to it is its own doing, as
  /// long as the machine has room.
  explicit Surroundings(bool alone) : alone_(alone) {}
  bool alone() const { return alone_; }
  /// The first cause is kept.
  void blame(const std::string& cause) {
    const std::lock_guard lock(mutex_);
    if (cause_.empty()) cause_ = cause;
  }
  /// Empty: none.
  std::string cause() const {
    const std::lock_guard lock(mutex_);
    return cause_;
  }

 private:
  bool alone_;
  mutable std::mutex mutex_;
  std::string cause_;
};

}  // namespace raycheck::tools
