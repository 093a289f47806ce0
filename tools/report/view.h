#pragma once

#include <string>
#include <string_view>

namespace raycheck::tools {

/// How a view is shown.
struct ViewOptions {
  bool colours = false;  ///< Whether to use colours, for a terminal.
};

/// The active content of a text.
enum class ViewKind {
  kText,      ///< No active content.
  kCommands,  ///< Lines that the log of a GitHub workflow executes.
};

/// A format of a command's report: its name for --format, and its writer. Each command has a table
/// of views; the first is the default.
template <class Report>
struct View {
  std::string_view name;
  std::string (*render)(const Report& report, const ViewOptions& options);
};

}  // namespace raycheck::tools
