#include "tools/shards/units.h"

#include <fmt/core.h>

#include <charconv>
#include <chrono>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "tools/report/digest.h"
#include "tools/report/json.h"
#include "tools/report/output_file.h"
#include "tools/report/packed.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kUnitEnding = ".unit";
/// The limit on the size of a file in a folder of units.
constexpr std::uintmax_t kMostUnitBytes = std::uintmax_t{256} << 20;

std::string bytes_of(const fs::path& file) {
  if (!fs::is_regular_file(file)) {
    throw std::invalid_argument(fmt::format("{}: is not a file", file.string()));
  }
  if (fs::file_size(file) > kMostUnitBytes) {
    throw std::invalid_argument(fmt::format("{}: is larger than {} MiB, the limit for a unit",
                                            file.string(), kMostUnitBytes >> 20));
  }
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw std::invalid_argument(fmt::format("{}: cannot be read", file.string()));
  return bytes;
}

/// The digest in a unit's file, of the packed result and its size.
std::string digest_of(const std::string& campaign, std::int64_t unit, std::size_t size,
                      const std::string& result) {
  return digest({campaign, std::to_string(unit), std::to_string(size), result});
}

/// Removes a temporary file if a killed worker left it. Running workers, on any machine, rename
/// such a file at once.
void remove_if_abandoned(const fs::path& file) {
  constexpr std::chrono::hours kAbandoned{1};
  const std::string name = file.filename().string();
  const bool is_ours = name.starts_with(kCampaignFile) || name.find(kUnitEnding) != name.npos;
  if (!is_ours || file.extension() != ".part") return;
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  if (!error && fs::file_time_type::clock::now() - written > kAbandoned) fs::remove(file, error);
}

/// The folder as the user gave it.
std::string shown(const fs::path& folder) {
  const std::string path = folder.string(), inside = std::string("/") + kUnitsInside;
  return path.ends_with(inside) ? path.substr(0, path.size() - inside.size()) : path;
}

/// How the campaign of a folder differs from the expected one.
std::string difference(const CampaignIdentity& other, const CampaignIdentity& campaign) {
  if (other.text() != campaign.text()) {
    return fmt::format("{}, not of {}", other.text(), campaign.text());
  }
  if (other.version != campaign.version) {
    return fmt::format("raycheck {}, not of {}", other.version, campaign.version);
  }
  for (const auto& [file, its_digest] : campaign.files) {
    const auto found = other.files.find(file);
    if (found == other.files.end() || found->second != its_digest) {
      return fmt::format("another version of {}", file);
    }
  }
  return "other files";
}

void require_same(const CampaignIdentity& campaign, const fs::path& folder) {
  const CampaignIdentity other = campaign_in(folder);
  if (other.digest() == campaign.digest()) return;
  throw std::invalid_argument(
      fmt::format("{}: holds units of {}", shown(folder), difference(other, campaign)));
}

}  // namespace

std::string CampaignIdentity::text() const {
  std::string all = "raycheck " + command;
  for (const std::string& argument : arguments) {
    const bool is_plain = argument.find_first_of(" '\"$*?\\;&|<>()") == std::string::npos;
    all += " " + (is_plain && !argument.empty() ? argument : single_quoted(argument));
  }
  return all;
}

std::string CampaignIdentity::digest() const {
  std::vector<std::string> texts = {command, version};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  for (const auto& [file, its_digest] : files) {
    texts.push_back(file);
    texts.push_back(its_digest);
  }
  return tools::digest(texts);
}

CampaignIdentity campaign_in(const fs::path& folder) {
  const fs::path file = folder / kCampaignFile;
  if (!fs::is_directory(folder)) {
    throw std::invalid_argument(fmt::format("{}: there is no such folder", folder.string()));
  }
  if (!fs::exists(file) && fs::exists(folder / kUnitsInside)) {
    return campaign_in(folder / kUnitsInside);
  }
  if (!fs::exists(file)) {
    throw std::invalid_argument(
        fmt::format("{}: is not a folder that a campaign wrote: {} is missing", folder.string(),
                    kCampaignFile));
  }
  try {
    const Json json = Json::parse(bytes_of(file));
    CampaignIdentity campaign = {json.at("command"), json.at("arguments"), json.at("version"),
                                 json.at("files")};
    if (json.at("digest") == campaign.digest()) return campaign;
  } catch (const Json::exception&) {
    // reported below
  }
  throw std::invalid_argument(fmt::format("{}: is truncated or was changed", file.string()));
}

