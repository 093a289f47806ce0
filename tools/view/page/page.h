#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tools/view/document.h"

namespace raycheck::tools {

/// A document as one HTML file, which needs no other and no network: its content security policy
/// allows its own script and style by their hashes, and pictures that are in it.
std::string page(const ViewDocument& document);

/// Compressed as zlib does (RFC 1950), as far as it can. Errors: std::runtime_error.
std::string deflated(std::string_view text);

/// How many bytes a text comes to behind another in one compressed stream, nearly.
std::size_t deflated_behind(std::string_view before, std::string_view text);

// The files of tools/view/page/ and three.js, as the build has put them into the program.
extern const std::string_view kPageTemplate;  ///< page.html
extern const std::string_view kPageStyle;     ///< page.css
extern const std::string_view kPageScript;    ///< The modules, bundled.
extern const std::string_view kThree;         ///< three.js and those of its examples that are used.

}  // namespace raycheck::tools
