#pragma once

// A value that is computed on demand. Internal to reference/.

#include <atomic>

namespace raycheck::reference {

/// Keeps the value that the first caller computes. `compute` must give the same value every time,
/// since threads that call get() while the first is still writing compute the value again instead
/// of waiting. Thread safety: get() and copying from an object may run in several threads at once.
template <class T>
class Kept {
 public:
  Kept() = default;
  Kept(const Kept& other) { *this = other; }
  Kept& operator=(const Kept& other) {
    if (this == &other) return *this;
    const bool is_ready = other.state_.load(std::memory_order_acquire) == State::kReady;
    if (is_ready) value_ = other.value_;
    state_.store(is_ready ? State::kReady : State::kEmpty, std::memory_order_release);
    return *this;
  }
  ~Kept() = default;

  template <class Compute>
  T get(Compute compute) const {
    if (state_.load(std::memory_order_acquire) == State::kReady) return value_;
    const T value = compute();
    State expected = State::kEmpty;
    if (state_.compare_exchange_strong(expected, State::kBeingWritten, std::memory_order_relaxed)) {
      value_ = value;
      state_.store(State::kReady, std::memory_order_release);
    }
    return value;
  }

 private:
  enum class State : unsigned char { kEmpty, kBeingWritten, kReady };
  mutable std::atomic<State> state_{State::kEmpty};
  mutable T value_;  ///< Read only after it is ready.
};

}  // namespace raycheck::reference
