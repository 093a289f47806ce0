#pragma once

#include <string>
#include <string_view>

namespace raycheck::tools {

/// A first draft of a format (scene/formats/), from the text of an example file whose statements
/// are lines. A keyword means what it means in the known formats or is usually called; the draft
/// begins with a comment about each keyword that means nothing known, and each number of a camera
/// that no line gives. `source` is the example's name. Error: scene::SceneFileError if the text is
/// not UTF-8, has control characters or has no statements.
std::string drafted_format(std::string_view title, std::string_view source, std::string_view text);

}  // namespace raycheck::tools
