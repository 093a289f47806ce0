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

/// The layers of a candidate's isolation, besides those that always apply: a separate session,
/// folder and environment, closed descriptors and resource limits.
struct Layers {
  bool own_user = false;    ///< It runs as an unused user id; needs root.
  bool seccomp = false;     ///< No sockets, no access to other processes.
  bool landlock = false;    ///< Access only to needed files; without bubblewrap.
  bool bubblewrap = false;  ///< Separate namespaces, with only the needed files.
  /// A separate control group, in which all its processes are counted, killed and, if the kernel
  /// can, limited together.
  bool control_group = false, group_memory = false, group_processes = false;
  /// "own user, seccomp, bubblewrap, control group (memory, processes)", or "limits only"
  std::string text() const;
};

/// A required layer that does not work on this machine.
struct MissingLayer {
  std::string name;
  std::string why;  ///< The error message.
};

/// The layers that work on this machine, found once by trying, and those that do not.
struct LayersHere {
  Layers layers;
  std::vector<MissingLayer> missing;
  /// Why there is no control group (most machines do not allow them); empty if there is one, or
  /// without a sandbox.
  std::string no_control_group = {};
};
const LayersHere& layers_here();

/// Which layers to use.
enum class Sandbox {
  kRequire,    ///< All required ones: a separate user if root, seccomp, bubblewrap.
  kAvailable,  ///< Those that work on this machine.
  kNone        ///< Only limits.
};
/// Errors: std::invalid_argument if `kRequire` needs a layer that does not work, with the reason
/// and the working layers; and if the folder for temporary files is unusable.
LayersHere chosen_layers(Sandbox sandbox);

/// A candidate's total CPU time, in whole nanoseconds, so that differences do not depend on earlier
/// sums. A stored answer counts with its original time, so that time limits do not depend on what
/// is stored. Shared by all its processes and threads.
class SpentTime {
 public:
  using Time = std::chrono::nanoseconds;
  /// `seconds`: clamped to 0 ... kMostSeconds, as stored values may be invalid.
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

/// Whether an error is temporary, from the state of the machine (no space, too many open files) and
/// not from the request.
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

/// Records why a candidate failed if the cause is outside it; then its answers do not count. Shared
/// by all its processes.
class Surroundings {
 public:
  /// `alone`: no other candidate runs in parallel, so that its failures are its own fault as long
  /// as the machine has memory and disk space.
  explicit Surroundings(bool alone) : alone_(alone) {}
  bool alone() const { return alone_; }
  /// Records a cause; the first one is kept.
  void blame(const std::string& cause) {
    const std::lock_guard lock(mutex_);
    if (cause_.empty()) cause_ = cause;
  }
  /// Empty if there is none.
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

/// The names of limits in the user's input, for messages; empty: not mentioned.
struct LimitNames {
  std::string seconds = {}, file = {}, memory = {}, processes = {}, disk = {};
};

/// The name of a limit in parentheses, to follow its mention: " (file_mib)".
std::string called(const std::string& limit);

/// Limits on a process, or on a process and all its descendants.
struct Limits {
  /// CPU time of all of them, from a request to the end of its reply; watch.h defines how waiting
  /// counts.
  double seconds = 10;
  std::uint64_t cpu_seconds = 600;
  /// In bytes: address space of each process, and physical memory of all together.
  std::uint64_t memory = std::uint64_t{4} << 30;
  std::uint64_t disk = std::uint64_t{1} << 30;   ///< In total, in bytes.
  std::uint64_t file = std::uint64_t{64} << 20;  ///< The largest file, in bytes.
  std::uint64_t files = 256;                     ///< Open at a time.
  std::uint64_t processes = 64;
  LimitNames names = {};
};

/// A program to run, with the files that it may read besides the system's, and its isolation.
struct Confined {
  std::vector<std::string> arguments;
  std::vector<std::filesystem::path> readable;
  Layers layers;
  Limits limits;
  /// Files in its folder at the start.
  std::vector<StartingFolder::File> files = {};
  /// Further contents of its folder; may be null.
  std::shared_ptr<const StartingFolder> start = {};
  /// Records failures with a cause outside the candidate; may be null.
  std::shared_ptr<Surroundings> surroundings = {};
  /// Its CPU time, shared with all copies of this struct.
  std::shared_ptr<SpentTime> spent = std::make_shared<SpentTime>();
};

/// How a candidate's process failed.
enum class FailureKind {
  kSystem,       ///< A system call failed: it could not be started, or not be reached.
  kEnded,        ///< It ended before it had finished its task.
  kTimeUp,       ///< It timed out.
  kExtraOutput,  ///< More output than requested, or allowed.
  kBadReply,     ///< A malformed reply, or not a picture.
  kNotAsked,     ///< It timed out too often and was dropped.
  kCannotSay     ///< Not a failure: its input format cannot express the scene.
};

/// A program's output as a clause for error messages; empty without output.
std::string output_text(const std::string& output);

/// A failure of a candidate's process: "exited with 3", "was killed by signal 11 (Segmentation
/// fault)", "gave no reply within 10 s".
class ProcessFailure : public std::runtime_error {
 public:
  /// `why`: one line. `output`: an excerpt of the output, or empty; what() has both.
  ProcessFailure(FailureKind kind, const std::string& why, const std::string& output = {})
      : std::runtime_error(why + output_text(output)), kind_(kind), why_(why), output_(output) {}
  FailureKind kind() const { return kind_; }
  const std::string& why() const { return why_; }
  const std::string& output() const { return output_; }

 private:
  FailureKind kind_;
  std::string why_, output_;
};

/// The folders in which programs are searched.
inline constexpr std::array kProgramFolders = {"/usr/local/bin", "/usr/bin", "/bin"};
/// The same as a value of PATH.
std::string program_path();

/// The path of raycheck-jail or raycheck-worker.
std::filesystem::path helper(const std::string& name);

/// The folder of this program and its helpers (raycheck-jail, raycheck-worker).
std::filesystem::path program_folder();
/// The prefix of the installation; its libexec/raycheck contains the programs.
std::filesystem::path prefix();

/// The folder of the adapters for other languages: of the installation, or else of the sources.
std::filesystem::path adapters();

/// A user id without an account, for a process: made of this process's id and a counter, of 31 bits
/// if such ids work, else of 16.
std::uint64_t next_user();
/// To be called if large ids do not work.
void use_small_users();

/// The standard streams of a program.
struct Streams {
  int input, output, error;
};

/// Starts a program in its layers with these streams, in this folder, with a nearly empty
/// environment. Returns once all layers are in place: later failures are the program's. `user`: 0
/// without a separate user; `group`: its control group, or empty.
/// Errors: ProcessFailure (kSystem) if a layer fails; the program never starts with fewer layers.
pid_t launch(const Confined& confined, const std::filesystem::path& folder, std::uint64_t user,
             const std::filesystem::path& group, const Streams& streams);

/// System folders that programs need; of /etc only files of the loader, Java and OpenSSL (Node.js
/// does not start if the last exists but is unreadable). Some may not exist.
std::vector<std::filesystem::path> system_paths();

/// Folders that raycheck's helpers need besides the system's: the adapters, and the libraries of an
/// installed package, if readable.
std::vector<std::filesystem::path> own_paths();

/// Files in these folders that would reveal answers or questions: raycheck's programs, in all
/// program folders, and its rubrics.
std::vector<std::filesystem::path> hidden_paths();

}  // namespace raycheck::tools
