#pragma once

#include <string>
#include <string_view>

namespace raycheck::tools {

/// Text as a cell of a CSV table, quoted if needed. Characters that control a terminal are spelled
/// out (scene/text.h). Text that a spreadsheet would take for a formula, because it begins with = +
/// - @, a tab or an end of line and is not a number, is prefixed with an apostrophe.
std::string csv_cell(std::string_view text);

/// Text for HTML elements and attributes. Characters that control a viewer are spelled out
/// (scene/text.h).
std::string escaped(std::string_view text);

/// Bytes in base64 (RFC 4648).
std::string base64(std::string_view bytes);

/// Bytes as a data URL: "data:image/png;base64,..." (RFC 2397).
std::string data_address(std::string_view type, std::string_view bytes);

}  // namespace raycheck::tools
