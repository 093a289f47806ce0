// Included by tests: GoogleTest, most of the standard library, and helpers for texts and numbers.
#pragma once

#include <gtest/gtest.h>

#include "tests/numbers.h"
#include "tests/standard.h"

namespace raycheck {

/// Whether a text has a part, for EXPECT_TRUE and EXPECT_FALSE, which print both if they fail.
inline testing::AssertionResult has(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  return (found ? testing::AssertionSuccess() : testing::AssertionFailure())
         << (found ? "there is '" : "there is no '") << part << "' in:\n"
         << text;
}

/// A text with its first `from` replaced. Domain: it contains `from`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("there is no " + from);
  return text.replace(at, from.size(), to);
}

/// A text repeated.
inline std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t k = 0; k < times; ++k) all += text;
  return all;
}

/// The text of a file; empty if it does not exist.
inline std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// The lines of a text, without their ends.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The message of the exception that a call throws, or "no error".
template <class Error = std::invalid_argument, class Call>
std::string thrown_by(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace raycheck
