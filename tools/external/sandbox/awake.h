#pragma once

#include <poll.h>
#include <sched.h>

namespace raycheck::tools {

/// The number of polls for a reply, or for the next request, before the process sleeps. Waking up
/// takes longer than most answers.
inline constexpr int kLooksAwake = 30;

/// Whether there is a second processor, on which the other process can run.
inline bool has_other_processor() {
  cpu_set_t usable;
  return sched_getaffinity(0, sizeof usable, &usable) != 0 || CPU_COUNT(&usable) > 1;
}

/// Polls (poll(2)) for a short while, without sleeping. Returns 0 if nothing has happened.
inline int poll_awake(pollfd* streams, nfds_t count) {
  static const bool is_worth_it = has_other_processor();
  int ready = 0;
  for (int look = 0; is_worth_it && ready == 0 && look < kLooksAwake; ++look) {
    sched_yield();
    ready = poll(streams, count, 0);
  }
  return ready;
}

}  // namespace raycheck::tools
