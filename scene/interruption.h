#pragma once

#include <functional>

namespace raycheck::scene {

/// Thrown by interrupted work. Not a std::exception, so that it is never mistaken for a failure of
/// a candidate or an input: code that has a part of an answer catches it and keeps that part.
struct Interrupted {};

/// While it lives, poll() on this thread calls `interrupted`, which must outlive it. If they nest,
/// the innermost one is called.
class Interruptible {
 public:
  explicit Interruptible(const std::function<bool()>& interrupted);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  const std::function<bool()>* before_;
};

/// Throws Interrupted if this thread's work is to end; does nothing if no Interruptible lives. Long
/// work calls it often, from its inner loops.
void poll();

}  // namespace raycheck::scene
