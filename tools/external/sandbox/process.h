#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/external/sandbox/control_group.h"
#include "tools/external/sandbox/descriptor.h"
#include "tools/external/sandbox/launch.h"
#include "tools/external/sandbox/private_folder.h"
#include "tools/external/sandbox/watch.h"

namespace raycheck::tools {

/// The beginning and the end of what a program says, however much that is.
class KeptText {
 public:
  void append(std::string_view more);
  bool empty() const { return begin_.empty(); }
  /// The beginning and the end, with a line between them that says how much is missing.
  std::string text() const;
  /// Its first and last few lines, and how much is left out between them; without what a
  /// terminal would obey.
  std::string excerpt() const;

 private:
  std::string begin_, end_;
  std::size_t lines_ = 0;    ///< Line ends in all of the output.
  std::size_t dropped_ = 0;  ///< Bytes.
};

/// The beginning of a text, at most this many bytes, not cut within a multi-byte character.
std::string_view cut_to(std::string_view text, std::size_t most);

/// The last line of a program's output, as a clause; empty if there is none.
std::string last_line_text(const KeptText& said);

/// Which limit a program that failed says that it met, as a clause; empty if it names no limit.
std::string limit_text(const KeptText& said, const Limits& limits);

/// A process that is talked to through pipes, in a folder of its own. When it ends, so does
/// everything that it started.
/// Errors: ProcessFailure, also where it cannot be started; afterwards it is dead.
class Process {
 public:
  explicit Process(const Confined& confined);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Sends a request and returns the answer, up to and including the first line for which `is_last`
  /// holds. Answers longer than `most_bytes` are failures.
  std::string exchange(std::string_view request,
                       const std::function<bool(std::string_view line)>& is_last,
                       std::size_t most_bytes);
  /// What had arrived of an answer that failed.
  const std::string& unfinished() const { return answer_; }
  /// Limits what is exchanged from now on to this many seconds of CPU time.
  void allow(double seconds) { confined_.limits.seconds = seconds; }
  /// Closes its input and waits until it ends; returns its exit code.
  int finish();
  /// What it wrote on standard error and, after finish(), on standard output: the beginning and the
  /// end of each.
  const KeptText& said() const { return said_; }
  const KeptText& printed() const { return printed_; }
  /// First and last lines of what it said, or else of what it printed.
  std::string excerpt() const;
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  [[noreturn]] void fail(FailureKind kind, const std::string& words);
  [[noreturn]] void fail_with(int status);
  [[noreturn]] void fail_ended();
  void blame(FailureKind kind, const std::string& words) const;
  void charge();
  void look(const char* doing);
  std::string_view heard_on(Descriptor& stream);
  void listen(Descriptor& stream, KeptText& to);
  bool has_neighbours() const;
  bool has_ended(int& status);
  bool kill_all();

  PrivateFolder folder_;
  Confined confined_;
  std::optional<ControlGroup> group_;
  std::uint64_t user_ = 0;
  pid_t pid_ = -1;
  std::optional<Watch> watch_;
  Descriptor input_, output_, error_;
  std::vector<char> buffer_ = std::vector<char>(65536);
  KeptText said_, printed_;
  std::string answer_;
};

}  // namespace raycheck::tools
