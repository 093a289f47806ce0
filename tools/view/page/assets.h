#pragma once

// The files of tools/view/page/ and three.js, as the build has put them into the program.

#include <string_view>

namespace raycheck::tools {

extern const std::string_view kPageTemplate;  ///< page.html
extern const std::string_view kPageStyle;     ///< page.css
extern const std::string_view kPageScript;    ///< The modules, bundled.
extern const std::string_view kThree;         ///< three.js and those of its examples that are used.

}  // namespace raycheck::tools
