#pragma once

#include <optional>
#include <string>

#include "tools/external/sandbox/launch.h"

namespace raycheck::tools {

/// What a program answered to a request, or how it failed.
struct StoredAnswer {
  std::string text;  ///< As who asked writes it; of a failure its words.
  std::optional<FailureKind> failure = {};
  double seconds = 0;  ///< That it took.
};

/// What one program, run in one way, answered in an earlier run: it is not asked again.
class AnswerStore {
 public:
  AnswerStore() = default;
  virtual ~AnswerStore() = default;
  AnswerStore(const AnswerStore&) = delete;
  AnswerStore& operator=(const AnswerStore&) = delete;

  virtual std::optional<StoredAnswer> find(const std::string& request) const = 0;
  virtual void keep(const std::string& request, StoredAnswer answer) = 0;
};

/// Whether a program would fail likewise if it were asked again: the system is not its.
constexpr bool is_lasting(FailureKind kind) { return kind != FailureKind::kSystem; }

}  // namespace raycheck::tools
