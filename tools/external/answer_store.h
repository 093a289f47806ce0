#pragma once

#include <optional>
#include <string>

#include "tools/external/sandbox/launch.h"

namespace raycheck::tools {

/// A program's answer to a request, or its failure.
struct StoredAnswer {
  std::string text;  ///< In the caller's format; for a failure, the message.
  std::optional<FailureKind> failure = {};
  double seconds = 0;  ///< The time that the answer took.
};

/// Stored answers of one program, run in one way. This base class stores nothing.
class AnswerStore {
 public:
  AnswerStore() = default;
  virtual ~AnswerStore() = default;
  AnswerStore(const AnswerStore&) = delete;
  AnswerStore& operator=(const AnswerStore&) = delete;

  virtual std::optional<StoredAnswer> find(const std::string& /*request*/) const { return {}; }
  virtual void keep(const std::string& /*request*/, StoredAnswer /*answer*/) {}
};

/// Whether a program would fail in the same way again, unlike failures of the system.
constexpr bool is_lasting(FailureKind kind) { return kind != FailureKind::kSystem; }

}  // namespace raycheck::tools
