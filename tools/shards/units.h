#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

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

/// Identifies a campaign; the same for all of its units.
struct CampaignIdentity {
  std::string command;                 ///< "properties"
  std::vector<std::string> arguments;  ///< The arguments on which the result depends.
  std::string version;                 ///< The versions of raycheck and of the unit format.
  /// The files that the arguments name, and their digests.
  std::map<std::string, std::string> files;

  /// A digest of all members.
  std::string digest() const;

  /// "raycheck properties --cases 2000"
  std::string text() const;
};

/// The file that identifies the campaign, in a folder of units.
inline constexpr const char* kCampaignFile = "campaign.json";
/// The subfolder of units in a folder that also has other files.
inline constexpr const char* kUnitsInside = ".raycheck/units";
/// The campaign of a folder of units, or of its subfolder kUnitsInside. Errors:
/// std::invalid_argument naming the folder or the file.
CampaignIdentity campaign_in(const std::filesystem::path& folder);

/// The units of a campaign in folders. Each unit is a file that appears completely or not at all
/// and contains a digest. Thread-safe except for open().
class Units {
 public:
  /// For computing the missing units of a shard; the results are written to a folder, which open()
  /// makes.
  Units(CampaignIdentity campaign, std::filesystem::path folder, Shard shard);
  /// For merging the units of folders.
  /// Errors: std::invalid_argument naming a folder of another campaign.
  Units(CampaignIdentity campaign, std::vector<std::filesystem::path> folders);

  /// The units of this shard in order, or all units when merging. `count`: the campaign's number of
  /// units.
  /// Errors: std::invalid_argument naming a folder or file of another campaign, or, when merging, a
  /// missing unit.
  std::vector<std::int64_t> open(std::int64_t count);
  /// Whether this run has all units of the campaign, so that it can report.
  bool are_all() const { return is_merged_ || shard_.of == 1; }
  const Shard& shard() const { return shard_; }
  const CampaignIdentity& campaign() const { return campaign_; }

  /// The contents of a unit's file; empty if it is missing or damaged. When merging, a damaged
  /// file, or two files that contradict each other, is an error: std::invalid_argument naming them.
  std::optional<std::string> read(std::int64_t unit) const;
  /// Throws std::invalid_argument naming the file of a unit that was read.
  [[noreturn]] void refuse(std::int64_t unit, const std::string& why) const;
  /// Errors: std::runtime_error.
  void write(std::int64_t unit, const std::string& result) const;

 private:
  void make_folder() const;
  std::string name_of(std::int64_t unit) const;
  std::string contents(const std::filesystem::path& file, std::int64_t unit) const;
  [[noreturn]] void refuse_missing(std::int64_t count) const;

  CampaignIdentity campaign_;
  std::string digest_;  ///< The campaign's digest.
  std::vector<std::filesystem::path> folders_;
  Shard shard_;
  bool is_merged_;
  /// The files of each unit that exists.
  std::map<std::int64_t, std::vector<std::filesystem::path>> files_;
};

}  // namespace raycheck::tools
