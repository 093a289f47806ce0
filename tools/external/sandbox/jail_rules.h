#pragma once

#include <sys/types.h>

#include <filesystem>
#include <vector>

namespace raycheck::tools {

/// Which processes a program can reach by their ids.
enum class Reach {
  kOwn,       ///< Only its own processes: it has a separate namespace or user.
  kSchedule,  ///< All processes of its user, but it can send signals only to its own.
  kSignal     ///< All processes of its user.
};

/// Forbids this process and its descendants, by seccomp: sockets; access to other processes;
/// namespaces, mounts and modules; objects that outlive the process (System V memory, message
/// queues, keys). If it can reach processes that are not its own, it must not change their
/// scheduling or limits, nor send signals outside itself and its group. (A list of forbidden ids is
/// not enough, because each of raycheck's threads has an id, too.) `judge`: raycheck's process id
/// if it can be reached, otherwise 0. Domain: PR_SET_NO_NEW_PRIVS is set. Errors:
/// std::system_error.
void forbid_calls(Reach reach, pid_t judge);

/// The files that a program may access, as absolute paths; a folder includes its contents.
struct FileRights {
  std::vector<std::filesystem::path> reads;   ///< To read and execute; missing ones are ignored.
  std::vector<std::filesystem::path> hidden;  ///< Exceptions within `reads`.
  std::vector<std::filesystem::path> writes;  ///< Full access; these must exist.
  bool empty() const { return reads.empty() && writes.empty(); }
};

/// Restricts this process and its descendants to these files by Landlock, and forbids TCP if the
/// kernel can (from 6.7 on). Returns whether signals are restricted, too (from 6.12 on). Errors:
/// std::system_error if the kernel has no Landlock.
bool keep_to_files(const FileRights& rights);

}  // namespace raycheck::tools
