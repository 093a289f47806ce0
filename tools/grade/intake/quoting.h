#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raycheck::tools {

/// Files' names as words of a shell.
std::string shell_words(const std::vector<std::string>& names);

/// A file's name as one of a candidate's words, which are split where no quotes are.
std::string candidate_word(const std::string& name);

/// A text with every `mark` replaced.
std::string with_mark(std::string text, std::string_view mark, const std::string& replacement);

/// In small letters, those of ASCII.
std::string lower_case(std::string text);

}  // namespace raycheck::tools
