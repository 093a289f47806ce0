#include "tools/bench/bench_target.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <string_view>

namespace raycheck::tools {
namespace {

constexpr std::string_view kOption = "--target=";

}  // namespace

bool choose_target(int& argc, char** argv) {
  for (int k = 1; k < argc; ++k) {
    const std::string_view argument = argv[k];
    if (!argument.starts_with(kOption)) continue;
    std::copy(argv + k + 1, argv + argc + 1, argv + k);
    --argc;
    const std::string_view name = argument.substr(kOption.size());
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      if (name != hwy::TargetName(target)) continue;
      hwy::SetSupportedTargetsForTest(target);
      return true;
    }
    std::cerr << kOption << name << ": this machine has";
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      std::cerr << " " << hwy::TargetName(target);
    }
    std::cerr << "\n";
    return false;
  }
  return true;
}

}  // namespace raycheck::tools
