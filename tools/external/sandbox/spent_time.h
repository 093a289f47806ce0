#pragma once

#include <atomic>

namespace raycheck::tools {

/// How long a candidate has taken in all, in seconds of CPU time. An answer of an earlier run takes
/// what it took then, so that what is asked does not depend on what is known. One for all its
/// processes and threads.
class SpentTime {
 public:
  void add(double seconds) { seconds_.fetch_add(seconds); }
  double seconds() const { return seconds_.load(); }

 private:
  std::atomic<double> seconds_{0};
};

}  // namespace raycheck::tools
