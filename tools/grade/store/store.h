#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tools/external/answer_store.h"

namespace raycheck::tools {

/// The result of building a submission.
struct Built {
  /// The command lines of its programs, the likeliest first, or the name of its library, relative
  /// to its folder.
  std::vector<std::string> programs = {""};
  /// The shell command that built it; empty if there was nothing to build.
  std::string words = {};
  /// Remarks for readers of the grade: "its Makefile failed; built from its sources".
  std::vector<std::string> notes = {};
  /// What it was built from: "its Makefile"; empty if the form's command built it.
  std::string what = {};
  std::size_t next_way = 0;  ///< The index of the next way to build it; 0 if there is none.
};

/// A digest of raycheck's version and of this machine's compilers, interpreters, Eigen and glm:
/// their paths, sizes and times, which differ between versions.
std::string toolchain();

bool is_executable(const std::filesystem::path& path);
/// A digest of a file's contents, and of whether it is executable.
std::string file_digest(const std::filesystem::path& path);

/// The store's folder in the folder of results; no submission may have this name.
inline constexpr std::string_view kStoreFolder = ".raycheck";

/// Stores the builds of submissions and the answers of their programs for later runs. The keys are
/// digests of everything on which these depend. Thread-safe.
class Store {
 public:
  /// Makes the folder, accessible only to its owner. Errors: std::invalid_argument.
  explicit Store(const std::filesystem::path& out);

  /// Copies a stored build to the empty folder `to`. If it is missing or damaged, `make` builds it
  /// there. Builds with the same key never run at the same time. Sets `is_stored`.
  Built built(const std::string& key, const std::filesystem::path& to,
              const std::function<Built()>& make, bool& is_stored);

  /// The answers of a program; all concurrent users get the same object.
  std::shared_ptr<AnswerStore> answers(const std::string& key);

 private:
  std::optional<Built> find(const std::string& key, const std::filesystem::path& to) const;
  void keep(const std::string& key, const std::filesystem::path& from, const Built& built) const;

  std::filesystem::path builds_, answers_;
  std::mutex mutex_;
  std::map<std::string, std::mutex> building_;
  std::map<std::string, std::weak_ptr<AnswerStore>> asked_;
};

/// The file of a submission's results that records its grade, for instructors.
inline constexpr const char* kRecordFile = "result.json";
/// The list of the files that raycheck wrote to the folder of results; no submission may have this
/// name.
inline constexpr std::string_view kOwnFilesList = ".raycheck-files";

/// The files that raycheck wrote below a folder of results, in this and earlier runs. They are
/// recognised by name and contents. Other files, including files of raycheck that were edited, are
/// never replaced or removed. Names are relative to the folder. Thread-safe.
class OwnFiles {
 public:
  /// Reads the list; the folder need not exist yet. Errors: std::invalid_argument if the list's
  /// name belongs to something else.
  explicit OwnFiles(std::filesystem::path out);

  /// Throws std::invalid_argument naming the file if it exists and raycheck did not write it.
  void require_own(const std::filesystem::path& name) const;
  /// Writes a file. Replaces a file only if raycheck wrote it. Errors: as require_own();
  /// std::runtime_error if it could not be written.
  void write(const std::filesystem::path& name, const std::string& text);
  /// Makes a folder, writes these files into it, and removes all other files of raycheck that lie
  /// directly in it, except kRecordFile. Errors: as write().
  void replace(const std::filesystem::path& folder,
               const std::map<std::string, std::string>& files);

 private:
  bool is_own(const std::filesystem::path& name) const;
  void list(const std::string& digest);

  std::filesystem::path out_;
  mutable std::mutex mutex_;
  std::set<std::string> digests_;  ///< Digests of names and contents.
};

}  // namespace raycheck::tools
