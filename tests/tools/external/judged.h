#ifndef RAYCHECK_TESTS_TOOLS_EXTERNAL_JUDGED_H_
#define RAYCHECK_TESTS_TOOLS_EXTERNAL_JUDGED_H_

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/tools/program.h"

namespace raycheck::tests {

/// What `check` says of someone else's candidate on a scene.
inline Outcome check(const std::string& scene, const std::string& candidate,
                     const std::string& more = "") {
  return run("check " + scene + " --format json " + more + " --candidate '" + candidate + "'");
}

inline nlohmann::json judged(const std::string& scene, const std::string& candidate,
                             const std::string& more = "") {
  const Outcome outcome = check(scene, candidate, more);
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1)
      << candidate << ": " << outcome.exit_code << "\n"
      << outcome.err;
  if (outcome.out.empty()) return {};
  return nlohmann::json::parse(outcome.out)["candidates"][0];
}

}  // namespace raycheck::tests

#endif  // RAYCHECK_TESTS_TOOLS_EXTERNAL_JUDGED_H_
