#include "tools/report/output_file.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "scene/invalid_input.h"

namespace raycheck::tools {

namespace fs = std::filesystem;

OutputFile::OutputFile(std::string named_by, std::string path)
    : named_by_(std::move(named_by)), path_(std::move(path)) {
  const auto refuse = [&](const std::string& why) {
    throw scene::InvalidInput(named_by_, path_, "cannot be written: " + why);
  };
  if (path_.empty()) refuse("the name is empty");
  std::error_code ignored;
  const fs::file_status status = fs::status(path_, ignored);
  if (fs::exists(status)) {
    if (!fs::is_regular_file(status)) refuse("the path exists and is not a regular file");
    if (access(path_.c_str(), W_OK) != 0) refuse(std::strerror(errno));
  }
  // The process id is not enough, because in containers every process may have the id 1.
  const std::string beside =
      fmt::format("{}.{}.{:08x}.part", path_, getpid(), std::random_device()());
  errno = 0;
  file_.open(beside, std::ios::binary);
  if (!file_) refuse(errno != 0 ? std::strerror(errno) : "cannot open it");
  beside_ = beside;
}

OutputFile::~OutputFile() {
  if (beside_.empty()) return;
  std::error_code ignored;
  fs::remove(beside_, ignored);
}

void OutputFile::append(std::string_view bytes) {
  errno = 0;
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  require_written();
}

void OutputFile::place() {
  errno = 0;
  file_.close();
  require_written();
  std::error_code error;
  fs::rename(beside_, path_, error);
  if (error) fail(error.message());
  beside_.clear();
}

void OutputFile::require_written() {
  if (!file_) fail(errno != 0 ? std::strerror(errno) : "only a part could be written");
}

void OutputFile::fail(const std::string& why) const {
  throw std::runtime_error(fmt::format("{} {}: could not be written: {}", named_by_, path_, why));
}

void make_folder(const std::string& named_by, const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw scene::InvalidInput(named_by, folder.string(), "cannot be made: " + error.message());
  }
}

void require_no_input(const std::string& named_by, const std::string& path,
                      const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    std::error_code error;
    if (!fs::equivalent(path, input, error)) continue;
    throw scene::InvalidInput(named_by, path,
                              fmt::format("is the input {}; give another file", input));
  }
}

}  // namespace raycheck::tools
