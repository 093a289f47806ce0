#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/files/format.h"

namespace raycheck::scene {

struct Word {
  std::string_view text;
  std::size_t line;
  std::size_t row = line;  ///< In a nested file: from 0.
  bool begins = false;     ///< In a nested file: whether it is the first of a block.
};

/// The words of a file whose format is not nested, without comments.
std::vector<Word> words_of(const FileFormat& format, std::string_view text);

/// The rows of a file of a nested format; names that its definitions give are replaced by what they
/// stand for, and the rows of definitions are empty. Of other formats: none.
/// Errors: SceneFileError if definitions add too many words.
std::vector<NestedRow> defined_rows(const FileFormat& format, std::string_view text,
                                    std::string_view file);

/// The words of rows, which must outlive them.
std::vector<Word> words_of(const std::vector<NestedRow>& rows);

}  // namespace raycheck::scene
