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

/// What was made of a submission.
struct Built {
  /// What starts it, or the library's name, from its folder; of several programs likelier ones
  /// first.
  std::vector<std::string> programs = {""};
  std::string words = {};  ///< The shell words that built it; empty: nothing was to build.
  /// What who reads the grade should know: "its Makefile failed; built from its sources".
  std::vector<std::string> notes = {};
};

/// A digest of raycheck's version and of the compilers and interpreters of this machine that builds
/// and programs use, and of Eigen and glm: which files they are, how large and of which time.
/// Another version is another file.
std::string toolchain();

/// The answers of one program in one compressed file, which is read at first and written when the
/// object goes, if there are new ones. A file that is not as it was written counts as none. For all
/// threads.
class AnswerFile : public AnswerStore {
 public:
  explicit AnswerFile(std::filesystem::path path);
  ~AnswerFile() override;

  std::optional<StoredAnswer> find(const std::string& request) const override;
  /// Answers beyond kMostKept bytes together are not kept.
  void keep(const std::string& request, StoredAnswer answer) override;
  static constexpr std::size_t kMostKept = std::size_t{64} << 20;

 private:
  std::filesystem::path path_;
  mutable std::mutex mutex_;
  std::map<std::string, StoredAnswer> answers_;  ///< By the digests of requests.
  std::size_t bytes_ = 0;
  bool is_new_ = false;
};

/// The folder below the results in which a store lies; no submission is called so.
inline constexpr std::string_view kStoreFolder = ".raycheck";

/// What was built of submissions and what their programs answered, by all that it depends on, from
/// one run to the next. The keys are digests. For all threads.
class Store {
 public:
  /// Makes the folder, for its owner alone. Errors: std::invalid_argument.
  explicit Store(const std::filesystem::path& out);

  /// What was built, its files copied to the empty folder `to`; where it is not there, or not as it
  /// was kept, `make` builds it there. Equal things are built once at a time. `is_stored` is set.
  Built built(const std::string& key, const std::filesystem::path& to,
              const std::function<Built()>& make, bool& is_stored);

  /// The answers of a program, the same for all who ask at a time.
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
