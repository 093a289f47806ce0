#pragma once

#include <sys/types.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {

/// The layers of a candidate's isolation. In addition, every candidate has a separate session,
/// folder and environment, closed descriptors and resource limits.
struct Layers {
  bool own_user = false;    ///< It runs under an unused user id; this needs root.
  bool seccomp = false;     ///< No sockets, no access to other processes.
  bool landlock = false;    ///< Access only to needed files; used without bubblewrap.
  bool bubblewrap = false;  ///< Separate namespaces, with only the needed files.
  /// A separate control group, in which the kernel counts and kills all its processes together and,
  /// if it can, limits them together.
  bool control_group = false, group_memory = false, group_processes = false;
  /// "own user, seccomp, bubblewrap, control group (memory, processes)", or "limits only"
  std::string text() const;
};

/// A required layer that does not work on this machine.
struct MissingLayer {
  std::string name;
  std::string why;  ///< The error message.
};

/// The layers that work on this machine, found by trying each once, and the layers that do not.
struct LayersHere {
  Layers layers;
  std::vector<MissingLayer> missing;
  /// Why there is no control group (most machines do not allow them). Empty if there is one, or if
  /// there is no sandbox.
  std::string no_control_group = {};
};
const LayersHere& layers_here();

/// Which layers to use.
enum class Sandbox {
  kRequire,    ///< All required layers: a separate user if raycheck is root, seccomp, bubblewrap.
  kAvailable,  ///< The layers that work on this machine.
  kNone        ///< No layers, only limits.
};
/// Errors: std::invalid_argument if kRequire needs a layer that does not work (with the reason and
/// the working layers), or if the folder for temporary files is unusable.
LayersHere chosen_layers(Sandbox sandbox);

/// A candidate's total CPU time, shared by all its processes and threads. It is in whole
/// nanoseconds, so that differences do not depend on earlier sums. A stored answer counts with its
/// original time, so that time limits do not depend on which answers are stored.
class SpentTime {
 public:
  using Time = std::chrono::nanoseconds;
  /// Clamps `seconds` to [0, kMostSeconds], because stored values may be invalid.
  void add(double seconds) {
    const std::chrono::duration<double> added(std::clamp(seconds, 0.0, kMostSeconds));
    spent_.fetch_add(std::chrono::round<Time>(added).count());
  }
  Time so_far() const { return Time(spent_.load()); }
  double seconds_since(Time before) const {
    return std::chrono::duration<double>(so_far() - before).count();
  }

 private:
  static constexpr double kMostSeconds = 1e8;
  std::atomic<Time::rep> spent_{0};
};

/// Whether an error is caused by the state of the machine (no space, too many open files), so that
/// it may be temporary, rather than by the request.
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

/// Records why a candidate failed if it is not its fault; then its answers do not count. Shared by
/// all its processes.
class Surroundings {
 public:
  /// `alone`: whether no other candidate runs in parallel. Then its failures are its own fault as
  /// long as the machine has memory and disk space.
  explicit Surroundings(bool alone) : alone_(alone) {}
  bool alone() const { return alone_; }
  /// Records a cause; the first one is kept.
  void blame(const std::string& cause) {
    const std::lock_guard lock(mutex_);
    if (cause_.empty()) cause_ = cause;
  }
  /// The cause; empty if there is none.
  std::string cause() const {
    const std::lock_guard lock(mutex_);
    return cause_;
  }

 private:
  bool alone_;
  mutable std::mutex mutex_;
  std::string cause_;
};

/// Why a candidate cannot be judged at all.
struct Refusal {
  std::string why;   ///< One line.
  std::string said;  ///< Output of a compiler or the program; may be empty.
};

/// The names of limits in the user's input, for messages; a limit with an empty name is not named.
struct LimitNames {
  std::string seconds = {}, file = {}, memory = {}, processes = {}, disk = {};
};

/// The name of a limit in parentheses, to be appended to its value: " (file_mib)".
std::string called(const std::string& limit);

/// Limits on a process, or on a process and all its descendants.
struct Limits {
  /// Limits the CPU time of all processes, from a request to the end of its reply; watch.h defines
  /// how waiting counts.
  double seconds = 10;
  std::uint64_t cpu_seconds = 600;
  /// In bytes: limits the address space of each process, and the physical memory of all together.
  std::uint64_t memory = std::uint64_t{4} << 30;
  std::uint64_t disk = std::uint64_t{1} << 30;   ///< In total, in bytes.
  std::uint64_t file = std::uint64_t{64} << 20;  ///< The largest file, in bytes.
  std::uint64_t files = 256;                     ///< The number of files open at a time.
  std::uint64_t processes = 64;
  LimitNames names = {};
};

