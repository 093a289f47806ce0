#ifndef RAYCHECK_TOOLS_GRADE_PAGES_HTML_H_
#define RAYCHECK_TOOLS_GRADE_PAGES_HTML_H_

#include <string>
#include <string_view>

namespace raycheck::tools {

/// Text as HTML shows it, in elements and in attributes; what acts on what shows it is spelled
/// (scene/text.h).
std::string escaped(std::string_view text);

/// A whole page that needs nothing besides itself, for narrow and for wide screens.
std::string page(std::string_view title, std::string_view body);

/// A link that saves a text as a file.
std::string download(std::string_view file, std::string_view text);

}  // namespace raycheck::tools

#endif  // RAYCHECK_TOOLS_GRADE_PAGES_HTML_H_
