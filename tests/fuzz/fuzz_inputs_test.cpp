// Runs the fuzz targets, in an ordinary build, on the fuzzers' seeds and on inputs on which a
// target once failed.

#include "tests/fuzz/targets.h"
#include "tests/testing.h"

namespace raycheck::tests {
namespace {

namespace fs = std::filesystem;

/// Runs a target on every file of a folder, at any depth.
int run_on(const FuzzTarget& target, const fs::path& folder) {
  int files = 0;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    EXPECT_NO_THROW(target.run(contents(entry.path()))) << target.name << ": " << entry.path();
    ++files;
  }
  return files;
}

TEST(HostileInputs, of_fuzzers_are_read_or_refused) {
  const fs::path root = RAYCHECK_SOURCE_DIR;
  int seeds = 0, failed_once = 0;
  for (const FuzzTarget& target : kFuzzTargets) {
    seeds += run_on(target, root / "tests/fuzz/seeds");
    seeds += run_on(target, root / "scene/examples");
    failed_once += run_on(target, root / "tests/fuzz/regressions" / target.name);
  }
  EXPECT_GT(seeds, 100);
  EXPECT_GT(failed_once, 0);
}

}  // namespace
}  // namespace raycheck::tests
