#include "tools/grade/results/own_files.h"

#include <fmt/core.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "tools/grade/results/record.h"
#include "tools/grade/rubric/rubric_files.h"
#include "tools/report/output_file.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHeading =
    "# What raycheck wrote here: digests of names and contents. It replaces no other files.";

std::string digest_of(const fs::path& name, const std::string& text) {
  return digest({name.generic_string(), text});
}

/// Whether something has that name, even a dangling link.
bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

}  // namespace

OwnFiles::OwnFiles(fs::path out) : out_(std::move(out)) {
  const fs::path path = out_ / kOwnFilesList;
  if (!is_there(path)) return;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  if (!fs::is_regular_file(fs::symlink_status(path)) || !std::getline(file, line) ||
      line != kHeading) {
    throw std::invalid_argument(fmt::format(
        "out {}: {} is not raycheck's list of the files that it wrote; move it away, or "
        "give another folder",
        out_.string(), path.string()));
  }
  while (std::getline(file, line)) digests_.insert(line);
}

bool OwnFiles::is_own(const fs::path& name) const {
  const fs::path path = out_ / name;
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(path, error))) return false;
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::lock_guard lock(mutex_);
  return digests_.contains(digest_of(name, text));
}

void OwnFiles::require_own(const fs::path& name) const {
  if (!is_there(out_ / name) || is_own(name)) return;
  throw std::invalid_argument(fmt::format(
      "out {}: {} is not as raycheck wrote it, and stays; move it away, or give another "
      "folder",
      out_.string(), (out_ / name).string()));
}

void OwnFiles::list(const std::string& digest) {
  const std::lock_guard lock(mutex_);
  if (!digests_.insert(digest).second) return;
  const fs::path path = out_ / kOwnFilesList;
  const bool is_new = !is_there(path);
  std::ofstream file(path, std::ios::binary | std::ios::app);
  if (is_new) file << kHeading << "\n";
  file << digest << "\n";
  if (!file.flush()) {
    throw std::runtime_error(fmt::format("out {}: could not be written", path.string()));
  }
}

void OwnFiles::write(const fs::path& name, const std::string& text) {
  require_own(name);
  // Listed first: after an interruption between the two no file is unknown.
  list(digest_of(name, text));
  OutputFile("out", out_ / name).write(text);
}

void OwnFiles::make_folder(const fs::path& name) const {
  std::error_code error;
  fs::create_directories(out_ / name, error);
  if (!error) return;
  throw std::invalid_argument(fmt::format("out {}: {}", out_.string(), error.message()));
}

void OwnFiles::replace(const fs::path& folder, const std::map<std::string, std::string>& files) {
  make_folder(folder);
  for (const auto& entry : fs::directory_iterator(out_ / folder)) {
    const std::string name = entry.path().filename();
    if (name != kRecordFile && !files.contains(name) && is_own(folder / name)) {
      fs::remove(entry.path());
    }
  }
  for (const auto& [name, text] : files) write(folder / name, text);
}

}  // namespace raycheck::tools
