#pragma once

#include <functional>
#include <string_view>

namespace raycheck::properties {

/// How long work is run, by whoever asks for it: nothing here changes an answer, but an interrupt
/// ends the work early, with what it has.
struct RunControl {
  /// Asked now and then, from any thread; true ends the work.
  std::function<bool()> interrupted = [] { return false; };
  /// Told now and then, by one thread at a time, how far the work has come: "3 of 7 graded".
  std::function<void(std::string_view)> progress = [](std::string_view) {};
  /// Told of each part that takes long once it is done, by one thread at a time: "3 of 7 graded:
  /// ada".
  std::function<void(std::string_view)> done = [](std::string_view) {};
  int threads = 1;
};

}  // namespace raycheck::properties
