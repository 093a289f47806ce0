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

/// The layers of a candidate's isolation, beyond what it always has: its own session, folder and
/// environment, closed descriptors and limits on its resources.
struct Layers {
  bool own_user = false;    ///< It runs as a user that owns nothing; raycheck is root.
  bool seccomp = false;     ///< No sockets, no access to other processes.
  bool landlock = false;    ///< Only the files that it needs; if bubblewrap is missing.
  bool bubblewrap = false;  ///< Its own namespaces; only the files that it needs.
  /// A control group of its own, in which all processes are counted, killed and, where the kernel
  /// can do so, limited together.
  bool control_group = false, group_memory = false, group_processes = false;
  /// "own user, seccomp, bubblewrap, control group (memory, processes)", or "limits only"
  std::string text() const;
};

/// A layer that a machine should have but that does not work.
struct MissingLayer {
  std::string name;
  std::string why;  ///< The error message of what failed.
};

/// The layers that work here, found once by trying, and those that do not.
struct LayersHere {
  Layers layers;
  std::vector<MissingLayer> missing;
  /// Why there is no control group (most machines let nobody make one); empty: there is one, or
  /// none was asked for.
  std::string no_control_group = {};
};
const LayersHere& layers_here();

/// Which layers to use.
enum class Sandbox {
  kRequire,    ///< All that should be there: a user of its own if root, seccomp, bubblewrap.
  kAvailable,  ///< Those that work here.
  kNone        ///< Only limits.
};
/// Errors: std::invalid_argument if `kRequire` needs a layer that does not work here, naming it,
/// why, and what does; and if the folder for temporary files is unusable.
LayersHere chosen_layers(Sandbox sandbox);

/// A candidate's total CPU time, in whole nanoseconds: what was spent since some time does not
/// depend on how much was before. A stored answer counts the time it took then, so that what is
/// asked does not depend on what is stored. Shared by all its processes and threads.
class SpentTime {
 public:
  using Time = std::chrono::nanoseconds;
  /// `seconds`: of what is not a time (it was stored), at most kMostSeconds are added.
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

/// Whether an error comes from the state of the machine (no room, too many open files) and not from
/// what was asked for, so that it may not occur another time.
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

/// Outside causes for which a candidate failed; if there is one, its answers do not count. Shared
/// by all its processes.
class Surroundings {
 public:
  /// `alone`: no other candidate runs beside it, so that whatever happens to it is its own fault,
  /// as long as the machine has space.
  explicit Surroundings(bool alone) : alone_(alone) {}
  bool alone() const { return alone_; }
  /// The first cause is kept.
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

/// Why an implementation cannot be judged at all.
struct Refusal {
  std::string why;   ///< One line.
  std::string said;  ///< What a compiler said about it, or empty.
};

/// The names of limits for those who set them, named when one is met; empty: not named.
struct LimitNames {
  std::string seconds = {}, file = {}, memory = {}, processes = {}, disk = {};
};

/// The name of a limit in parentheses, to follow its mention: " (file_mib)".
std::string called(const std::string& limit);

/// What one process, or a process and all that it starts, may use.
struct Limits {
  /// Of CPU time, from a request to the end of its reply, together; watch.h says what of
  /// waiting counts.
  double seconds = 10;
  std::uint64_t cpu_seconds = 600;
  /// In bytes: of address space for each, of physical memory for all together.
  std::uint64_t memory = std::uint64_t{4} << 30;
  std::uint64_t disk = std::uint64_t{1} << 30;   ///< In total, in bytes.
  std::uint64_t file = std::uint64_t{64} << 20;  ///< The largest file, in bytes.
  std::uint64_t files = 256;                     ///< Open at a time.
  std::uint64_t processes = 64;
  LimitNames names = {};
};

/// A program to run, what it may read besides the system, and how it is isolated.
struct Confined {
  std::vector<std::string> arguments;
  std::vector<std::filesystem::path> readable;
  Layers layers;
  Limits limits;
  /// The files in its folder at the start.
  std::vector<StartingFolder::File> files = {};
  /// Further contents of it; null: none.
  std::shared_ptr<const StartingFolder> start = {};
  /// Is told about failures with a cause outside the candidate; null: nobody is.
  std::shared_ptr<Surroundings> surroundings = {};
  /// Where its time is added up, with that of its copies.
  std::shared_ptr<SpentTime> spent = std::make_shared<SpentTime>();
};

/// How a candidate's process failed.
enum class FailureKind {
  kSystem,    ///< The system refused something: it could not be started, or not be reached.
  kEnded,     ///< It ended before it had finished its task.
  kTimeUp,    ///< No reply, or no end, in time: asking again would cost as much.
  kSaidMore,  ///< More output than asked for, or allowed.
  kBadReply,  ///< What it sent is not a reply, or not a picture.
  kNotAsked,  ///< It was silent too often to be asked again.
  kCannotSay  ///< None: its form of input cannot express the question.
};

/// What a program said, as a clause after why it failed; empty if it said nothing.
std::string said_text(const std::string& said);

/// What went wrong with a candidate's process; in words "exited with 3", "was killed by signal 11
/// (Segmentation fault)", "gave no reply within 10 s".
class ProcessFailure : public std::runtime_error {
 public:
  /// `why`: one line. `said`: an excerpt of the output, or empty; what() has both.
  ProcessFailure(FailureKind kind, const std::string& why, const std::string& said = {})
      : std::runtime_error(why + said_text(said)), kind_(kind), why_(why), said_(said) {}
  FailureKind kind() const { return kind_; }
  const std::string& why() const { return why_; }
  const std::string& said() const { return said_; }

 private:
  FailureKind kind_;
  std::string why_, said_;
};

/// Where programs named without a folder are searched.
inline constexpr std::array kProgramFolders = {"/usr/local/bin", "/usr/bin", "/bin"};
/// The same as a PATH.
std::string program_path();

/// raycheck-jail or raycheck-worker.
std::filesystem::path helper(const std::string& name);

/// The folder of this program and its helpers (raycheck-jail, raycheck-worker).
std::filesystem::path program_folder();
/// The prefix of an installed program, whose libexec/raycheck holds the programs.
std::filesystem::path prefix();

/// The folder of the adapters for other languages: beside an installed program, or in the sources
/// it was built from.
std::filesystem::path adapters();

/// A user id for each process that belongs to no account: made of this process's id and a counter
/// where such large ids exist, else of 16 bits.
std::uint64_t next_user();
/// Large ids do not work here.
void use_small_users();

/// The descriptors that a program reads and writes.
struct Streams {
  int input, output, error;
};

/// Starts a program in its layers with these streams, in this folder, with a nearly empty
/// environment; returns once all layers are in place, so that what it does from then on is its own
/// fault. `user`: 0 if it has no separate user; `group`: its control group, or empty.
/// Errors: ProcessFailure (kSystem) if it could not be started in all layers; it is never started
///         in fewer.
pid_t launch(const Confined& confined, const std::filesystem::path& folder, std::uint64_t user,
             const std::filesystem::path& group, const Streams& streams);

/// The parts of the system that programs need; of /etc only files of the loader, Java and OpenSSL
/// (Node.js does not start where the last exists but is closed). Some may not exist.
std::vector<std::filesystem::path> system_paths();

/// What raycheck's helpers need besides the system: the adapters, and a package's libraries, if it
/// has some that they may read.
std::vector<std::filesystem::path> own_paths();

/// What in all these gives away right answers or questions: raycheck itself, wherever programs are
/// looked for, and the rubrics that come with it.
std::vector<std::filesystem::path> hidden_paths();

}  // namespace raycheck::tools
