#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace raycheck::tools {

/// The code cells of a Jupyter notebook as one Python module: lines of magics (% and !) become
/// `pass`, cells of other languages (%%bash) are left out. Empty where the text is no notebook.
std::optional<std::string> notebook_module(std::string_view text);

}  // namespace raycheck::tools
