#pragma once

// What pages say in words; in view_words_text.cpp.

#include <array>
#include <string>
#include <vector>

#include "tools/view/document.h"

namespace raycheck::tools {

/// Behind an s that counts multiples of a ray's direction; nothing where that is a unit vector.
std::string direction_remark(const ExplainReport& report);

/// What the microscope shows: around which point, in what unit, how far away the answers to a miss
/// are, and of which methods there is nothing to draw.
std::vector<std::string> microscope_sentences(const Microscope& microscope,
                                              const ExplainReport& report, double gap);

/// [word, what it means] of the words that pages use.
std::vector<std::array<std::string, 2>> words_of_pages();

}  // namespace raycheck::tools
