#pragma once

#include <functional>

namespace raycheck::scene {

/// What interrupted work throws. It is no std::exception, so that nothing takes it for a failure of
/// a candidate or of an input: whoever has a part of an answer catches it and keeps that.
struct Interrupted {};

/// While it lives, poll() on this thread asks `interrupted`, which has to live as long. The one
/// made last is asked; it gives way to the one before when it ends.
class Interruptible {
 public:
  explicit Interruptible(const std::function<bool()>& interrupted);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  const std::function<bool()>* before_;
};

/// Throws Interrupted where the work of this thread is to end; does nothing where nobody said who
/// is to be asked. Whatever takes long calls it often, from deep inside.
void poll();

}  // namespace raycheck::scene
