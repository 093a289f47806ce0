#pragma once

#include <sys/types.h>

#include <filesystem>
#include <vector>

namespace raycheck::tools {

/// Which processes a program can reach by their ids.
enum class Reach {
  kOwn,       ///< Only its own: it has a separate namespace, or user.
  kSchedule,  ///< All processes of its user, but it can signal only its own.
  kSignal     ///< All processes of its user.
};

/// Forbids for this process and its descendants, by seccomp: sockets; access to other processes;
/// namespaces, mounts and modules; objects that outlive it (System V memory, message queues, keys).
/// With a reach beyond its own processes also: to change the scheduling and the limits of others,
/// and to send signals outside itself and its group. (A list of forbidden ids would not do:
/// raycheck is one of the others, and each of its threads has an id.) `judge`: raycheck's process
/// id, if it can be reached; else 0. Domain: PR_SET_NO_NEW_PRIVS is set. Errors: std::system_error.
void forbid_calls(Reach reach, pid_t judge);

/// File access of a program, by absolute paths; folders include their contents.
struct FileRights {
  std::vector<std::filesystem::path> reads;   ///< To read and execute; missing ones are ignored.
  std::vector<std::filesystem::path> hidden;  ///< Exceptions within `reads`.
  std::vector<std::filesystem::path> writes;  ///< Full access; these must exist.
  bool empty() const { return reads.empty() && writes.empty(); }
};

/// Restricts this process and its descendants to these files by Landlock, and forbids TCP if the
/// kernel supports that (6.7). Returns whether signals are restricted, too (6.12). Errors:
/// std::system_error if the kernel has no Landlock.
bool keep_to_files(const FileRights& rights);

}  // namespace raycheck::tools