/// A program to run, the files that it may read besides the system's, and its isolation.
struct Confined {
  std::vector<std::string> arguments;
  std::vector<std::filesystem::path> readable;
  Layers layers;
  Limits limits;
  /// Files in its folder at the start.
  std::vector<StartingFolder::File> files = {};
  /// Further contents of its folder at the start; may be null.
  std::shared_ptr<const StartingFolder> start = {};
  /// Records why a failure is not the candidate's fault; may be null.
  std::shared_ptr<Surroundings> surroundings = {};
  /// Its CPU time, shared with all copies of this struct.
  std::shared_ptr<SpentTime> spent = std::make_shared<SpentTime>();
};

/// How a candidate's process failed.
enum class FailureKind {
  kSystem,        ///< A system call failed: the process could not be started or reached.
  kEnded,         ///< It ended before its task was finished.
  kTimeUp,        ///< It timed out.
  kExtraOutput,   ///< It gave more output than requested or allowed.
  kBadReply,      ///< A malformed reply, or not a picture.
  kNotAsked,      ///< It timed out too often and was dropped.
  kCannotExpress  ///< Not a failure: its input format cannot express the scene.
};

/// A program's output as a clause for error messages; empty if there is none.
std::string output_text(const std::string& output);

/// A failure of a candidate's process: "exited with 3", "was killed by signal 11 (Segmentation
/// fault)", "gave no reply within 10 s".
class ProcessFailure : public std::runtime_error {
 public:
  /// `why` is one line; `output` is an excerpt of the output, or empty. what() contains both.
  ProcessFailure(FailureKind kind, const std::string& why, const std::string& output = {})
      : std::runtime_error(why + output_text(output)), kind_(kind), why_(why), output_(output) {}
  FailureKind kind() const { return kind_; }
  const std::string& why() const { return why_; }
  const std::string& output() const { return output_; }

 private:
  FailureKind kind_;
  std::string why_, output_;
};

/// The folders that are searched for programs.
inline constexpr std::array kProgramFolders = {"/usr/local/bin", "/usr/bin", "/bin"};
/// kProgramFolders as a value of PATH.
std::string program_path();
/// Whether one of kProgramFolders has a program with this name.
bool is_on_path(const std::string& program);

/// The path of raycheck-jail or raycheck-worker.
std::filesystem::path helper(const std::string& name);

/// The folder of this program and its helpers (raycheck-jail, raycheck-worker).
std::filesystem::path program_folder();
/// The prefix of the installation; PREFIX/libexec/raycheck contains the programs.
std::filesystem::path prefix();

/// The folder of the adapters for other languages: in the installation or, if raycheck is not
/// installed, in its sources.
std::filesystem::path adapters();

/// A user id without an account, for a new process. It is made from this process's id and a
/// counter, and has 31 bits; after use_small_users(), 16.
std::uint64_t next_user();
/// Makes next_user() return ids of 16 bits; to be called if larger ids do not work.
void use_small_users();

/// The standard streams of a program.
struct Streams {
  int input, output, error;
};

/// Starts a program in its layers, with these streams, in this folder, with a nearly empty
/// environment. Returns when all layers are in place; later failures are the program's fault.
/// `user`: its user id, or 0. `group`: its control group, or empty.
/// Errors: ProcessFailure (kSystem) if a layer fails; the program never starts with fewer layers.
pid_t launch(const Confined& confined, const std::filesystem::path& folder, std::uint64_t user,
             const std::filesystem::path& group, const Streams& streams);

/// System folders that programs need. Of /etc, these are only files of the loader, Java and OpenSSL
/// (Node.js does not start if OpenSSL's file exists but is unreadable). Some may not exist.
std::vector<std::filesystem::path> system_paths();

/// Folders that raycheck's helpers need besides the system's: the adapters and, if readable, the
/// libraries of an installed package.
std::vector<std::filesystem::path> own_paths();

/// Files that would reveal answers or questions: raycheck's programs, in all program folders, and
/// its rubrics.
std::vector<std::filesystem::path> hidden_paths();

}  // namespace raycheck::tools
