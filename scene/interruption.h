#pragma once

#include <functional>

namespace raycheck::scene {

/// Thrown by interrupted work. It is not a std::exception, so that it is never mistaken for a
/// failure of a candidate or an input. Code that has a part of an answer catches it and keeps the
/// part.
struct Interrupted {};

/// While an object lives, poll() on this thread calls its `interrupted`, which must live as long.
/// If several objects live, the function of the newest is called.
class Interruptible {
 public:
  explicit Interruptible(const std::function<bool()>& interrupted);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  const std::function<bool()>* before_;
};

/// Throws Interrupted if this thread's work must end; does nothing if no Interruptible lives. Long
/// work calls poll() often, from its inner loops.
void poll();

}  // namespace raycheck::scene
