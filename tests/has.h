#pragma once

#include <gtest/gtest.h>

#include <string>

namespace raycheck {

/// Whether a text has a part, for EXPECT_TRUE and EXPECT_FALSE, which print both where they fail.
inline testing::AssertionResult has(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  return (found ? testing::AssertionSuccess() : testing::AssertionFailure())
         << (found ? "there is '" : "there is no '") << part << "' in:\n"
         << text;
}

}  // namespace raycheck
