#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "tools/external/answer_store.h"

namespace raycheck::tools {

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

}  // namespace raycheck::tools
