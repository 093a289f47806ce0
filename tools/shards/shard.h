#pragma once

#include <cstdint>
#include <string>

namespace raycheck::tools {

/// A worker's share of a campaign: the shards together do each unit once.
struct Shard {
  std::int64_t number = 1;   ///< The shard's number, from 1.
  std::int64_t of = 1;       ///< The number of shards.
  std::string said_by = {};  ///< "shard 3/64", or a scheduler's variable; empty: not set.

  bool has(std::int64_t unit) const { return unit % of == number - 1; }
};

/// The shard "3/64"; for "auto/64" the number comes from a scheduler; for an empty text both
/// numbers come from a scheduler, or there is only one shard. Slurm's arrays, Kubernetes' indexed
/// jobs, Bazel's test shards and GitLab's parallel jobs set environment variables for this.
/// Errors: std::invalid_argument naming the option or the variable.
Shard chosen_shard(const std::string& text);

}  // namespace raycheck::tools
