#ifndef RAYCHECK_TOOLS_EXTERNAL_SANDBOX_LAUNCH_H_
#define RAYCHECK_TOOLS_EXTERNAL_SANDBOX_LAUNCH_H_

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/external/sandbox/layers.h"

namespace raycheck::tools {

/// What one process may use.
struct Limits {
  double seconds = 10;  ///< Wall time, from a request to the end of its reply.
  std::uint64_t cpu_seconds = 600;
  std::uint64_t memory = std::uint64_t{4} << 30;  ///< Of addresses, in bytes.
  std::uint64_t file = std::uint64_t{64} << 20;   ///< The largest file, in bytes.
  std::uint64_t files = 64;                       ///< Open at a time.
  std::uint64_t processes = 64;
};

/// A program to run, what it may read besides the system, and how it is isolated.
struct Confined {
  std::vector<std::string> arguments;
  std::vector<std::filesystem::path> readable;
  Layers layers;
  Limits limits;
  /// What lies in its folder at the start: names and contents.
  std::vector<std::pair<std::string, std::string>> files = {};
};

/// How a candidate's process failed.
enum class FailureKind {
  kSystem,    ///< The system refused something: it could not be started or asked.
  kEnded,     ///< It ended before it had done what it should.
  kTimeUp,    ///< No reply, or no end, in the time it has: to ask again costs as much.
  kSaidMore,  ///< More than it was asked, or may say.
  kBadReply   ///< Its reply, or its picture, is none.
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

/// The folder in which raycheck and its helpers (raycheck-jail, raycheck-worker) lie.
std::filesystem::path program_folder();

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

/// Starts a program in its layers with these streams, in this folder, with next to no environment.
/// `user`: 0 where it has none of its own. Errors: ProcessFailure.
pid_t launch(const Confined& confined, const std::filesystem::path& folder, std::uint64_t user,
             const Streams& streams);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_EXTERNAL_SANDBOX_LAUNCH_H_
