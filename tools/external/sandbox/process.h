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

/// Keeps the beginning and the end of a program's output, which may have any length, without the
/// lines in which Java reports raycheck's own options.
class KeptText {
 public:
  void append(std::string_view more);
  bool empty() const { return text().empty(); }
  /// The beginning and the end, with a line between them that counts the missing bytes.
  std::string text() const;
  /// Its first and last lines, and the number of lines between them; without terminal control
  /// codes.
  std::string excerpt() const;

 private:
  std::string begin_, end_;
  std::size_t lines_ = 0;    ///< The number of line ends in the whole output.
  std::size_t dropped_ = 0;  ///< The number of bytes dropped.
};

/// The beginning of a text: at most this many bytes, not cut within a multi-byte character.
std::string_view cut_to(std::string_view text, std::size_t most);

/// The last line of a program's output that gives a reason, as a clause; empty if there is no
/// output.
std::string last_line_text(const KeptText& error_output);

/// The limit that a failed program met, or that it needs a display, recognised from its output, as
/// a clause; empty if neither is recognised.
std::string limit_text(const KeptText& error_output, const Limits& limits);

/// A sandboxed process in a private folder, with pipes to its standard streams. When it ends, its
/// descendants are killed. Errors: ProcessFailure, also if it cannot be started. After a failure
/// the process is dead.
class Process {
 public:
  explicit Process(const Confined& confined);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Sends a request and returns the answer, up to the first line for which `is_last` is true,
  /// inclusive. An answer longer than `most_bytes` is a failure.
  std::string exchange(std::string_view request,
                       const std::function<bool(std::string_view line)>& is_last,
                       std::size_t most_bytes);
  /// The incomplete answer of a failed exchange.
  const std::string& unfinished() const { return answer_; }
  /// The waiting time of the last exchange over its time limit (Watch::limits_waited).
  double limits_waited() const { return watch_->limits_waited(); }
  /// Sets the limit of CPU time, in seconds, for each later exchange.
  void allow(double seconds) { confined_.limits.seconds = seconds; }
  /// Closes its input and waits until it ends; returns its exit code.
  int finish();
  /// The beginning and the end of its standard error; printed(): of its standard output, after
  /// finish().
  const KeptText& error_output() const { return error_output_; }
  const KeptText& printed() const { return printed_; }
  /// The first and last lines of its standard error or, if that is empty, of its standard output.
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
  KeptText error_output_, printed_;
  std::string answer_;
};

}  // namespace raycheck::tools
