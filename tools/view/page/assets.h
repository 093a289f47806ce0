#pragma once

#include <string_view>

namespace raycheck::tools {

// The files of tools/view/page/ and three.js, which the build embeds in the program.
extern const std::string_view kPageTemplate;  ///< page.html
extern const std::string_view kPageStyle;     ///< page.css
extern const std::string_view kPageScript;    ///< The modules, bundled.
extern const std::string_view kThree;         ///< three.js and those of its examples that are used.

}  // namespace raycheck::tools
