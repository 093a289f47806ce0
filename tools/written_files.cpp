#include "tools/written_files.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "tools/report/output_file.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Options whose value is a file to be written; of --report it is behind the kind.
constexpr const char* kWriting[] = {"--certificates", "--out",  "--package", "--plot",
                                    "--report",       "--save", "--view"};

/// Those whose value is a file that is read, besides what a command takes without an option.
constexpr const char* kReading[] = {"--baseline", "--candidate", "--secret-file"};

bool reads(const CLI::Option& option) {
  return option.get_positional() ||
         std::any_of(std::begin(kReading), std::end(kReading),
                     [&](const char* name) { return option.check_name(name); });
}

struct Written {
  const CLI::Option* option;
  std::string named_by, path;
};

std::vector<Written> written_by(const CLI::App& command) {
  std::vector<Written> all;
  for (const char* name : kWriting) {
    const CLI::Option* const option = command.get_option_no_throw(name);
    if (option == nullptr) continue;
    for (const std::string& value : option->results()) {
      const std::size_t kind = option->check_name("--report") ? value.find('=') + 1 : 0;
      all.push_back({option, name, value.substr(kind)});
    }
  }
  const CLI::Option* const updates = command.get_option_no_throw("--update-baseline");
  if (updates != nullptr && updates->count() > 0) {
    const CLI::Option* const baseline = command.get_option("--baseline");
    for (const std::string& value : baseline->results()) {
      all.push_back({baseline, "--baseline", value});
    }
  }
  return all;
}

/// Every text of an option that may name a file: the value, what follows "source:" or "name=", and
/// the words of a command.
std::vector<std::string> files_of(const CLI::Option& option) {
  std::vector<std::string> files;
  for (const std::string& value : option.results()) {
    for (const std::size_t begin : {std::size_t{0}, value.find(':') + 1, value.find('=') + 1}) {
      files.push_back(value.substr(begin));
      std::istringstream words(files.back());
      for (std::string word; words >> word;) files.push_back(word);
    }
  }
  return files;
}

bool is_same(const std::string& a, const std::string& b) {
  std::error_code error;
  const fs::path one = fs::weakly_canonical(a, error), other = fs::weakly_canonical(b, error);
  return !a.empty() && !error && one == other;
}

}  // namespace

void require_written_apart(const CLI::App& command) {
  const std::vector<Written> all = written_by(command);
  for (auto one = all.begin(); one != all.end(); ++one) {
    const bool is_twice = std::any_of(
        one + 1, all.end(), [&](const Written& next) { return is_same(one->path, next.path); });
    if (is_twice) {
      throw std::invalid_argument(
          fmt::format("{} {}: the file is named twice", one->named_by, one->path));
    }
    std::error_code error;
    if (!fs::is_regular_file(one->path, error)) continue;
    for (const CLI::Option* option : command.get_options()) {
      const bool is_written = std::any_of(
          all.begin(), all.end(), [&](const Written& other) { return other.option == option; });
      if (is_written || !reads(*option)) continue;
      require_no_input(one->named_by, one->path, files_of(*option));
    }
  }
}

}  // namespace raycheck::tools
