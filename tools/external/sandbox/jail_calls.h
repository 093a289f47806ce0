#pragma once

#include <sys/types.h>

namespace raycheck::tools {

/// Which processes a program can reach by their numbers.
enum class Reach {
  kOwn,       ///< Its own alone: they have a namespace of their own, or another user.
  kSchedule,  ///< All of its user, but signals reach its own alone.
  kSignal     ///< All of its user.
};

/// Forbids this process and what it starts, by seccomp: sockets; to look into other processes;
/// namespaces, mounts and modules; what outlives it (System V memory, message queues, keys). Where
/// it reaches more than its own: to change how others are scheduled and what they may use, and to
/// send signals to others than itself and its group. The judge is one of these, and each of its
/// threads has a number of its own, so that no list of numbers would do.
/// `judge`: raycheck itself, where it can be reached.
/// Domain: no process may gain privileges any more.
/// Errors: std::system_error.
void forbid_calls(Reach reach, pid_t judge);

}  // namespace raycheck::tools
