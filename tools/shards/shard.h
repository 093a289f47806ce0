#pragma once

#include <cstdint>
#include <string>

namespace raycheck::tools {

/// A worker's share of a campaign. All shards together run each unit once.
struct Shard {
  std::int64_t number = 1;  ///< The shard's number, from 1.
  std::int64_t of = 1;      ///< The number of shards.
  /// "shard 3/64", or a scheduler's variable; empty if nothing chose the shard.
  std::string said_by = {};

  bool has(std::int64_t unit) const { return unit % of == number - 1; }
};

/// Parses a shard, "3/64". For "auto/64", a scheduler sets the number. For an empty text, a
/// scheduler sets both numbers, or there is only one shard. Slurm's arrays, Kubernetes' indexed
/// jobs, Bazel's test shards and GitLab's parallel jobs set environment variables for this. Errors:
/// std::invalid_argument naming the option or the variable.
Shard chosen_shard(const std::string& text);

}  // namespace raycheck::tools
