#pragma once

#include <string_view>

namespace raycheck::tools {

// The files of tools/view/page/ and three.js, as embedded in the program by the build.
extern const std::string_view kPageTemplate;  ///< page.html
extern const std::string_view kPageStyle;     ///< page.css
extern const std::string_view kPageScript;    ///< The modules, bundled.
extern const std::string_view kThree;         ///< three.js and the used ones of its examples.

}  // namespace raycheck::tools
