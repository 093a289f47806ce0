#pragma once

#include <string>
#include <string_view>

namespace raycheck::tools {

/// How a view is shown.
struct ViewOptions {
  bool colours = false;  ///< Whether to use colours, for a terminal.
};

/// A format of a command's report: its name for --format, and its writer. A room's views are in a
/// table; the first is the default.
template <class Report>
struct View {
  std::string_view name;
  std::string (*render)(const Report& report, const ViewOptions& options);
};

}  // namespace raycheck::tools
