#pragma once

#include <cstdint>
#include <string>

namespace raycheck::tools {

/// One of several workers, who do each unit of a campaign once between them.
struct Shard {
  std::int64_t number = 1;   ///< From 1 on,
  std::int64_t of = 1;       ///< of so many.
  std::string said_by = {};  ///< "shard 3/64", or the variable of a scheduler; empty: by nobody.

  bool has(std::int64_t unit) const { return unit % of == number - 1; }
};

/// "3/64", or "auto/64" for the number that a scheduler says; empty for what a scheduler says of
/// both, or the only shard where none does. Slurm's arrays, Kubernetes' indexed jobs, Bazel's test
/// shards and GitLab's parallel jobs say it by environment variables.
/// Errors: std::invalid_argument naming the option or the variable.
Shard chosen_shard(const std::string& text);

}  // namespace raycheck::tools
