#pragma once

#include <string>
#include <string_view>

namespace raycheck::tools {

/// Text as a cell of a table, in quotes where it needs them, with what acts on a terminal spelled
/// (scene/text.h). What a spreadsheet would take for a formula, since it begins with = + - @, a tab
/// or an end of line and is no number, begins with an apostrophe instead.
std::string csv_cell(std::string_view text);

}  // namespace raycheck::tools
