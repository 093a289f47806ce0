#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/shards/shard.h"

namespace raycheck::tools {

/// What all units of a campaign have in common.
struct CampaignIdentity {
  std::string command;                       ///< "properties"
  std::vector<std::string> arguments;        ///< Those that its result depends on.
  std::string version;                       ///< Of raycheck, and of the shape of units.
  std::map<std::string, std::string> files;  ///< That the arguments name, and their digests.

  /// Of all that.
  std::string digest() const;

  /// "raycheck properties --cases 2000"
  std::string text() const;
};

/// The file of a folder of units that tells whose they are.
inline constexpr const char* kCampaignFile = "campaign.json";
/// Where the units are in a folder that has other things.
inline constexpr const char* kUnitsInside = ".raycheck/units";
/// The campaign of a folder, or of that inside.
/// Errors: std::invalid_argument naming the folder or the file.
CampaignIdentity campaign_in(const std::filesystem::path& folder);

/// The units of a campaign that folders hold: each a file, which appears completely or not at all
/// and states the digest of what is in it. Thread-safe but for open().
class Units {
 public:
  /// Does what is missing of a shard, and keeps it in a folder, which open() makes.
  Units(CampaignIdentity campaign, std::filesystem::path folder, Shard shard);
  /// Merges what folders hold. Errors: std::invalid_argument naming the one of another campaign.
  Units(CampaignIdentity campaign, std::vector<std::filesystem::path> folders);

  /// The units that this shard does, or all, in order. `count`: how many the campaign has. Errors:
  /// std::invalid_argument naming a folder or a file of another campaign, or a missing unit, if to
  /// be merged.
  std::vector<std::int64_t> open(std::int64_t count);
  /// Whether all units are seen, so that there is something to report.
  bool are_all() const { return is_merged_ || shard_.of == 1; }
  const Shard& shard() const { return shard_; }
  const CampaignIdentity& campaign() const { return campaign_; }

  /// What a unit's file has, or empty if it is missing or, where it can be done again, damaged.
  /// Errors, to be merged: std::invalid_argument naming the file that is damaged, or two that
  /// contradict each other.
  std::optional<std::string> read(std::int64_t unit) const;
  /// Throws std::invalid_argument that names the file of a unit that was read.
  [[noreturn]] void refuse(std::int64_t unit, const std::string& why) const;
  /// Errors: std::runtime_error.
  void write(std::int64_t unit, const std::string& result) const;

 private:
  void make_folder() const;
  std::string name_of(std::int64_t unit) const;
  std::string contents(const std::filesystem::path& file, std::int64_t unit) const;
  [[noreturn]] void refuse_missing(std::int64_t count) const;

  CampaignIdentity campaign_;
  std::string digest_;  ///< Its own.
  std::vector<std::filesystem::path> folders_;
  Shard shard_;
  bool is_merged_;
  /// Of each unit that is there.
  std::map<std::int64_t, std::vector<std::filesystem::path>> files_;
};

}  // namespace raycheck::tools
