#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tools/view/document.h"

namespace raycheck::tools {

/// A document as one self-contained HTML file: its content security policy allows its own script
/// and style by their hashes, and embedded pictures.
std::string page(const ViewDocument& document);

/// About how many bytes a text adds after another in one compressed stream.
std::size_t deflated_behind(std::string_view before, std::string_view text);

// The files of tools/view/page/ and three.js, as embedded in the program by the build.
extern const std::string_view kPageTemplate;  ///< page.html
extern const std::string_view kPageStyle;     ///< page.css
extern const std::string_view kPageScript;    ///< The modules, bundled.
extern const std::string_view kThree;         ///< three.js and the used ones of its examples.

}  // namespace raycheck::tools
