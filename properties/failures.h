#pragma once

// Exceptions for candidates that give no answer, and for internal errors of raycheck.

#include <cstdint>
#include <functional>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "properties/case.h"
#include "scene/interruption.h"

namespace raycheck::properties {

/// A candidate gives no answer.
struct NoAnswer : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// The candidate refuses the question.
struct CandidateRefused : NoAnswer {
  using NoAnswer::NoAnswer;
};
/// The question cannot be expressed in the candidate's form of input, so it is not asked.
struct CannotBeSaid : NoAnswer {
  using NoAnswer::NoAnswer;
};
/// A line of a candidate's source.
struct CodeLine {
  std::string file;       ///< Relative to the working folder if the file is below it.
  std::int64_t line = 1;  ///< From 1 on.
  std::string text = {};  ///< The text of the line, trimmed.
  void serialize(auto& archive) { archive(file, line, text); }
};

/// The candidate fails.
struct CandidateFailed : NoAnswer {
  explicit CandidateFailed(const std::string& what, std::optional<CodeLine> at = {},
                           bool gave_no_reply = false)
      : NoAnswer(what), line(std::move(at)), timed_out(gave_no_reply) {}
  std::optional<CodeLine> line;  ///< Where it failed, if known.
  bool timed_out;                ///< It gave no reply in time.
};
/// The candidate would fail on every question.
struct CandidateUnavailable : CandidateFailed {
  using CandidateFailed::CandidateFailed;
};

/// The candidate's `image` returned a picture whose size is not the scene's.
struct OtherSize : CandidateFailed {
  OtherSize(const std::string& what, std::int64_t its_width, std::int64_t its_height)
      : CandidateFailed(what), width(its_width), height(its_height) {}
  std::int64_t width, height;
};

/// raycheck itself fails, whatever the candidate answers; there is no verdict.
struct InternalError : std::logic_error {
  explicit InternalError(const std::string& what, std::optional<Case> on = {})
      : std::logic_error(what), the_case(std::move(on)) {}
  std::optional<Case> the_case;  ///< The case on which it failed, if known.
};

/// Calls `ask`. Exceptions of this file pass through; `translate` turns any other into one of them.
template <class Ask, class Translate>
auto translated(const Ask& ask, const Translate& translate) -> decltype(ask()) {
  try {
    return ask();
  } catch (const NoAnswer&) {
    throw;
  } catch (const InternalError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const scene::Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    translate(&error);
    throw;
  } catch (...) {
    translate(nullptr);
    throw;
  }
}

/// Calls a candidate's function: std::invalid_argument is a refusal, any other exception a failure.
template <class Ask>
auto asked(const Ask& ask) -> decltype(ask()) {
  return translated(ask, [](const std::exception* error) {
    if (error == nullptr) throw CandidateFailed("it throws something that is not a std::exception");
    if (dynamic_cast<const std::invalid_argument*>(error) != nullptr) {
      throw CandidateRefused(error->what());
    }
    throw CandidateFailed(error->what());
  });
}

/// Calls raycheck's code between a law and a candidate. Exceptions other than NoAnswer become an
/// InternalError: they are not the candidate's fault.
template <class Ask>
auto asked_by_us(const Ask& ask) -> decltype(ask()) {
  return translated(ask, [](const std::exception* error) {
    if (error != nullptr) throw InternalError(error->what());
  });
}

/// A function of a candidate; calls go through asked().
template <class Signature>
class CandidateFunction;
template <class Answer, class... Arguments>
class CandidateFunction<Answer(Arguments...)> : public std::function<Answer(Arguments...)> {
  using Base = std::function<Answer(Arguments...)>;

 public:
  using Base::Base;
  using Base::operator=;
  Answer operator()(Arguments... arguments) const {
    return asked([&] { return as_is(std::forward<Arguments>(arguments)...); });
  }
  /// Calls the function without asked(): exceptions pass through. For callers that expect many
  /// exceptions, since each rethrow takes time.
  Answer as_is(Arguments... arguments) const {
    return Base::operator()(std::forward<Arguments>(arguments)...);
  }
};

}  // namespace raycheck::properties
