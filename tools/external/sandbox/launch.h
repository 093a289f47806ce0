#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/external/sandbox/layers.h"
#include "tools/external/sandbox/spent_time.h"
#include "tools/external/sandbox/starting_folder.h"
#include "tools/external/sandbox/surroundings.h"

namespace raycheck::tools {

/// What those who set limits call them, to be said where one is met; empty: nothing is said.
struct LimitNames {
  std::string seconds = {}, file = {}, memory = {}, processes = {}, disk = {};
};

/// " (file_mib)": what those who set a limit call it, to be said behind it.
std::string called(const std::string& limit);

/// What one process, or a process and all that it starts, may use.
struct Limits {
  /// Of CPU time, from a request to the end of its reply, together; watch.h says what time those
  /// have who wait.
  double seconds = 10;
  std::uint64_t cpu_seconds = 600;
  /// In bytes: each of addresses, together of the machine's memory.
  std::uint64_t memory = std::uint64_t{4} << 30;
  std::uint64_t disk = std::uint64_t{1} << 30;   ///< Together, in bytes.
  std::uint64_t file = std::uint64_t{64} << 20;  ///< The largest file, in bytes.
  std::uint64_t files = 64;                      ///< Open at a time.
  std::uint64_t processes = 64;
  LimitNames names = {};
};

/// A program to run, what it may read besides the system, and how it is isolated.
struct Confined {
  std::vector<std::string> arguments;
  std::vector<std::filesystem::path> readable;
  Layers layers;
  Limits limits;
  /// What lies in its folder at the start: names and contents.
  std::vector<std::pair<std::string, std::string>> files = {};
  /// And besides; null: nothing.
  std::shared_ptr<const StartingFolder> start = {};
  /// Who is told where it fails for a cause outside it; null: nobody.
  std::shared_ptr<Surroundings> surroundings = {};
  /// Where its time is added up, together with that of its copies.
  std::shared_ptr<SpentTime> spent = std::make_shared<SpentTime>();
};

/// How a candidate's process failed.
enum class FailureKind {
  kSystem,    ///< The system refused something: it could not be started or asked.
  kEnded,     ///< It ended before it had done what it should.
  kTimeUp,    ///< No reply, or no end, in the time it has: to ask again costs as much.
  kSaidMore,  ///< More than it was asked, or may say.
  kBadReply,  ///< Its reply, or its picture, is none.
  kNotAsked   ///< It was silent too often to be asked again.
};

/// What went wrong with a candidate's process; in words "exited with 3", "was killed by signal 11
/// (Segmentation fault)", "gave no reply within 10 s".
class ProcessFailure : public std::runtime_error {
 public:
  ProcessFailure(FailureKind kind, const std::string& words)
      : std::runtime_error(words), kind_(kind) {}
  FailureKind kind() const { return kind_; }

 private:
  FailureKind kind_;
};

/// Where programs that are named without a folder are looked for.
inline constexpr std::string_view kProgramPath = "/usr/local/bin:/usr/bin:/bin";

/// raycheck-jail or raycheck-worker.
std::filesystem::path helper(const std::string& name);

/// The folder in which this program and its helpers (raycheck-jail, raycheck-worker) lie.
std::filesystem::path program_folder();
/// Of programs that are installed, which lie below libexec/raycheck, what that lies below.
std::filesystem::path prefix();

/// Where the adapters of other languages are: beside an installed program, or in the sources that
/// it was built of.
std::filesystem::path adapters();

/// A user for each process, which no account has: of this process and a number where such large ids
/// exist, else one of 16 bits.
std::uint64_t next_user();
/// Large ids do not work here.
void use_small_users();

/// What a program reads and writes: descriptors.
struct Streams {
  int input, output, error;
};

/// Starts a program in its layers with these streams, in this folder, with next to no environment;
/// returns when all layers are in place, so that what it does from then on is its own fault.
/// `user`: 0 where it has none of its own; `group`: its control group, empty where it has none.
/// Errors: ProcessFailure (kSystem) where it could not be
/// started in all of them; it is never started in fewer.
pid_t launch(const Confined& confined, const std::filesystem::path& folder, std::uint64_t user,
             const std::filesystem::path& group, const Streams& streams);

}  // namespace raycheck::tools
