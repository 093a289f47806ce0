#pragma once

#include <sys/wait.h>

#include "tests/testing.h"

namespace raycheck::tests {

struct Ended {
  int code = -1;
  std::string text;  ///< Its standard output and standard error.
};

inline Ended shell(const std::string& command) {
  FILE* const pipe = popen(("( " + command + " ) 2>&1").c_str(), "r");
  Ended ended;
  std::array<char, 4096> buffer{};
  for (std::size_t count; (count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    ended.text.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

/// Builds an example of an installed tree in a folder, by its CMakeLists.txt.
inline Ended build_example(const std::filesystem::path& prefix, const std::string& name,
                           const std::filesystem::path& to, const std::string& options = "") {
  std::filesystem::remove_all(to);
  return shell("cmake -S " + (prefix / "share/raycheck/examples" / name).string() + " -B " +
               to.string() + " -DCMAKE_PREFIX_PATH=" + prefix.string() + " " + options +
               " && cmake --build " + to.string());
}

}  // namespace raycheck::tests
