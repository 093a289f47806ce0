#pragma once

#include <mutex>
#include <optional>

namespace raycheck::scene {

/// A large value, computed by the first thread that needs it. Other threads wait.
template <class T>
class OnDemand {
 public:
  template <class Compute>
  const T& get(Compute compute) const {
    std::call_once(once_, [&] { value_.emplace(compute()); });
    return *value_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::optional<T> value_;
};

}  // namespace raycheck::scene
