#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/external/answer_store.h"

namespace raycheck::tools {

/// The result of building a submission.
struct Built {
  /// Its command lines, or the library's name, relative to its folder; likelier programs first.
  std::vector<std::string> programs = {""};
  std::string words = {};  ///< The shell command that built it; empty: nothing to build.
  /// Remarks for readers of the grade: "its Makefile failed; built from its sources".
  std::vector<std::string> notes = {};
  std::string what = {};     ///< What it was built from: "its Makefile"; empty: as the form says.
  std::size_t next_way = 0;  ///< Of the ways to build it, the next; 0: there is none.
};

/// A digest of raycheck's version and of the compilers and interpreters of this machine that builds
/// and programs use, and of Eigen and glm: their files, sizes and times. Another version is another
/// file.
std::string toolchain();

bool is_executable(const std::filesystem::path& path);
/// A digest of a file's contents, and of whether it is executable.
std::string file_digest(const std::filesystem::path& path);

/// A store's folder, below the results; no submission may have this name.
inline constexpr std::string_view kStoreFolder = ".raycheck";

/// Submissions' builds and their programs' answers, kept from run to run, by digests of all that
/// they depend on. Thread-safe.
class Store {
 public:
  /// Makes the folder, accessible to its owner only. Errors: std::invalid_argument.
  explicit Store(const std::filesystem::path& out);

  /// A build, its files copied to the empty folder `to`; if it is missing or damaged, `make` builds
  /// it there. Equal builds run only once at a time. Sets `is_stored`.
  Built built(const std::string& key, const std::filesystem::path& to,
              const std::function<Built()>& make, bool& is_stored);

  /// The answers of a program, one object for all concurrent users.
  std::shared_ptr<AnswerStore> answers(const std::string& key);

 private:
  std::optional<Built> find(const std::string& key, const std::filesystem::path& to) const;
  void keep(const std::string& key, const std::filesystem::path& from, const Built& built) const;

  std::filesystem::path builds_, answers_;
  std::mutex mutex_;
  std::map<std::string, std::mutex> building_;
  std::map<std::string, std::weak_ptr<AnswerStore>> asked_;
};

}  // namespace raycheck::tools
