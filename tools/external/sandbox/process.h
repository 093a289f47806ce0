#ifndef RAYCHECK_TOOLS_EXTERNAL_SANDBOX_PROCESS_H_
#define RAYCHECK_TOOLS_EXTERNAL_SANDBOX_PROCESS_H_

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "tools/external/sandbox/launch.h"
#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {

/// The end of what a program said, as a clause; empty where it was silent.
std::string last_line_text(const std::string& said);

/// A process that is talked to through pipes, in a folder of its own; its end is the end of all
/// that it started.
/// Errors: ProcessFailure, also where it cannot be started; afterwards it is dead.
class Process {
 public:
  explicit Process(const Confined& confined);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Sends a request and returns what is answered, up to and with the first line for which
  /// `is_last` holds. Longer answers than `most_bytes` are failures.
  std::string exchange(std::string_view request,
                       const std::function<bool(std::string_view line)>& is_last,
                       std::size_t most_bytes);
  /// Closes its input and waits for its end; returns its exit code.
  int finish();
  /// The end of what it wrote on the standard error.
  const std::string& said() const { return said_; }
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  [[noreturn]] void fail(FailureKind kind, const std::string& words);
  [[noreturn]] void fail_ended();
  void listen();
  bool has_ended(int& status);
  void kill_all();
  void kill_rest(pid_t group) const;

  PrivateFolder folder_;
  Confined confined_;
  std::uint64_t user_ = 0;
  pid_t pid_ = -1;
  int input_ = -1, output_ = -1, error_ = -1;
  std::string said_;
};

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXTERNAL_SANDBOX_PROCESS_H_
