#pragma once

#include <functional>
#include <string_view>

namespace raycheck::properties {

/// The caller's control over long work. It does not change answers; an interrupt ends the work
/// early, with the results so far.
struct RunControl {
  /// Called now and then, from any thread; true ends the work.
  std::function<bool()> interrupted = [] { return false; };
  /// Receives the progress now and then, from one thread at a time: "3 of 7 graded".
  std::function<void(std::string_view)> progress = [](std::string_view) {};
  /// Receives each long part once it is done, from one thread at a time: "3 of 7 graded: ada".
  std::function<void(std::string_view)> done = [](std::string_view) {};
  int threads = 1;
};

}  // namespace raycheck::properties
