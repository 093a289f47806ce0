#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "tools/external/answer_store.h"
#include "tools/grade/store/built.h"

namespace raycheck::tools {

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
