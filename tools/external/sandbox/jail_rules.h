#pragma once

#include <sys/types.h>

#include <filesystem>
#include <vector>

namespace raycheck::tools {

/// Which processes a program can reach by their ids.
enum class Reach {
  kOwn,       ///< Only its own: they have a separate namespace, or user.
  kSchedule,  ///< All of its user, but signals reach only its own.
  kSignal     ///< All of its user.
};

/// Forbids this process and what it starts, by seccomp: sockets; to look into other processes;
/// namespaces, mounts and modules; what outlives it (System V memory, message queues, keys). Where
/// it reaches more than its own: to change how others are scheduled and what they may use, and to
/// send signals to others than itself and its group. The judge is one of these, and each of its
/// threads has an id of its own, so that no list of ids would do.
/// `judge`: raycheck itself, where it can be reached.
/// Domain: no process may gain privileges any more.
/// Errors: std::system_error.
void forbid_calls(Reach reach, pid_t judge);

/// What a program may do with files, by absolute paths; folders include all that lies in them.
struct FileRights {
  std::vector<std::filesystem::path> reads;   ///< Reads and runs; missing ones are ignored.
  std::vector<std::filesystem::path> hidden;  ///< Parts of `reads` that it may not read.
  std::vector<std::filesystem::path> writes;  ///< Full access; these must exist.
  bool empty() const { return reads.empty() && writes.empty(); }
};

/// Restricts this process and its descendants to these files by Landlock, and denies TCP if the
/// kernel can (6.7). Returns whether signals are restricted, too (6.12).
/// Errors: std::system_error if the kernel has no Landlock.
bool keep_to_files(const FileRights& rights);

}  // namespace raycheck::tools