Units::Units(CampaignIdentity campaign, fs::path folder, Shard shard)
    : campaign_(std::move(campaign)),
      digest_(campaign_.digest()),
      folders_({folder}),
      shard_(std::move(shard)),
      is_merged_(false) {}

Units::Units(CampaignIdentity campaign, std::vector<fs::path> folders)
    : campaign_(std::move(campaign)),
      digest_(campaign_.digest()),
      folders_(std::move(folders)),
      is_merged_(true) {
  for (const fs::path& folder : folders_) require_same(campaign_, folder);
}

void Units::make_folder() const {
  const fs::path& folder = folders_.front();
  tools::make_folder("out", folder);
  if (!fs::exists(folder / kCampaignFile)) {
    OutputFile("out", (folder / kCampaignFile).string())
        .write(json_text({{"command", campaign_.command},
                          {"arguments", campaign_.arguments},
                          {"version", campaign_.version},
                          {"files", campaign_.files},
                          {"digest", digest_}}));
  }
  require_same(campaign_, folder);
}

std::vector<std::int64_t> Units::open(std::int64_t count) {
  if (!is_merged_) make_folder();
  files_.clear();
  for (const fs::path& folder : folders_) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (!is_merged_) remove_if_abandoned(entry.path());
      if (entry.path().extension() != kUnitEnding) continue;
      std::int64_t unit = -1;
      std::from_chars(name.data(), name.data() + name.size(), unit);
      if (unit < 0 || unit >= count || name != name_of(unit)) {
        throw std::invalid_argument(fmt::format("{}: does not belong to the campaign {}",
                                                entry.path().string(), campaign_.text()));
      }
      files_[unit].push_back(entry.path());
    }
  }
  if (is_merged_ && std::ssize(files_) < count) refuse_missing(count);
  std::vector<std::int64_t> mine;
  for (std::int64_t unit = 0; unit < count; ++unit) {
    if (is_merged_ || shard_.has(unit)) mine.push_back(unit);
  }
  return mine;
}

void Units::refuse_missing(std::int64_t count) const {
  std::int64_t first = 0;
  while (files_.count(first) > 0) ++first;
  const std::int64_t others = count - std::ssize(files_) - 1;
  throw std::invalid_argument(fmt::format(
      "{}: unit {} of {} is missing{}; to add the missing units, run {} with this folder as --out",
      shown(folders_.front()), first + 1, count,
      others > 0 ? fmt::format(", and {} more", others) : "", campaign_.text()));
}

std::string Units::name_of(std::int64_t unit) const {
  return fmt::format("{:06}-{:.16}{}", unit, digest({digest_, std::to_string(unit)}), kUnitEnding);
}

std::string Units::contents(const fs::path& file, std::int64_t unit) const {
  std::istringstream bytes(bytes_of(file));
  std::string stated;
  std::size_t size = 0;
  bytes >> stated >> size;
  bytes.get();
  // The digest is checked before unpacking, so that a changed size is not used.
  const std::string packed_result{std::istreambuf_iterator<char>(bytes), {}};
  if (stated == digest_of(digest_, unit, size, packed_result)) {
    return unpacked(packed_result, size);
  }
  throw std::invalid_argument(fmt::format(
      "{}: is truncated or was changed: remove it and run its shard again", file.string()));
}

std::optional<std::string> Units::read(std::int64_t unit) const {
  const auto found = files_.find(unit);
  if (found == files_.end()) return std::nullopt;
  const std::vector<fs::path>& copies = found->second;
  try {
    std::string first = contents(copies.front(), unit);
    for (std::size_t k = 1; k < copies.size(); ++k) {
      if (contents(copies[k], unit) == first) continue;
      throw std::invalid_argument(fmt::format("{} and {}: contradict each other",
                                              copies.front().string(), copies[k].string()));
    }
    return first;
  } catch (const std::invalid_argument&) {
    if (is_merged_) throw;
    return std::nullopt;
  }
}

void Units::refuse(std::int64_t unit, const std::string& why) const {
  throw std::invalid_argument(
      fmt::format("{}: is not a valid unit: {}", files_.at(unit).front().string(), why));
}

void Units::write(std::int64_t unit, const std::string& result) const {
  OutputFile file("out", (folders_.front() / name_of(unit)).string());
  const std::string bytes = packed(result);
  file.append(
      fmt::format("{} {}\n", digest_of(digest_, unit, result.size(), bytes), result.size()));
  file.append(bytes);
  file.place();
}

}  // namespace raycheck::tools
