#ifndef RAYCHECK_TOOLS_EXTERNAL_SANDBOX_PROCESS_H_
#define RAYCHECK_TOOLS_EXTERNAL_SANDBOX_PROCESS_H_

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {

/// What keeps a candidate in its place, beyond what always does: a group, a folder and an
/// environment of its own, closed descriptors and limits on what it uses.
struct Layers {
  bool other_user = false;   ///< It runs as a user that owns nothing; raycheck is root.
  bool seccomp = false;      ///< No sockets, no looking into other processes.
  bool bubblewrap = false;   ///< Namespaces of its own; of the file system what it needs.
  std::string text() const;  ///< "other user, seccomp, bubblewrap", or "limits only"
};

/// The layers that work here; found out once, by trying.
const Layers& layers_that_work();

/// Which to use. Throws std::invalid_argument where `require` asks for what does not work here.
enum class Sandbox { kAuto, kRequire, kNone };
Layers chosen_layers(Sandbox sandbox);

/// What one process may use.
struct Limits {
  double seconds = 10;  ///< Wall time, from a request to the end of its reply.
  std::uint64_t cpu_seconds = 600;
  std::uint64_t memory = std::uint64_t{4} << 30;  ///< Of addresses, in bytes.
  std::uint64_t file = std::uint64_t{64} << 20;   ///< The largest file, in bytes.
  std::uint64_t files = 64;                       ///< Open at a time.
  std::uint64_t processes = 64;
};

/// raycheck-jail or raycheck-worker.
std::filesystem::path helper(const std::string& name);

/// A program to run, what it may read besides the system, and how it is kept.
struct Confined {
  std::vector<std::string> arguments;
  std::vector<std::filesystem::path> readable;
  Layers layers;
  Limits limits;
  /// What lies in its folder at the start: names and contents.
  std::vector<std::pair<std::string, std::string>> files = {};
};

/// What went wrong with a candidate's process: "exited with 3", "was killed by signal 11
/// (Segmentation fault)", "gave no reply within 10 s".
inline constexpr std::string_view kSilent = "gave no reply within";
inline constexpr std::string_view kEndless = "did not end within";
class ProcessFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The folder in which raycheck and its helpers (raycheck-jail, raycheck-worker) lie.
std::filesystem::path program_folder();

/// Where the adapters of other languages are: beside an installed program, or in the sources that
/// it was built of.
std::filesystem::path adapters();

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
  [[noreturn]] void fail(const std::string& what);
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
