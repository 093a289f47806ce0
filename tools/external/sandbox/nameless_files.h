#pragma once

#include <cstdint>
#include <vector>

#include "tools/external/sandbox/process_tree.h"

namespace raycheck::tools {

/// What files take that no folder has any more, or never had: removed ones, memfd_create(), shared
/// memory. In bytes.
struct NamelessFiles {
  std::uint64_t in_memory = 0, on_disk = 0;
};

/// Of those that processes have open or mapped, each once. Where the system does not show how much
/// of one there is, what is mapped of it counts.
NamelessFiles nameless_files(const std::vector<ProcessState>& processes);

}  // namespace raycheck::tools
